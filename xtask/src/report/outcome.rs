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

/// The reason for a missing number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Failure {
    /// The method reports that it missed its tolerance.
    NotConverged,
    /// A value was infinite or NaN.
    NotFinite,
    /// The result is 0 for a value other than 0.
    Zero,
}

impl Failure {
    /// Its name in a table.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::NotConverged => "not-converged",
            Self::NotFinite => "not-finite",
            Self::Zero => "zero",
        }
    }
}

impl From<QuadratureError> for Failure {
    fn from(error: QuadratureError) -> Self {
        match error {
            QuadratureError::NotConverged { .. } => Self::NotConverged,
            _ => Self::NotFinite,
        }
    }
}

/// A prepared problem: one-time work is done.
pub type Job = Box<dyn Fn() -> Result<Outcome, Failure> + Send + Sync>;
