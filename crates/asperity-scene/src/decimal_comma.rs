//! Numbers with a decimal comma, and how to write them.

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
}
