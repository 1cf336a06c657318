//! Separations that were probably meant in another unit.

use asperity::SeparationUnit;

/// Farther away or deeper than this many σ_z there is no contact that anybody means.
const FAR: f64 = 1e3;
/// Nearer to 0 than this many σ_z nobody asks unless for 0 itself: the number has another unit.
const NEAR: f64 = 1e-3;
/// Within so many σ_z lie the gaps that are asked about.
const GAPS: std::ops::Range<f64> = 1e-2..30.0;
/// No gap of a rough contact is as long as this \[m\]; multiples of σ_z are.
const LONG: f64 = 0.1;

/// What a separation (or another length, by its `name`) was probably meant to be that makes no sense
/// in its unit, or little beside what it would be in the other one; σ_z is `height_std` \[m\].
///
/// ```
/// use asperity::SeparationUnit;
///
/// let told = asperity_scene::mistaken_unit("separation", 2e-6, SeparationUnit::Sigma, 1e-6);
/// let question = "separation is 2e-6 asperity_height_std: is it in metres, 2.0 asperity_height_std?";
/// assert_eq!(told.as_deref(), Some(question));
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
        // All the way.
        _ if size.is_infinite() => None,
        SeparationUnit::Metres if size > LONG.max(FAR * height_std) => Some(format!(
            "{name} is {value:?} m, {over:e} asperity_height_std: is it a multiple of asperity_height_std?"
        )),
        SeparationUnit::Sigma if size > FAR => {
            Some(format!("{name} is {value:?} asperity_height_std: is it in another unit?"))
        }
        SeparationUnit::Sigma if size < NEAR && GAPS.contains(&over.abs()) => Some(format!(
            "{name} is {value:e} asperity_height_std: is it in metres, {over:?} asperity_height_std?"
        )),
        _ => None,
    }
}
