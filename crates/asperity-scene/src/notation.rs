//! Numbers with a decimal comma or thousands separators, and how to write them.

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

/// The same text without thousands separators, of a number in groups of three digits, whose unit
/// may follow: `1000000 N` for `1,000,000 N`. One point is a decimal point.
///
/// ```
/// use asperity_scene::without_thousands;
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
    let mut digits = groups.next().filter(|first| (1..=3).contains(&first.len()))?.to_string();
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
    // 1.500,5 has one decimal sign, which is not the separator.
    let decimal = rest.strip_prefix([',', '.']).filter(|_| ",.".contains(separator));
    match decimal {
        Some(fraction) if fraction.starts_with(|c: char| c.is_ascii_digit()) => {
            Some(format!("{sign}{digits}.{fraction}"))
        }
        _ if rest.starts_with([',', '.']) => None,
        _ => (separator != '.' || count > 1).then(|| format!("{sign}{digits}{rest}")),
    }
}

/// How to write a number that is refused for its commas, points or blanks: "has a decimal comma;
/// write 1.5" for `1,5`. `None` for other texts.
#[must_use]
pub fn notation_hint(text: &str) -> Option<String> {
    match (with_decimal_point(text), without_thousands(text)) {
        (Some(decimal), Some(thousands)) => {
            Some(format!("is {decimal} or {thousands}; write one of the two"))
        }
        (Some(decimal), None) => Some(format!("has a decimal comma; write {decimal}")),
        (None, Some(thousands)) => {
            let short = thousands.parse::<f64>().map(|value| format!("{value:e}"));
            let short = short.ok().filter(|short| short.len() < thousands.len());
            let or = short.map_or(String::new(), |short| format!(" or {short}"));
            Some(format!("has thousands separators; write {thousands}{or}"))
        }
        (None, None) => None,
    }
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
        ] {
            assert_eq!(without_thousands(text).as_deref(), plain, "{text}");
        }
    }

    #[test]
    fn hints_give_every_reading() {
        for (text, hint) in [
            ("1,5 N", Some("has a decimal comma; write 1.5 N")),
            ("1,500 N", Some("is 1.500 N or 1500 N; write one of the two")),
            ("1,000,000", Some("has thousands separators; write 1000000 or 1e6")),
            ("1.234.567 N", Some("has thousands separators; write 1234567 N")),
            ("5 N", None),
        ] {
            assert_eq!(notation_hint(text).as_deref(), hint, "{text}");
        }
    }
}
