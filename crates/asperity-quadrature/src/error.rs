//! What can go wrong in a quadrature.

use serde::Serialize;

/// Why an integral could not be given.
#[derive(Debug, Clone, PartialEq, thiserror::Error, Serialize)]
#[serde(tag = "code", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum QuadratureError {
    /// The density returned NaN or an infinity.
    #[error("the density is {value} at {at}: a finite number was required")]
    NotFinite {
        /// Where it was sampled.
        at: f64,
        /// What it returned.
        value: f64,
    },
    /// The density refused to be sampled.
    #[error("the density could not be sampled: {reason}")]
    Refused {
        /// The reason given by the density.
        reason: String,
    },
    /// There is no such place.
    #[error(
        "s is {s} and the scale {scale}: a finite s up to 1e9 and a positive, finite scale were required"
    )]
    OutOfRange {
        /// The separation asked for.
        s: f64,
        /// The scale asked for.
        scale: f64,
    },
    /// Refinement ended before the tolerance was met.
    #[error(
        "not converged: relative error {reached:.1e} reached after {evaluations} evaluations, {asked:.1e} was asked"
    )]
    NotConverged {
        /// The relative error estimate that was reached.
        reached: f64,
        /// The relative tolerance that was asked.
        asked: f64,
        /// How often the integrand was evaluated.
        evaluations: usize,
    },
    /// A weight cannot be integrated.
    #[error("{weight}: {fault}")]
    Weight {
        /// The weight's name.
        weight: String,
        /// What is wrong with it.
        fault: WeightFault,
    },
}

/// What is wrong with a weight, at places in its own unit.
#[derive(Debug, Clone, PartialEq, thiserror::Error, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum WeightFault {
    /// The support is empty.
    #[error("its support is from {low:?} to {high:?}: a lower and a higher end were required")]
    Support {
        /// The lower end.
        low: f64,
        /// The higher end.
        high: f64,
    },
    /// One of its breaks is not a number.
    #[error("one of its breaks is {at:?}: finite numbers were required")]
    Break {
        /// The break.
        at: f64,
    },
    /// Its logarithm is not a number, or infinite.
    #[error("its logarithm is {value} at {at:e}: a number was required")]
    Value {
        /// The place.
        at: f64,
        /// The logarithm.
        value: f64,
    },
    /// It has a pole that is none of an integrable power of the distance to a declared place.
    #[error(
        "it has a pole at {at:e}: a power above -0.95 of the distance to an end of the support or a break was required"
    )]
    Pole {
        /// The place.
        at: f64,
    },
    /// It is zero wherever it was looked at.
    #[error("it is zero everywhere from {low:?} to {high:?}: numbers above 0 were required")]
    Zero {
        /// The lower end of the support.
        low: f64,
        /// The higher end.
        high: f64,
    },
    /// It is no probability density.
    #[error(
        "its integral is {integral:.6}: 1 was required (support and breaks, where it has jumps, kinks, poles or peaks, must be declared)"
    )]
    Integral {
        /// What was found.
        integral: f64,
    },
    /// It varies too wildly to be followed.
    #[error("it cannot be followed near {at:e}: fewer kinks, jumps and peaks were required")]
    Wild {
        /// Where samples ran out.
        at: f64,
    },
    /// It is too small there, compared with its largest value, to be integrated.
    #[error("it is too small above {above:e} to be integrated, yet not beyond its support")]
    Faint {
        /// The place.
        above: f64,
    },
    /// Times the density that grows, it has no integral.
    #[error("the integral of the law over it diverges")]
    Diverges,
}
