//! Numbers as the page shows them: four digits and a decimal prefix.

use asperity::{short, shortest_digits};
use asperity_plot::{PREFIXES, legible};
use serde_json::{Value, json};

/// All digits of a number but the last, in which conversions differ.
pub(crate) const EXACTLY: usize = 15;

/// A number with its unit: `12.5 MN/m`, `3.2e-8 m²`; the digits alone for a pure number.
pub(crate) fn shown(value: f64, unit: &str) -> String {
    let (factor, name) = legible(value, unit);
    format!("{} {name}", short(value / factor)).trim_end().into()
}

/// A value with three digits, and its interval in the same unit: `4.04 GN/m`, `3.76 to 4.35`. The
/// unit `%` is for shares.
pub(crate) fn interval(value: f64, ends: Option<[f64; 2]>, unit: &str) -> (String, String) {
    let (factor, name) = if unit == "%" { (0.01, unit.into()) } else { legible(value, unit) };
    let digits = |x: f64| {
        let x = x / factor;
        let rounded: f64 = format!("{x:.2e}").parse().unwrap_or(x);
        short(rounded)
    };
    let range =
        ends.map_or(String::new(), |[low, high]| format!("{} to {}", digits(low), digits(high)));
    (format!("{} {name}", digits(value)).trim_end().into(), range)
}

/// A number with four digits or, known within a range, with three and this behind it.
pub(crate) fn ranged(value: f64, ends: Option<[f64; 2]>, unit: &str) -> String {
    match interval(value, ends, unit) {
        (value, range) if ends.is_some() => format!("{value} ({range})"),
        _ => shown(value, unit),
    }
}

/// A number of a table by its name, with all digits, as shown, and what it means.
pub(crate) fn number(name: &str, shown: String, value: f64, meaning: &str) -> Value {
    let digits = shortest_digits(value);
    json!({ "name": name, "digits": digits, "shown": shown, "meaning": meaning })
}

/// A deviation in percent, with its sign: `+19 %`.
pub(crate) fn percent(share: f64) -> String {
    let whole = (100.0 * share).round() + 0.0;
    let sign = if whole > 0.0 { "+" } else { "" };
    format!("{sign}{whole} %").replace('-', "−")
}

/// A number as a scene file and the program take it, rounded to some digits: `126 N`.
pub(crate) fn typed(value: f64, unit: &str, digits: usize) -> String {
    let rounded = |x: f64| format!("{x:.*e}", digits - 1).parse().unwrap_or(x);
    let size = rounded(value).abs();
    let fits = |(factor, _): &(f64, &str)| *factor >= 1.0 && size >= *factor;
    let (factor, prefix) = PREFIXES.into_iter().find(fits).unwrap_or((1.0, ""));
    format!("{} {prefix}{unit}", shortest_digits(rounded(value / factor)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_four_digits_and_a_prefix() {
        let cases = [
            (1.234_56e7, "N/m", "12.35 MN/m"),
            (2.5e-7, "m", "250 nm"),
            (3.2e-8, "m2", "3.2e-8 m²"),
            (0.012_345_6, "", "0.01235"),
            (0.0, "Pa", "0 Pa"),
            (-3.0, "N", "-3 N"),
            (1e-30, "N", "1e-30 N"),
            (1500.0, "W/m2/K", "1.5 kW/m²/K"),
        ];
        for (value, unit, wanted) in cases {
            assert_eq!(shown(value, unit), wanted);
        }
    }

    #[test]
    fn exact_numbers_are_read_back_to_fifteen_digits() {
        for (value, unit, wanted) in [
            (2e7, "Pa", "20 MPa"),
            (2e7 * 1e-4, "N", "2 kN"),
            (0.123_456_789_012_3, "N", "0.1234567890123 N"),
            (1e-9, "N", "1e-9 N"),
            (0.0, "Pa", "0 Pa"),
            (0.1 + 0.2, "Pa", "0.3 Pa"),
        ] {
            let text = typed(value, unit, EXACTLY);
            assert_eq!(text, wanted);
            let read = asperity_scene::quantity(&text, unit).unwrap();
            assert!((read - value).abs() <= 1e-15 * value, "{text}");
        }
    }

    #[test]
    fn typed_numbers_are_read_back() {
        for (value, unit, wanted) in
            [(1259.0, "N", "1.26 kN"), (0.05, "N", "0.05 N"), (2.512e8, "Pa", "251 MPa")]
        {
            let text = typed(value, unit, 3);
            assert_eq!(text, wanted);
            let read = asperity_scene::quantity(&text, unit).unwrap();
            assert!((read / value - 1.0).abs() < 5e-3, "{text}");
        }
    }
}
