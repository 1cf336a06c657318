//! A density at one unit, with its kinks.

use crate::Density;

/// A density over x = (z - d)/`unit`, to be integrated over weights to a relative tolerance.
#[derive(Debug)]
pub(crate) struct Integrand {
    pub(crate) density: Density,
    pub(crate) unit: f64,
    pub(crate) tolerance: f64,
    /// Finite ends and kinks of all pieces, ascending.
    pub(crate) kinks: Vec<f64>,
}

impl Integrand {
    pub(crate) fn new(density: Density, unit: f64, tolerance: f64) -> Self {
        let mut kinks = density.breaks(f64::NEG_INFINITY, f64::INFINITY);
        kinks.retain(|x| x.is_finite());
        Self { density, unit, tolerance, kinks }
    }
}
