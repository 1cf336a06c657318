//! Several models on the same data.

use serde::Serialize;

use crate::Fitted;
use crate::combinations::list;

/// A difference of the criterion below which two models are hardly distinguished: a factor of 20
/// in their odds.
const STRONG: f64 = 6.0;

/// Fitted models, that of the lowest BIC first.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Ranking {
    /// The fitted models.
    pub models: Vec<Fitted>,
    /// What their order says, and what it does not.
    pub summary: String,
}

/// Orders models by their BIC, then by the misfit; those that did not converge come last.
#[must_use]
pub fn rank(mut models: Vec<Fitted>) -> Ranking {
    let key = |fitted: &Fitted| {
        let misfit = fitted.bic.or(fitted.rms).unwrap_or(f64::INFINITY);
        (!fitted.converged, misfit)
    };
    models.sort_by(|a, b| {
        let ((a, one), (b, other)) = (key(a), key(b));
        a.cmp(&b).then(one.total_cmp(&other))
    });
    let summary = summary(&models);
    Ranking { models, summary }
}

fn summary(models: &[Fitted]) -> String {
    let [first, others @ ..] = models else { return "no model was fitted".into() };
    let Some(least) = first.bic else {
        return "as many parameters as measured values leave nothing to rank models by".into();
    };
    if others.is_empty() {
        return format!(
            "{} alone was fitted: its residuals do not say whether other models fit as well",
            first.model
        );
    }
    let near = others.iter().filter(|other| other.bic.is_some_and(|bic| bic - least < STRONG));
    let near: Vec<&str> = near.map(|other| other.model.as_str()).collect();
    let lead = match near[..] {
        [] => format!("{} fits best by BIC, clearly before the others", first.model),
        _ => format!(
            "{} fits best by BIC, but {} within {STRONG} of it cannot be told from it by these data",
            first.model,
            list(&near)
        ),
    };
    format!(
        "{lead}; a low BIC does not say that a model is right, or that its numbers are those of the surface"
    )
}
