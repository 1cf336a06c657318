//! Diagnostics of scans: the statistics stand.

use asperity_core::{Diagnostic, Surface};

use crate::{Level, TopographyError};

/// Two parameters farther apart than this factor disagree.
const APART: f64 = 2.0;
/// Factor by which summits may fall at half the resolution: white noise has 4.
const SUMMITS: f64 = 2.0;
/// Factor by which m₄ of a profile may fall at half the resolution: white noise has 16.
const CURVATURE: f64 = 4.0;

/// β = η R Sq outside [the usual range](Surface::USUAL_ROUGHNESS).
pub(crate) fn roughness_parameter(beta: f64) -> Option<Diagnostic> {
    let usual = Surface::USUAL_ROUGHNESS;
    let advice = match beta > usual[1] {
        true => {
            "form and waviness raise Sq, noise raises eta; level with quadratic, filter with a cut-off, or smooth the scan"
        }
        false => {
            "the scan is smoothed, too coarse for the asperities, or of a regular surface; use a smaller pixel size"
        }
    };
    let found = Diagnostic::warning("roughness-parameter", "beta", beta)
        .usual(usual)
        .fact(format!("beta = eta R Sq is {beta:.4} (usual: {} to {})", usual[0], usual[1]))
        .advice(advice);
    (!(usual[0]..=usual[1]).contains(&beta)).then_some(found)
}

/// Parameters by the spectral moments and by the summits that disagree.
pub(crate) fn estimators_disagree(parameters: &[(&str, f64, f64)]) -> Option<Diagnostic> {
    let apart: Vec<_> = parameters.iter().filter(|(_, m, s)| ratio(*m, *s) > APART).collect();
    let largest = apart.iter().map(|(_, m, s)| ratio(*m, *s)).max_by(f64::total_cmp)?;
    let each = apart.iter().map(|(name, moments, summits)| {
        format!("{name} is {moments:.4e} by the spectral moments and {summits:.4e} by the summits")
    });
    let found = Diagnostic::warning("estimators-disagree", "estimator_ratio", largest)
        .usual([1.0, APART])
        .fact(each.collect::<Vec<_>>().join(", "))
        .advice(
            "the surface is not an isotropic Gaussian one at this pixel size; compare the results of both estimators",
        );
    Some(found)
}

/// The estimator that was not asked for fails.
pub(crate) fn no_second_estimator(reason: &TopographyError) -> Diagnostic {
    Diagnostic::warning("no-second-estimator", "estimators", 1.0)
        .usual([2.0, f64::INFINITY])
        .fact("the two estimators cannot be compared")
        .advice(reason.to_string())
}

const FOLLOWS: &str =
    "it depends on the pixel size; filter or smooth the scan, or use the pixel size of the contact";

/// Summits per area \[1/m²\], of all points and of every second one: the pixel size, not the
/// surface, sets the number of asperities.
pub(crate) fn summits_follow_sampling(fine: f64, coarse: f64) -> Option<Diagnostic> {
    let found = Diagnostic::warning("summits-follow-sampling", "summit_density", fine)
        .usual([0.0, SUMMITS * coarse])
        .unit("1/m2")
        .fact(format!("summit density is {fine:.4e} 1/m2, and {coarse:.4e} at half the resolution"))
        .advice(FOLLOWS);
    (fine > SUMMITS * coarse).then_some(found)
}

/// m₄ \[1/m²\] of a profile, of all points and of every second one.
pub(crate) fn curvature_follows_sampling(fine: f64, coarse: f64) -> Option<Diagnostic> {
    let found = Diagnostic::warning("curvature-follows-sampling", "m4", fine)
        .usual([0.0, CURVATURE * coarse])
        .unit("1/m2")
        .fact(format!("m4 is {fine:.4e} 1/m2, and {coarse:.4e} at half the resolution"))
        .advice(FOLLOWS);
    (fine > CURVATURE * coarse).then_some(found)
}

/// Missing points were filled.
pub(crate) fn filled(share: f64) -> Option<Diagnostic> {
    let percent = 100.0 * share;
    let found = Diagnostic::warning("filled", "filled_share", share)
        .usual([0.0, 0.0])
        .fact(format!("{percent:.3} % of the points were missing and are filled (harmonic)"))
        .advice("filled parts are smoother than the surface and have no summits");
    (share > 0.0).then_some(found)
}

/// Rms slopes along rows and columns that differ.
pub(crate) fn anisotropic(slope_x: f64, slope_y: f64) -> Option<Diagnostic> {
    let ratio = ratio(slope_x, slope_y);
    let found = Diagnostic::warning("anisotropic", "slope_ratio", ratio)
        .usual([1.0, APART])
        .fact(format!("the rms slope is {slope_x:.4e} along rows and {slope_y:.4e} along columns"))
        .advice("models assume round asperities; compare with boundary elements (bem)");
    (ratio > APART).then_some(found)
}

impl Level {
    /// A diagnostic where taking this away tilts a periodic surface.
    #[must_use]
    pub fn tilts(self, periodic: bool) -> Option<Diagnostic> {
        let found = Diagnostic::warning("level", "level", f64::NAN)
            .fact(format!("level {self} of a periodic surface opens its edges"))
            .advice("this spoils slopes and curvatures; use level mean");
        (periodic && matches!(self, Self::Plane | Self::Quadratic)).then_some(found)
    }
}

/// The larger over the smaller one.
fn ratio(a: f64, b: f64) -> f64 {
    (a / b).max(b / a)
}
