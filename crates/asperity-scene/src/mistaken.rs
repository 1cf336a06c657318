//! Separations that were probably meant in another unit.

use asperity::{Diagnostic, SeparationUnit};

/// Farther away or deeper than this many σ_z there is no contact that anybody means.
const FAR: f64 = 1e3;
/// Nearer to 0 than this many σ_z nobody asks unless for 0 itself: the number has another unit.
const NEAR: f64 = 1e-3;
/// Within so many σ_z lie the gaps that are asked about.
const GAPS: std::ops::Range<f64> = 1e-2..30.0;
/// No gap of a rough contact is as long as this \[m\]; multiples of σ_z are.
const LONG: f64 = 0.1;

/// A diagnostic of a separation (or another length, by its `name`) that makes no sense in its unit, or
/// little beside the other one; σ_z is `height_std` \[m\].
///
/// ```
/// use asperity::SeparationUnit;
///
/// let found = asperity_scene::mistaken_unit("separation", 2e-6, SeparationUnit::Sigma, 1e-6);
/// let text = "separation is 2e-6 asperity_height_std: 2e-6 looks like metres; 2e-6 m is 2 asperity_height_std";
/// assert_eq!(found.unwrap().to_string(), text);
/// assert_eq!(asperity_scene::mistaken_unit("separation", 2.0, SeparationUnit::Sigma, 1e-6), None);
/// ```
#[must_use]
pub fn mistaken_unit(
    name: &str,
    value: f64,
    unit: SeparationUnit,
    height_std: f64,
) -> Option<Diagnostic> {
    let (size, over) = (value.abs(), value / height_std);
    let digits = format!("{value:?}");
    let digits = digits.strip_suffix(".0").unwrap_or(&digits);
    let (given, advice) = match unit {
        // All the way.
        _ if size.is_infinite() => return None,
        SeparationUnit::Metres if size > LONG.max(FAR * height_std) => {
            let metres = value * height_std;
            let meant = format!("{digits} asperity_height_std is {metres:e} m");
            ("m", format!("{digits} looks like asperity_height_std; {meant}"))
        }
        SeparationUnit::Sigma if size > FAR => {
            ("asperity_height_std", "the surfaces are far apart; check the unit".into())
        }
        SeparationUnit::Sigma if size < NEAR && GAPS.contains(&over.abs()) => {
            let meant = format!("{digits} m is {over} asperity_height_std");
            ("asperity_height_std", format!("{digits} looks like metres; {meant}"))
        }
        _ => return None,
    };
    let found = Diagnostic::warning("unit", name.to_string(), value);
    Some(found.fact(format!("{name} is {digits} {given}")).advice(advice))
}
