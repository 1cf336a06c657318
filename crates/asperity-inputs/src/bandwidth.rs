//! Slopes with which no isotropic Gaussian surface has the other numbers.

use std::f64::consts::PI;

use asperity::ContactError;

use crate::Roughness;
use crate::likely::angle_hint;

/// The alternative to the radius, with the standard deviation of the surface and the density.
pub(crate) const MEAN_SLOPE: &str = "mean_slope";
/// The alternative to `spc`, with `sq` and `spd`.
pub(crate) const GRADIENT: &str = "sdq";
/// The slope above which a surface that is too steep is rather that than given in another unit.
pub(crate) const ROUGH: f64 = 0.3;
/// The field of an error for moments that no isotropic Gaussian surface has.
const BANDWIDTH: &str = "bandwidth (m0 m4/m2^2)";

/// Whether an error is that of moments that no isotropic Gaussian surface has.
pub(crate) fn is_of_bandwidth(error: &ContactError) -> bool {
    matches!(error, ContactError::OutOfRange { field: BANDWIDTH, .. })
}

/// The key of a slope with which no isotropic Gaussian surface has the other numbers, the slope,
/// and what is wrong with it: m0 m4/m2² = 12 √3 π Spd (Sq/Sdq)² is at least 1.5.
pub(crate) fn too_steep(roughness: &Roughness) -> Option<(&'static str, f64, String)> {
    let rough = |std: f64, density: f64| (8.0 * 3f64.sqrt() * density).sqrt() * std;
    let (key, slope, most, formula) = match *roughness {
        Roughness::Gradient([sq, spd, sdq]) => {
            let most = PI.sqrt() * rough(sq, spd);
            (GRADIENT, sdq, most, "6.598 sq sqrt(spd)")
        }
        Roughness::MeanSlope([std, slope, density]) => {
            let formula = "3.722 surface_height_std sqrt(asperity_density)";
            (MEAN_SLOPE, slope, rough(std, density), formula)
        }
        _ => return None,
    };
    let hint = angle_hint(slope).unwrap_or_else(|| {
        let most = asperity::short(most);
        format!("is too steep: at most {formula} = {most} was required, as of every isotropic Gaussian surface")
    });
    Some((key, slope, hint))
}
