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
        /// The density's own words.
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
}
