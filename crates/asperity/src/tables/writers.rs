//! Contact tables in the formats of finite-element codes.
//!
//! Formats are those of the codes' public manuals and sources. CalculiX was run on its files
//! (`tests/calculix.rs`), no other code was.

use crate::tables::contact_table::ContactTable;
use crate::tables::error::TableError;
use crate::tables::format::TableFormat;
use crate::tables::units::UnitSystem;
use crate::{Datum, Scene, Separation, SeparationUnit, shortest_digits};

impl ContactTable {
    /// The table of a scene in the format of a code, with clearances from a plane; `title` goes to
    /// its comments.
    ///
    /// # Errors
    /// [`ContactError::NoMeanPlane`](crate::ContactError::NoMeanPlane), and
    /// [`TableError::TooMany`] where the code takes fewer nodes.
    pub fn text(
        &self,
        (format, units): (TableFormat, UnitSystem),
        scene: &Scene,
        from: Datum,
        title: &str,
    ) -> Result<String, TableError> {
        let head = Head { title, table: self, scene, from, units };
        match format {
            TableFormat::Csv => csv(&head),
            TableFormat::Abaqus => abaqus(&head),
            TableFormat::Calculix => calculix(&head),
            TableFormat::Ansys => ansys(&head),
        }
    }
}

/// A table, and the facts for its comments.
pub(crate) struct Head<'h> {
    pub(crate) title: &'h str,
    pub(crate) table: &'h ContactTable,
    pub(crate) scene: &'h Scene,
    /// The plane that clearances are measured from.
    pub(crate) from: Datum,
    pub(crate) units: UnitSystem,
}

type Result<T, E = TableError> = std::result::Result<T, E>;

impl Head<'_> {
    /// A separation of the table as a length, from the scene's own plane.
    pub(crate) fn length(&self, sigmas: f64) -> Result<f64> {
        let separation = Separation::sigmas(sigmas);
        let metres = separation.measured_in(SeparationUnit::Metres, self.from, self.scene)?.value;
        Ok(self.units.length(metres))
    }

    /// Relative errors of the pressure and of its slope between the nodes.
    fn errors(&self) -> [String; 2] {
        [self.table.pressure_error, self.table.stiffness_error].map(|x| format!("{x:.3e}"))
    }

    /// Clearances and pressures for straight lines, the lightest first: from where the
    /// tangent of the first node reaches 0.
    fn lines(&self) -> Result<Vec<(f64, f64)>> {
        let end = self.table.cut_off().map(|separation| (separation, 0.0));
        let nodes = self.table.nodes.iter().rev().map(|node| (node.separation, node.pressure));
        let pair = |(s, pressure)| Ok((self.length(s)?, self.units.pressure(pressure)));
        end.into_iter().chain(nodes).map(pair).collect()
    }
}

/// Clearance, pressure and tangent.
fn csv(head: &Head<'_>) -> Result<String> {
    let Head { title, from, table, units, .. } = head;
    let ([pressure, slope], nodes) = (head.errors(), table.nodes.len());
    let (length, stress, converted) =
        (units.of_length(), units.of_pressure(), units.conversion("#"));
    let mut text = format!(
        "# {title}: contact pressure against clearance
{converted}# clearance is the separation from {from}
# tangent is -dp/dclearance: cubics through both (Hermite) are continuous with
# their slope and fall all the way
# interpolation error (relative, an upper bound) between any two of {nodes} nodes: pressure {pressure}, tangent {slope}
clearance_{length},pressure_{stress},tangent_{stress}_per_{length}
"
    );
    for node in &table.nodes {
        let (pressure, tangent) = (units.pressure(node.pressure), units.slope(node.stiffness));
        let [clearance, pressure, tangent] =
            [head.length(node.separation)?, pressure, tangent].map(shortest_digits);
        text += &format!("{clearance},{pressure},{tangent}\n");
    }
    Ok(text)
}

/// `*SURFACE BEHAVIOR`: pairs of pressure and overclosure, numbers of at most 20 characters, the
/// limit of Abaqus (recalled).
fn abaqus(head: &Head<'_>) -> Result<String> {
    let Head { title, from, table, units, .. } = head;
    let ([pressure, slope], nodes) = (head.errors(), table.nodes.len());
    let (length, stress, converted) =
        (units.of_length(), units.of_pressure(), units.conversion("**"));
    let mut text = format!(
        "** {title}: contact pressure against overclosure, in {stress} and {length}
{converted}** overclosure = -(separation from {from})
** so that a negative overclosure is a clearance and 0 is where {from} meets the counterface
** straight lines between {nodes} nodes: largest relative error {pressure} of the pressure, {slope} of its slope
** between any two; the slope jumps at the nodes
** the first pair is where the tangent of the second reaches 0: the model's pressure there,
** below that of the second pair, is left out; beyond the last pair the last slope continues
** to be included after *SURFACE INTERACTION, NAME=...
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR
"
    );
    for (clearance, pressure) in head.lines()? {
        text += &format!("{pressure:.9e}, {:.9e}\n", 0.0 - clearance);
    }
    Ok(text)
}

/// Points of a curve that ccx has room for (`materialdata_sp.f`).
const CURVE: usize = 200;

/// The same for CalculiX, which reads no more than 20 characters of a number.
fn calculix(head: &Head<'_>) -> Result<String> {
    let Head { title, from, table, units, .. } = head;
    let ([pressure, slope], nodes, lines) = (head.errors(), table.nodes.len(), head.lines()?);
    let begins = lines.first().map_or(0.0, |(clearance, _)| *clearance);
    if lines.len() > CURVE {
        return Err(TableError::TooMany { nodes, most: CURVE - 1, format: "CalculiX" });
    }
    let (length, stress, converted) =
        (units.of_length(), units.of_pressure(), units.conversion("**"));
    let mut text = format!(
        "** {title}: contact pressure against overclosure, in {stress} and {length}
{converted}** overclosure 0 is where the pressure begins, at a separation of {begins:.9e} {length}
** from {from}: put the surfaces there, or move them by that
** straight lines between {nodes} nodes: largest relative error {pressure} of the pressure, {slope} of its slope
** between any two; the slope jumps at the nodes; beyond the last pair the pressure stays
** to be included after *SURFACE INTERACTION, NAME=..., for *CONTACT PAIR, TYPE=NODE TO SURFACE:
** with SURFACE TO SURFACE, ccx 2.20 passes no force by a table
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR
"
    );
    for (clearance, pressure) in lines {
        text += &format!("{pressure:.9e}, {:.9e}\n", begins - clearance);
    }
    Ok(text)
}

/// Points that COMBIN39 takes, of which one is the origin and one lies in tension.
const POINTS: usize = 20;

/// Real constants of COMBIN39: deflections and forces, from compression to tension.
fn ansys(head: &Head<'_>) -> Result<String> {
    let Head { title, from, table, scene, units } = head;
    let ([pressure, slope], nodes, lines) = (head.errors(), table.nodes.len(), head.lines()?);
    let begins = lines.first().map_or(0.0, |(clearance, _)| *clearance);
    if lines.len() + 1 > POINTS {
        return Err(TableError::TooMany { nodes, most: POINTS - 2, format: "COMBIN39" });
    }
    let area = units.area(scene.nominal_area);
    let (length, converted) = (units.of_length(), units.conversion("!"));
    let mut text = format!(
        "! {title}: force against deflection, in N and {length}, of a spring COMBIN39
{converted}! that stands for the nominal area, {area:e} {length}2: scale the forces to the area of each spring
! deflection 0 is where the force begins, at a separation of {begins:.9e} {length}
! from {from}; compression is negative
! straight lines between {nodes} nodes: largest relative error {pressure} of the force, {slope} of its slope
! between any two; beyond the ends the last slope continues
! not yet tried with ANSYS
ASPERITY = 1 ! the number of the set of real constants
"
    );
    // In tension there is no force; a point there is asked for.
    let reach = lines.last().map_or(0.0, |(closest, _)| begins - closest);
    let mut points: Vec<(f64, f64)> =
        lines.iter().rev().map(|(c, p)| (c - begins, 0.0 - p * area)).collect();
    points.push((reach, 0.0));
    for (k, triple) in points.chunks(3).enumerate() {
        text += if k == 0 { "R,ASPERITY" } else { "RMORE" };
        for (deflection, force) in triple {
            text += &format!(",{deflection:.9e},{force:.9e}");
        }
        text.push('\n');
    }
    Ok(text)
}
