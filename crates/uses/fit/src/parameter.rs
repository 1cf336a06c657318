//! Free parameters, their bounds, and the coordinates in which they are varied.

use asperity_core::{At, Quantity, Scene, short};

use crate::forward::STIFFNESSES;
use crate::{Data, FitError, Measured, Observation};

/// The factor either way of the start within which a parameter is varied by default.
pub const USUAL_FACTOR: f64 = 30.0;

/// What a free parameter changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Role {
    /// A number of the scene.
    Scene,
    /// The reading of the separation where the surfaces are at separation 0 \[m\].
    SeparationOffset,
    /// The normal compliance of the rig, in series with the contact \[m/N\].
    SeriesCompliance,
}

impl Role {
    /// The names of the parameters of the rig.
    pub const RIG: [&str; 2] = ["separation_offset", "series_compliance"];

    /// The name of a parameter of the rig: `separation_offset` or `series_compliance`.
    #[must_use]
    pub fn of(name: &str) -> Self {
        match name {
            "separation_offset" => Self::SeparationOffset,
            "series_compliance" => Self::SeriesCompliance,
            _ => Self::Scene,
        }
    }

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

/// A free parameter: varied in its logarithm between positive bounds, linearly otherwise.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Parameter {
    /// Its name, the key of a scene file for a number of the scene.
    pub name: String,
    /// Its SI unit; empty for pure numbers.
    pub unit: String,
    /// What it changes.
    pub role: Role,
    /// The value from which the fit starts, within the bounds.
    pub start: f64,
    /// The smallest and the largest value.
    pub bounds: [f64; 2],
    /// A typical size of a change, for a parameter that is varied linearly.
    pub scale: f64,
}

impl Parameter {
    /// A parameter between bounds; the start is the nearest value within them.
    ///
    /// # Errors
    /// [`FitError::Parameter`] unless the bounds are finite and ascending, and the scale of a
    /// linear parameter is above 0.
    pub fn new(
        name: impl Into<String>,
        unit: &str,
        start: f64,
        bounds: [f64; 2],
        scale: f64,
    ) -> Result<Self, FitError> {
        let (name, [low, high]) = (name.into(), bounds);
        let role = Role::of(&name);
        let finite = low.is_finite() && high.is_finite() && start.is_finite();
        let reason = if !finite || low >= high {
            let [low, high] = bounds.map(short);
            format!(
                "the bounds are {low} and {high}: two finite numbers, the smaller first, were required"
            )
        } else if role == Role::SeriesCompliance && low < 0.0 {
            format!("the lower bound is {}: at least 0 was required", short(low))
        } else if low <= 0.0 && !(scale > 0.0 && scale.is_finite()) {
            format!("its scale is {scale:?}: a finite number above 0 was required")
        } else {
            let (unit, start) = (unit.into(), start.clamp(low, high));
            return Ok(Self { name, unit, role, start, bounds, scale });
        };
        Err(FitError::Parameter { parameter: name, reason })
    }

    /// Whether it is varied in its logarithm.
    #[must_use]
    pub fn is_log(&self) -> bool {
        self.bounds[0] > 0.0
    }

    /// The coordinate of a value: its logarithm, or the value in units of the scale.
    pub(crate) fn coordinate(&self, value: f64) -> f64 {
        if self.is_log() { value.ln() } else { value / self.scale }
    }

    /// The value at a coordinate, within the bounds.
    pub(crate) fn value(&self, coordinate: f64) -> f64 {
        let value = if self.is_log() { coordinate.exp() } else { coordinate * self.scale };
        value.clamp(self.bounds[0], self.bounds[1])
    }

    /// The bounds as coordinates.
    pub(crate) fn range(&self) -> [f64; 2] {
        self.bounds.map(|bound| self.coordinate(bound))
    }

    /// A value with its unit.
    pub(crate) fn shown(&self, value: f64) -> String {
        let gap = if self.unit.is_empty() { "" } else { " " };
        format!("{}{gap}{}", short(value), self.unit)
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
    let stiffness = |one: &&Observation| matches!(one.measured, Measured::Quantity(quantity) if STIFFNESSES.contains(&quantity));
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
