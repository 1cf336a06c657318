//! The axis of a request: separations in their unit, from a scene's plane, loads or pressures.

use asperity::{At, ContactError, Datum, Scene, Separation, SeparationUnit};
use pyo3::prelude::*;

use crate::convert::error::value_error;

/// The meaning of a number.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Axis {
    Separation(SeparationUnit),
    Load,
    Pressure,
}

impl<'py> FromPyObject<'_, 'py> for Axis {
    type Error = PyErr;

    fn extract(name: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        match name.extract::<&str>()? {
            "asperity_height_std" => Ok(Self::Separation(SeparationUnit::Sigma)),
            "m" => Ok(Self::Separation(SeparationUnit::Metres)),
            "load" => Ok(Self::Load),
            "pressure" => Ok(Self::Pressure),
            other => Err(value_error(format!(
                "separation_unit is {other:?}: \"asperity_height_std\" or \"m\" was required"
            ))),
        }
    }
}

impl Axis {
    /// The SI unit of its numbers in texts.
    pub(crate) fn si(self) -> &'static str {
        match self {
            Self::Separation(_) => "m",
            Self::Load => "N",
            Self::Pressure => "Pa",
        }
    }

    /// The axis of numbers in that SI unit.
    pub(crate) fn in_si(self) -> Self {
        match self {
            Self::Separation(_) => Self::Separation(SeparationUnit::Metres),
            other => other,
        }
    }

    /// A number on this axis as a place, from a scene's plane.
    pub(crate) fn at(self, value: f64, from: Datum) -> At {
        match self {
            Self::Separation(unit) => Separation { value, unit, from }.into(),
            Self::Load => At::Load(value),
            Self::Pressure => At::Pressure(value),
        }
    }

    /// A separation in this unit, from a scene's plane.
    pub(crate) fn of(
        self,
        separation: Separation,
        from: Datum,
        scene: &Scene,
    ) -> Result<f64, ContactError> {
        match self {
            Self::Separation(unit) => Ok(separation.measured_in(unit, from, scene)?.value),
            _ => Ok(separation.value),
        }
    }

    /// A warning if a separation, or the length `name`, probably has another unit.
    pub(crate) fn mistaken_unit(self, name: &str, value: f64, height_std: f64) -> Option<String> {
        let Self::Separation(unit) = self else { return None };
        let found = asperity_inputs::mistaken_unit(name, value, unit, height_std)?;
        Some(match unit {
            SeparationUnit::Metres => format!("{found} (separation_unit is \"m\")"),
            _ => format!("{found}; separation_unit=\"m\" takes metres"),
        })
    }
}
