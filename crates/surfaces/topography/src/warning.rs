//! Warnings about scans.

use asperity_core::{Advice, Code, Finding, Surface};

use crate::outliers::MATTERS;
use crate::{Level, Moments, Outliers, Texture, TopographyError};

/// Factor above which two parameters disagree.
const APART: f64 = 2.0;
const ROUGH: &str =
    "form and waviness increase Sq, noise increases eta; use level quadratic, filter or smooth";
const SMOOTH: &str = "the scan is smoothed, too coarse for the asperities, or of a regular surface; use a smaller pixel size";

/// A warning if β = η R Sq is outside [the usual range](Surface::USUAL_ROUGHNESS).
pub(crate) fn roughness_parameter(beta: f64) -> Option<Finding> {
    let usual = Surface::USUAL_ROUGHNESS;
    let advice = if beta > usual[1] { ROUGH } else { SMOOTH };
    let found = Finding::warning(Code::RoughnessParameter, "beta", beta)
        .usual(usual)
        .fact(format!("beta = eta R Sq is {beta:.4} (usual: {} to {})", usual[0], usual[1]))
        .advice(advice);
    (!(usual[0]..=usual[1]).contains(&beta)).then_some(found)
}

/// A warning if parameters by the spectral moments and by the summits disagree.
pub(crate) fn estimators_disagree(moments: &Surface, summits: &Surface) -> Option<Finding> {
    let parameters = [
        ("asperity_density", moments.asperity_density, summits.asperity_density),
        ("asperity_radius", moments.asperity_radius, summits.asperity_radius),
        ("asperity_height_std", moments.asperity_height_std, summits.asperity_height_std),
    ];
    let apart: Vec<_> = parameters.iter().filter(|(_, m, s)| ratio(*m, *s) > APART).collect();
    let largest = apart.iter().map(|(_, m, s)| ratio(*m, *s)).max_by(f64::total_cmp)?;
    let each = apart.iter().map(|(name, moments, summits)| {
        format!("{name} is {moments:.4e} by the spectral moments and {summits:.4e} by the summits")
    });
    let found = Finding::warning(Code::EstimatorsDisagree, "estimator_ratio", largest)
        .usual([1.0, APART])
        .fact(each.collect::<Vec<_>>().join(", "))
        .advice(
            "at this pixel size the surface is not Gaussian and isotropic; compare the results of both estimators",
        );
    Some(found)
}

/// A warning that the other estimator fails.
pub(crate) fn no_second_estimator(reason: &TopographyError) -> Finding {
    Finding::warning(Code::NoSecondEstimator, "estimators", 1.0)
        .usual([2.0, f64::INFINITY])
        .fact("the two estimators cannot be compared")
        .advice(reason.to_string())
}

/// A warning if the pixel size determines a number \[1/m²\] by more than a factor, from its value
/// for all points and for every second one.
pub(crate) fn follows_sampling(
    (code, of): (Code, &'static str),
    [fine, coarse]: [f64; 2],
    most: f64,
) -> Option<Finding> {
    let found = Finding::warning(code, of, fine)
        .usual([0.0, most * coarse])
        .unit("1/m2")
        .fact(format!(
            "{} is {fine:.4e} 1/m2, and {coarse:.4e} at half the resolution",
            of.replace('_', " ")
        ))
        .advice(
            "the result depends on the pixel size; smooth the scan, or use a pixel size suited to the contact",
        );
    (fine > most * coarse).then_some(found)
}

/// A warning that missing points were filled.
pub(crate) fn filled(share: f64) -> Option<Finding> {
    let percent = 100.0 * share;
    let found = Finding::warning(Code::Filled, "filled_share", share)
        .usual([0.0, 0.0])
        .fact(format!(
            "{percent:.3} % of the points were missing and are filled with harmonic heights"
        ))
        .advice("filled parts are smoother than the surface and have no summits");
    (share > 0.0).then_some(found)
}

/// A warning that outliers determine parameters of the surface.
pub(crate) fn outliers(found: &Outliers) -> Option<Finding> {
    let Outliers { count, largest, m4_share, kurtosis_share, .. } = *found;
    let (points, have) = if count == 1 { ("point is", "has") } else { ("points are", "have") };
    let side = if largest > 0.0 { "above" } else { "below" };
    let (percent, of_kurtosis) = (100.0 * m4_share, 100.0 * kurtosis_share);
    let spoilt = match m4_share >= MATTERS {
        true => "radius, density and kurtosis describe",
        false => "the kurtosis describes",
    };
    let warning = Finding::warning(Code::Outliers, "outliers", count as f64)
        .usual([0.0, 0.0])
        .fact(format!(
            "{count} {points} far outside the neighbouring heights (up to {:.3e} m {side}) and {have} {percent:.1} % of m4 and {of_kurtosis:.1} % of the kurtosis",
            largest.abs()
        ))
        .advice(format!("{spoilt} these points, not the surface"))
        .to_do(Advice::Despike);
    found.matter().then_some(warning)
}

/// A warning that the estimator finds no asperities.
pub(crate) fn no_asperities(reason: &str) -> Finding {
    Finding::warning(Code::NoAsperities, "asperities", 0.0)
        .usual([1.0, f64::INFINITY])
        .fact("the surface has no asperities for asperity models")
        .advice(format!("{reason}; boundary elements (bem) need none"))
}

/// A warning if the rms slopes along and across the lay differ.
pub(crate) fn anisotropic(moments: &Moments) -> Option<Finding> {
    let Texture { slope_along, slope_across, direction } = moments.texture()?;
    let (ratio, turned) = (slope_across / slope_along, direction.round() + 0.0);
    let found = Finding::warning(Code::Anisotropic, "slope_ratio", ratio)
        .usual([1.0, APART])
        .fact(format!(
            "the rms slope is {slope_along:.4e} along the lay, {turned} degrees from the rows, and {slope_across:.4e} across it"
        ))
        .advice("models assume isotropic asperities; compare with boundary elements (bem)");
    (ratio > APART).then_some(found)
}

impl Level {
    /// A warning if removing this form tilts a periodic surface.
    #[must_use]
    pub fn tilts(self, periodic: bool) -> Option<Finding> {
        let found = Finding::warning(Code::Level, "level", f64::NAN)
            .fact(format!("level {self} of a periodic surface makes its edges differ"))
            .advice("slopes and curvatures at the edges are wrong; use level mean");
        (periodic && matches!(self, Self::Plane | Self::Quadratic)).then_some(found)
    }
}

/// The larger over the smaller one.
fn ratio(a: f64, b: f64) -> f64 {
    (a / b).max(b / a)
}
