//! The result of a fit.

use asperity_core::Severity;
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
    /// Combinations that the data do not fix, in words.
    pub undetermined: Vec<String>,
    /// Measured values that cannot be reached, each with the reason.
    pub unreachable: Vec<String>,
    /// Bounds, and ends of the range with values of scene and model, at which parameters stop.
    pub limits: Vec<String>,
    /// The line (of arrays the row) that the others contradict, or two of more than six, and how
    /// far they are from a fit to the others. The values here are fitted to all.
    pub outlier: Option<String>,
    /// The column of another stiffness that describes the data clearly better than the one given.
    pub other_column: Option<String>,
    /// If no values within the bounds describe the data (an rms above 1 or 30 standard deviations,
    /// or no contact), or the fit has less than one contact in a row and other units describe the
    /// data as well: how large the misfit is, and the line or the units that explain it.
    pub misfit: Option<String>,
    /// Remarks on intervals and other values of the parameters that fit as well.
    pub notes: Vec<String>,
    /// Every measured value beside the fitted one.
    pub residuals: Vec<Residual>,
    /// Evaluations of the model for all data.
    pub evaluations: usize,
}

impl Fitted {
    /// Whether values of the model are those of the data, so that more may be said of them.
    #[must_use]
    pub fn describes_data(&self) -> bool {
        self.misfit.is_none() && self.unreachable.is_empty()
    }

    /// Warnings and notes worth reading, in their order: a misfit leaves no meaning to intervals
    /// and limits, and the place of the nearest value to an unreachable one is in its own sentence.
    #[must_use]
    pub fn remarks<'f>(&'f self) -> Vec<(Severity, &'f str)> {
        let open = "the search did not converge: the values are the best that it found";
        let open = (!self.converged).then_some(open);
        let texts = |list: &'f [String]| list.iter().map(String::as_str);
        let mut warnings: Vec<&str> = open.into_iter().chain(texts(&self.unreachable)).collect();
        let mut notes = vec![];
        match &self.misfit {
            Some(misfit) => warnings.push(misfit),
            None => {
                warnings.extend(self.outlier.as_deref());
                warnings.extend(self.other_column.as_deref());
                warnings.extend(texts(&self.undetermined));
                let limits = if self.unreachable.is_empty() { &self.limits[..] } else { &[] };
                warnings.extend(texts(limits));
                notes.extend(texts(&self.notes));
            }
        }
        let warnings = warnings.into_iter().map(|text| (Severity::Warning, text));
        warnings.chain(notes.into_iter().map(|text| (Severity::Note, text))).collect()
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
