//! `asperity surface --scales`: a scan against the short-wavelength cut-off.

use anyhow::{Result, bail};
use asperity::Code;
use asperity_answer::{Blanks, Sheet};
use asperity_scene::MeasuredKeys;
use asperity_topography::{Statistics, Topography};

use crate::output;
use crate::output::plot::Plot;

/// A number of a surface.
type Number = fn(&Statistics) -> Option<f64>;
/// Columns of the surface.
const COLUMNS: [(&str, Number); 5] = [
    ("alpha", |s| Some(s.moments.profile.bandwidth())),
    ("asperity_radius_m", |s| Some(s.surface().ok()?.asperity_radius)),
    ("asperity_density_per_m2", |s| Some(s.surface().ok()?.asperity_density)),
    ("asperity_height_std_m", |s| Some(s.surface().ok()?.asperity_height_std)),
    ("rms_gradient", |s| Some((2.0 * s.moments.profile.m2).sqrt())),
];
const CUTOFF: &str = "cutoff_m";

/// The table of a scan, prepared by these keys with each cut-off.
pub fn table(cutoffs: &[f64], scan: &Topography, keys: &MeasuredKeys) -> Result<Sheet> {
    let (mut table, mut blanks) = (Sheet::new(&[CUTOFF]), Blanks::default());
    table.heads.extend(COLUMNS.iter().map(|(name, _)| (*name).to_string()));
    for &cutoff in cutoffs {
        let mut keys = keys.clone();
        keys.smooth = Some(cutoff);
        let smooth = keys.prepare(scan.clone());
        let found = smooth.and_then(|smooth| smooth.statistics(keys.estimator));
        let number = |(_, number): (&str, Number)| number(found.as_ref().ok()?);
        let numbers = COLUMNS.map(number);
        if let Err(reason) = found.and_then(|statistics| statistics.surface()) {
            let text = format!("{CUTOFF} {cutoff:e}: {reason}");
            blanks.count("value", std::mem::discriminant(&reason), text);
        }
        table.add(&[], [Some(cutoff)].into_iter().chain(numbers));
    }
    blanks.texts(cutoffs.len()).for_each(|text| output::warn(Code::NoValue, text));
    if table.rows.iter().all(|row| row[1..].iter().all(|cell| cell.number().is_none())) {
        bail!("no row has a value");
    }
    Ok(table)
}

/// A panel for each column, against the cut-off.
pub fn picture(table: &Sheet) -> Result<String> {
    let columns: Vec<&str> = table.heads[1..].iter().map(String::as_str).collect();
    Plot::new(&[], CUTOFF, &columns).svg(table)
}
