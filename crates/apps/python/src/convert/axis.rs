//! The axis of a request: separations in their unit, from a scene's plane, loads or pressures.

use asperity::{At, ContactError, Datum, Finding, Scene, Separation, SeparationUnit};
use pyo3::prelude::*;

use crate::convert::numbers::largest_magnitude;
use crate::convert::{value_error, warn_unless};

/// The meaning of a number.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Axis {
    Separation(SeparationUnit),
    /// A film, from the mean plane of the surface.
    Film(SeparationUnit),
    /// Of curved bodies [m].
    Approach,
    Load,
    Pressure,
}

/// Separations in metres.
pub(crate) const METRES: Axis = Axis::Separation(SeparationUnit::Metres);

impl<'py> FromPyObject<'_, 'py> for Axis {
    type Error = PyErr;

    fn extract(name: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        match name.extract::<&str>()? {
            "asperity_height_std" => Ok(Self::Separation(SeparationUnit::Sigma)),
            "m" => Ok(METRES),
            "film" => Ok(Self::Film(SeparationUnit::Metres)),
            "lambda_ratio" => Ok(Self::Film(SeparationUnit::SurfaceStd)),
            "approach" => Ok(Self::Approach),
            "load" => Ok(Self::Load),
            "pressure" => Ok(Self::Pressure),
            other => Err(value_error(format!(
                "separation_unit is '{other}': 'asperity_height_std' or 'm' was required"
            ))),
        }
    }
}

impl Axis {
    /// The SI unit of its numbers in texts.
    pub(crate) fn si(self) -> &'static str {
        match self {
            Self::Separation(_) | Self::Film(_) | Self::Approach => "m",
            Self::Load => "N",
            Self::Pressure => "Pa",
        }
    }

    /// The axis of numbers in that SI unit.
    pub(crate) fn in_si(self) -> Self {
        if let Self::Separation(_) = self { METRES } else { self }
    }

    /// Refuses places that a scene does not have.
    pub(crate) fn check(self, file: &asperity_scene::SceneFile) -> PyResult<()> {
        Err(value_error(match (self, file.shape()) {
            (Self::Separation(_) | Self::Film(_), Some(_)) => {
                "the bodies of the scene are curved: give load or approach"
            }
            (Self::Approach, None) => {
                "approach is of curved bodies, and those of the scene are flat: give load, pressure or separation"
            }
            _ => return Ok(()),
        }))
    }

    /// The length of the unit of separations on a scene [m].
    pub(crate) fn metres(self, scene: &Scene) -> f64 {
        if self == METRES { 1.0 } else { scene.surface.asperity_height_std }
    }

    /// A number on this axis as a place, from a scene's plane.
    pub(crate) fn at(self, value: f64, from: Datum) -> At {
        match self {
            Self::Separation(unit) => Separation { value, unit, from }.into(),
            Self::Film(unit) => Separation { value, unit, from: Datum::SurfaceMean }.into(),
            Self::Approach => Separation::metres(-value).into(),
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

    /// A warning if separations, or the lengths `name`, probably have another unit; it names the
    /// number of largest magnitude, as smaller ones of an array do not show the unit.
    pub(crate) fn mistaken_unit(
        self,
        name: &str,
        numbers: &[f64],
        height_std: f64,
    ) -> Option<Finding> {
        let Self::Separation(unit) = self else { return None };
        let remedy = match unit {
            SeparationUnit::Metres => "separation_unit is \"m\"",
            _ => "separation_unit=\"m\" takes metres",
        };
        let mistaken =
            |number| asperity_scene::mistaken_unit(name, number, unit, height_std, remedy);
        let largest = if let [one] = numbers { one.abs() } else { largest_magnitude(numbers) };
        // Most arrays need no search for the number.
        mistaken(largest)?;
        mistaken(*numbers.iter().find(|x| x.abs().to_bits() == largest.to_bits())?)
    }

    /// Emits that warning, `above` frames of the package up.
    pub(crate) fn warn_of_unit(
        self,
        py: Python<'_>,
        name: &str,
        numbers: &[f64],
        file: &asperity_scene::SceneFile,
        above: usize,
    ) -> PyResult<()> {
        let mistaken = self.mistaken_unit(name, numbers, file.scene.surface.asperity_height_std);
        mistaken.map_or(Ok(()), |found| warn_unless(py, &file.spec.accept, &found, above))
    }
}
