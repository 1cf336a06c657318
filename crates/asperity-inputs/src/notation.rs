//! Numbers with a decimal comma, thousands separators or a power of ten, and how to write them.

use crate::scaled::{PRODUCTS, mantissa, ten_to};

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
    let separator = body.chars().find(|c| !c.is_ascii_digit())?;
    if !",.'_ \u{2019}\u{a0}\u{202f}".contains(separator) {
        return None;
    }
    let mut groups = body.split(separator);
    // 0,125 and 0.125,0.5 have no thousands.
    let first = |first: &&str| (1..=3).contains(&first.len()) && !first.starts_with('0');
    let mut digits = groups.next().filter(first)?.to_string();
    let (mut count, mut rest) = (0, String::new());
    for group in groups {
        if !rest.is_empty() {
            // What follows the number, a unit for example.
            rest.push(separator);
            rest.push_str(group);
            continue;
        }
        let end = group.find(|c: char| !c.is_ascii_digit()).unwrap_or(group.len());
        let (three, after) = group.split_at_checked(end)?;
        match (three.len(), count) {
            (3, _) => {
                digits.push_str(three);
                count += 1;
            }
            (0, 1..) => rest.push(separator),
            _ => return None,
        }
        rest.push_str(after);
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

/// How to write a number that is refused for its commas, points, blanks or powers: "has a decimal
/// comma; write 1.5" for `1,5`. `None` for other texts.
#[must_use]
pub fn notation_hint(text: &str) -> Option<String> {
    match (with_decimal_point(text), without_thousands(text)) {
        (Some(decimal), Some(thousands)) => {
            Some(format!("is ambiguous; write {decimal} or {thousands}"))
        }
        (Some(decimal), None) => Some(format!("has a decimal comma; write {decimal}")),
        (None, Some(thousands)) => {
            let short = thousands.parse::<f64>().map(|value| format!("{value:e}"));
            let short = short.ok().filter(|short| short.len() < thousands.len());
            let or = short.map_or(String::new(), |short| format!(" or {short}"));
            Some(format!("has thousands separators; write {thousands}{or}"))
        }
        (None, None) => with_exponent(text)
            .map(|same| format!("has a power of ten; write {same}"))
            .or_else(|| Some(format!("has a raised dot; write {}", without_raised_dot(text)?)))
            .or_else(|| {
                let refused = "has blanks between its digits; write one number without blanks";
                has_blank(text).then(|| refused.into())
            }),
    }
}

/// A number with a power of ten as `1.5e3 N`, for `1.5 10^3 N`, `1.5 x 10^3 N` and `10^3`.
fn with_exponent(text: &str) -> Option<String> {
    let text = text.trim();
    let (number, rest) = match ten_to(text) {
        Some(_) => ("1".into(), text),
        None => mantissa(text).filter(|(number, _)| !number.contains('e'))?,
    };
    let power = rest.trim_start();
    let power = power.strip_prefix(PRODUCTS).map_or(power, str::trim_start);
    let (power, unit) = ten_to(power)?;
    Some(format!("{number}e{power}{unit}"))
}

/// `1.5 kN` for a number with a raised dot.
fn without_raised_dot(text: &str) -> Option<String> {
    let (whole, rest) = text.trim().split_once('\u{b7}')?;
    let is_whole = !whole.is_empty() && whole.chars().all(|c| c.is_ascii_digit());
    let is_decimal = is_whole && rest.starts_with(|c: char| c.is_ascii_digit());
    is_decimal.then(|| format!("{whole}.{rest}"))
}

/// Whether a number is followed by a blank and further digits.
fn has_blank(text: &str) -> bool {
    mantissa(text.trim()).is_some_and(|(_, rest)| {
        let next = mantissa(rest.trim_start());
        rest.starts_with(char::is_whitespace)
            && next.is_some_and(|(_, rest)| !rest.starts_with('/'))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

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
            ("10^2 N", Some("has a power of ten; write 1e2 N")),
            ("1.5 10^3 N", Some("has a power of ten; write 1.5e3 N")),
            ("5 x 10\u{207b}\u{2076}", Some("has a power of ten; write 5e-6")),
            ("1\u{b7}5 kN", Some("has a raised dot; write 1.5 kN")),
            ("10 20 N", Some("has blanks between its digits; write one number without blanks")),
            ("5 N", None),
            ("5 1/mm2", None),
        ] {
            assert_eq!(notation_hint(text).as_deref(), hint, "{text}");
        }
    }
}
