//! Separations that look like another unit.

use asperity::{Finding, SeparationUnit};

/// Separations beyond this many σ_z are unlikely.
const FAR: f64 = 1e3;
/// Separations below this many σ_z are unlikely, except 0.
const NEAR: f64 = 1e-3;
/// Usual gaps, in σ_z.
const GAPS: std::ops::Range<f64> = 1e-2..30.0;
/// Gaps above this length \[m\] are unlikely.
const LONG: f64 = 0.1;

/// A warning for a separation (or another length, by its `name`) that is unlikely in its unit and
/// looks like the other one, with the `remedy`; σ_z is `height_std` \[m\].
///
/// ```
/// use asperity::SeparationUnit;
///
/// let found = |x| asperity_inputs::mistaken_unit("gap", x, SeparationUnit::Sigma, 1e-6, "write 2um");
/// let text = "gap is 2e-6 asperity_height_std: 2e-6 looks like metres; 2e-6 m is 2 asperity_height_std; write 2um";
/// assert_eq!(found(2e-6).unwrap().to_string(), text);
/// assert_eq!(found(2.0), None);
/// ```
#[must_use]
pub fn mistaken_unit(
    name: &str,
    value: f64,
    unit: SeparationUnit,
    height_std: f64,
    remedy: &str,
) -> Option<Finding> {
    let (size, over) = (value.abs(), value / height_std);
    let digits = format!("{value:?}");
    let digits = digits.strip_suffix(".0").unwrap_or(&digits);
    let (given, advice) = match unit {
        // No contact at all.
        _ if size.is_infinite() => return None,
        SeparationUnit::Metres if size > LONG.max(FAR * height_std) => {
            let metres = value * height_std;
            let meant = format!("`{digits} asperity_height_std` is {metres:e} m");
            ("m", format!("{digits} looks like `asperity_height_std`; {meant}"))
        }
        SeparationUnit::Sigma if size > FAR => {
            ("`asperity_height_std`", "the surfaces are far apart; check the unit".into())
        }
        SeparationUnit::Sigma if size < NEAR && GAPS.contains(&over.abs()) => {
            let meant = format!("{digits} m is `{over} asperity_height_std`");
            ("`asperity_height_std`", format!("{digits} looks like metres; {meant}"))
        }
        _ => return None,
    };
    let found = Finding::warning("likely-unit", name.to_string(), value);
    Some(found.fact(format!("{name} is {digits} {given}")).advice(format!("{advice}; {remedy}")))
}
