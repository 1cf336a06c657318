//! The integral of one law on one scene, prepared for many separations.

use std::sync::{Arc, OnceLock};

use asperity_quadrature::Density;

use crate::engine::height_integral::HeightIntegral;
use crate::engine::inverse::force_at::Falls;
use crate::engine::laws::Laws;
use crate::engine::onset::Onset;
use crate::{ContactError, Law, Quantity, Scene, Tolerance};

/// Range of scales w_c/σ_z: powers of others overflow f64, and no surface has them.
const SCALES: std::ops::RangeInclusive<f64> = 1e-100..=1e100;

/// The integral of one law.
#[derive(Debug)]
pub(crate) struct Channel {
    /// The quantity of the law.
    pub(crate) base: Quantity,
    pub(crate) law: Arc<Law>,
    pub(crate) units: Units,
    pub(crate) total: HeightIntegral,
    parts: OnceLock<Vec<HeightIntegral>>,
    falls: OnceLock<Result<Option<Arc<Falls>>, ContactError>>,
    scene: Scene,
    tolerance: Tolerance,
}

/// From a law's numbers to those of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Units {
    /// η A_n times the law's value unit.
    pub(crate) factor: f64,
    /// Interference unit over σ_z.
    pub(crate) scale: f64,
    /// The onset of the law.
    pub(crate) onset: Onset,
}

impl Units {
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
            None => Err(ContactError::Ratio { ratio: scale }),
        }
    }
}

impl Channel {
    pub(crate) fn new(
        base: Quantity,
        law: Arc<Law>,
        scene: &Scene,
        tolerance: Tolerance,
    ) -> Result<Self, ContactError> {
        let units = Units::new(base, &law, scene)?;
        let total = HeightIntegral::new(law.density(), &law, scene, tolerance.relative());
        let (parts, falls, scene) = (OnceLock::new(), OnceLock::new(), scene.clone());
        Ok(Self { base, law, units, total, parts, falls, scene, tolerance })
    }

    /// The falls of the law, if there are any.
    pub(crate) fn falls(&self, laws: &Laws) -> Result<Option<Arc<Falls>>, ContactError> {
        self.falls.get_or_init(|| laws.falls(&self.scene, self.tolerance)).clone()
    }

    /// The integral of each part of the law.
    pub(crate) fn parts(&self) -> &[HeightIntegral] {
        self.parts.get_or_init(|| {
            let integral = |part: &crate::Part| {
                let alone = Density { pieces: vec![part.piece()] };
                HeightIntegral::new(alone, &self.law, &self.scene, self.tolerance.relative())
            };
            self.law.parts.iter().map(integral).collect()
        })
    }
}
