//! Contact tables from models: nodes at equal distances, or as many as an error needs.

use std::cmp::Ordering;

use asperity::bem::Bem;
use asperity::{
    At, Best, Contact, ContactError, ContactModel, Datum, Described, Finding, Model, Quantity,
    Request, SeparationUnit, linspace,
};

use super::error_bound::bounds;
use super::kinks::{kinks, pieces};
use super::{Export, Nodes, TableFormat, cubic};
use crate::subject::{Outcome, Subject};

/// More nodes than this are not added to meet an error.
const MOST_NODES: usize = 100_000;

/// Least relative error of a table of `best`.
const LEAST_OF_BEST: f64 = 1e-5;

/// One node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContactNode {
    /// d/σ_z, from the mean of the asperity heights.
    pub(crate) separation: f64,
    /// Force over nominal area \[Pa\].
    pub(crate) pressure: f64,
    /// -dp/dd \[Pa/m\], jumps of the law included.
    pub(crate) stiffness: f64,
}

/// Pressure and stiffness at nodes, and bounds of the error between them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ContactTable {
    /// Two or more ascending separations; pressure falls, pressures and stiffnesses are positive.
    pub(crate) nodes: Vec<ContactNode>,
    /// Bounds of the relative errors of pressure and stiffness between the nodes; none where each
    /// node is a solution of boundary elements.
    pub(crate) errors: Option<[f64; 2]>,
    /// The separation over σ_z at which the tangent of the last node reaches pressure 0: a table
    /// that ends there has no kink at the last node. The model's own pressure beyond the last node
    /// is below that node's.
    pub(crate) cut_off: f64,
    /// What a reader should know of the solutions at the loads of a list.
    pub(crate) notes: Vec<Finding>,
}

impl ContactTable {
    /// The table that is asked for.
    pub(crate) fn new(export: &Export<'_>) -> Outcome<Self> {
        let Export { subject, format, .. } = export;
        match export.nodes {
            Nodes::Range { ends, count, log, max_error } => {
                let builder = Builder::new(subject, *format, &[])?;
                Builder { log, ..builder }.between(ends, count, max_error)
            }
            Nodes::Loads(loads) => Builder::new(subject, *format, loads)?.at_loads(loads),
        }
    }
}

/// A model on a scene, evaluated node by node.
struct Builder {
    contact: Box<dyn Contact>,
    nominal_area: f64,
    format: TableFormat,
    /// Separations \[σ_z\] at which the force may have a kink.
    kinks: Vec<f64>,
    tolerance: f64,
    /// Whether the first nodes are at equal ratios of load.
    log: bool,
    /// Whether each node is a solution of boundary elements.
    is_solved: bool,
}

impl Builder {
    /// On the scene; boundary elements solve these loads.
    fn new(subject: &Subject<'_>, format: TableFormat, loads: &[At]) -> Result<Self, ContactError> {
        let Subject { file, model, tolerance, .. } = *subject;
        let request = Request::new([Quantity::Force, Quantity::Tangent]).within(tolerance);
        let request = request.at(loads.iter().copied());
        let is_bem = model.id() == Bem::ID;
        if is_bem && loads.is_empty() {
            return Err(ContactError::Refused {
                model: model.id().into(),
                reason: "a table with a bound of its error takes thousands of solutions; give a list of loads, or use the curve of pressure, tangent and separation at some loads".into(),
            });
        }
        Ok(Self {
            contact: model.compile(&file.scene, &request)?,
            nominal_area: file.scene.nominal_area,
            format,
            kinks: kinks(subject)?,
            tolerance: tolerance.relative(),
            log: false,
            is_solved: is_bem || model.id() == Best::<Model>::ID && !file.solved.is_empty(),
        })
    }

    /// With nodes at these loads alone.
    fn at_loads(&self, loads: &[At]) -> Outcome<ContactTable> {
        let node = |at: &At| {
            let tangent = self.contact.evaluate(Quantity::Tangent, *at)?.value();
            let pressure = at.pressure(self.contact.scene()).unwrap_or(0.0);
            self.checked(self.sigmas(*at)?, [pressure, tangent / self.nominal_area])
        };
        let mut nodes: Vec<ContactNode> = loads.iter().map(node).collect::<Outcome<_>>()?;
        nodes.sort_by(|a, b| a.separation.total_cmp(&b.separation));
        Ok(ContactTable { notes: self.contact.notes(loads), ..self.table(nodes)? })
    }

    /// From one end to the other, with `count` nodes at equal distances, and with nodes added
    /// between those until no interpolated pressure is off by more than a relative error.
    fn between(&self, ends: [At; 2], count: usize, error: Option<f64>) -> Outcome<ContactTable> {
        // Solved surfaces are interpolated too coarsely for a finer table.
        if self.contact.model() == Best::<Model>::ID
            && let Some(error) = error.filter(|error| *error < LEAST_OF_BEST)
        {
            let text = format!(
                "error is {error:e}: at least {LEAST_OF_BEST:e} was required of best, whose interval is some 10 % wide"
            );
            return Err(text.into());
        }
        let even = self.even(ends, count)?;
        let Some(error) = error else { return self.table(even) };
        asperity::positive("error", error)?;
        let mut nodes = vec![even[0]];
        // Intervals still to be looked at, the next one on top.
        let mut ahead: Vec<ContactNode> = even[1..].iter().rev().copied().collect();
        while let (Some(&from), Some(&to)) = (nodes.last(), ahead.last()) {
            if self.monotone(&from, &to) && self.errors(&from, &to, error)?[0] <= error {
                nodes.push(to);
                ahead.pop();
                continue;
            }
            let middle = 0.5 * (from.separation + to.separation);
            if nodes.len() + ahead.len() >= MOST_NODES || middle <= from.separation {
                return Err(format!(
                    "error is {error:e}, which 100000 nodes and the tolerance of the integrals cannot meet; give a larger error or a narrower range"
                )
                .into());
            }
            ahead.push(self.node(middle)?);
        }
        self.table(nodes)
    }

    fn height_std(&self) -> f64 {
        self.contact.scene().surface.asperity_height_std
    }

    fn node(&self, separation: f64) -> Outcome<ContactNode> {
        let (force, tangent) = self.contact.force_and_tangent(separation)?;
        self.checked(separation, [force, tangent].map(|e| e.value() / self.nominal_area))
    }

    /// The node of this pressure and stiffness over the area.
    fn checked(&self, separation: f64, [pressure, stiffness]: [f64; 2]) -> Outcome<ContactNode> {
        if pressure > 0.0 && stiffness > 0.0 {
            return Ok(ContactNode { separation, pressure, stiffness });
        }
        // A solver cannot use a pressure that does not fall as the surfaces part.
        Err(format!(
            "at a separation of {separation} asperity_height_std the pressure is {pressure:e} Pa and its stiffness {stiffness:e} Pa/m: both above 0 were required, at every separation of the range"
        )
        .into())
    }

    /// d/σ_z from the mean of the asperity heights.
    fn sigmas(&self, at: At) -> Result<f64, ContactError> {
        let (unit, from) = (SeparationUnit::Sigma, Datum::AsperityMean);
        let separation = self.contact.separation(at)?;
        Ok(separation.measured_in(unit, from, self.contact.scene())?.value)
    }

    /// The first nodes, by ascending separation.
    fn even(&self, mut ends: [At; 2], count: usize) -> Outcome<Vec<ContactNode>> {
        let count = count.max(2);
        let [mut first, mut last] = [self.sigmas(ends[0])?, self.sigmas(ends[1])?];
        if first > last {
            ends.reverse();
            (first, last) = (last, first);
        }
        if first.partial_cmp(&last) != Some(Ordering::Less) {
            return Err(format!(
                "both ends of the range are at a separation of {first} asperity_height_std: two different ones were required"
            )
            .into());
        }
        let mut separations = match ends.map(|at| at.load(self.contact.scene())) {
            [Some(one), Some(other)] if self.log => {
                let loads = linspace(one.ln(), other.ln(), count).into_iter();
                loads.map(|ln| self.sigmas(At::Load(ln.exp()))).collect::<Result<_, _>>()?
            }
            _ => linspace(first, last, count),
        };
        (separations[0], separations[count - 1]) = (first, last);
        separations.into_iter().map(|s| self.node(s)).collect()
    }

    fn table(&self, nodes: Vec<ContactNode>) -> Outcome<ContactTable> {
        let mut most = [0.0_f64; 2];
        for (from, to) in nodes.iter().zip(&nodes[1..]) {
            if !self.monotone(from, to) {
                let (nodes, from, to) = (nodes.len(), from.separation, to.separation);
                return Err(format!(
                    "{nodes} nodes are too few: the cubic between separations {from} and {to} is not monotone; more nodes were required"
                )
                .into());
            }
            if !self.is_solved {
                let errors = self.errors(from, to, f64::INFINITY)?;
                most = [0, 1].map(|k| most[k].max(errors[k]));
            }
        }
        let last = nodes[nodes.len() - 1];
        let cut_off = last.separation + last.pressure / last.stiffness / self.height_std();
        let errors = (!self.is_solved).then_some(most);
        Ok(ContactTable { nodes, errors, cut_off, notes: vec![] })
    }

    /// Slopes at both ends over the secant's: positive, because the pressure falls.
    fn slopes(&self, from: &ContactNode, to: &ContactNode) -> (f64, f64) {
        let width = (to.separation - from.separation) * self.height_std();
        let secant = (from.pressure - to.pressure) / width;
        (from.stiffness / secant, to.stiffness / secant)
    }

    /// Whether the interpolated curve falls everywhere.
    fn monotone(&self, from: &ContactNode, to: &ContactNode) -> bool {
        if to.pressure >= from.pressure {
            return false;
        }
        let (a, b) = self.slopes(from, to);
        !self.format.is_cubic() || cubic::is_monotone(a, b)
    }

    /// Bounds of the relative errors of pressure and stiffness between two nodes; of a pressure off
    /// by more than `enough`, no more than that.
    fn errors(&self, from: &ContactNode, to: &ContactNode, enough: f64) -> Outcome<[f64; 2]> {
        let fall = from.pressure - to.pressure;
        let (a, b) = if self.format.is_cubic() { self.slopes(from, to) } else { (1.0, 1.0) };
        let width = to.separation - from.separation;
        let secant = fall / (width * self.height_std());
        let errors = |separation: f64| {
            let t = (separation - from.separation) / width;
            let exact = self.node(separation)?;
            let pressure = from.pressure - fall * cubic::value(a, b, t);
            let stiffness = secant * cubic::slope(a, b, t);
            let errors = [pressure / exact.pressure - 1.0, stiffness / exact.stiffness - 1.0];
            Outcome::Ok(errors)
        };
        let ends = pieces(&self.kinks, from.separation, to.separation);
        // Nodes and what lies between are known to the tolerance.
        let found = bounds(errors, &ends, (4.0 * self.tolerance, enough))?;
        Ok(found.map(|error| error + 2.0 * self.tolerance))
    }
}

#[cfg(test)]
mod tests;
