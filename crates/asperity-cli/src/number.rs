//! Numbers as text: the shortest digits that read back exactly, or a few for the eye.

/// The shortest digits that give the same number back in any tool: 289.29, 1.427e-7, -inf.
pub fn exact(x: f64) -> String {
    // Debug switches to exponents below 1e-5 and from 1e16, where plain digits run long.
    let text = format!("{x:?}");
    let short = text.strip_suffix(".0").unwrap_or(&text);
    if short == "-0" { "0".into() } else { short.into() }
}

/// Six significant digits, for tables that are looked at.
pub fn rounded(x: f64) -> String {
    let six: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    let is_plain = six == 0.0 || !six.is_finite() || (1e-3..1e7).contains(&six.abs());
    if is_plain { exact(six) } else { format!("{six:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_digits_read_back() {
        for x in [0.0, 1.0, -0.1, 1e-7, 1.0 / 3.0, 5e-324, f64::MAX, 1e16, 289.290_001, -2e-5] {
            assert!(exact(x).parse::<f64>().unwrap().total_cmp(&x).is_eq(), "{x}");
        }
        let texts = [0.01, 4.0, -0.0, 1e-7, 1e300, f64::NEG_INFINITY].map(exact);
        assert_eq!(texts, ["0.01", "4", "0", "1e-7", "1e300", "-inf"]);
    }

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
