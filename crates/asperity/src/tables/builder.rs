//! Contact tables from models: nodes at equal distances, or as many as an error needs.

use std::cmp::Ordering;

use crate::recommended::BEM;
use crate::tables::contact_table::{ContactNode, ContactTable};
use crate::tables::cubic;
use crate::tables::error::TableError;
use crate::tables::error_bound::bounds;
use crate::tables::format::Interpolation;
use crate::tables::kinks::{kinks, pieces};
use crate::{
    At, Contact, ContactError, ContactModel, Datum, Quantity, Request, Scene, SeparationUnit,
    Tolerance, linspace,
};

/// More nodes than this are not added to meet an error.
const MOST_NODES: usize = 100_000;

impl ContactTable {
    /// From one separation, load or pressure to another, larger one, with `count` ≥ 2 nodes at
    /// equal distances of separation.
    ///
    /// # Errors
    /// [`TableError`]; the integrals are done to `tolerance`.
    pub fn even<A: Into<At>>(
        model: &dyn ContactModel,
        scene: &Scene,
        tolerance: Tolerance,
        (first, last, count): (A, A, usize),
        interpolation: Interpolation,
    ) -> Result<Self, TableError> {
        let builder = Builder::new(model, scene, tolerance, interpolation)?;
        builder.table(builder.even(first.into(), last.into(), count)?)
    }

    /// As [`even`](Self::even), with nodes added between those until no interpolated pressure is
    /// off by more than a relative `error`.
    ///
    /// ```
    /// use asperity::{ContactTable, Interface, Interpolation, Scene, Surface, Tolerance};
    ///
    /// let scene = Scene::new(Interface::new(116e9, 0.31, 1.12e9), Surface::new(3.6e-4, 1.1e8, 1e-6), 3e-5);
    /// let (range, cubic) = ((0.0, 4.0, 2), Interpolation::Hermite);
    /// let table =
    ///     ContactTable::within(&asperity::KogutEtsion, &scene, Tolerance::default(), range, 1e-6, cubic)?;
    /// assert!(table.pressure_error <= 1e-6 && table.nodes.len() < 100);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`TableError`]; the integrals are done to `tolerance`, below which `error` cannot be met.
    pub fn within<A: Into<At>>(
        model: &dyn ContactModel,
        scene: &Scene,
        tolerance: Tolerance,
        (first, last, count): (A, A, usize),
        error: f64,
        interpolation: Interpolation,
    ) -> Result<Self, TableError> {
        crate::positive("error", error)?;
        let builder = Builder::new(model, scene, tolerance, interpolation)?;
        let even = builder.even(first.into(), last.into(), count)?;
        let mut nodes = vec![even[0]];
        // Intervals still to be looked at, the next one on top.
        let mut ahead: Vec<ContactNode> = even[1..].iter().rev().copied().collect();
        while let (Some(&from), Some(&to)) = (nodes.last(), ahead.last()) {
            if builder.monotone(&from, &to) && builder.errors(&from, &to, error)?[0] <= error {
                nodes.push(to);
                ahead.pop();
                continue;
            }
            let middle = 0.5 * (from.separation + to.separation);
            if nodes.len() + ahead.len() >= MOST_NODES || middle <= from.separation {
                return Err(TableError::TooFine { error });
            }
            ahead.push(builder.node(middle)?);
        }
        builder.table(nodes)
    }
}

/// A model on a scene, evaluated node by node.
struct Builder {
    contact: Box<dyn Contact>,
    nominal_area: f64,
    interpolation: Interpolation,
    /// Separations \[σ_z\] at which the force may have a kink.
    kinks: Vec<f64>,
    tolerance: f64,
}

impl Builder {
    fn new(
        model: &dyn ContactModel,
        scene: &Scene,
        tolerance: Tolerance,
        interpolation: Interpolation,
    ) -> Result<Self, TableError> {
        let request = Request::new([Quantity::Force, Quantity::Tangent]).within(tolerance);
        if model.citation().id == BEM {
            return Err(TableError::Contact(ContactError::Refused {
                model: model.name().into(),
                reason: "a table with a bound of its error takes thousands of solutions; use the curve of pressure, tangent and separation at some loads".into(),
            }));
        }
        let contact = model.compile(scene, &request)?;
        Ok(Self {
            contact,
            nominal_area: scene.nominal_area,
            interpolation,
            kinks: kinks(model, scene, tolerance)?,
            tolerance: tolerance.relative(),
        })
    }

    fn height_std(&self) -> f64 {
        self.contact.scene().surface.asperity_height_std
    }

    fn node(&self, separation: f64) -> Result<ContactNode, TableError> {
        let (force, tangent) = self.contact.force_and_tangent(separation)?;
        let [pressure, stiffness] = [force, tangent].map(|e| e.value() / self.nominal_area);
        if pressure > 0.0 && stiffness > 0.0 {
            return Ok(ContactNode { separation, pressure, stiffness });
        }
        let model = self.contact.model().into();
        Err(TableError::NotFalling { model, separation, pressure, stiffness })
    }

    /// d/σ_z from the mean of the asperity heights.
    fn sigmas(&self, at: At) -> Result<f64, TableError> {
        let (unit, from) = (SeparationUnit::Sigma, Datum::AsperityMean);
        let separation = self.contact.separation(at)?;
        Ok(separation.measured_in(unit, from, self.contact.scene())?.value)
    }

    fn even(&self, first: At, last: At, count: usize) -> Result<Vec<ContactNode>, TableError> {
        let by_load = !matches!(first, At::Separation(_));
        let (first, last) = (self.sigmas(first)?, self.sigmas(last)?);
        // The smaller load is at the larger separation.
        let (first, last) = if by_load { (last, first) } else { (first, last) };
        if first.partial_cmp(&last) != Some(Ordering::Less) {
            return Err(TableError::Range { first, last });
        }
        linspace(first, last, count.max(2)).into_iter().map(|s| self.node(s)).collect()
    }

    fn table(&self, nodes: Vec<ContactNode>) -> Result<ContactTable, TableError> {
        let (mut pressure_error, mut stiffness_error) = (0.0, 0.0);
        for pair in nodes.windows(2) {
            let (from, to) = (&pair[0], &pair[1]);
            if !self.monotone(from, to) {
                let nodes = nodes.len();
                return Err(TableError::Overshoot {
                    nodes,
                    from: from.separation,
                    to: to.separation,
                });
            }
            let [pressure, stiffness] = self.errors(from, to, f64::INFINITY)?;
            pressure_error = f64::max(pressure_error, pressure);
            stiffness_error = f64::max(stiffness_error, stiffness);
        }
        Ok(ContactTable {
            nodes,
            interpolation: self.interpolation,
            pressure_error,
            stiffness_error,
            asperity_height_std: self.height_std(),
        })
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
        self.interpolation == Interpolation::Linear || cubic::is_monotone(a, b)
    }

    /// Bounds of the relative errors of pressure and stiffness between two nodes; of a pressure off
    /// by more than `enough`, no more than that.
    fn errors(
        &self,
        from: &ContactNode,
        to: &ContactNode,
        enough: f64,
    ) -> Result<[f64; 2], TableError> {
        let fall = from.pressure - to.pressure;
        let (a, b) = match self.interpolation {
            Interpolation::Linear => (1.0, 1.0),
            Interpolation::Hermite => self.slopes(from, to),
        };
        let width = to.separation - from.separation;
        let secant = fall / (width * self.height_std());
        let errors = |separation: f64| {
            let t = (separation - from.separation) / width;
            let exact = self.node(separation)?;
            let pressure = from.pressure - fall * cubic::value(a, b, t);
            let stiffness = secant * cubic::slope(a, b, t);
            let errors = [pressure / exact.pressure - 1.0, stiffness / exact.stiffness - 1.0];
            Ok::<_, TableError>(errors)
        };
        let ends = pieces(&self.kinks, from.separation, to.separation);
        // Nodes and what lies between are known to the tolerance.
        let found = bounds(errors, &ends, (4.0 * self.tolerance, enough))?;
        Ok(found.map(|error| error + 2.0 * self.tolerance))
    }
}

#[cfg(test)]
mod tests;
