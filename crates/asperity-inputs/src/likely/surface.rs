//! Numbers of a surface that are probably in another unit than SI.

use std::f64::consts::PI;

use asperity::short;

use crate::keys::Key;
use crate::likely::angle_hint;
use crate::{Roughness, Way};

/// Keys, the range of their numbers on rough surfaces in SI units, and the units that are taken for
/// these, likeliest first.
type Slip = (&'static [&'static str], [f64; 2], &'static [(&'static str, f64)]);
const SLIPS: [Slip; 6] = [
    (
        &["sq", "surface_height_std", "asperity_height_std", "ra", "rq", "rz"],
        [3e-11, 2e-3],
        &[("um", 1e-6), ("nm", 1e-9)],
    ),
    (&["asperity_radius"], [2e-9, 5e-2], &[("mm", 1e-3), ("um", 1e-6)]),
    (&["spd", "asperity_density"], [1e6, 1e16], &[("1/mm2", 1e6), ("1/um2", 1e12)]),
    (&["spc"], [100.0, 5e8], &[("1/mm", 1e3), ("1/um", 1e6)]),
    (&["m0"], [1e-21, 4e-6], &[("um2", 1e-12), ("nm2", 1e-18)]),
    (&["m4"], [100.0, 1e17], &[("1/mm2", 1e6), ("1/um2", 1e12)]),
];

/// "looks like um; 1.1 um is 1.1e-6 m" for a number that only another unit makes usual.
pub(crate) fn other_unit(key: &str, value: f64) -> Option<String> {
    let (_, [least, most], units) = SLIPS.iter().find(|(keys, ..)| keys.contains(&key))?;
    let is_usual = |x: f64| (*least..=*most).contains(&x);
    let (unit, size) = units.iter().find(|(_, size)| !is_usual(value) && is_usual(value * size))?;
    let (given, meant) = (short(value), short(value * size));
    let si = Key::find("surface", key)?.unit.replace('^', "");
    Some(format!("looks like {unit}; {given} {unit} is {meant} {si}"))
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
