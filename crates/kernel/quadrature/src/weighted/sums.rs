//! The value and the slope of one integral, with what is known of their errors.

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
