//! The integral of one law on one scene, and what quantities come of it.

use std::sync::OnceLock;

use asperity_quadrature::{AnyScale, Density, QuadratureError};

use crate::height_integral::HeightIntegral;
use crate::{ContactError, HeightDistribution, Law, Quantity, Scene, StiffnessKind};

/// The integral of one law.
#[derive(Debug)]
pub(crate) struct Channel {
    pub(crate) quantity: Quantity,
    pub(crate) law: Law,
    /// η A_n times the law's value unit.
    pub(crate) factor: f64,
    /// Interference unit over σ_z.
    pub(crate) scale: f64,
    heights: HeightDistribution,
    pub(crate) tolerance: f64,
    pub(crate) total: HeightIntegral,
    parts: OnceLock<Vec<HeightIntegral>>,
    /// For other scenes of the same asperities.
    pub(crate) elsewhere: OnceLock<AnyScale>,
}

/// Refuses scenes whose numbers leave the doubles.
pub(crate) fn check_scales(
    quantity: Quantity,
    factor: f64,
    scale: f64,
    height_std: f64,
) -> Result<(), ContactError> {
    // Tangents are divided by σ_z.
    let scales = [factor, factor / height_std, scale];
    match scales.into_iter().find(|scale| !(*scale > 0.0 && scale.is_finite())) {
        None => Ok(()),
        Some(scale) => Err(ContactError::Scale { quantity, scale }),
    }
}

/// The law a quantity is computed from.
pub(crate) fn law_of(quantity: Quantity, stiffness: StiffnessKind) -> Quantity {
    match (quantity, stiffness) {
        (Quantity::Tangent, _) | (Quantity::Stiffness, StiffnessKind::Tangent) => Quantity::Force,
        (quantity, _) => quantity,
    }
}

pub(crate) fn failed(
    quantity: Quantity,
    separation: f64,
) -> impl Fn(QuadratureError) -> ContactError {
    move |source| ContactError::Integral { quantity, separation, source }
}

impl Channel {
    pub(crate) fn new(
        quantity: Quantity,
        law: Law,
        scene: &Scene,
        tolerance: f64,
    ) -> Result<Self, ContactError> {
        let scale = law.interference_unit / scene.surface.asperity_height_std;
        let total = HeightIntegral::new(law.density(), scale, &scene.heights, tolerance);
        let factor = scene.asperities() * law.value_unit;
        check_scales(quantity, factor, scale, scene.surface.asperity_height_std)?;
        Ok(Self {
            quantity,
            factor,
            law,
            scale,
            heights: scene.heights.clone(),
            tolerance,
            total,
            parts: OnceLock::new(),
            elsewhere: OnceLock::new(),
        })
    }

    pub(crate) fn parts(&self) -> &[HeightIntegral] {
        self.parts.get_or_init(|| {
            let alone = |part: &crate::Part| Density { pieces: vec![part.piece()] };
            let integral =
                |part| HeightIntegral::new(alone(part), self.scale, &self.heights, self.tolerance);
            self.law.parts.iter().map(integral).collect()
        })
    }
}
