//! Numbers of a surface that are probably in another unit than SI.

use std::f64::consts::PI;

use asperity::{Code, Finding, likely_unit, short};

use crate::document::Document;
use crate::keys::joined;
use crate::likely::angle_hint;
use crate::{Roughness, Way};

/// The first number of a section, given without a unit, that only another unit would make usual,
/// and a text with the likely units of all such numbers.
pub(crate) fn other_unit(
    document: &Document<'_>,
    section: &str,
    numbers: impl IntoIterator<Item = (&'static str, f64)>,
) -> Option<(&'static str, f64, String)> {
    let numbers = numbers.into_iter();
    let numbers = numbers.filter(|(key, _)| !document.stated.contains(&joined(section, key)));
    let odd = numbers.filter_map(|(key, value)| Some((key, value, likely_unit(key, value)?)));
    odd.reduce(|(first, number, hint), (key, value, more)| {
        (first, number, format!("{hint}; {key} = {} {more}", short(value)))
    })
}

/// The finding of a number in another unit.
pub(crate) fn in_other_unit(
    document: &Document<'_>,
    section: &str,
    (key, value, hint): (&'static str, f64, String),
) -> Finding {
    let fact = format!("{} = {} {hint}", document.place(&joined(section, key)), short(value));
    Finding::warning(Code::UnusualSize, key, value).fact(fact)
}

/// The key of a slope with which no isotropic Gaussian surface has the other numbers, the slope,
/// and what is wrong with it: m0 m4/m2² = 12 √3 π Spd (Sq/Sdq)² is at least 1.5.
pub(crate) fn too_steep(roughness: &Roughness) -> Option<(&'static str, f64, String)> {
    let [std, second, third] = roughness.numbers;
    let most = |density: f64| (8.0 * 3f64.sqrt() * density).sqrt() * std;
    let (key, slope, most, formula) = match roughness.way {
        Way::Gradient => ("sdq", third, PI.sqrt() * most(second), "6.598 sq sqrt(spd)"),
        Way::MeanSlope => {
            let formula = "3.722 surface_height_std sqrt(asperity_density)";
            ("mean_slope", second, most(third), formula)
        }
        _ => return None,
    };
    let required = "was required, as of every isotropic Gaussian surface";
    let steep = || format!("is too steep: at most {formula} = {} {required}", short(most));
    Some((key, slope, angle_hint(slope).unwrap_or_else(steep)))
}
