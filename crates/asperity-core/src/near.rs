//! The known name closest to a mistyped one.

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
}
