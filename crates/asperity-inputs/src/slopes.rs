//! Slopes as gradients, angles and ratios of lengths.

use std::f64::consts::{FRAC_PI_2, PI};

use asperity::{Finding, plain_unit as plain};

use crate::notation::with_decimal_point;
use crate::scaled::{leading, scale};

/// The gradient above which it is probably in degrees or per cent: 45 degrees.
const STEEP: f64 = 1.0;
/// The largest gradient that is probably in per cent.
const STEEPEST: f64 = 200.0;

/// A warning for a gradient, of this name, that is probably in degrees or per cent.
///
/// ```
/// let found = asperity_inputs::likely_angle("mean_slope", 7.0).unwrap().to_string();
/// let text = "mean_slope is 7, steeper than 45 degrees: 7 looks like degrees or per cent; 7 deg is 0.1228, 7 % is 0.07";
/// assert_eq!(found, text);
/// assert_eq!(asperity_inputs::likely_angle("mean_slope", 0.07), None);
/// ```
#[must_use]
pub fn likely_angle(name: &str, gradient: f64) -> Option<Finding> {
    let (given, hint) = (asperity::short(gradient), angle_hint(gradient)?);
    let found = Finding::warning("unit", name.to_string(), gradient);
    let found = found.fact(format!("`{name}` is {given}, steeper than 45 degrees"));
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

/// Units of a gradient: ratios of lengths, with their size.
const RATIOS: [(&str, f64); 7] = [
    ("%", 0.01),
    ("percent", 0.01),
    ("um/mm", 1e-3),
    ("um/um", 1.0),
    ("mm/m", 1e-3),
    ("mm/mm", 1.0),
    ("m/m", 1.0),
];
/// Units of an angle, with their size \[rad\].
const ANGLES: [(&str, f64); 7] = [
    ("deg", PI / 180.0),
    ("degree", PI / 180.0),
    ("degrees", PI / 180.0),
    ("\u{b0}", PI / 180.0),
    ("rad", 1.0),
    ("mrad", 1e-3),
    ("grad", PI / 200.0),
];

/// The number of a text in one of the units, times its size.
fn in_units(text: &str, units: &[(&str, f64)]) -> Option<f64> {
    let decimal = with_decimal_point(text);
    let (number, power, rest) = leading(decimal.as_deref().unwrap_or(text))?;
    let unit = plain(rest);
    let (_, size) = units.iter().find(|(name, _)| *name == unit)?;
    Some(scale(&number, power)? * size)
}

/// Whether a text is an angle in a known unit.
pub(crate) fn is_angle(text: &str) -> bool {
    in_units(text, &ANGLES).is_some()
}

/// The gradient that a text states in per cent, degrees, radians or as a ratio of lengths, as a
/// number; `None` for angles that are not between 0 and 90 degrees.
///
/// ```
/// assert_eq!(asperity_inputs::gradient("6 %"), Some(0.06));
/// assert_eq!(asperity_inputs::gradient("90 deg"), None);
/// ```
#[must_use]
pub fn gradient(text: &str) -> Option<f64> {
    let angle = || in_units(text, &ANGLES).filter(|angle| (0.0..FRAC_PI_2).contains(angle));
    let found = in_units(text, &RATIOS).or_else(|| angle().map(f64::tan));
    found.filter(|found| found.is_finite())
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
            ("70 mrad", 0.07011),
            ("1570 mrad", 1255.7656),
            ("4 grad", 0.06291),
            ("4 degrees", 0.06993),
            ("7 percent", 0.07),
            ("1e-3 rad", 1e-3),
            ("58 um/mm", 0.058),
            ("0.058 \u{b5}m/\u{b5}m", 0.058),
        ] {
            assert!((gradient(text).unwrap() - wanted).abs() < 5e-5, "{text}");
        }
        for text in ["90 deg", "100\u{b0}", "-3 deg", "2 rad", "100 grad", "1571 mrad"] {
            assert_eq!(gradient(text), None, "{text}");
        }
        assert!(gradient("6").is_none() && gradient("6 um").is_none() && gradient("%").is_none());
    }
}
