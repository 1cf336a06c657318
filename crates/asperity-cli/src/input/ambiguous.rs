//! Commas in numbers of the command line: of lists, decimals or thousands.

use asperity_inputs::{notation_hint, with_decimal_point, without_thousands};
use clap::{ArgMatches, Command};

use crate::input::distances::Distances;
use crate::input::lists::Numbers;
use crate::output::print_always;

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

/// The single numbers that a list of plain values may be: 1500 and 1.500 for 1,500.
fn single_values(text: &str) -> Vec<String> {
    let is_plain = |same: &String| same.chars().all(|c| c.is_ascii_digit() || "+-.".contains(c));
    let thousands = without_thousands(text)
        .filter(|same| is_plain(same) && !same.trim_start_matches(['-', '+']).starts_with('0'));
    let decimal = with_decimal_point(text).filter(is_plain);
    thousands.into_iter().chain(decimal).collect()
}

/// Prints a note for each list of values whose digits may be one number.
pub fn note_lists(command: &Command, arguments: &ArgMatches) {
    for argument in command.get_arguments() {
        let id = argument.get_id().as_str();
        let is_list = arguments.try_get_many::<Numbers>(id).is_ok()
            || arguments.try_get_many::<Distances>(id).is_ok();
        let Some(name) = argument.get_long().filter(|_| is_list) else { continue };
        let given = arguments.get_raw(id).into_iter().flatten();
        for text in given.filter_map(|text| text.to_str()) {
            let single = single_values(text).join(" or ");
            if !single.is_empty() {
                let values: Vec<&str> = text.split(',').map(str::trim).collect();
                let (last, others) = values.split_last().unwrap_or((&text, &[]));
                let count = if values.len() == 2 { "two".into() } else { values.len().to_string() };
                let others = others.join(", ");
                // Also where other notes are left out, as results may be those of other loads.
                print_always(
                    "note",
                    &format!(
                        "--{name} {text} is read as {count} values, {others} and {last}; a single value is written {single}"
                    ),
                );
            }
        }
    }
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

    #[test]
    fn lists_whose_digits_may_be_one_number_are_recognised() {
        for (text, single) in [
            ("1,5", &["1.5"][..]),
            ("-0,25", &["-0.25"]),
            ("1,500", &["1500", "1.500"]),
            ("1.500,5", &["1500.5"]),
            ("1,234.5", &["1234.5"]),
            ("1,234,567", &["1234567"]),
            ("10,100", &["10100", "10.100"]),
            ("0,100", &["0.100"]),
            ("1,5,9", &[]),
            ("1.5,2", &[]),
            ("1.000,2.000", &[]),
            ("10.125,20.5", &[]),
            ("1, 5", &[]),
            ("1,5e6", &[]),
            ("100", &[]),
            ("1.500", &[]),
        ] {
            assert_eq!(single_values(text), single, "{text}");
        }
    }
}
