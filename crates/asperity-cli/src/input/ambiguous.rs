//! Commas in numbers of the command line: of lists, decimals or thousands.

use asperity_inputs::{notation_hint, with_decimal_point, without_thousands};

/// Refuses lists that are rather one number, such as 1,5e6, 1,5kN or 1,000,000.
pub fn refuse_one_number(text: &str) -> Result<(), String> {
    let thousand = without_thousands(text);
    // No value of a list begins with two zeros.
    if let Some(hint) = notation_hint(text).filter(|_| text.contains(",0") && thousand.is_some()) {
        return Err(format!("{text} {hint}"));
    }
    let parts = with_decimal_point(text).zip(text.trim().split_once(','));
    let Some((one, (first, second))) = parts else { return Ok(()) };
    let ends = |c: char| c.is_alphabetic() || c == '\u{b5}';
    let (mantissa, unit) = second.split_at(second.find(ends).unwrap_or(second.len()));
    let is_exponent = unit.trim_start_matches(['e', 'E']).parse::<i32>().is_ok();
    let two = match is_exponent {
        true => format!("{first}.0,{second}"),
        // 0,100nm begins a list.
        false if first == "0" && mantissa.trim().ends_with('0') => return Ok(()),
        false if !unit.is_empty() => format!("{first}{unit},{second}"),
        _ => return Ok(()),
    };
    let thousand = thousand.map(|same| format!(" or {same}")).unwrap_or_default();
    Err(format!("{text} is ambiguous; write {one}{thousand} for one value, or {two} for two"))
}

/// Why a number with a comma is refused where one value is taken.
pub fn one_value_only(text: &str) -> Option<String> {
    let one = with_decimal_point(text).filter(|_| without_thousands(text).is_none())?;
    Some(format!("{text:?} has a decimal comma; write {one}, as two values are not possible here"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::lists::all;
    use crate::input::numbers::{load, number};

    #[test]
    fn decimal_commas_are_refused_with_both_readings() {
        for (text, one, two) in [
            ("1,5e6", "1.5e6", "1.0,5e6"),
            ("12,5e6", "12.5e6", "12.0,5e6"),
            ("-2,5E-3", "-2.5E-3", "-2.0,5E-3"),
            ("1,5um", "1.5um", "1um,5um"),
            ("10,25 kN", "10.25 kN", "10kN,25 kN"),
            ("0,5mm", "0.5mm", "0mm,5mm"),
        ] {
            let wanted =
                format!("{text} is ambiguous; write {one} for one value, or {two} for two");
            assert_eq!(refuse_one_number(text), Err(wanted));
        }
        for (text, how) in [
            ("1,000,000", "1,000,000 has thousands separators; write 1000000 or 1e6"),
            ("1,050,200kN", "1,050,200kN has thousands separators; write 1050200kN"),
            ("1,000", "1,000 is ambiguous; write 1.000 or 1000"),
            (
                "1,500kN",
                "1,500kN is ambiguous; write 1.500kN or 1500kN for one value, or 1kN,500kN for two",
            ),
        ] {
            assert_eq!(refuse_one_number(text), Err(how.into()));
        }
        for list in [
            "0.125,0.5,1",
            "0.001,0.1",
            "0.250,0.500",
            "100.125,0.5",
            "1,5",
            "0,100nm",
            "1.0,5e6",
            "1e5,2e6",
            "1,5,9e6",
            "1um,5um",
            "10,100",
            "100,200,300",
            "1,0,5",
        ] {
            assert_eq!(refuse_one_number(list), Ok(()), "{list}");
        }
        let refused = all(load)("0,5").unwrap_err();
        assert_eq!(refused, "0 is not above 0; write 0.5 for one value");
        let one = |text: &str, same: &str| {
            format!(
                "{text:?} has a decimal comma; write {same}, as two values are not possible here"
            )
        };
        assert_eq!(number("0,5").unwrap_err(), one("0,5", "0.5"));
        assert_eq!(load("1,5 kN").unwrap_err(), one("1,5 kN", "1.5 kN"));
        assert_eq!(load("0,125kN").unwrap_err(), one("0,125kN", "0.125kN"));
        let either = load("1,500").unwrap_err();
        assert_eq!(either, "\"1,500\" is ambiguous; write 1.500 or 1500");
    }
}
