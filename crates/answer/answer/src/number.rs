//! Numbers in messages and rows.

use asperity::{Tolerance, shortest_digits};

/// A number with six significant digits.
#[must_use]
pub fn rounded(x: f64) -> String {
    let six: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    let is_plain = six == 0.0 || !six.is_finite() || (1e-3..1e7).contains(&six.abs());
    if is_plain { shortest_digits(six) } else { format!("{six:e}") }
}

/// A number with the digits that a relative tolerance leaves, and two more: 100 for
/// 99.99999999999989 at 1e-10.
#[must_use]
pub fn within(x: f64, tolerance: Tolerance) -> f64 {
    let digits = (2.0 - tolerance.relative().log10().floor()).clamp(2.0, 17.0) as usize;
    format!("{x:.*e}", digits - 1).parse().unwrap_or(x)
}

/// Decimal prefixes.
const PREFIXES: [(f64, &str); 7] =
    [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "u"), (1e-9, "n")];

/// The factor and the name of a unit with a decimal prefix that suits a value.
pub(crate) fn prefixed(value: f64, unit: &str) -> (f64, String) {
    let fits = |(factor, _): &(f64, &str)| value.abs() >= *factor && !unit.is_empty();
    let (factor, prefix) = PREFIXES.into_iter().find(fits).unwrap_or((1.0, ""));
    (factor, format!("{prefix}{unit}"))
}

/// A number with as many decimals as `like` has with three digits, trailing zeros kept.
pub(crate) fn fixed(x: f64, like: f64) -> String {
    match like.abs() {
        0.0 => format!("{x}"),
        small @ ..1e-3 if small > 0.0 => format!("{x:.2e}"),
        size => format!("{x:.*}", (2.0 - size.log10().floor()).clamp(0.0, 12.0) as usize),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounded_numbers_keep_six_digits_and_no_idle_zeros() {
        let texts = [0.0, 289.290_04, 1.427_123_4e-7, 12_345_678.0, 0.5, 999_999.7, -1e-9, 4e6];
        let texts = texts.map(rounded);
        assert_eq!(
            texts,
            ["0", "289.29", "1.42712e-7", "1.23457e7", "0.5", "1000000", "-1e-9", "4000000"]
        );
        assert_eq!(rounded(f64::NEG_INFINITY), "-inf");
    }

    #[test]
    fn digits_beyond_the_tolerance_are_left_out() {
        let at = |x: f64, tolerance: f64| within(x, Tolerance::new(tolerance).unwrap()).to_bits();
        assert_eq!(at(99.999_999_999_999_89, 1e-10), 100f64.to_bits());
        assert_eq!(at(-1.234_567_891_234_567e-7, 1e-10), (-1.234_567_891_23e-7f64).to_bits());
        assert_eq!(at(0.1 + 0.2, 1e-15), (0.1 + 0.2f64).to_bits());
        assert_eq!(at(1.264, 0.1), 1.26f64.to_bits());
        assert!(within(f64::INFINITY, Tolerance::default()).is_infinite());
    }
}
