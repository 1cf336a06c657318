//! Thermal conductance against pressure in the formats of finite-element codes.
//!
//! The formats follow public text: the keyword manuals of Abaqus (`*GAP CONDUCTANCE`, 2017) and of
//! CalculiX 2.17, and CalculiX' sources (`gapconductances.f`, `materialdata_sp.f`). CalculiX was
//! run on them (`tests/calculix.rs`), no other code was.

use asperity::{At, ContactModel, Quantity, Request};

use super::error_bound::bounds;
use super::kinks::{kinks, pieces};
use super::text::{check_nodes, filled};
use super::{ContactTable, Export, TableFormat};
use crate::subject::{Outcome, Subject};

/// Pairs of `*GAP CONDUCTANCE` that ccx 2.20 has room for between surfaces: with more it conducts
/// wrongly, without a message.
const MOST_PAIRS: usize = 40;
/// Points at which the line to the end of the conductance is compared with the model.
const PROBES: usize = 7;

/// A node: separation over σ_z, pressure \[Pa\] and conductance \[W/(m² K)\].
type Conducting = (f64, [f64; 2]);

impl ContactTable {
    /// Thermal conductance per nominal area at the nodes of this table, as `*GAP CONDUCTANCE`, for
    /// straight lines. It begins with 0 where the pressure does.
    pub(crate) fn conductance_text(&self, export: &Export<'_>) -> Outcome<String> {
        let (calculix, units) = (export.format == TableFormat::Calculix, export.units);
        let Subject { file, model, tolerance, .. } = export.subject;
        let asked = [Quantity::Pressure, Quantity::ThermalConductancePerArea];
        let contact = model.compile(&file.scene, &Request::new(asked).within(tolerance))?;
        let of = |at: At| -> Outcome<[f64; 2]> {
            let [pressure, conductance] = asked.map(|quantity| contact.evaluate(quantity, at));
            Ok([pressure?.value(), conductance?.value()])
        };
        let nodes = self.nodes.iter().map(|node| node.separation);
        let pairs = nodes.map(|s| Ok((s, of(s.into())?))).collect::<Outcome<Vec<Conducting>>>()?;
        let [error, last_error] = line_errors(export, &of, &pairs)?;
        if calculix {
            check_nodes(pairs.len(), MOST_PAIRS - 1, "*GAP CONDUCTANCE of CalculiX")?;
        }
        let blanks = [
            ("unit", units.conductance),
            ("stress", units.pressure),
            ("nodes", &pairs.len().to_string()),
            ("error", &format!("{error:.3e}")),
            ("last_error", &format!("{last_error:.3e}")),
            ("probes", &PROBES.to_string()),
            ("converted", &units.conversion(1, "**")),
        ];
        let mut text = filled(include_str!("forms/conductance.txt"), &blanks);
        let (form, temperature) = match calculix {
            true => (include_str!("forms/conductance_calculix.txt"), ", 273."),
            false => (include_str!("forms/conductance_abaqus.txt"), ""),
        };
        text += form;
        let lightest_first = pairs.iter().rev().map(|(_, numbers)| *numbers);
        for [pressure, conductance] in [[0.0; 2]].into_iter().chain(lightest_first) {
            let [pressure, conductance] = [pressure / units.pascals, conductance / units.watts];
            text += &format!("{conductance:.9e}, {pressure:.9e}{temperature}\n");
        }
        Ok(text)
    }
}

/// The largest relative errors of the lines between the nodes, and of the line to the pair without
/// conductance, of which the model knows nothing.
fn line_errors(
    export: &Export<'_>,
    of: &dyn Fn(At) -> Outcome<[f64; 2]>,
    pairs: &[Conducting],
) -> Outcome<[f64; 2]> {
    let kinks = kinks(&export.subject)?;
    let noise = 4.0 * export.subject.tolerance.relative();
    let [mut error, mut last_error] = [0.0_f64; 2];
    for pair in pairs.windows(2) {
        let [(s0, [p0, h0]), (s1, [p1, h1])] = [pair[0], pair[1]];
        let errors = |separation: f64| {
            let [p, h] = of(separation.into())?;
            let t = (p - p0) / (p1 - p0);
            Outcome::Ok([(h0 + t * (h1 - h0)) / h - 1.0])
        };
        let ends = pieces(&kinks, s0, s1);
        let [found] = bounds(errors, &ends, (noise, f64::INFINITY))?;
        error = error.max(found + 0.5 * noise);
    }
    if let Some(&(_, [p0, h0])) = pairs.last() {
        for t in (1..=PROBES).map(|k| k as f64 / (PROBES + 1) as f64) {
            let [_, h] = of(At::Pressure((1.0 - t) * p0))?;
            last_error = last_error.max(((1.0 - t) * h0 / h - 1.0).abs());
        }
    }
    Ok([error, last_error])
}
