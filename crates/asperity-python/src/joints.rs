//! `Unloading` and `PartialSlip`: a joint that was closed, as it opens again and as it is sheared.

use std::ops::Range;

use asperity::joints;
use asperity::{ContactError, SeparationUnit};
use numpy::{PyArray1, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyTuple};

use crate::engine::{Engine, tolerance};
use crate::error::{value_error, warn};
use crate::long::{pool, stretches};
use crate::numbers::{floats, scalar, texts_in_si};
use crate::places::Axis;
use crate::scene::SceneFile;

/// The unit of multiples of σ_z.
pub(crate) const SIGMAS: Axis = Axis::Separation(SeparationUnit::Sigma);
/// Rows that one thread does at a time: each is an integral of its own.
const TOGETHER: usize = 4;

/// A joint that was closed for the first time, and opens again.
///
/// Made by ``Model.unloading``. Retreats are distances back from the closest approach, in
/// ``separation_unit`` or with their own, as "100 nm"; a float gives floats, an array gives arrays
/// of its shape.
#[pyclass(frozen, module = "asperity")]
pub(crate) struct Unloading {
    model: Py<Engine>,
    /// The scene.
    #[pyo3(get)]
    scene: Py<SceneFile>,
    /// What was given: an axis and a number on it.
    place: (String, f64),
    /// The relative tolerance.
    #[pyo3(get)]
    rtol: f64,
    /// The unit of retreats and of the closest approach: "asperity_height_std" or "m".
    #[pyo3(get)]
    separation_unit: String,
    /// The closest approach, from the scene's plane.
    #[pyo3(get)]
    closest: f64,
    unit: Axis,
    whole: joints::Joint,
    joint: joints::Unloading,
}

#[pymethods]
impl Unloading {
    /// Of a `Model` on a `Scene`, at an axis and a number on it.
    #[new]
    fn new(
        py: Python<'_>,
        model: Py<Engine>,
        scene: Py<SceneFile>,
        place: (Bound<'_, PyAny>, f64),
        law: &str,
        rtol: f64,
        separation_unit: Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        let file = scene.get().0.clone();
        let law = law.parse().map_err(|what| value_error(format!("law: {what}")))?;
        let (axis, unit): (Axis, Axis) = (place.0.extract()?, separation_unit.extract()?);
        let slip = axis.slip("separation", place.1, file.scene.surface.asperity_height_std);
        slip.map_or(Ok(()), |slip| warn(py, &slip, 1))?;
        let (named, tolerance) = (model.get().on(&file)?, tolerance(rtol)?);
        let at = axis.at(place.1, file.separation_from);
        let joint = py.detach(|| {
            let whole = joints::Joint::new(&named, &file.scene, law, tolerance)?;
            Ok((whole.unloading(at)?, whole))
        });
        let (joint, whole) = joint.map_err(|error| model.get().raise(py, error))?;
        let closest = unit.of(joint.closest(), file.separation_from, &file.scene);
        let closest = closest.map_err(|error| model.get().raise(py, error))?;
        let (place, separation_unit) = ((place.0.extract()?, place.1), separation_unit.extract()?);
        Ok(Self { model, scene, place, rtol, separation_unit, closest, unit, whole, joint })
    }

    /// Force [N] after going back by retreats.
    fn force<'py>(&self, retreat: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(retreat, |joint, u| Ok(joint.force(u)?.value()))
    }

    /// Real contact area [m^2] after going back by retreats; not by the law "etsion".
    fn area<'py>(&self, retreat: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(retreat, |joint, u| Ok(joint.area(u)?.value()))
    }

    /// Stiffness -dF/dd [N/m] after going back by retreats.
    fn stiffness<'py>(&self, retreat: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(retreat, |joint, u| Ok(joint.stiffness(u)?.value()))
    }

    /// Work [J] that going back by retreats gives back.
    fn returned<'py>(&self, retreat: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(retreat, |joint, u| Ok(joint.returned(u)?.value()))
    }

    /// Number of asperities that still touch after going back by retreats, on average.
    fn contacts<'py>(&self, retreat: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(retreat, |joint, u| Ok(joint.contacts(u)?.value()))
    }

    /// Retreat at which contact ends: beyond, fewer than one asperity touches on average.
    fn last_contact(&self, py: Python<'_>) -> PyResult<f64> {
        let found = py.detach(|| self.joint.last_contact());
        Ok(found.map_err(|error| self.model.get().raise(py, error))? / self.metres())
    }

    /// Loss factor of closing and opening: what is dissipated over 2 pi times the work of closing.
    fn loss_factor(&self, py: Python<'_>) -> PyResult<f64> {
        let work = || self.whole.work(self.joint.closest().into())?.loss_factor();
        let found = py.detach(work);
        found.map_err(|error| self.model.get().raise(py, error))
    }

    /// Work [J] that the first closing took and opening does not give back.
    fn dissipated(&self, py: Python<'_>) -> PyResult<f64> {
        let work = py.detach(|| self.whole.work(self.joint.closest().into()));
        work.map(|work| work.lost().value()).map_err(|error| self.model.get().raise(py, error))
    }

    /// The same joint, sheared at its closest approach with a coefficient of friction.
    fn slip(slf: &Bound<'_, Self>, friction: f64) -> PyResult<PartialSlip> {
        PartialSlip::new(slf.clone().unbind(), friction)
    }

    /// How the asperities come back: "hertz", "brake" or "etsion".
    #[getter]
    fn law(&self) -> String {
        self.joint.law().to_string()
    }

    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let Self { model, scene, place, rtol, separation_unit, .. } = slf.get();
        let arguments = (model, scene, place, slf.get().law(), rtol, separation_unit);
        Ok((slf.get_type().into_any(), arguments.into_pyobject(slf.py())?))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let name = self.model.bind(py).getattr("name")?;
        Ok(format!(
            "<asperity.Unloading of {name} by {} from {:.5e} {}; {}>",
            self.law(),
            self.closest,
            self.separation_unit,
            self.scene.bind(py).repr()?
        ))
    }
}

impl Unloading {
    /// Of the unit of retreats.
    fn metres(&self) -> f64 {
        if self.unit == SIGMAS { self.joint.scene().surface.asperity_height_std } else { 1.0 }
    }

    fn over<'py>(
        &self,
        retreat: &Bound<'py, PyAny>,
        one: impl Fn(&joints::Unloading, f64) -> Result<f64, ContactError> + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let sigma = self.joint.scene().surface.asperity_height_std;
        let read = texts_in_si(retreat, "m")?;
        let (retreat, unit, metres) = match &read {
            Some(read) => (read, SIGMAS.in_si(), 1.0),
            None => (retreat, self.unit, self.metres()),
        };
        let slipped = |value: f64| unit.slip("retreat", value, sigma);
        let one = |u: f64| one(&self.joint, metres * u);
        over(retreat, "retreat", slipped, one, |error| self.model.get().raise(retreat.py(), error))
    }
}

/// A joint that is sheared at a constant separation, from virgin or in cycles.
///
/// Made by ``Unloading.slip``. Shifts and amplitudes are in metres or with their unit, as "100 nm"; a
/// float gives floats, an array gives arrays of its shape. The asperities answer as elastically as in the unloading.
#[pyclass(frozen, module = "asperity")]
pub(crate) struct PartialSlip {
    /// The joint that is sheared.
    #[pyo3(get)]
    unloading: Py<Unloading>,
    /// The coefficient of friction.
    #[pyo3(get)]
    friction: f64,
    slip: joints::PartialSlip,
}

#[pymethods]
impl PartialSlip {
    /// Of an `Unloading`.
    #[new]
    fn new(unloading: Py<Unloading>, friction: f64) -> PyResult<Self> {
        let slip = joints::PartialSlip::new(&unloading.get().joint, friction);
        Ok(Self { slip: slip.map_err(value_error)?, unloading, friction })
    }

    /// Tangential force [N] at first shifts.
    fn force<'py>(&self, shift: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(shift, "shift", |slip, u| Ok(slip.force(u)?.value()))
    }

    /// Tangential force [N] at shifts in a steady cycle: on the way back from +amplitude, or forth
    /// from -amplitude.
    #[pyo3(signature = (shift, amplitude, *, forth=false))]
    fn loop_force<'py>(
        &self,
        shift: &Bound<'py, PyAny>,
        amplitude: &Bound<'py, PyAny>,
        forth: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        let amplitude: f64 =
            texts_in_si(amplitude, "m")?.as_ref().unwrap_or(amplitude).extract()?;
        self.over(shift, "shift", |slip, u| slip.loop_force(u, amplitude, forth))
    }

    /// Energy [J] that a cycle between -amplitude and +amplitude loses.
    fn loss<'py>(&self, amplitude: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(amplitude, "amplitude", |slip, u| Ok(slip.loss(u)?.value()))
    }

    /// Loss factor of a cycle between -amplitude and +amplitude: its loss over 2 pi times half of force
    /// times amplitude, 4/pi where all slides.
    fn loss_factor<'py>(&self, amplitude: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(amplitude, "amplitude", joints::PartialSlip::loss_factor)
    }

    /// Shift [m] at which the tangential force reaches this share of its limit, friction times the
    /// normal force: everything all but slides at 0.99.
    #[pyo3(signature = (share=0.99))]
    fn shift_at(&self, py: Python<'_>, share: f64) -> PyResult<f64> {
        py.detach(|| self.slip.shift_at(share)).map_err(|error| self.raise(py, error))
    }

    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let arguments = (&slf.get().unloading, slf.get().friction);
        Ok((slf.get_type().into_any(), arguments.into_pyobject(slf.py())?))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let unloading = self.unloading.bind(py).repr()?;
        Ok(format!("<asperity.PartialSlip with friction {}; {unloading}>", self.friction))
    }
}

impl PartialSlip {
    fn raise(&self, py: Python<'_>, error: ContactError) -> PyErr {
        self.unloading.get().model.get().raise(py, error)
    }

    fn over<'py>(
        &self,
        numbers: &Bound<'py, PyAny>,
        name: &str,
        one: impl Fn(&joints::PartialSlip, f64) -> Result<f64, ContactError> + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let one = |u: f64| one(&self.slip, u);
        let read = texts_in_si(numbers, "m")?;
        let numbers = read.as_ref().unwrap_or(numbers);
        over(numbers, name, |_| None, one, |error| self.raise(numbers.py(), error))
    }
}

/// A float's answer as a float, an array's as an array of its shape; `slipped` is what deserves a
/// word about a number.
fn over<'py>(
    numbers: &Bound<'py, PyAny>,
    name: &str,
    slipped: impl Fn(f64) -> Option<String>,
    one: impl Fn(f64) -> Result<f64, ContactError> + Sync,
    raise: impl Fn(ContactError) -> PyErr + Copy,
) -> PyResult<Bound<'py, PyAny>> {
    let py = numbers.py();
    if let Some(number) = scalar(numbers) {
        slipped(number).map_or(Ok(()), |slip| warn(py, &slip, 0))?;
        let found = py.detach(|| one(number)).map_err(raise)?;
        return Ok(PyFloat::new(py, found).into_any());
    }
    let numbers = floats(numbers, name)?.readonly();
    let given = numbers.as_slice()?;
    // One of an array may be small; all of them are not.
    let largest = given.iter().copied().fold(0.0, f64::max);
    slipped(largest).map_or(Ok(()), |slip| warn(py, &slip, 0))?;
    let run = |range: Range<usize>| -> Result<Vec<f64>, ContactError> {
        given[range].iter().map(|number| one(*number)).collect()
    };
    let mut values = Vec::with_capacity(given.len());
    stretches(py, &*pool(None)?, given.len(), TOGETHER, run, |found| {
        values.extend(found.map_err(raise)?);
        Ok(true)
    })?;
    Ok(PyArray1::from_vec(py, values).reshape(numbers.shape())?.into_any())
}
