//! What can go wrong in a quadrature.

use serde::Serialize;

/// Why an integral has no value.
#[derive(Debug, Clone, PartialEq, thiserror::Error, Serialize)]
#[serde(tag = "code", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum QuadratureError {
    /// The density returned NaN or an infinity.
    #[error("the density is {value} at {at}: a finite number was required")]
    NotFinite {
        /// The place of the sample.
        at: f64,
        /// The sample.
        value: f64,
    },
    /// The density has no value at a sample.
    #[error("the density could not be sampled: {reason}")]
    Refused {
        /// The reason given by the density.
        reason: String,
    },
    /// The separation or the scale is out of range.
    #[error(
        "s is {s} and the scale {scale}: a finite s up to 1e9 and a positive, finite scale were required"
    )]
    OutOfRange {
        /// The separation.
        s: f64,
        /// The scale.
        scale: f64,
    },
    /// Refinement ended before the tolerance was met.
    #[error(
        "not converged: the relative error bound is {:.1e}{}, and {asked:.1e} was asked: use a larger tolerance",
        rounded_up(*.reached),
        after(*.evaluations)
    )]
    NotConverged {
        /// The relative error estimate that was reached.
        reached: f64,
        /// The requested relative tolerance.
        asked: f64,
        /// How often the integrand was evaluated.
        evaluations: usize,
    },
    /// A weight has no usable integral.
    #[error("{weight}: {fault}")]
    Weight {
        /// The weight's name.
        weight: String,
        /// The fault.
        fault: WeightFault,
    },
}

impl QuadratureError {
    /// The relative error `reached` misses the one `asked`.
    pub(crate) fn missed(reached: f64, asked: f64, evaluations: usize) -> Self {
        Self::NotConverged { reached, asked, evaluations }
    }
}

/// A bound of two digits, so that it is above the tolerance that it misses.
fn rounded_up(bound: f64) -> f64 {
    let unit = 10f64.powf(bound.log10().floor() - 1.0);
    let rounded = (bound / unit).ceil() * unit;
    if rounded.is_finite() { rounded } else { bound }
}

/// Integrals from a table need no evaluations of their own.
fn after(evaluations: usize) -> String {
    if evaluations == 0 { String::new() } else { format!(" after {evaluations} evaluations") }
}

/// A fault of a weight, at places in its own unit.
#[derive(Debug, Clone, PartialEq, thiserror::Error, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum WeightFault {
    /// The support is empty.
    #[error("the support is from {low:?} to {high:?}: a lower and a higher end were required")]
    Support {
        /// The lower end.
        low: f64,
        /// The higher end.
        high: f64,
    },
    /// A break is not a finite number.
    #[error("a break is {at:?}: finite numbers were required")]
    Break {
        /// The break.
        at: f64,
    },
    /// The logarithm is NaN or infinite.
    #[error("the logarithm is {value} at {at:e}: a number was required")]
    Value {
        /// The place.
        at: f64,
        /// The logarithm.
        value: f64,
    },
    /// A pole is not an integrable power of the distance to a declared place.
    #[error(
        "pole at {at:e}: a power above -0.95 of the distance to an end of the support or a break was required"
    )]
    Pole {
        /// The place.
        at: f64,
    },
    /// All samples are zero.
    #[error("zero everywhere from {low:?} to {high:?}: numbers above 0 were required")]
    Zero {
        /// The lower end of the support.
        low: f64,
        /// The higher end.
        high: f64,
    },
    /// The integral is not 1.
    #[error(
        "the integral is {integral:.6}: 1 was required (declare the support, and breaks at jumps, kinks, poles and peaks)"
    )]
    Integral {
        /// The integral.
        integral: f64,
    },
    /// The samples do not suffice to represent the weight.
    #[error(
        "too many kinks, jumps or peaks near {at:e}: a density that is smooth between them was required"
    )]
    Wild {
        /// The place of the last sample.
        at: f64,
    },
    /// The weight there is too small, compared with its largest value, to be integrated.
    #[error("too small above {above:e} to be integrated, though within the support")]
    Faint {
        /// The place.
        above: f64,
    },
    /// The integral of the growing density over the weight is infinite.
    #[error("the integral of the law over this density diverges")]
    Diverges,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missed_tolerance_is_below_the_bound_in_print() {
        for (reached, printed) in [(1.004e-12, "1.1e-12"), (5.12e-7, "5.2e-7"), (9.91e-7, "1.0e-6")]
        {
            let text = QuadratureError::missed(reached, 1e-12, 0).to_string();
            assert!(text.contains(&format!("bound is {printed}, and 1.0e-12")), "{text}");
        }
        for (reached, printed) in [(f64::INFINITY, "inf"), (f64::NAN, "NaN"), (0.0, "0.0e0")] {
            let text = QuadratureError::missed(reached, 1e-12, 0).to_string();
            assert!(text.contains(&format!("bound is {printed},")), "{text}");
        }
    }
}
