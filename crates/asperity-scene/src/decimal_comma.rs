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

/// How to write a number with one comma: with a decimal point, or, where three digits follow the
/// comma and it may separate thousands, in either reading.
///
/// ```
/// use asperity_scene::comma_readings;
///
/// assert_eq!(comma_readings("0,3").as_deref(), Some("0.3"));
/// let both = "210000 MPa for thousands or 210.000 MPa for decimals";
/// assert_eq!(comma_readings("210,000 MPa").as_deref(), Some(both));
/// ```
#[must_use]
pub fn comma_readings(text: &str) -> Option<String> {
    let decimals = with_decimal_point(text)?;
    Some(match without_thousands(text) {
        Some(whole) => format!("{whole} for thousands or {decimals} for decimals"),
        None => decimals,
    })
}

/// Whether the comma of a text may separate thousands.
pub(crate) fn may_be_thousands(text: &str) -> bool {
    without_thousands(text).is_some()
}

/// The same text without a comma that may separate thousands, as in 210,000 MPa.
fn without_thousands(text: &str) -> Option<String> {
    let (whole, rest) = text.trim().split_once(',')?;
    let digits = rest.chars().take_while(char::is_ascii_digit).count();
    let first = whole.trim_start_matches(['-', '+']);
    (digits == 3 && first.len() <= 3 && !first.starts_with('0')).then(|| format!("{whole}{rest}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comma_before_three_digits_may_separate_thousands() {
        for (text, readings) in [
            ("1,500 kN", "1500 kN for thousands or 1.500 kN for decimals"),
            ("-12,345", "-12345 for thousands or -12.345 for decimals"),
            ("0,300", "0.300"),
            ("1234,567", "1234.567"),
            ("1,50 kN", "1.50 kN"),
            ("1,5000", "1.5000"),
        ] {
            assert_eq!(comma_readings(text).as_deref(), Some(readings), "{text}");
        }
        assert_eq!(comma_readings("1.5"), None);
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
}
