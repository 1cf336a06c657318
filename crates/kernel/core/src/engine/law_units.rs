//! From a law's numbers to a scene's.

use crate::engine::onset::Onset;
use crate::{ContactError, Law, Quantity, Scene};

/// Range of scales w_c/σ_z: powers of others overflow f64, and no surface has them.
const SCALES: std::ops::RangeInclusive<f64> = 1e-100..=1e100;

/// The units of a law on a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LawUnits {
    /// η A_n times the law's value unit.
    pub(crate) factor: f64,
    /// Interference unit over σ_z.
    pub(crate) scale: f64,
    /// The onset of the law.
    pub(crate) onset: Onset,
}

impl LawUnits {
    /// Refuses scenes whose numbers overflow f64.
    pub(crate) fn new(base: Quantity, law: &Law, scene: &Scene) -> Result<Self, ContactError> {
        let height_std = scene.surface.asperity_height_std;
        let factor = scene.asperities() * law.value_unit;
        let scale = law.interference_unit / height_std;
        // Tangents are divided by σ_z.
        let held = |x: &f64| *x > 0.0 && x.is_finite();
        match [factor, factor / height_std].into_iter().find(|x| !held(x)) {
            Some(scale) => Err(ContactError::Scale { quantity: base, scale }),
            None if SCALES.contains(&scale) && (law.onset * scale).is_finite() => {
                Ok(Self { factor, scale, onset: Onset(law.onset * scale) })
            }
            None => Err(ContactError::OutOfRange {
                field: "the law's interference unit over asperity_height_std",
                value: scale,
                required: "1e-100 to 1e100",
            }),
        }
    }
}
