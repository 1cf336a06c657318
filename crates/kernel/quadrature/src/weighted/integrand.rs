//! A density at one unit, with its kinks, and its integral: value and slope, with what is known of
//! their errors.

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

/// I(d) = sums\[0\]·exp(`ln_scale`) and -dI/dd = sums\[1\]·exp(`ln_scale`), with the integrals of
/// absolute values and the errors.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sums {
    pub(crate) sums: [f64; 2],
    pub(crate) sizes: [f64; 2],
    pub(crate) ln_scale: f64,
    /// Errors of the integration, relative to the sizes.
    pub(crate) errors: [f64; 2],
    /// Errors of rounded places and of the density's own values, relative to the sizes.
    pub(crate) inputs: [f64; 2],
    pub(crate) evaluations: usize,
}

impl Sums {
    /// The whole errors of value and slope, relative to the sizes.
    pub(crate) fn total(&self) -> [f64; 2] {
        [0, 1].map(|n| self.errors[n] + self.inputs[n])
    }
}
