//! The result of a fit, and the order of several.

use asperity_core::{Finding, Findings, Severity};
use serde::Serialize;

/// A model fitted to data.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Fitted {
    /// The model's id.
    pub model: String,
    /// Whether the search ended at a minimum.
    pub converged: bool,
    /// Root mean square of ln(fitted/measured), a relative error, 0 below 1e-12; `None` if no
    /// value has a logarithm.
    pub rms: Option<f64>,
    /// Sum of squares over the degrees of freedom, with standard deviations: about 1 where model
    /// and standard deviations are right. `None` without them or without freedom.
    pub reduced_chi_squared: Option<f64>,
    /// Bayesian information criterion, for the comparison of models on the same data: lower is
    /// better. `None` where the parameters leave no freedom.
    pub bic: Option<f64>,
    /// The free parameters, in their order.
    pub parameters: Vec<Estimate>,
    /// Correlation of the parameters (of logarithms, for those varied so); `None` for those that
    /// the data do not fix.
    pub correlation: Vec<Vec<Option<f64>>>,
    /// Condition number of the derivatives of the residuals by the parameters; `None` if a
    /// combination of parameters has no effect.
    pub condition: Option<f64>,
    /// Doubts about the fit, each with its parameter (`not-converged`, `limits` at a bound,
    /// `undetermined`), and unusual results of the model where data were measured, such as yielding
    /// that it ignores.
    pub findings: Findings,
    /// Every measured value beside the fitted one.
    pub residuals: Vec<Residual>,
    /// Evaluations of the model for all data.
    pub evaluations: usize,
}

impl Fitted {
    /// The warning that the law of the model does not hold where data were measured; none where the
    /// data do not determine the hardness, on which that depends.
    #[must_use]
    pub fn invalid(&self) -> Option<&Finding> {
        let is_strength = |one: &&Estimate| ["hardness", "yield_strength"].contains(&&*one.name);
        let is_open = |one: &Estimate| one.lower.or(one.upper).is_none();
        if self.parameters.iter().find(is_strength).is_some_and(is_open) {
            return None;
        }
        self.findings.iter().find(|one| one.code.is_of_model() && one.severity < Severity::Note)
    }
}

/// A fitted parameter.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Estimate {
    /// The name.
    pub name: String,
    /// The value of the least squares.
    pub value: f64,
    /// Lower end of the 95 % interval; `None` if the data do not fix it within the bounds.
    pub lower: Option<f64>,
    /// Its upper end.
    pub upper: Option<f64>,
    /// The SI unit; empty for pure numbers.
    pub unit: String,
    /// The bounds within which it was varied.
    pub bounds: [f64; 2],
}

/// A measured value and the fitted one.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Residual {
    /// The row of the data, counted from 1.
    pub row: usize,
    /// The column of the data.
    pub column: String,
    /// The measured value, in SI units.
    pub measured: f64,
    /// The fitted value.
    pub fitted: f64,
    /// Difference of logarithms, or over the standard deviation if that is given.
    pub residual: f64,
}

/// Orders models by BIC, lowest first, or by rms where one of them has no BIC. Behind these come
/// models that did not converge, and then those whose law does not hold where data were measured.
#[must_use]
pub fn rank(mut models: Vec<Fitted>) -> Vec<Fitted> {
    let has_bic = models.iter().all(|fitted| fitted.bic.is_some());
    let key = |fitted: &Fitted| {
        let misfit = if has_bic { fitted.bic } else { fitted.rms };
        ((fitted.invalid().is_some(), !fitted.converged), misfit.unwrap_or(f64::INFINITY))
    };
    models.sort_by(|a, b| {
        let ((a, one), (b, other)) = (key(a), key(b));
        a.cmp(&b).then(one.total_cmp(&other))
    });
    models
}
