//! Lists of two values that are rather one number with a decimal comma.

use asperity_scene::with_decimal_point;

/// Refuses two values that are rather one with a decimal comma, 1,5e6 or 1,5kN.
pub fn refuse_decimal_comma(text: &str) -> Result<(), String> {
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
    Err(format!("{text} is ambiguous; write {one} for one value, or {two} for two"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::numbers::{all, load, number};

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
            assert_eq!(refuse_decimal_comma(text), Err(wanted));
        }
        for list in ["1,5", "0,100nm", "1.0,5e6", "1e5,2e6", "1,5,9e6", "1um,5um"] {
            assert_eq!(refuse_decimal_comma(list), Ok(()), "{list}");
        }
        let refused = all(load)("0,5").unwrap_err();
        assert_eq!(refused, "0 is not above 0; write 0.5 for one value");
        assert_eq!(number("0,5").unwrap_err(), "\"0,5\" has a decimal comma; write 0.5");
        assert_eq!(load("1,5 kN").unwrap_err(), "\"1,5 kN\" has a decimal comma; write 1.5 kN");
    }
}
