//! Names and numbers as text.

use std::fmt::Display;

use strsim::osa_distance;

/// The first of the known names with the fewest typing errors, whatever the case: at most two, and
/// fewer in a name of less than four letters.
///
/// ```
/// let known = ["gw", "zmc", "etsion"];
/// assert_eq!(asperity_core::nearest_name("zcm", known), Some("zmc"));
/// assert_eq!(asperity_core::nearest_name("x", known), None);
/// ```
pub fn nearest_name<'a>(
    mistyped: &str,
    known: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    let mistyped = mistyped.trim().to_lowercase();
    let allowed = (mistyped.chars().count() / 2).min(2);
    let errors = |name: &'a str| (osa_distance(&mistyped, &name.to_lowercase()), name);
    let nearest = known.into_iter().map(errors).min_by_key(|(errors, _)| *errors);
    nearest.filter(|(errors, _)| *errors <= allowed).map(|(_, name)| name)
}

/// The nearest name in parentheses, to stand behind an unknown one; empty without it.
///
/// ```
/// assert_eq!(asperity_core::nearest_hint(Some("zmc")), " (the nearest is \"zmc\")");
/// assert_eq!(asperity_core::nearest_hint(None::<&str>), "");
/// ```
pub fn nearest_hint(near: Option<impl Display>) -> String {
    near.map_or_else(String::new, |near| format!(" (the nearest is \"{near}\")"))
}

/// The shortest digits that give the same number back in any tool: `289.29`, `1.427e-7`, `-inf`.
///
/// ```
/// assert_eq!([4.0, -0.0, 1e-7].map(asperity_core::shortest_digits), ["4", "0", "1e-7"]);
/// ```
#[must_use]
pub fn shortest_digits(x: f64) -> String {
    // Debug switches to exponents below 1e-5 and from 1e16, where plain digits run long.
    let text = format!("{x:?}");
    let short = text.strip_suffix(".0").unwrap_or(&text);
    if short == "-0" { "0".into() } else { short.into() }
}

/// A number with all its digits as people write it: `0.9`, `1e9`, `2.15e-7`.
///
/// ```
/// assert_eq!([1e9, -0.5, 2.15e-7, 123.0].map(asperity_core::written), ["1e9", "-0.5", "2.15e-7", "123"]);
/// ```
#[must_use]
pub fn written(x: f64) -> String {
    match x.abs() {
        size if size != 0.0 && !(1e-3..1e5).contains(&size) => format!("{x:e}"),
        _ => format!("{x}"),
    }
}

/// A number with four digits for messages, without an exponent from 1e-3 to 1e5.
#[must_use]
pub fn short(x: f64) -> String {
    match format!("{x:.3e}").parse().unwrap_or(x) {
        0.0 => "0".into(),
        four => written(four),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_names_are_found_and_far_ones_are_not() {
        let known = ["plane", "quadratic", "none", "SH"];
        for (mistyped, wanted) in [
            ("plain", Some("plane")),
            ("QUADRATIC", Some("quadratic")),
            ("sh", Some("SH")),
            ("noen", Some("none")),
            ("x", None),
            ("parabola", None),
            ("", None),
        ] {
            assert_eq!(nearest_name(mistyped, known), wanted, "{mistyped}");
        }
        assert_eq!(nearest_name("x", []), None);
    }

    #[test]
    fn shortest_digits_read_back() {
        for x in [0.0, 1.0, -0.1, 1e-7, 1.0 / 3.0, 5e-324, f64::MAX, 1e16, 289.290_001, -2e-5] {
            assert!(shortest_digits(x).parse::<f64>().unwrap().total_cmp(&x).is_eq(), "{x}");
        }
        let texts = [0.01, 4.0, -0.0, 1e-7, 1e300, f64::NEG_INFINITY].map(shortest_digits);
        assert_eq!(texts, ["0.01", "4", "0", "1e-7", "1e300", "-inf"]);
    }
}
