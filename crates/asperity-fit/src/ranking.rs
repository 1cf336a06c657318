//! Several models on the same data.

use serde::Serialize;

use crate::doubt::list;
use crate::{Data, Fitted};

/// A difference of the criterion below which two models are hardly distinguished: a factor of 20
/// in their odds.
const STRONG: f64 = 6.0;

/// Residuals below this, relative, are errors of the values: they read 0 and rank no model.
pub(crate) const ACCURACY: f64 = 1e-12;

/// Fitted models, ordered by BIC, lowest first, or by rms where one of them has no BIC.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Ranking {
    /// The fitted models.
    pub models: Vec<Fitted>,
    /// The meaning of their order, and its limits.
    pub summary: String,
}

/// Orders models by BIC, lowest first, or by rms where one of them has no BIC; those that did not
/// converge come last.
#[must_use]
pub fn rank(mut models: Vec<Fitted>) -> Ranking {
    let has_bic = models.iter().all(|fitted| fitted.bic.is_some());
    let key = |fitted: &Fitted| {
        let misfit = if has_bic { fitted.bic } else { fitted.rms };
        (!fitted.converged, misfit.unwrap_or(f64::INFINITY))
    };
    models.sort_by(|a, b| {
        let ((a, one), (b, other)) = (key(a), key(b));
        a.cmp(&b).then(one.total_cmp(&other))
    });
    let summary = summary(&models, has_bic);
    Ranking { models, summary }
}

fn summary(models: &[Fitted], has_bic: bool) -> String {
    let [first, others @ ..] = models else { return "no model was fitted".into() };
    let least = match (first.bic, first.residuals.len()) {
        (Some(least), _) if has_bic => least,
        (_, 1) => return "one measured value cannot choose between models".into(),
        _ => return "as many parameters as measured values leave nothing to rank models by".into(),
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
            "{} fits best by BIC, but these data do not distinguish it from {} (BIC within {STRONG})",
            first.model,
            list(&near)
        ),
    };
    format!(
        "{lead}; a low BIC does not say that a model is right, or that its numbers are those of the surface"
    )
}

/// The Bayesian information criterion, for normal residuals of known or unknown deviation.
pub(crate) fn bic(data: &Data, squares: f64, rank: usize) -> Option<f64> {
    let count = data.len() as f64;
    // One value ranks no model, also where no parameter changes it.
    if data.len() <= rank.max(1) {
        return None;
    }
    let misfit = match data.has_std() {
        true => squares,
        false => count * (squares / count).max(ACCURACY * ACCURACY).ln(),
    };
    Some(misfit + rank as f64 * count.ln())
}
