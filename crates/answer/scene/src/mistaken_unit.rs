//! Lengths that look like another unit.

use asperity::{Code, Finding, SeparationUnit};

/// Separations beyond this many σ_z are unlikely.
const FAR: f64 = 1e3;
/// Separations below this many σ_z are unlikely, except 0.
const NEAR: f64 = 1e-3;
/// Usual gaps, in σ_z.
const GAPS: std::ops::Range<f64> = 1e-2..30.0;
/// Gaps above this length \[m\] are unlikely.
const LONG: f64 = 0.1;

/// A warning for a separation (or another length, by its `name`) of an unlikely size in its unit,
/// with the `remedy`; σ_z is `height_std` \[m\].
///
/// ```
/// use asperity::SeparationUnit;
///
/// let found = |x| asperity_scene::mistaken_unit("gap", x, SeparationUnit::Sigma, 1e-6, "write 2um");
/// let text = "gap is 2e-6 asperity_height_std (usual: 0.001 to 1000): write 2um";
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
    let size = value.abs();
    let (si, usual) = match unit {
        SeparationUnit::Metres => ("m", [0.0, LONG.max(FAR * height_std)]),
        SeparationUnit::Sigma => ("asperity_height_std", [NEAR, FAR]),
        _ => return None,
    };
    // A gap next to 0 that is none in metres either is meant so, and an infinite one, too.
    let is_odd = size > usual[1] || size < usual[0] && GAPS.contains(&(size / height_std));
    let found = Finding::warning(Code::LikelyUnit, name.to_string(), value).usual(usual).unit(si);
    (is_odd && size.is_finite()).then(|| found.advice(remedy.to_string()))
}
