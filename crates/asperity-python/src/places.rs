//! Where a contact is asked about: separations in their unit, from a scene's plane, or loads.

use asperity::{At, ContactError, Datum, Scene, Separation, SeparationUnit};
use pyo3::prelude::*;

use crate::error::value_error;

/// What a plain number stands for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Axis {
    Separation(SeparationUnit),
    Load,
    Pressure,
}

/// Farther away or deeper than this many σ_z there is no contact that anybody means.
const FAR: f64 = 1e3;
/// Nearer to 0 than this many σ_z nobody asks unless for 0 itself: the number has another unit.
const NEAR: f64 = 1e-3;
/// Within so many σ_z lie the gaps that are asked about.
const GAPS: std::ops::Range<f64> = 1e-2..30.0;
/// No gap of a rough contact is as long as this \[m\]; multiples of σ_z are.
const LONG: f64 = 0.1;

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
    /// A number, from a scene's plane.
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

    /// What a number was probably meant to be that makes no sense as a separation, or little beside
    /// what it would be in the other unit.
    pub(crate) fn slip(self, value: f64, height_std: f64) -> Option<String> {
        let (size, over) = (value.abs(), value / height_std);
        match self {
            Self::Separation(SeparationUnit::Metres) if size > LONG.max(FAR * height_std) => {
                Some(format!(
                    "separation is {value:?} m, {over:e} asperity_height_std: is it a multiple of asperity_height_std? separation_unit is \"m\""
                ))
            }
            Self::Separation(SeparationUnit::Sigma) if size > FAR => Some(format!(
                "separation is {value:?} asperity_height_std: is it in another unit? separation_unit=\"m\" takes metres"
            )),
            Self::Separation(SeparationUnit::Sigma)
                if size < NEAR && GAPS.contains(&over.abs()) =>
            {
                Some(format!(
                    "separation is {value:e} asperity_height_std: is it in metres, {over:?} asperity_height_std? separation_unit=\"m\" takes metres"
                ))
            }
            _ => None,
        }
    }
}
