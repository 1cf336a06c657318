//! Where the parameters of a rig start, by the data.

use asperity_core::{At, Quantity, Scene};

use crate::parameter::{Role, USUAL_FACTOR};
use crate::{Data, FitError, Measured, Observation};

impl Role {
    /// Where a parameter of the rig starts, its usual bounds, and the size of a change that
    /// matters; `None` for a number of the scene.
    ///
    /// # Errors
    /// [`FitError::Parameter`] for data that do not depend on it.
    pub fn usual(
        self,
        data: &Data,
        scene: &Scene,
    ) -> Result<Option<(f64, [f64; 2], f64)>, FitError> {
        let without_effect = |name: &str, needed: &str| FitError::Parameter {
            parameter: name.into(),
            reason: format!("the data have no column that depends on it: {needed} was required"),
        };
        let [offset, compliance] = Self::RIG;
        let std = scene.surface.asperity_height_std;
        match self {
            Self::Scene => Ok(None),
            Self::SeparationOffset => {
                let ends = readings(data).ok_or_else(|| without_effect(offset, "separation_m"))?;
                let [low, high] = ends;
                let beyond = USUAL_FACTOR * std;
                // Contacts carry most loads at separations of about twice the deviation.
                let start = 0.5 * (low + high) - 2.0 * std;
                Ok(Some((start, [low - beyond, high + beyond], std)))
            }
            Self::SeriesCompliance => {
                let usual = usual_compliance(data, scene).ok_or_else(|| {
                    without_effect(compliance, "separation_m or a normal stiffness")
                })?;
                Ok(Some((usual, [usual / USUAL_FACTOR, usual * USUAL_FACTOR], usual)))
            }
        }
    }
}

/// The smallest and the largest reading of a separation.
fn readings(data: &Data) -> Option<[f64; 2]> {
    let reading = |one: &Observation| match (one.at, one.measured) {
        (At::Separation(reading), _) => Some(reading.value),
        (_, Measured::Separation) => Some(one.value),
        _ => None,
    };
    span(data.iter().filter_map(reading))
}

fn span(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    let join = |found: Option<[f64; 2]>, value: f64| {
        let [low, high] = found.unwrap_or([value; 2]);
        Some([low.min(value), high.max(value)])
    };
    values.fold(None, join)
}

/// A tenth of the smallest compliance that was measured, or of the readings over the loads.
fn usual_compliance(data: &Data, scene: &Scene) -> Option<f64> {
    let stiffness = |one: &&Observation| {
        let stiffnesses = [Quantity::Stiffness, Quantity::Tangent, Quantity::UnloadingStiffness];
        matches!(one.measured, Measured::Quantity(quantity) if stiffnesses.contains(&quantity))
    };
    if let Some([_, stiffest]) = span(data.iter().filter(stiffness).map(|one| one.value)) {
        return Some(0.1 / stiffest).filter(|usual| *usual > 0.0 && usual.is_finite());
    }
    let load = |one: &Observation| match (one.at, one.measured) {
        (at, Measured::Separation) => at.load(scene),
        (At::Separation(_), Measured::Quantity(Quantity::Force)) => Some(one.value),
        (At::Separation(_), Measured::Quantity(Quantity::Pressure)) => {
            At::Pressure(one.value).load(scene)
        }
        _ => None,
    };
    let ([near, far], [least, most]) = (readings(data)?, span(data.iter().filter_map(load))?);
    let usual = 0.1 * (far - near) / (most - least);
    Some(usual).filter(|usual| *usual > 0.0 && usual.is_finite())
}
