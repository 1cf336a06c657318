//! Numbers that are probably written in another notation or unit, and how to write them.

use std::f64::consts::{FRAC_PI_2, PI};

use asperity::{Finding, HARDNESS_OVER_YIELD, hardness_of_vickers, plain_unit as plain, short};

use crate::scaled::{leading, scale};

mod lengths;
mod surface;

pub use lengths::mistaken_unit;
pub(crate) use surface::{other_unit, too_steep};

/// The same text with a decimal point, of a number with a decimal comma, whose unit may follow:
/// `1.5 kN` for `1,5 kN`.
///
/// ```
/// use asperity_inputs::with_decimal_point;
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

/// The same text without thousands separators, of a number in groups of three digits, whose unit
/// may follow: `1000000 N` for `1,000,000 N`. One point is a decimal point.
///
/// ```
/// use asperity_inputs::without_thousands;
///
/// assert_eq!(without_thousands("1.500,5 N").as_deref(), Some("1500.5 N"));
/// assert_eq!(without_thousands("1.500"), None);
/// ```
#[must_use]
pub fn without_thousands(text: &str) -> Option<String> {
    let text = text.trim();
    let body = text.trim_start_matches(['-', '+']);
    let sign = text.get(..text.len() - body.len())?;
    let number = |text: &'_ str| text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    let (first, mut rest) = body.split_at(number(body));
    let separator = rest.chars().next().filter(|c| ",.'_ \u{2019}\u{a0}\u{202f}".contains(*c))?;
    // 0,125 and 0.125,0.5 have no thousands.
    let is_first = (1..=3).contains(&first.len()) && !first.starts_with('0');
    let (mut digits, mut count) = (is_first.then(|| first.to_string())?, 0);
    while let Some(group) = rest.strip_prefix(separator) {
        let (three, after) = group.split_at(number(group));
        match (three.len(), count) {
            (3, _) => digits.push_str(three),
            (0, 1..) => break,
            _ => return None,
        }
        (rest, count) = (after, count + 1);
    }
    // 1.500,5 has one decimal sign, which is not the separator; 1'500,5 may be a list.
    let signs = if ",.".contains(separator) { &[',', '.'][..] } else { &['.'] };
    let decimal = rest.strip_prefix(signs);
    match decimal {
        // 1.000,2.000 is a list of two.
        Some(fraction) if fraction.contains([',', '.']) => None,
        Some(fraction) if fraction.starts_with(|c: char| c.is_ascii_digit()) => {
            Some(format!("{sign}{digits}.{fraction}"))
        }
        _ if rest.starts_with([',', '.']) => None,
        _ => (separator != '.' || count > 1).then(|| format!("{sign}{digits}{rest}")),
    }
}

/// How to write a number that is refused for its commas or points: "has a decimal comma; write 1.5"
/// for `1,5`. `None` for other texts.
#[must_use]
pub fn notation_hint(text: &str) -> Option<String> {
    Some(match (with_decimal_point(text), without_thousands(text)) {
        (Some(decimal), Some(thousands)) => {
            format!("is ambiguous; write {decimal} or {thousands}")
        }
        (Some(decimal), None) => format!("has a decimal comma; write {decimal}"),
        (None, Some(thousands)) => {
            let short = thousands.parse::<f64>().map(|value| format!("{value:e}"));
            let short = short.ok().filter(|short| short.len() < thousands.len());
            let or = short.map_or(String::new(), |short| format!(" or {short}"));
            format!("has thousands separators; write {thousands}{or}")
        }
        (None, None) => return None,
    })
}

/// How to write a number of a key that is given as a text without a unit that the key has.
pub(crate) fn number_hint(key: &str, text: &str) -> Option<String> {
    let is_number = |text: &str| text.trim().parse::<f64>().is_ok_and(f64::is_finite);
    if is_number(text) {
        return Some("is a number in quotes; remove these".into());
    }
    if let Some(slope) = gradient(text).filter(|_| ["sdq", "mean_slope"].contains(&key)) {
        return Some(format!("is a slope; write {} without quotes", short(slope)));
    }
    let same = with_decimal_point(text).or_else(|| without_thousands(text))?;
    let end = if is_number(&same) { " without quotes" } else { "" };
    Some(notation_hint(text)? + end)
}

/// The reason against a hardness such as `120 HV` as a yield strength, behind the text in a
/// message; `None` for other texts.
pub(crate) fn not_a_hardness(text: &str) -> Option<String> {
    let contact = hardness_of_vickers(vickers(text)?);
    let [contact, strength] = [contact, contact / HARDNESS_OVER_YIELD]
        .map(|pascal| format!("{}GPa", short(1e-9 * pascal)));
    Some(format!(
        "is a hardness, not a yield strength: give hardness = \"{contact}\" instead; the yield strength is about {strength} if the contact hardness is {HARDNESS_OVER_YIELD} times as large, as of metals that hardly harden"
    ))
}

/// The Vickers number of a text: 120 of `120 HV`, `120 HV10` or `HV 120`.
pub(crate) fn vickers(text: &str) -> Option<f64> {
    let text = text.to_uppercase();
    let (before, after) = text.trim().split_once("HV")?;
    let number = [before, after].into_iter().find_map(|text| text.trim().parse::<f64>().ok());
    number.filter(|value| value.is_finite())
}

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
    let (given, hint) = (short(gradient), angle_hint(gradient)?);
    let found = Finding::warning("unit", name.to_string(), gradient);
    let found = found.fact(format!("`{name}` is {given}, steeper than 45 degrees"));
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
/// assert_eq!(asperity_inputs::gradient("6 %"), Some(0.06));
/// assert_eq!(asperity_inputs::gradient("90 deg"), None);
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
    fn groups_of_three_digits_are_thousands() {
        for (text, plain) in [
            ("1,000,000", Some("1000000")),
            ("-1,234,567.5e3", Some("-1234567.5e3")),
            ("1.500.000 Pa", Some("1500000 Pa")),
            ("1.500,25 N", Some("1500.25 N")),
            ("12 500 N", Some("12500 N")),
            ("1'500", Some("1500")),
            ("500'000.0", Some("500000.0")),
            ("12\u{202f}500.5 N", Some("12500.5 N")),
            ("1_000 N/m", Some("1000 N/m")),
            ("1\u{202f}500,5", None),
            ("1,500", Some("1500")),
            ("1,500kN", Some("1500kN")),
            // A decimal point, and what is no group.
            ("1.500", None),
            ("1.500 N", None),
            ("1,50,000", None),
            ("1000,000", None),
            ("1,5", None),
            ("1,0000", None),
            (",000", None),
            ("1,000,", None),
            ("1,000.", None),
            ("5 mm", None),
            ("1500", None),
            ("", None),
            ("\u{b5},000", None),
            // No thousands begin with 0, and a number has one decimal sign.
            ("0,125", None),
            ("0.125,0.5,1", None),
            ("0.250,0.500", None),
            ("1.000,2.000", None),
            ("10.125,20.5", None),
        ] {
            assert_eq!(without_thousands(text).as_deref(), plain, "{text}");
        }
    }

    #[test]
    fn hints_give_every_reading() {
        for (text, hint) in [
            ("1,5 N", Some("has a decimal comma; write 1.5 N")),
            ("0,125 um", Some("has a decimal comma; write 0.125 um")),
            ("1,500 N", Some("is ambiguous; write 1.500 N or 1500 N")),
            ("1,000,000", Some("has thousands separators; write 1000000 or 1e6")),
            ("1.234.567 N", Some("has thousands separators; write 1234567 N")),
            ("5 N", None),
            ("5 1/mm2", None),
        ] {
            assert_eq!(notation_hint(text).as_deref(), hint, "{text}");
        }
    }

    #[test]
    fn a_vickers_number_is_no_yield_strength() {
        let strength = not_a_hardness("120 HV").unwrap();
        assert!(strength.starts_with("is a hardness, not a yield strength: give hardness = \"1.269GPa\" instead; the yield strength is about 0.4533GPa if"), "{strength}");
        assert_eq!(not_a_hardness("120 MPa"), None);
    }
}
