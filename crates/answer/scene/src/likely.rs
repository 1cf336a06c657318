//! Numbers that are probably written in another notation or unit, and how to write them.

use std::f64::consts::{FRAC_PI_2, PI};

use asperity::{Code, Finding, plain_unit as plain, short, vickers_of_rockwell_c};

use crate::keys::Key;
use crate::scaled::{leading, scale};

mod lengths;

pub use lengths::mistaken_unit;

/// The same text with a decimal point, of a number with a decimal comma, whose unit may follow:
/// `1.5 kN` for `1,5 kN`.
///
/// ```
/// use asperity_scene::with_decimal_point;
///
/// assert_eq!(with_decimal_point("1,5 kN").as_deref(), Some("1.5 kN"));
/// assert_eq!(with_decimal_point("1.000,5"), None);
/// ```
#[must_use]
pub fn with_decimal_point(text: &str) -> Option<String> {
    let (whole, rest) = text.trim().split_once(',')?;
    let digits = whole.trim_start_matches(['-', '+']);
    let is_whole = !digits.is_empty() && digits.chars().all(|c| c.is_ascii_digit());
    let is_number = is_whole
        && rest.starts_with(|c: char| c.is_ascii_digit())
        && !rest.contains([',', '.', ':']);
    is_number.then(|| format!("{whole}.{rest}"))
}

/// What is wrong with a number that is refused for its commas or points: "has a decimal comma;
/// write 1.5" for `1,5`. `None` for other texts.
#[must_use]
pub fn notation_hint(text: &str) -> Option<String> {
    let digits =
        |text: &str| text.len() - text.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    if let Some((decimal, (whole, rest))) =
        with_decimal_point(text).zip(text.trim().split_once(','))
    {
        let bare = whole.trim_start_matches(['-', '+']);
        let is_group = digits(rest) == 3 && bare.len() < 4 && !bare.starts_with('0');
        return Some(match is_group {
            true => format!("is ambiguous; write {decimal} or {whole}{rest}"),
            false => format!("has a decimal comma; write {decimal}"),
        });
    }
    // Groups of three digits behind a separator; one point is a decimal point.
    let groups = |separators: &'static str| {
        let parts = text.split(|c| separators.contains(c)).skip(1);
        parts.filter(|part| digits(part) == 3).count()
    };
    let has_groups =
        groups(",'_\u{2019}\u{a0}\u{202f}") > 0 || groups(".") > usize::from(!text.contains(','));
    has_groups.then(|| "has thousands separators; remove them".into())
}

/// How to write a number of a key that is given as a text without a unit that the key has.
pub(crate) fn number_hint(key: &str, text: &str) -> Option<String> {
    let is_number = |text: &str| text.trim().parse::<f64>().is_ok_and(f64::is_finite);
    if is_number(text) {
        let typed = Key::find("", key).filter(|key| !key.unit.is_empty());
        let unit = typed.and_then(|key| key.form[1].split_once(' '));
        let number = text.trim().parse::<f64>().unwrap_or_default();
        return Some(match unit {
            Some(_) if key == "hardness" && number >= TESTED => {
                let scales = match vickers_of_rockwell_c(number) {
                    Some(_) => &["HRC", "HV"][..],
                    None => &["HV"],
                };
                let each = scales.iter().map(|scale| format!("\"{} {scale}\"", text.trim()));
                format!("has no unit; write {}, for example", each.collect::<Vec<_>>().join(" or "))
            }
            Some((_, unit)) => {
                format!("has no unit; write \"{} {unit}\", for example", text.trim())
            }
            None => "is a number in quotes; remove these".into(),
        });
    }
    if let Some(slope) = gradient(text).filter(|_| ["sdq", "mean_slope"].contains(&key)) {
        return Some(format!("is a slope; write {} without quotes", short(slope)));
    }
    let is_plain = with_decimal_point(text).is_some_and(|same| is_number(&same));
    Some(notation_hint(text)? + if is_plain { " without quotes" } else { "" })
}

/// The number and the scale of a text that is the result of a hardness test: 120 and HV of
/// `120 HV`, `120 HV10` or `HV 120`; also of HRC and HB (`200 HBW`).
pub(crate) fn hardness_test(text: &str) -> Option<(f64, &'static str)> {
    let text = text.to_uppercase();
    ["HV", "HRC", "HBW", "HB"].into_iter().find_map(|scale| {
        let (before, after) = text.trim().split_once(scale)?;
        let number = [before, after].into_iter().find_map(|text| text.trim().parse::<f64>().ok());
        number.filter(|value| value.is_finite()).map(|number| (number, scale))
    })
}

/// Least number of a hardness in quotes without a unit that is none in GPa: only diamond is harder.
const TESTED: f64 = 20.0;

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
pub fn likely_angle(name: &str, gradient: f64) -> Option<Finding> {
    let (given, hint) = (short(gradient), angle_hint(gradient)?);
    let found = Finding::warning(Code::LikelyUnit, name.to_string(), gradient);
    let found = found.fact(format!("{name} is {given}, steeper than 45 degrees"));
    Some(found.advice(format!("{given} {hint}")))
}

/// "looks like degrees or per cent; 7 deg is 0.1228, 7 % is 0.07" for a gradient of 7.
pub(crate) fn angle_hint(gradient: f64) -> Option<String> {
    let slope = gradient.to_radians().tan();
    let [given, slope, share] = [gradient, slope, 0.01 * gradient].map(short);
    (gradient > STEEP && gradient <= STEEPEST).then(|| match gradient < 89.0 {
        true => {
            format!("looks like degrees or per cent; {given} deg is {slope}, {given} % is {share}")
        }
        false => format!("looks like per cent; {given} % is {share}"),
    })
}

/// Units of a gradient with their size, and whether they are units of an angle.
const GRADIENTS: [(&str, f64, bool); 11] = [
    ("%", 0.01, false),
    ("percent", 0.01, false),
    ("um/mm", 1e-3, false),
    ("mm/m", 1e-3, false),
    ("um/um", 1.0, false),
    ("deg", PI / 180.0, true),
    ("degrees", PI / 180.0, true),
    ("\u{b0}", PI / 180.0, true),
    ("rad", 1.0, true),
    ("mrad", 1e-3, true),
    ("grad", PI / 200.0, true),
];

/// The gradient that a text states in per cent, degrees, radians or as a ratio of lengths, as a
/// number; `None` for angles that are not between 0 and 90 degrees.
///
/// ```
/// assert_eq!(asperity_scene::gradient("6 %"), Some(0.06));
/// assert_eq!(asperity_scene::gradient("90 deg"), None);
/// ```
#[must_use]
pub fn gradient(text: &str) -> Option<f64> {
    let decimal = with_decimal_point(text);
    let (number, rest) = leading(decimal.as_deref().unwrap_or(text))?;
    let unit = plain(&rest);
    let (_, size, is_angle) = GRADIENTS.iter().find(|(name, ..)| *name == unit)?;
    let found = scale(&number, 0)? * size;
    match is_angle {
        true => (0.0..FRAC_PI_2).contains(&found).then(|| found.tan()),
        false => Some(found).filter(|found| found.is_finite()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SEPARATORS: &str = "has thousands separators; remove them";

    #[test]
    fn gradients_above_one_look_like_degrees_or_per_cent() {
        let hint = |gradient| likely_angle("sdq", gradient).unwrap().to_string();
        assert!(hint(12.0).contains("12 deg is 0.2126, 12 % is 0.12"));
        assert!(hint(90.0).contains("90 % is 0.9") && !hint(90.0).contains("deg is"));
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

    #[test]
    fn one_comma_between_digits_is_a_decimal_comma() {
        for (text, point) in [
            ("0,3", Some("0.3")),
            (" -1,5e-6", Some("-1.5e-6")),
            ("1,1 um", Some("1.1 um")),
            ("3e-1,5", None),
            ("1,5,2", None),
            ("1, 5", None),
            ("a,5", None),
            ("1,", None),
            ("1.5", None),
        ] {
            assert_eq!(with_decimal_point(text).as_deref(), point, "{text}");
        }
    }

    #[test]
    fn hints_give_every_reading() {
        for (text, hint) in [
            ("1,5 N", Some("has a decimal comma; write 1.5 N")),
            ("1,500 N", Some("is ambiguous; write 1.500 N or 1500 N")),
            ("1,000,000", Some(SEPARATORS)),
            ("1.234.567 N", Some(SEPARATORS)),
            ("1.500,5 N", Some(SEPARATORS)),
            ("12\u{202f}500 N", Some(SEPARATORS)),
            ("5 N", None),
            ("1.500", None),
            ("1,5,0", None),
            ("5 1/mm2", None),
        ] {
            assert_eq!(notation_hint(text).as_deref(), hint, "{text}");
        }
    }
}
