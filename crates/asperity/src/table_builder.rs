//! The nodes of a contact table, and what is interpolated between two of them.

use std::cmp::Ordering;

use crate::cubic;
use crate::{
    At, Contact, ContactModel, ContactNode, ContactTable, Datum, Interpolation, Quantity, Request,
    Scene, SeparationUnit, TableError, Tolerance, linspace,
};

/// Points at which each interval is compared with the model.
pub(crate) const PROBES: usize = 7;

/// A model on a scene, asked node by node.
pub(crate) struct Builder {
    contact: Box<dyn Contact>,
    nominal_area: f64,
    interpolation: Interpolation,
}

impl Builder {
    pub(crate) fn new(
        model: &dyn ContactModel,
        scene: &Scene,
        tolerance: Tolerance,
        interpolation: Interpolation,
    ) -> Result<Self, TableError> {
        let request = Request::new([Quantity::Force, Quantity::Tangent]).within(tolerance);
        let contact = model.compile(scene, &request)?;
        Ok(Self { contact, nominal_area: scene.nominal_area, interpolation })
    }

    fn height_std(&self) -> f64 {
        self.contact.scene().surface.asperity_height_std
    }

    pub(crate) fn node(&self, separation: f64) -> Result<ContactNode, TableError> {
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

    pub(crate) fn even(
        &self,
        first: At,
        last: At,
        count: usize,
    ) -> Result<Vec<ContactNode>, TableError> {
        let by_load = !matches!(first, At::Separation(_));
        let (first, last) = (self.sigmas(first)?, self.sigmas(last)?);
        // The smaller load is at the larger separation.
        let (first, last) = if by_load { (last, first) } else { (first, last) };
        if first.partial_cmp(&last) != Some(Ordering::Less) {
            return Err(TableError::Range { first, last });
        }
        linspace(first, last, count.max(2)).into_iter().map(|s| self.node(s)).collect()
    }

    pub(crate) fn table(&self, nodes: Vec<ContactNode>) -> Result<ContactTable, TableError> {
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
            let (pressure, stiffness) = self.errors(from, to)?;
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

    /// Whether what is interpolated falls all the way.
    pub(crate) fn monotone(&self, from: &ContactNode, to: &ContactNode) -> bool {
        if to.pressure >= from.pressure {
            return false;
        }
        let (a, b) = self.slopes(from, to);
        self.interpolation == Interpolation::Linear || cubic::is_monotone(a, b)
    }

    /// The largest relative errors of pressure and stiffness between two nodes.
    pub(crate) fn errors(
        &self,
        from: &ContactNode,
        to: &ContactNode,
    ) -> Result<(f64, f64), TableError> {
        let fall = from.pressure - to.pressure;
        let (a, b) = match self.interpolation {
            Interpolation::Linear => (1.0, 1.0),
            Interpolation::Hermite => self.slopes(from, to),
        };
        let width = to.separation - from.separation;
        let (mut pressure_error, mut stiffness_error): (f64, f64) = (0.0, 0.0);
        for k in 1..=PROBES {
            let t = k as f64 / (PROBES + 1) as f64;
            let exact = self.node(from.separation + t * width)?;
            let pressure = from.pressure - fall * cubic::value(a, b, t);
            let secant = fall / (width * self.height_std());
            let stiffness = secant * cubic::slope(a, b, t);
            pressure_error = pressure_error.max((pressure / exact.pressure - 1.0).abs());
            stiffness_error = stiffness_error.max((stiffness / exact.stiffness - 1.0).abs());
        }
        Ok((pressure_error, stiffness_error))
    }
}
