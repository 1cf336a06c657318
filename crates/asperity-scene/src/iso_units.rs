//! Likely units of numbers of a surface that are given without one.

use std::f64::consts::FRAC_PI_2;

use asperity::{Diagnostic, Surface};

use crate::Roughness;
use crate::notation::with_decimal_point;

/// The units, SI first, in which instruments report numbers of a surface, the usual ones second;
/// slopes have none.
fn units_of(key: &str) -> &'static [(&'static str, f64)] {
    match key {
        "sq" | "surface_height_std" => &[("m", 1.0), ("um", 1e-6), ("nm", 1e-9)],
        "asperity_radius" => &[("m", 1.0), ("um", 1e-6), ("mm", 1e-3)],
        "spd" | "asperity_density" => &[("1/m2", 1.0), ("1/mm2", 1e6), ("1/um2", 1e12)],
        "spc" => &[("1/m", 1.0), ("1/mm", 1e3), ("1/um", 1e6)],
        "m0" => &[("m2", 1.0), ("um2", 1e-12), ("nm2", 1e-18)],
        "m4" => &[("1/m2", 1.0), ("1/mm2", 1e6), ("1/um2", 1e12)],
        _ => &[("", 1.0)],
    }
}

/// A number of a surface in a unit that makes the surface usual.
pub(crate) struct LikelyUnits {
    /// The first key whose number is in another unit.
    pub(crate) key: &'static str,
    /// Its number as given.
    pub(crate) value: f64,
    /// All such numbers, as given and in SI units.
    pub(crate) hint: String,
}

/// The units in which numbers that were given without one describe a usual surface.
pub(crate) fn likely_units(
    roughness: &Roughness,
    is_stated: impl Fn(&str) -> bool,
) -> Option<LikelyUnits> {
    let (keys, given) = (roughness.keys(), roughness.numbers());
    // Indices of units; one of them is tried for a number without a unit only.
    let triples = (0..27).map(|k| [k % 3, k / 3 % 3, k / 9]);
    // The fewest changes first, then the units that instruments prefer.
    let likeliest = |units: &[usize; 3]| [0, 1].map(|k| units.iter().filter(|u| **u == k).count());
    let converted = |units: &[usize; 3], k: usize| {
        let (key, index, value) = (*keys.get(k)?, *units.get(k)?, *given.get(k)?);
        let (unit, factor) = units_of(key).get(index)?;
        (index == 0 || !is_stated(key)).then_some((key, value, *unit, value * factor))
    };
    let [from, to] = Surface::USUAL_ASPERITY_ROUGHNESS;
    let usual = |units: &[usize; 3]| {
        let number = |k| converted(units, k).map(|(.., meant)| meant);
        let numbers = number(0).zip(number(1)).zip(number(2));
        let surface = numbers.map(|((a, b), c)| roughness.with([a, b, c]).surface());
        surface.and_then(Result::ok).is_some_and(|surface| {
            surface.findings().is_empty() && (from..=to).contains(&surface.roughness_parameter())
        })
    };
    let units = triples.filter(usual).max_by_key(likeliest)?;
    let changed = (0..3).filter(|k| units.get(*k).is_some_and(|index| *index > 0));
    let changed: Vec<_> = changed.filter_map(|k| converted(&units, k)).collect();
    let (key, value, ..) = *changed.first()?;
    let hint = |(key, value, unit, meant): (&str, f64, &str, f64)| {
        let [value, meant] = [value, meant].map(asperity::short);
        format!("{key} = {value} looks like {unit}; {value} {unit} is {meant} in SI units")
    };
    let hint = changed.into_iter().map(hint).collect::<Vec<_>>().join("; ");
    Some(LikelyUnits { key, value, hint })
}

/// The gradient above which it is probably in degrees or per cent: 45 degrees.
const STEEP: f64 = 1.0;
/// The largest gradient that is probably in per cent.
const STEEPEST: f64 = 200.0;

/// A warning for a gradient, of this name, that is probably in degrees or per cent.
///
/// ```
/// let found = asperity_scene::likely_angle("mean_slope", 7.0).unwrap().to_string();
/// let text = "mean_slope is 7, steeper than 45 degrees: 7 looks like degrees or per cent; 7 deg is 0.1228, 7 % is 0.07";
/// assert_eq!(found, text);
/// assert_eq!(asperity_scene::likely_angle("mean_slope", 0.07), None);
/// ```
#[must_use]
pub fn likely_angle(name: &str, gradient: f64) -> Option<Diagnostic> {
    let (given, hint) = (asperity::short(gradient), angle_hint(gradient)?);
    let found = Diagnostic::warning("unit", name.to_string(), gradient);
    let found = found.fact(format!("{name} is {given}, steeper than 45 degrees"));
    Some(found.advice(format!("{given} {hint}")))
}

/// "looks like degrees or per cent; 7 deg is 0.1228, 7 % is 0.07" for a gradient of 7.
pub(crate) fn angle_hint(gradient: f64) -> Option<String> {
    let slope = gradient.to_radians().tan();
    let [given, slope, share] = [gradient, slope, 0.01 * gradient].map(asperity::short);
    (gradient > STEEP && gradient <= STEEPEST).then(|| match gradient < 89.0 {
        true => {
            format!("looks like degrees or per cent; {given} deg is {slope}, {given} % is {share}")
        }
        false => format!("looks like per cent; {given} % is {share}"),
    })
}

/// Mean curvatures of peaks below this \[1/m\], radii above 1 cm, are probably in 1/mm.
const FLAT: f64 = 100.0;

/// A warning for a mean curvature of peaks that is probably in 1/mm.
pub(crate) fn likely_curvature(spc: f64) -> Option<Diagnostic> {
    (spc > 0.0 && spc < FLAT).then(|| {
        let [given, radius, meant] = [spc, 1.0 / spc, 1e3 * spc].map(asperity::short);
        let hint = format!("{given} looks like 1/mm; {given} 1/mm is {meant} 1/m");
        Diagnostic::warning("unit", "spc", spc)
            .fact(format!("spc is {given} 1/m, peaks of radius {radius} m"))
            .advice("check the number and its unit")
            .likely_unit(hint)
    })
}

/// Units of a gradient that are ratios of lengths, with their size.
const RATIOS: [(&str, f64); 5] = [
    ("um/mm", 1e-3),
    ("\u{b5}m/mm", 1e-3),
    ("um/um", 1.0),
    ("\u{b5}m/\u{b5}m", 1.0),
    ("mm/m", 1e-3),
];

/// The gradient that a text states in per cent, degrees, radians or as a ratio of lengths, as a
/// number; `None` for angles that are not between 0 and 90 degrees.
#[must_use]
pub fn gradient(text: &str) -> Option<f64> {
    let number = |end: &str| {
        let number = text.trim().strip_suffix(end)?.trim();
        with_decimal_point(number).unwrap_or(number.into()).parse::<f64>().ok()
    };
    let degrees = || number("deg").or_else(|| number("\u{b0}")).map(f64::to_radians);
    let angle =
        || degrees().or_else(|| number("rad")).filter(|angle| (0.0..FRAC_PI_2).contains(angle));
    let ratio = || RATIOS.into_iter().find_map(|(unit, size)| Some(size * number(unit)?));
    let found = number("%").map(|percent| 0.01 * percent).or_else(ratio);
    found.or_else(|| angle().map(f64::tan)).filter(|found| found.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gradients_above_one_look_like_degrees_or_per_cent() {
        let text = "sdq is 12, steeper than 45 degrees: 12 looks like degrees or per cent; 12 deg is 0.2126, 12 % is 0.12";
        assert_eq!(likely_angle("sdq", 12.0).unwrap().to_string(), text);
        let text = "sdq is 90, steeper than 45 degrees: 90 looks like per cent; 90 % is 0.9";
        assert_eq!(likely_angle("sdq", 90.0).unwrap().to_string(), text);
        assert_eq!((likely_angle("sdq", 0.4), likely_angle("sdq", 300.0)), (None, None));
    }

    #[test]
    fn texts_with_per_cent_or_degrees_are_gradients() {
        for (text, wanted) in [
            ("6 %", 0.06),
            ("6,5 %", 0.065),
            ("12deg", 0.2126),
            ("45\u{b0}", 1.0),
            ("0.058 rad", 0.05807),
            ("58 um/mm", 0.058),
            ("0.058 \u{b5}m/\u{b5}m", 0.058),
        ] {
            assert!((gradient(text).unwrap() - wanted).abs() < 5e-5, "{text}");
        }
        for text in ["90 deg", "100\u{b0}", "-3 deg", "2 rad"] {
            assert_eq!(gradient(text), None, "{text}");
        }
        assert!(gradient("6").is_none() && gradient("6 um").is_none() && gradient("%").is_none());
    }
}
