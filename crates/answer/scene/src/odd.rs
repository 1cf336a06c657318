//! Numbers of a surface that are probably in another unit than SI.

use std::f64::consts::PI;

use asperity::{Finding, likely_unit, short};

use crate::finish::Drawing;
use crate::likely::{angle_hint, likely_angle};
use crate::roughness::{Roughness, Way};

/// The first number, given without a unit, that only another unit would make usual, and a text with
/// the likely units of all such numbers.
pub(crate) type Odd = (&'static str, f64, String);

fn odd(
    numbers: impl Iterator<Item = (&'static str, f64)>,
    is_stated: impl Fn(&str) -> bool,
) -> Option<Odd> {
    let numbers = numbers.filter(|(key, _)| !is_stated(key));
    let odd = numbers.filter_map(|(key, value)| Some((key, value, likely_unit(key, value)?)));
    odd.reduce(|(first, number, hint), (key, value, more)| {
        (first, number, format!("{hint}; {key} = {} {more}", short(value)))
    })
}

/// The odd numbers of a surface; asperities are described by their own findings.
pub(crate) fn odd_roughness(
    roughness: &Roughness,
    is_stated: impl Fn(&str) -> bool,
) -> Option<Odd> {
    let is_plain = roughness.way == Way::Asperities
        || steep_slope(roughness).is_some()
        || roughness.numbers.iter().any(|value| *value <= 0.0);
    odd(roughness.by_key().filter(|_| !is_plain), is_stated)
}

/// The odd heights of a drawing.
pub(crate) fn odd_drawing(drawing: &Drawing, is_stated: impl Fn(&str) -> bool) -> Option<Odd> {
    odd(drawing.by_key().filter(|(key, _)| ["ra", "rq", "rz"].contains(key)), is_stated)
}

/// The warning of a slope that is probably in degrees or per cent.
pub(crate) fn steep_slope(roughness: &Roughness) -> Option<Finding> {
    let mut slopes = roughness.by_key().filter(|(key, _)| ["sdq", "mean_slope"].contains(key));
    slopes.find_map(|(key, value)| likely_angle(key, value))
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
