//! Rounded numbers for tables.

use asperity::shortest_digits;

/// A number with six significant digits.
pub fn rounded(x: f64) -> String {
    let six: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    let is_plain = six == 0.0 || !six.is_finite() || (1e-3..1e7).contains(&six.abs());
    if is_plain { shortest_digits(six) } else { format!("{six:e}") }
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
}
