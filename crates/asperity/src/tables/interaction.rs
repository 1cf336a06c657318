//! Thermal conductance, and friction that begins elastically, in the formats of finite-element
//! codes.
//!
//! The formats are those of public text: the keyword manuals of Abaqus (`*GAP CONDUCTANCE`, 2017;
//! `*FRICTION`, and the elastic stick of its theory manual, 6.6) and of CalculiX 2.17, and
//! CalculiX' sources (`gapconductances.f`, `frictions.f`, `materialdata_sp.f`). CalculiX was run on
//! the conductance (`tests/calculix.rs`), no other code was.

use crate::tables::contact_table::{ContactNode, ContactTable};
use crate::tables::error::TableError;
use crate::tables::error_bound::bounds;
use crate::tables::format::TableFormat;
use crate::tables::kinks::{kinks, pieces};
use crate::tables::units::UnitSystem;
use crate::tables::writers::Head;
use crate::{
    At, ContactError, ContactModel, Datum, Quantity, Request, Scene, Tolerance, shortest_digits,
};

/// Pairs of `*GAP CONDUCTANCE` that ccx 2.20 has room for between surfaces: with more it conducts
/// wrongly, without a message.
const MOST_PAIRS: usize = 40;
/// Points at which the line to the end of the conductance is compared with the model.
const PROBES: usize = 7;

/// The variable of a table of conductance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ConductanceAgainst {
    /// The contact pressure.
    Pressure,
    /// The clearance, where the code knows such a table.
    Clearance,
}

type Result<T, E = TableError> = std::result::Result<T, E>;

impl TableFormat {
    /// Refuses what [`ContactTable::conductance_text`] has no form for, before a table is made.
    ///
    /// # Errors
    /// [`TableError::NoSuchTable`] for formats other than Abaqus and CalculiX, and for clearances
    /// in CalculiX.
    pub fn check_conductance(self, against: ConductanceAgainst) -> Result<()> {
        let (what, known) = match (self, against) {
            (Self::Abaqus, _) | (Self::Calculix, ConductanceAgainst::Pressure) => return Ok(()),
            (Self::Calculix, _) => ("conductance against clearance", "abaqus"),
            _ => ("conductance", "abaqus or calculix"),
        };
        Err(TableError::NoSuchTable { format: self, what, known })
    }

    /// Refuses what [`ContactTable::friction_text`] has no form for, before a table is made.
    ///
    /// # Errors
    /// [`TableError::NoSuchTable`] for formats other than Abaqus and CalculiX.
    pub fn check_friction(self) -> Result<()> {
        match self {
            Self::Abaqus | Self::Calculix => Ok(()),
            _ => {
                let (what, known) = ("friction", "abaqus or calculix");
                Err(TableError::NoSuchTable { format: self, what, known })
            }
        }
    }
}

impl ContactTable {
    /// The nodes of the largest and of the smallest pressure.
    fn ends(&self) -> Result<[&ContactNode; 2]> {
        let pressed = |node: &ContactNode| node.pressure > 0.0;
        match &self.nodes[..] {
            [first, .., last]
                if self.nodes.iter().all(pressed) && first.pressure > last.pressure =>
            {
                Ok([first, last])
            }
            nodes => Err(TableError::TooFew { nodes: nodes.len() }),
        }
    }

    /// Thermal conductance per nominal area at the nodes of this table of a model on a
    /// scene, as `*GAP CONDUCTANCE`, for straight lines. It begins with 0 where the pressure does.
    ///
    /// # Errors
    /// [`TableError::NoSuchTable`] for formats other than Abaqus and CalculiX, and for clearances
    /// in CalculiX; those of [`Quantity::ThermalConductance`].
    pub fn conductance_text(
        &self,
        (format, units): (TableFormat, UnitSystem),
        against: ConductanceAgainst,
        (model, scene, from): (&dyn ContactModel, &Scene, Datum),
        tolerance: Tolerance,
    ) -> Result<String> {
        format.check_conductance(against)?;
        let calculix = format == TableFormat::Calculix;
        let by_pressure = against == ConductanceAgainst::Pressure;
        let asked = [Quantity::Pressure, Quantity::ThermalConductancePerArea];
        let contact = model.compile(scene, &Request::new(asked).within(tolerance))?;
        let of = |at: At| -> Result<[f64; 2], ContactError> {
            let [pressure, conductance] = asked.map(|quantity| contact.evaluate(quantity, at));
            Ok([pressure?.value(), conductance?.value()])
        };
        let head = Head { title: "", table: self, scene, from, units };
        self.ends()?;
        let mut pairs = vec![];
        for node in &self.nodes {
            pairs.push((node.separation, of(node.separation.into())?));
        }
        let few = TableError::TooFew { nodes: pairs.len() };
        // Without pressure or conductance there is nothing to be off from.
        let off = |line: f64, h: f64| Some(line / h - 1.0).filter(|off| off.is_finite());
        let (kinks, noise) = (kinks(model, scene, tolerance)?, 4.0 * tolerance.relative());
        let mut error = 0.0_f64;
        for pair in pairs.windows(2) {
            let [(s0, [p0, h0]), (s1, [p1, h1])] = [pair[0], pair[1]];
            let errors = |separation: f64| {
                let [p, h] = of(separation.into())?;
                let t = match by_pressure {
                    true => (p - p0) / (p1 - p0),
                    false => (separation - s0) / (s1 - s0),
                };
                Ok::<_, TableError>([off(h0 + t * (h1 - h0), h).ok_or(few.clone())?])
            };
            let ends = pieces(&kinks, s0, s1);
            let [found] = bounds(errors, &ends, (noise, f64::INFINITY))?;
            error = error.max(found + 0.5 * noise);
        }
        // The line to the pair without conductance, of which the model knows nothing.
        let mut last_error = 0.0_f64;
        if let (Some((s0, [p0, h0])), Some(s1)) = (pairs.last().copied(), self.cut_off()) {
            for t in (1..=PROBES).map(|k| k as f64 / (PROBES + 1) as f64) {
                let at = match by_pressure {
                    true => At::Pressure((1.0 - t) * p0),
                    false => (s0 + t * (s1 - s0)).into(),
                };
                let [_, h] = of(at)?;
                last_error = last_error.max(off((1.0 - t) * h0, h).ok_or(few.clone())?.abs());
            }
        }
        if calculix && pairs.len() >= MOST_PAIRS {
            let (nodes, most) = (pairs.len(), MOST_PAIRS - 1);
            return Err(TableError::TooMany {
                nodes,
                most,
                format: "*GAP CONDUCTANCE of CalculiX",
            });
        }
        let (nodes, named) = (pairs.len(), if by_pressure { "pressure" } else { "clearance" });
        let mut text = format!(
            "** thermal conductance against {named}, in {} and {}, of contacts in vacuum that are
** far from each other; straight lines between {nodes} nodes: largest relative error {error:.3e},
** and {last_error:.3e} at {PROBES} points of the line from the lightest of them to no conductance
",
            units.of_conductance(),
            if by_pressure { units.of_pressure() } else { units.of_length() }
        );
        text += &units.conductance_conversion("**");
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
                if by_pressure { units.pressure(pressure) } else { head.length(separation)? };
            lines.push((place, units.conductance(conductance)));
        }
        let end = match (by_pressure, self.cut_off()) {
            (false, Some(separation)) => head.length(separation)?,
            _ => 0.0,
        };
        lines.push((end, 0.0));
        if by_pressure {
            lines.reverse();
        }
        for (place, conductance) in lines {
            text += &if calculix {
                format!("{conductance:.9e}, {place:.9e}, 273.\n")
            } else {
                format!("{conductance:.9e}, {place:.9e}\n")
            };
        }
        Ok(text)
    }

    /// Coulomb's friction with the model's tangential stiffness in stick, as `*FRICTION`: in Abaqus
    /// as an elastic slip, in CalculiX as a stick slope, both at the largest pressure of the table.
    ///
    /// # Errors
    /// [`TableError::NoSuchTable`] for formats other than Abaqus and CalculiX;
    /// [`ContactError::OutOfRange`] unless μ is above 0 and at most 10; those of
    /// [`Quantity::TangentialStiffness`].
    pub fn friction_text(
        &self,
        (format, units): (TableFormat, UnitSystem),
        friction: f64,
        (model, scene): (&dyn ContactModel, &Scene),
        tolerance: Tolerance,
    ) -> Result<String> {
        format.check_friction()?;
        crate::joints::coefficient_of_friction(friction)?;
        let stiffness = Quantity::TangentialStiffness;
        let contact = model.compile(scene, &Request::new([stiffness]).within(tolerance))?;
        let of = |node: &ContactNode| -> Result<_> {
            let slope = contact.evaluate(stiffness, node.separation)?.value() / scene.nominal_area;
            let slip = units.length(friction * node.pressure / slope);
            Ok((units.pressure(node.pressure), units.slope(slope), slip))
        };
        let [first, last] = self.ends()?;
        let ((pressure, slope, slip), (light, light_slope, light_slip)) = (of(first)?, of(last)?);
        let (stress, length) = (units.of_pressure(), units.of_length());
        let from = format!(
            "** friction with the stiffness in stick at {pressure:.3e} {stress}, {slope:.3e} {stress}/{length}; the asperities' own
** curve bends from the beginning on, up to the same limit\n"
        );
        Ok(match format {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Interface, Interpolation, KogutEtsion, Surface};

    #[test]
    fn tables_without_a_range_are_refused() {
        let mut interface = Interface::new(116e9, 0.31, 1.12e9);
        interface.equivalent_shear_modulus = Some(41e9);
        interface.thermal_conductivity = Some(50.0);
        let scene = Scene::new(interface, Surface::new(3.59e-4, 1.11e8, 1e-6), 3e-5);
        let (model, tolerance) = (KogutEtsion, Tolerance::default());
        let lines = Interpolation::Linear;
        let whole = ContactTable::even(&model, &scene, tolerance, (0.0, 4.0, 9), lines).unwrap();
        let (abaqus, by) = (TableFormat::Abaqus, ConductanceAgainst::Pressure);
        let mut same = whole.clone();
        same.nodes[8] = same.nodes[0];
        let mut nan = whole.clone();
        nan.nodes[4].pressure = f64::NAN;
        let none = ContactTable { nodes: vec![], ..whole.clone() };
        let one = ContactTable { nodes: whole.nodes[..1].to_vec(), ..whole.clone() };
        for (table, begins) in
            [(none, "0 nodes: two"), (one, "1 nodes: two"), (same, "9 nodes"), (nan, "9 nodes")]
        {
            let refused =
                table.friction_text((abaqus, UnitSystem::Si), 0.2, (&model, &scene), tolerance);
            assert!(refused.unwrap_err().to_string().starts_with(begins));
            let asked = (&model as &dyn ContactModel, &scene, Datum::AsperityMean);
            let refused = table.conductance_text((abaqus, UnitSystem::Si), by, asked, tolerance);
            assert!(refused.unwrap_err().to_string().starts_with(begins));
        }
    }
}
