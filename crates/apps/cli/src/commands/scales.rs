//! `asperity surface --scales`: a scan against the short-wavelength cut-off.

use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use asperity::{At, Code, ContactModel, Quantity, Request};
use asperity_answer::{Blanks, Sheet};
use asperity_scene::{MeasuredKeys, SceneFile};
use asperity_topography::{Statistics, Topography};
use clap::Args;

use crate::input::args::model_id;
use crate::input::lists::{Numbers, all};
use crate::input::numbers::{length, load, pressure};
use crate::output;
use crate::output::plot::Plot;
use crate::scene::LoadedScene;

/// Statistics of a surface against the short-wavelength cut-off.
#[derive(Debug, Args)]
pub struct Scales {
    /// Tabulate the asperities, and results of a scene, against the short-wavelength cut-off: N
    /// cut-offs from A to B, in m, or with a unit
    #[arg(long, value_name = "A:B:N[:log]|v,v", value_parser = all(length))]
    #[arg(conflicts_with_all = ["smooth", "scene"])]
    scales: Option<Numbers>,
    /// With --scales: a scene whose materials and nominal area are used with each surface
    #[arg(long, value_name = "SCENE", requires = "scales", requires = "place")]
    with: Option<PathBuf>,
    /// With --with: load in N, or with a unit
    #[arg(long, value_name = "N", value_parser = load, group = "place")]
    #[arg(requires = "with")]
    load: Option<f64>,
    /// With --with: pressure on the nominal area in Pa, or with a unit
    #[arg(long, value_name = "PA", value_parser = pressure, group = "place")]
    #[arg(requires = "with")]
    pressure: Option<f64>,
    /// With --with: model [default: ke; gw without a hardness]
    #[arg(long, value_name = "M", value_parser = model_id, requires = "with")]
    model: Option<String>,
}

/// A number of a surface.
type Number = fn(&Statistics) -> Option<f64>;
/// Columns of the surface.
const COLUMNS: [(&str, Number); 5] = [
    ("alpha", |s| Some(s.alpha)),
    ("asperity_radius_m", |s| s.asperity_radius),
    ("asperity_density_per_m2", |s| s.asperity_density),
    ("asperity_height_std_m", |s| s.asperity_height_std),
    ("rms_gradient", |s| Some((2.0 * s.m2).sqrt())),
];
/// Results of the scene.
const ANSWERS: [Quantity; 2] = [Quantity::AreaFraction, Quantity::Tangent];
const CUTOFF: &str = "cutoff_m";

impl Scales {
    pub fn is_requested(&self) -> bool {
        self.scales.is_some()
    }

    /// The table of a scan, prepared by these keys with each cut-off.
    pub fn table(&self, scan: &Topography, keys: &MeasuredKeys) -> Result<Sheet> {
        let cutoffs = self.scales.as_ref().map_or(&[][..], |numbers| &numbers.0);
        let scene = self.with.as_deref().map(|path| LoadedScene::load(path, &[])).transpose()?;
        let asked = match &scene {
            Some(scene) => Some((scene, scene.model(self.model.as_deref())?)),
            None => None,
        };
        let at = self.load.map(At::Load).or(self.pressure.map(At::Pressure));
        let (mut table, mut blanks) = (Sheet::new(&[CUTOFF]), Blanks::default());
        table.heads.extend(COLUMNS.iter().map(|(name, _)| (*name).to_string()));
        if asked.is_some() {
            table.heads.extend(ANSWERS.map(Quantity::column));
        }
        for &cutoff in cutoffs {
            let mut keys = keys.clone();
            keys.smooth = Some(cutoff);
            let found = keys.prepare(scan.clone());
            let found = found.and_then(|smooth| Ok((smooth.statistics(keys.estimator)?, smooth)));
            let number = |(_, number): (&str, Number)| number(&found.as_ref().ok()?.0);
            let mut numbers = COLUMNS.map(number).to_vec();
            match (found.and_then(|(s, smooth)| Ok((s.surface()?, smooth))), &asked, at) {
                (Ok((asperities, smooth)), Some((scene, model)), Some(at)) => {
                    let file = scene.file.with_scan(asperities, smooth);
                    numbers.extend(
                        answers(&file, model.id(), at).with_context(|| scene.name.clone())?,
                    );
                }
                (Err(reason), ..) => {
                    blanks.count(
                        "value",
                        std::mem::discriminant(&reason),
                        format!("{CUTOFF} {cutoff:e}: {reason}"),
                    );
                }
                _ => {}
            }
            table.add(&[], [Some(cutoff)].into_iter().chain(numbers));
        }
        blanks.texts(cutoffs.len()).for_each(|text| output::warn(Code::NoValue, text));
        if table.rows.iter().all(|row| row[1..].iter().all(|cell| cell.number().is_none())) {
            bail!("no row has a value");
        }
        Ok(table)
    }
}

/// The results of a scene; `None` where there is none.
fn answers(file: &SceneFile, id: &str, at: At) -> Result<Vec<Option<f64>>> {
    let request = Request::new(ANSWERS).at([at]);
    let response = file.model(id)?.solve(&file.scene, &request)?;
    let value = |column: &asperity::Column| column.rows[0].as_ref().ok().map(|v| v.value());
    Ok(response.columns.iter().map(value).collect())
}

/// A panel for each column, against the cut-off.
pub fn picture(table: &Sheet) -> Result<String> {
    let columns: Vec<&str> = table.heads[1..].iter().map(String::as_str).collect();
    Plot::new(&[], CUTOFF, &columns).svg(table)
}
