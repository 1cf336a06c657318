//! Separations at which the force of a model may have a kink.

use asperity::{AsperityModel, ContactError, ContactModel};

use crate::subject::Subject;

/// Kinks nearer to each other than this \[σ_z\] are one.
const SAME_KINK: f64 = 1e-9;

/// Separations \[σ_z\] at which the force of a model may have a kink, ascending: a break of the
/// density that meets one of the law.
pub(crate) fn kinks(subject: &Subject<'_>) -> Result<Vec<f64>, ContactError> {
    let Subject { file, model, tolerance, .. } = *subject;
    let scene = &file.scene;
    let sigma = scene.surface.asperity_height_std;
    let (low, high) = scene.heights.support(sigma);
    let breaks = [low, high].into_iter().chain(scene.heights.breaks().iter().copied());
    let breaks: Vec<f64> = breaks.filter(|z| z.is_finite()).collect();
    if breaks.is_empty() {
        return Ok(vec![]);
    }
    let force = |model: &dyn AsperityModel| model.force(&scene.asperity()?, tolerance);
    let law = model.asperity_model().map(force).transpose()?;
    // Onset of contact, and the kinks of the law, as interferences [m].
    let mut interferences = vec![law.as_ref().map_or(0.0, |law| law.onset * law.interference_unit)];
    if let Some(law) = &law {
        interferences.extend(law.kinks().into_iter().map(|x| x * law.interference_unit));
    }
    let at = |z: f64| interferences.iter().map(move |w| (z - w) / sigma);
    let mut kinks: Vec<f64> = breaks.into_iter().flat_map(at).collect();
    kinks.sort_by(f64::total_cmp);
    kinks.dedup_by(|a, b| (*a - *b).abs() <= SAME_KINK);
    Ok(kinks)
}

/// The ends of an interval with the kinks between them.
pub(crate) fn pieces(kinks: &[f64], from: f64, to: f64) -> Vec<f64> {
    let first = kinks.partition_point(|kink| *kink <= from + SAME_KINK);
    let inside = kinks[first..].iter().copied().take_while(|kink| *kink < to - SAME_KINK);
    [from].into_iter().chain(inside).chain([to]).collect()
}
