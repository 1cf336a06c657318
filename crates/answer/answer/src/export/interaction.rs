//! Thermal conductance, and friction that begins elastically, in the formats of finite-element
//! codes.
//!
//! The formats follow public text: the keyword manuals of Abaqus (`*GAP CONDUCTANCE`, 2017;
//! `*FRICTION`, and the elastic stick of its theory manual, 6.6) and of CalculiX 2.17, and
//! CalculiX' sources (`gapconductances.f`, `frictions.f`, `materialdata_sp.f`). CalculiX was run on
//! the conductance (`tests/calculix.rs`), no other code was.

use asperity::joints::coefficient_of_friction;
use asperity::{At, ContactModel, Quantity, Request, shortest_digits};

use super::error_bound::bounds;
use super::kinks::{kinks, pieces};
use super::text::{check_nodes, filled};
use super::{ConductanceAgainst, ContactNode, ContactTable, Export, TableFormat};
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
    pub(crate) fn conductance_text(
        &self,
        export: &Export<'_>,
        against: ConductanceAgainst,
    ) -> Outcome<String> {
        let (calculix, units) = (export.format == TableFormat::Calculix, export.units.units());
        let by_pressure = against == ConductanceAgainst::Pressure;
        let Subject { file, model, tolerance, .. } = export.subject;
        let asked = [Quantity::Pressure, Quantity::ThermalConductancePerArea];
        let contact = model.compile(&file.scene, &Request::new(asked).within(tolerance))?;
        let of = |at: At| -> Outcome<[f64; 2]> {
            let [pressure, conductance] = asked.map(|quantity| contact.evaluate(quantity, at));
            Ok([pressure?.value(), conductance?.value()])
        };
        let nodes = self.nodes.iter().map(|node| node.separation);
        let pairs = nodes.map(|s| Ok((s, of(s.into())?))).collect::<Outcome<Vec<Conducting>>>()?;
        let [error, last_error] = self.line_errors(export, &of, &pairs, by_pressure)?;
        if calculix {
            check_nodes(pairs.len(), MOST_PAIRS - 1, "*GAP CONDUCTANCE of CalculiX")?;
        }
        let blanks = [
            ("variable", against.name()),
            ("unit", units.conductance),
            ("unit_of_variable", if by_pressure { units.pressure } else { units.length }),
            ("nodes", &pairs.len().to_string()),
            ("error", &format!("{error:.3e}")),
            ("last_error", &format!("{last_error:.3e}")),
            ("probes", &PROBES.to_string()),
            ("converted", &units.conversion(1, "**")),
        ];
        let mut text = filled(include_str!("forms/conductance.txt"), &blanks);
        text += match (calculix, by_pressure) {
            (true, _) => include_str!("forms/conductance_calculix.txt"),
            (_, true) => include_str!("forms/conductance_pressure.txt"),
            _ => include_str!("forms/conductance_clearance.txt"),
        };
        let mut lines = vec![];
        for (separation, [pressure, conductance]) in pairs {
            let place =
                if by_pressure { pressure / units.pascals } else { export.length(separation)? };
            lines.push((place, conductance / units.watts));
        }
        let end = if by_pressure { 0.0 } else { export.length(self.cut_off)? };
        lines.push((end, 0.0));
        if by_pressure {
            lines.reverse();
        }
        let temperature = if calculix { ", 273." } else { "" };
        for (place, conductance) in lines {
            text += &format!("{conductance:.9e}, {place:.9e}{temperature}\n");
        }
        Ok(text)
    }

    /// The largest relative errors of the lines between the nodes, and of the line to the pair
    /// without conductance, of which the model knows nothing.
    fn line_errors(
        &self,
        export: &Export<'_>,
        of: &dyn Fn(At) -> Outcome<[f64; 2]>,
        pairs: &[Conducting],
        by_pressure: bool,
    ) -> Outcome<[f64; 2]> {
        let kinks = kinks(&export.subject)?;
        let noise = 4.0 * export.subject.tolerance.relative();
        let [mut error, mut last_error] = [0.0_f64; 2];
        for pair in pairs.windows(2) {
            let [(s0, [p0, h0]), (s1, [p1, h1])] = [pair[0], pair[1]];
            let errors = |separation: f64| {
                let [p, h] = of(separation.into())?;
                let t = match by_pressure {
                    true => (p - p0) / (p1 - p0),
                    false => (separation - s0) / (s1 - s0),
                };
                Outcome::Ok([(h0 + t * (h1 - h0)) / h - 1.0])
            };
            let ends = pieces(&kinks, s0, s1);
            let [found] = bounds(errors, &ends, (noise, f64::INFINITY))?;
            error = error.max(found + 0.5 * noise);
        }
        if let Some(&(s0, [p0, h0])) = pairs.last() {
            for t in (1..=PROBES).map(|k| k as f64 / (PROBES + 1) as f64) {
                let at = match by_pressure {
                    true => At::Pressure((1.0 - t) * p0),
                    false => (s0 + t * (self.cut_off - s0)).into(),
                };
                let [_, h] = of(at)?;
                last_error = last_error.max(((1.0 - t) * h0 / h - 1.0).abs());
            }
        }
        Ok([error, last_error])
    }

    /// Coulomb's friction with the model's tangential stiffness in stick, as `*FRICTION`: in Abaqus
    /// as an elastic slip, in CalculiX as a stick slope, both at the largest pressure of the table.
    pub(crate) fn friction_text(&self, export: &Export<'_>, friction: f64) -> Outcome<String> {
        coefficient_of_friction(friction)?;
        let units = export.units.units();
        let Subject { file, model, tolerance, .. } = export.subject;
        let stiffness = Quantity::TangentialStiffness;
        let contact = model.compile(&file.scene, &Request::new([stiffness]).within(tolerance))?;
        let of = |node: &ContactNode| -> Outcome<[f64; 3]> {
            let slope = contact.evaluate(stiffness, node.separation)?.value();
            let slope = slope / file.scene.nominal_area;
            let slip = friction * node.pressure / slope * units.per_metre;
            Ok([node.pressure / units.pascals, units.slope(slope), slip])
        };
        let [first, .., last] = &self.nodes[..] else { return Ok(String::new()) };
        let ([pressure, slope, slip], [light, light_slope, light_slip]) = (of(first)?, of(last)?);
        let (form, shown) = match export.format {
            TableFormat::Abaqus => {
                (include_str!("forms/friction_abaqus.txt"), shortest_digits(friction))
            }
            _ => (include_str!("forms/friction_calculix.txt"), format!("{friction:.9e}")),
        };
        let rounded = [pressure, slope, slip, light, light_slope, light_slip];
        let names = ["pressure", "slope", "slip", "light", "light_slope", "light_slip"];
        let rounded = rounded.map(|number| format!("{number:.3e}"));
        let [exact_slope, exact_slip] = [slope, slip].map(|number| format!("{number:.9e}"));
        let mut blanks = vec![
            ("stress", units.pressure),
            ("length", units.length),
            ("exact_slope", &exact_slope),
            ("exact_slip", &exact_slip),
            ("friction", &shown),
        ];
        blanks.extend(names.into_iter().zip(rounded.iter().map(|text| &**text)));
        Ok(filled(form, &blanks))
    }
}
