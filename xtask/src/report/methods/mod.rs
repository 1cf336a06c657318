//! The methods that are compared. Each turns a problem into a job that can be run again and again.

mod classical;
mod compiled;
mod naive;
mod rule;

use std::sync::Arc;

use anyhow::{Result, bail};
use asperity_quadrature::QuadratureError;

use super::laws::Laws;
use super::problem::Problem;

/// What a method found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// In SI units.
    pub value: f64,
    /// Whether the value is over its scale, exp of [`Problem::ln_scale`].
    pub scaled: bool,
    /// Evaluations of the integrand; nothing where they are counted apart.
    pub evaluations: Option<usize>,
}

/// Why a method gave no number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Failure {
    /// It says that it did not reach its tolerance.
    NotConverged,
    /// It met a number that is none.
    NotFinite,
    /// It returned 0 for what is not 0.
    Zero,
}

impl Failure {
    /// The word for it in a table.
    #[must_use]
    pub fn word(self) -> &'static str {
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

/// A problem made ready: everything that is done once has been done.
pub type Job = Box<dyn Fn() -> Result<Outcome, Failure> + Send + Sync>;

/// How a method is set for one row of the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Setting {
    /// To this relative tolerance.
    Tolerance(f64),
    /// With this many points on each panel.
    Points(usize),
    /// It has none.
    Fixed,
}

/// A method.
pub struct Method {
    /// Its name in tables.
    pub name: &'static str,
    /// What the Markdown says of it.
    pub what: &'static str,
    /// What it can be set to.
    pub kind: Kind,
    prepare: Prepare,
    /// Counts evaluations where outcomes do not tell them.
    count: Option<Count>,
}

/// Nodes for a problem.
type Count = fn(&Laws, &Problem, Setting) -> Result<usize>;
/// Turns a problem into a job.
type Prepare = fn(&Laws, &Arc<Problem>, Setting) -> Result<Job>;

/// What a method can be set to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A tolerance.
    Adaptive,
    /// A number of points a panel.
    Panels,
    /// Nothing.
    Fixed,
}

impl Method {
    /// Makes a problem ready.
    ///
    /// # Errors
    /// What the library refuses; a published method refuses nothing.
    pub fn prepare(&self, laws: &Laws, problem: &Arc<Problem>, setting: Setting) -> Result<Job> {
        (self.prepare)(laws, problem, setting)
    }

    /// Evaluations of the integrand for a problem, or of an exponential, for a rule that has the
    /// law in its weight; nothing where the method gives no answer.
    ///
    /// # Errors
    /// What the library refuses.
    pub fn evaluations(
        &self,
        laws: &Laws,
        problem: &Arc<Problem>,
        setting: Setting,
    ) -> Result<Option<usize>> {
        match self.count {
            Some(count) => count(laws, problem, setting).map(Some),
            None => Ok(self.prepare(laws, problem, setting)?().ok().and_then(|o| o.evaluations)),
        }
    }

    /// How it is set on the hard cases, where each method runs once.
    #[must_use]
    pub fn on_hard_cases(&self) -> Setting {
        match self.kind {
            Kind::Adaptive => Setting::Tolerance(HARD_TOLERANCE),
            Kind::Panels => Setting::Points(HARD_POINTS),
            Kind::Fixed => Setting::Fixed,
        }
    }
}

/// What is asked of the methods that take a tolerance, on the hard cases.
pub const HARD_TOLERANCE: f64 = 1e-10;
/// Points a panel, on the hard cases.
pub const HARD_POINTS: usize = 128;

/// The tolerance of a setting that is one.
fn tolerance(setting: Setting) -> Result<f64> {
    match setting {
        Setting::Tolerance(tolerance) => Ok(tolerance),
        other => bail!("{other:?} is no tolerance"),
    }
}

/// All methods of this process, ours first.
#[must_use]
pub fn all() -> Vec<Method> {
    let mut methods = vec![compiled::METHOD, rule::METHOD];
    methods.extend(classical::METHODS);
    methods.extend(naive::METHODS);
    methods
}
