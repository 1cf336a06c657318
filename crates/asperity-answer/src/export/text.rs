//! Contact tables in the formats of finite-element codes.
//!
//! Formats are those of the codes' public manuals and sources. CalculiX was run on its files
//! (`tests/calculix.rs`), no other code was.

use asperity::{ContactError, Datum, Separation, SeparationUnit, shortest_digits};

use super::units::Units;
use super::{ContactTable, Export, TableFormat};
use crate::subject::Outcome;

impl ContactTable {
    /// The table in its format, with clearances from the plane of the scene; `title` goes to its
    /// comments.
    pub(crate) fn text(&self, export: &Export<'_>, title: &str) -> Outcome<String> {
        let head = Head {
            title,
            from: export.subject.file.separation_from,
            table: self,
            units: export.units.units(),
            export,
            nodes: self.nodes.len(),
            pressure: format!("{:.3e}", self.pressure_error),
            slope: format!("{:.3e}", self.stiffness_error),
        };
        match export.format {
            TableFormat::Csv => csv(&head),
            TableFormat::Abaqus => abaqus(&head),
            TableFormat::Calculix => calculix(&head),
            TableFormat::Ansys => ansys(&head),
        }
    }
}

impl Export<'_> {
    /// A separation over σ_z as a length, from the scene's own plane, in the units of the table.
    pub(crate) fn length(&self, sigmas: f64) -> Result<f64, ContactError> {
        let metres = self.subject.place(Separation::sigmas(sigmas), SeparationUnit::Metres)?;
        Ok(metres * self.units.units().per_metre)
    }
}

/// A table, and the facts for its comments.
struct Head<'h> {
    title: &'h str,
    /// The plane that clearances are measured from.
    from: Datum,
    table: &'h ContactTable,
    units: &'static Units,
    export: &'h Export<'h>,
    nodes: usize,
    /// Relative errors of the pressure and of its slope between the nodes.
    pressure: String,
    slope: String,
}

impl Head<'_> {
    /// Clearances and pressures for straight lines, the lightest first: from where the
    /// tangent of the first node reaches 0.
    fn lines(&self) -> Outcome<Vec<(f64, f64)>> {
        let end = self.table.cut_off().map(|separation| (separation, 0.0));
        let nodes = self.table.nodes.iter().rev().map(|node| (node.separation, node.pressure));
        let pair = |(s, pressure)| Ok((self.export.length(s)?, pressure / self.units.pascals));
        end.into_iter().chain(nodes).map(pair).collect()
    }
}

/// Clearance, pressure and tangent.
fn csv(head: &Head<'_>) -> Outcome<String> {
    let Head { title, from, table, units, export, nodes, pressure, slope } = head;
    let (length, stress, converted) = (units.length, units.pressure, units.conversion(0, "#"));
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
        let (pressure, tangent) = (node.pressure / units.pascals, units.slope(node.stiffness));
        let [clearance, pressure, tangent] =
            [export.length(node.separation)?, pressure, tangent].map(shortest_digits);
        text += &format!("{clearance},{pressure},{tangent}\n");
    }
    Ok(text)
}

/// `*SURFACE BEHAVIOR`: pairs of pressure and overclosure, numbers of at most 20 characters, the
/// limit of Abaqus (recalled).
fn abaqus(head: &Head<'_>) -> Outcome<String> {
    let Head { title, from, units, nodes, pressure, slope, .. } = head;
    let (length, stress, converted) = (units.length, units.pressure, units.conversion(0, "**"));
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

/// Refuses more nodes than a code takes.
pub(crate) fn check_nodes(nodes: usize, most: usize, code: &str) -> Outcome {
    match nodes <= most {
        true => Ok(()),
        false => Err(format!("{nodes} nodes: {code} allows {most}; increase the error, narrow the range or give fewer nodes").into()),
    }
}

/// Points of a curve that ccx has room for (`materialdata_sp.f`).
const CURVE: usize = 200;

/// The same for CalculiX, which reads no more than 20 characters of a number.
fn calculix(head: &Head<'_>) -> Outcome<String> {
    let Head { title, from, units, nodes, pressure, slope, .. } = head;
    let lines = head.lines()?;
    let begins = lines.first().map_or(0.0, |(clearance, _)| *clearance);
    check_nodes(*nodes, CURVE - 1, "CalculiX")?;
    let (length, stress, converted) = (units.length, units.pressure, units.conversion(0, "**"));
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
fn ansys(head: &Head<'_>) -> Outcome<String> {
    let Head { title, from, units, export, nodes, pressure, slope, .. } = head;
    let lines = head.lines()?;
    let begins = lines.first().map_or(0.0, |(clearance, _)| *clearance);
    check_nodes(*nodes, POINTS - 2, "COMBIN39")?;
    let area = export.subject.file.scene.nominal_area * units.per_metre.powi(2);
    let (length, converted) = (units.length, units.conversion(0, "!"));
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
