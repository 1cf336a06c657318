//! The result of a method on a problem: a number or a failure.

use asperity_quadrature::QuadratureError;

/// The result of a method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// In SI units.
    pub value: f64,
    /// Whether the value is divided by its scale, exp of `Problem::ln_scale`.
    pub scaled: bool,
    /// Evaluations of the integrand; `None` where they are counted separately.
    pub evaluations: Option<usize>,
}

/// The reason for a missing number, as it stands in a table.
pub type Failure = &'static str;

/// The method reports that it missed its tolerance.
pub const NOT_CONVERGED: Failure = "not-converged";
/// A value was infinite or NaN.
pub const NOT_FINITE: Failure = "not-finite";
/// The result is 0 for a value other than 0.
pub const ZERO: Failure = "zero";

/// The reason for which a rule has no number.
pub fn failure(error: QuadratureError) -> Failure {
    match error {
        QuadratureError::NotConverged { .. } => NOT_CONVERGED,
        _ => NOT_FINITE,
    }
}

/// A prepared problem: one-time work is done.
pub type Job = Box<dyn Fn() -> Result<Outcome, Failure> + Send + Sync>;
