//! Contact tables in the words of finite-element codes.
//!
//! What is said of a code's format was read in its public manual or source. No code was run on
//! these files here.

use anyhow::{Result, bail};
use asperity::{ContactTable, Datum, Scene, Separation, SeparationUnit};

use crate::number::{exact, rounded};

/// A table, and what its comments say of it.
pub struct Head<'h> {
    pub title: &'h str,
    pub table: &'h ContactTable,
    pub scene: &'h Scene,
    /// The plane that clearances are measured from.
    pub from: Datum,
}

pub type Writer = fn(&Head<'_>) -> Result<String>;

impl Head<'_> {
    /// A separation of the table in metres, from the scene's own plane.
    fn metres(&self, sigmas: f64) -> Result<f64> {
        let separation = Separation::sigmas(sigmas);
        Ok(separation.measured_in(SeparationUnit::Metres, self.from, self.scene)?.value)
    }

    /// Relative errors of the pressure and of its slope between the nodes.
    fn errors(&self) -> [String; 2] {
        [self.table.pressure_error, self.table.stiffness_error].map(rounded)
    }

    /// Clearances \[m\] and pressures \[Pa\] for straight lines, the lightest first: from where the
    /// tangent of the first node reaches 0.
    fn lines(&self) -> Result<Vec<(f64, f64)>> {
        let end = self.table.cut_off().map(|separation| (separation, 0.0));
        let nodes = self.table.nodes.iter().rev().map(|node| (node.separation, node.pressure));
        end.into_iter().chain(nodes).map(|(s, pressure)| Ok((self.metres(s)?, pressure))).collect()
    }
}

/// Clearance, pressure and tangent.
pub fn csv(head: &Head<'_>) -> Result<String> {
    let Head { title, from, table, .. } = head;
    let ([pressure, slope], nodes) = (head.errors(), table.nodes.len());
    let mut text = format!(
        "# {title}: contact pressure against clearance
# clearance is the separation from {from}
# tangent is -dp/dclearance: cubics through both (Hermite) are continuous with
# their slope and fall all the way
# interpolation error, measured at 7 points between any two of {nodes} nodes: pressure {pressure}, tangent {slope} (relative)
clearance_m,pressure_Pa,tangent_Pa_per_m
"
    );
    for node in &table.nodes {
        let clearance = head.metres(node.separation)?;
        let [clearance, pressure, tangent] = [clearance, node.pressure, node.stiffness].map(exact);
        text += &format!("{clearance},{pressure},{tangent}\n");
    }
    Ok(text)
}

/// `*SURFACE BEHAVIOR`: pairs of pressure and overclosure.
pub fn abaqus(head: &Head<'_>) -> Result<String> {
    let Head { title, from, table, .. } = head;
    let ([pressure, slope], nodes) = (head.errors(), table.nodes.len());
    let mut text = format!(
        "** {title}: contact pressure against overclosure, in Pa and m
** overclosure = -(separation from {from})
** so that a negative overclosure is a clearance and 0 is where the nominal surfaces meet
** straight lines between {nodes} nodes: largest relative error {pressure} of the pressure, {slope} of its slope,
** measured at 7 points between any two; the slope jumps at the nodes
** the first pair is where the tangent of the second reaches 0: the model's pressure there,
** below that of the second pair, is left out; beyond the last pair the last slope goes on
** to be included after *SURFACE INTERACTION, NAME=...
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR
"
    );
    for (clearance, pressure) in head.lines()? {
        text += &format!("{}, {}\n", exact(pressure), exact(-clearance));
    }
    Ok(text)
}

/// The same for CalculiX, which reads no more than 20 characters of a number.
pub fn calculix(head: &Head<'_>) -> Result<String> {
    let Head { title, from, table, .. } = head;
    let ([pressure, slope], nodes, lines) = (head.errors(), table.nodes.len(), head.lines()?);
    let Some(&(begins, _)) = lines.first() else { bail!("a table with nodes was required") };
    let mut text = format!(
        "** {title}: contact pressure against overclosure, in Pa and m
** overclosure 0 is where the pressure begins, at a separation of {begins:.9e} m
** from {from}: put the surfaces there, or move them by that
** straight lines between {nodes} nodes: largest relative error {pressure} of the pressure, {slope} of its slope,
** measured at 7 points between any two; the slope jumps at the nodes
** to be included after *SURFACE INTERACTION, NAME=...; not yet tried with ccx
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
pub fn ansys(head: &Head<'_>) -> Result<String> {
    let Head { title, from, table, scene, .. } = head;
    let ([pressure, slope], nodes, lines) = (head.errors(), table.nodes.len(), head.lines()?);
    let Some(&(begins, _)) = lines.first() else { bail!("a table with nodes was required") };
    if lines.len() + 1 > POINTS {
        let most = POINTS - 2;
        bail!(
            "{nodes} nodes: at most {most} were required, as COMBIN39 takes no more: a larger --max-error, a narrower range or fewer nodes"
        );
    }
    let area = scene.nominal_area;
    let mut text = format!(
        "! {title}: force against deflection, in N and m, of a spring COMBIN39
! that stands for the nominal area, {area:e} m2: scale the forces to the area of each spring
! deflection 0 is where the force begins, at a separation of {begins:.9e} m
! from {from}; compression is negative
! straight lines between {nodes} nodes: largest relative error {pressure} of the force, {slope} of its slope,
! measured at 7 points between any two; beyond the ends the last slope goes on
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
