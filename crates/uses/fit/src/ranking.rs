//! Several models on the same data, in their order.

use crate::{Data, Fitted};

/// Residuals below this, relative, are errors of the values: they read 0 and rank no model.
pub(crate) const ACCURACY: f64 = 1e-12;

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
