//! Thermal conductance, and friction that begins elastically, in the formats of finite-element
//! codes.
//!
//! The formats are those of public text: the keyword manuals of Abaqus (`*GAP CONDUCTANCE`, 2017;
//! `*FRICTION`, and the elastic stick of its theory manual, 6.6) and of CalculiX 2.17, and
//! CalculiX' sources (`gapconductances.f`, `frictions.f`, `materialdata_sp.f`). CalculiX was run on
//! the conductance (`tests/calculix.rs`), no other code was.

use asperity::joints::coefficient_of_friction;
use asperity::{At, ContactModel, Quantity, Request, shortest_digits};

use super::error_bound::bounds;
use super::kinks::{kinks, pieces};
use super::text::check_nodes;
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
        let error = self.line_error(export, &of, &pairs, by_pressure)?;
        let last_error = self.last_error(&of, &pairs, by_pressure)?;
        let nodes = pairs.len();
        if calculix {
            check_nodes(nodes, MOST_PAIRS - 1, "*GAP CONDUCTANCE of CalculiX")?;
        }
        let named = against.name();
        let mut text = format!(
            "** thermal conductance against {named}, in {} and {}, of contacts in vacuum that are
** far from each other; straight lines between {nodes} nodes: largest relative error {error:.3e},
** and {last_error:.3e} at {PROBES} points of the line from the lightest of them to no conductance
",
            units.conductance,
            if by_pressure { units.pressure } else { units.length }
        );
        text += &units.conversion(1, "**");
        text += match (calculix, by_pressure) {
            (true, _) => "** constant beyond the last pair; the third number is a temperature, and of no effect
** with the table above no heat flows in ccx 2.20, which knows the pressure with
** *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR and SURFACE TO SURFACE only: replace the table by
** that if heat is needed
*GAP CONDUCTANCE
",
            (_, true) => "** not verified: what Abaqus does beyond the last pair, and at clearances that carry pressure
*GAP CONDUCTANCE, PRESSURE
",
            _ => "** clearances as in the overclosures above, with the other sign; beyond the last there is none;
** not verified: what Abaqus does at clearances below 0
*GAP CONDUCTANCE
",
        };
        let mut lines = vec![];
        for (separation, [pressure, conductance]) in pairs {
            let place =
                if by_pressure { pressure / units.pascals } else { export.length(separation)? };
            lines.push((place, conductance / units.watts));
        }
        let end = match (by_pressure, self.cut_off()) {
            (false, Some(separation)) => export.length(separation)?,
            _ => 0.0,
        };
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

    /// The largest relative error of the lines between the nodes.
    fn line_error(
        &self,
        export: &Export<'_>,
        of: &dyn Fn(At) -> Outcome<[f64; 2]>,
        pairs: &[Conducting],
        by_pressure: bool,
    ) -> Outcome<f64> {
        let kinks = kinks(&export.subject)?;
        let noise = 4.0 * export.subject.tolerance.relative();
        let mut error = 0.0_f64;
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
        Ok(error)
    }

    /// The relative error of the line to the pair without conductance, of which the model knows
    /// nothing.
    fn last_error(
        &self,
        of: &dyn Fn(At) -> Outcome<[f64; 2]>,
        pairs: &[Conducting],
        by_pressure: bool,
    ) -> Outcome<f64> {
        let mut error = 0.0_f64;
        if let (Some((s0, [p0, h0])), Some(s1)) = (pairs.last().copied(), self.cut_off()) {
            for t in (1..=PROBES).map(|k| k as f64 / (PROBES + 1) as f64) {
                let at = match by_pressure {
                    true => At::Pressure((1.0 - t) * p0),
                    false => (s0 + t * (s1 - s0)).into(),
                };
                let [_, h] = of(at)?;
                error = error.max(((1.0 - t) * h0 / h - 1.0).abs());
            }
        }
        Ok(error)
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
        let (stress, length) = (units.pressure, units.length);
        let from = format!(
            "** friction with the stiffness in stick at {pressure:.3e} {stress}, {slope:.3e} {stress}/{length}; the asperities' own
** curve bends from the beginning on, up to the same limit\n"
        );
        Ok(match export.format {
            TableFormat::Abaqus => format!(
                "{from}** Abaqus/Standard takes the stiffness as mu p over the elastic slip, which is {slip:.3e} {length} there
** and {light_slip:.3e} {length} at {light:.3e} {stress}; for Abaqus/Explicit, in its place (one stiffness for all pressures):
** *FRICTION, SHEAR TRACTION SLOPE={slope:.9e}
*FRICTION, ELASTIC SLIP={slip:.9e}
{}
",
                shortest_digits(friction)
            ),
            _ => format!(
                "{from}** ccx has one stick slope for all pressures; at {light:.3e} {stress} it would be {light_slope:.3e} {stress}/{length}
*FRICTION
{friction:.9e}, {slope:.9e}
"
            ),
        })
    }
}
