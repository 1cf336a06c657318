//! Separations that look like another unit.

use asperity::SeparationUnit;

/// Separations beyond this many σ_z are unlikely.
const FAR: f64 = 1e3;
/// Separations below this many σ_z are unlikely, except 0.
const NEAR: f64 = 1e-3;
/// Usual gaps, in σ_z.
const GAPS: std::ops::Range<f64> = 1e-2..30.0;
/// Gaps above this length \[m\] are unlikely.
const LONG: f64 = 0.1;

/// A warning for a separation (or another length, by its `name`) that is unlikely in its unit and
/// looks like the other one; σ_z is `height_std` \[m\].
///
/// ```
/// use asperity::SeparationUnit;
///
/// let warning = asperity_scene::mistaken_unit("separation", 2e-6, SeparationUnit::Sigma, 1e-6);
/// let text = "separation is 2e-6 asperity_height_std; 2e-6 looks like metres, 2.0 asperity_height_std";
/// assert_eq!(warning.as_deref(), Some(text));
/// assert_eq!(asperity_scene::mistaken_unit("separation", 2.0, SeparationUnit::Sigma, 1e-6), None);
/// ```
#[must_use]
pub fn mistaken_unit(
    name: &str,
    value: f64,
    unit: SeparationUnit,
    height_std: f64,
) -> Option<String> {
    let (size, over) = (value.abs(), value / height_std);
    match unit {
        // No contact at all.
        _ if size.is_infinite() => None,
        SeparationUnit::Metres if size > LONG.max(FAR * height_std) => Some(format!(
            "{name} is {value:?} m, {over:e} asperity_height_std; {value:?} looks like a multiple of asperity_height_std"
        )),
        SeparationUnit::Sigma if size > FAR => Some(format!(
            "{name} is {value:?} asperity_height_std; {value:?} looks like another unit"
        )),
        SeparationUnit::Sigma if size < NEAR && GAPS.contains(&over.abs()) => Some(format!(
            "{name} is {value:e} asperity_height_std; {value:e} looks like metres, {over:?} asperity_height_std"
        )),
        _ => None,
    }
}
