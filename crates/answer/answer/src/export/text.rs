//! Contact tables in the formats of finite-element codes.
//!
//! Formats follow the codes' public manuals and sources. CalculiX was run on its files
//! (`tests/calculix.rs`), no other code was. The heads stand in `forms`.

use asperity::{ContactError, Separation, SeparationUnit, shortest_digits};

use super::{ContactTable, Export, TableFormat};
use crate::subject::Outcome;

/// Points of a curve that ccx has room for (`materialdata_sp.f`).
const CURVE: usize = 200;

impl ContactTable {
    /// The table in its format, with clearances from the plane of the scene.
    pub(crate) fn text(&self, export: &Export<'_>) -> Outcome<String> {
        let (units, heat) = (export.units, export.conductance);
        let (form, sign) = match export.format {
            TableFormat::Csv | TableFormat::Film => (include_str!("forms/csv.txt"), "#"),
            TableFormat::Abaqus => (include_str!("forms/abaqus.txt"), "**"),
            TableFormat::Calculix if heat => (include_str!("forms/calculix_heat.txt"), "**"),
            TableFormat::Calculix => (include_str!("forms/calculix.txt"), "**"),
        };
        if export.format == TableFormat::Calculix {
            check_nodes(self.nodes.len(), CURVE - 1, "CalculiX")?;
        }
        let lines = self.lines(export)?;
        let ((begins, _), (last, pressure)) = (lines[0], lines[lines.len() - 1]);
        let mut text = filled(
            form,
            &[
                ("title", &export.title()),
                ("converted", &(export.origin(sign, &self.nodes) + &units.conversion(0, sign))),
                ("from", export.subject.file.plane()),
                ("nodes", &self.nodes.len().to_string()),
                ("errors", &self.errors_in_words()),
                ("length", units.length),
                ("stress", units.pressure),
                ("begins", &format!("{begins:.9e}")),
                ("stiffness", &format!("{:.9e}", pressure / (begins - last))),
            ],
        );
        match export.format {
            TableFormat::Csv | TableFormat::Film => {
                for node in &self.nodes {
                    let clearance = export.length(node.separation)?;
                    let (pressure, tangent) = (node.pressure / units.pascals, node.stiffness);
                    let numbers = [clearance, pressure, units.slope(tangent)].map(shortest_digits);
                    text += &(numbers.join(",") + "\n");
                }
            }
            // Numbers of at most 20 characters: the limit of Abaqus (recalled) and CalculiX.
            TableFormat::Abaqus | TableFormat::Calculix => {
                let (onset, comment) = match export.format {
                    TableFormat::Abaqus => (0.0, ""),
                    _ => (begins, if heat { "** " } else { "" }),
                };
                for (clearance, pressure) in lines {
                    text += &format!("{comment}{pressure:.9e}, {:.9e}\n", onset - clearance);
                }
            }
        }
        Ok(text)
    }

    /// How far the lines between the nodes are off.
    fn errors_in_words(&self) -> String {
        let Some([pressure, slope]) = self.errors else {
            return "no bound of the error is known".into();
        };
        format!("largest relative error {pressure:.3e} of the pressure, {slope:.3e} of its slope")
    }

    /// Clearances and pressures for straight lines, the lightest first: from where the tangent of
    /// the first node reaches 0.
    fn lines(&self, export: &Export<'_>) -> Outcome<Vec<(f64, f64)>> {
        let pascals = export.units.pascals;
        let nodes = self.nodes.iter().rev().map(|node| (node.separation, node.pressure));
        let pair = |(s, pressure)| Ok((export.length(s)?, pressure / pascals));
        [(self.cut_off, 0.0)].into_iter().chain(nodes).map(pair).collect()
    }
}

impl Export<'_> {
    /// A separation over σ_z as a length, from the scene's own plane, in the units of the table.
    pub(crate) fn length(&self, sigmas: f64) -> Result<f64, ContactError> {
        let metres = self.subject.place(Separation::sigmas(sigmas), SeparationUnit::Metres)?;
        Ok(metres * self.units.per_metre)
    }
}

/// A form with its blanks, `{name}`, filled in.
pub(crate) fn filled(form: &str, blanks: &[(&str, &str)]) -> String {
    let fill =
        |text: String, (name, value): &(&str, &str)| text.replace(&format!("{{{name}}}"), value);
    blanks.iter().fold(form.into(), fill)
}

/// Refuses more nodes than a code takes.
pub(crate) fn check_nodes(nodes: usize, most: usize, code: &str) -> Outcome {
    match nodes <= most {
        true => Ok(()),
        false => Err(format!("{nodes} nodes: {code} allows {most}; increase the error, narrow the range or give fewer nodes").into()),
    }
}
