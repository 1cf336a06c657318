//! `Unloading`: a joint that opens after its first closing.

use asperity::joints;
use asperity::{ContactError, Severity};
use pyo3::prelude::*;

use super::{PartialSlip, ROWS_PER_TASK};
use crate::ask::over::Given;
use crate::check::check_scene;
use crate::convert::axis::{Axis, METRES};
use crate::convert::{value_error, warn};
use crate::model::engine::{Engine, tolerance};
use crate::scene::SceneFile;

/// A joint that opens after its first closing.
///
/// Made by ``Model.unloading``. Retreats are distances back from the closest approach, in
/// ``separation_unit`` or with their own, as "100 nm"; a float gives floats, an array gives arrays
/// of its shape.
#[pyclass(frozen, module = "asperity")]
pub(crate) struct Unloading {
    pub(super) model: Py<Engine>,
    /// The scene.
    #[pyo3(get)]
    scene: Py<SceneFile>,
    /// The place as given: an axis and a number on it.
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
    pub(super) joint: joints::Unloading,
}

#[pymethods]
impl Unloading {
    /// The unloading of a `Model` on a `Scene`, from an axis and a number on it.
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
        let law = law.parse().map_err(|error| value_error(format!("law: {error}")))?;
        let (axis, unit): (Axis, Axis) = (place.0.extract()?, separation_unit.extract()?);
        axis.warn_of_unit(py, "separation", &[place.1], &file.scene, 1)?;
        let (named, tolerance) = (model.get().on(&file)?, tolerance(rtol)?);
        let at = axis.at(place.1, file.separation_from);
        let (joint, whole, closest) = model.get().run(py, || {
            let whole = joints::Joint::new(&named, &file.scene, law, tolerance)?;
            let joint = whole.unloading(at)?;
            let closest = unit.of(joint.closest(), file.separation_from, &file.scene)?;
            Ok((joint, whole, closest))
        })?;
        let found = py.detach(|| check_scene(model.get(), &named, &file, [at]));
        let found = file.accepted(found).at_least(Severity::Warning);
        found.iter().try_for_each(|found| warn(py, found, 1))?;
        let (place, separation_unit) = ((place.0.extract()?, place.1), separation_unit.extract()?);
        Ok(Self { model, scene, place, rtol, separation_unit, closest, unit, whole, joint })
    }

    /// Force [N] at retreats.
    fn force<'py>(&self, retreat: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(retreat, |joint, u| Ok(joint.force(u)?.value()))
    }

    /// Real contact area [m^2] at retreats; not for the law "etsion".
    fn area<'py>(&self, retreat: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(retreat, |joint, u| Ok(joint.area(u)?.value()))
    }

    /// Stiffness -dF/dd [N/m] at retreats.
    fn stiffness<'py>(&self, retreat: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(retreat, |joint, u| Ok(joint.stiffness(u)?.value()))
    }

    /// Work [J] returned by unloading up to retreats.
    fn returned<'py>(&self, retreat: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(retreat, |joint, u| Ok(joint.returned(u)?.value()))
    }

    /// Mean number of asperities in contact at retreats.
    fn contacts<'py>(&self, retreat: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(retreat, |joint, u| Ok(joint.contacts(u)?.value()))
    }

    /// Retreat at which contact ends: beyond, fewer than one asperity is in contact on average.
    fn last_contact(&self, py: Python<'_>) -> PyResult<f64> {
        let found = self.model.get().run(py, || self.joint.last_contact())?;
        Ok(found / self.unit.metres(self.joint.scene()))
    }

    /// Loss factor of the first closing and opening: the dissipated energy over 2 pi times the work
    /// of closing.
    fn loss_factor(&self, py: Python<'_>) -> PyResult<f64> {
        self.work(py)?.loss_factor().map_err(|error| self.model.get().raise(py, error))
    }

    /// Energy [J] dissipated in the first closing and opening.
    fn dissipated(&self, py: Python<'_>) -> PyResult<f64> {
        Ok(self.work(py)?.lost().value())
    }

    /// The joint under shear at its closest approach, with a coefficient of friction.
    fn slip(slf: &Bound<'_, Self>, friction: f64) -> PyResult<PartialSlip> {
        PartialSlip::new(slf.clone().unbind(), friction)
    }

    /// The unloading law of an asperity: "hertz", "brake" or "etsion".
    #[getter]
    fn law(&self) -> String {
        self.joint.law().to_string()
    }

    #[expect(clippy::type_complexity, reason = "the arguments of a call")]
    fn __getnewargs__(&self) -> (&Py<Engine>, &Py<SceneFile>, &(String, f64), String, f64, &str) {
        let Self { model, scene, place, separation_unit, .. } = self;
        (model, scene, place, self.law(), self.rtol, separation_unit)
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
    /// The work of closing and opening; warns if the joint gains energy.
    fn work(&self, py: Python<'_>) -> PyResult<joints::Work> {
        let closest = self.joint.closest().into();
        let (work, gain) = self.model.get().run(py, || {
            let work = self.whole.work(closest)?;
            Ok((work, self.whole.energy_gain(closest, &work)?))
        })?;
        gain.map_or(Ok(()), |gain| warn(py, gain.finding(), 0))?;
        Ok(work)
    }

    fn over<'py>(
        &self,
        retreat: &Bound<'py, PyAny>,
        one: impl Fn(&joints::Unloading, f64) -> Result<f64, ContactError> + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (py, scene) = (retreat.py(), self.joint.scene());
        let (given, is_si) = Given::read(retreat, "retreat", "m")?;
        let unit = if is_si { METRES } else { self.unit };
        unit.warn_of_unit(py, "retreat", given.numbers()?, scene, 0)?;
        let one = |_, u: f64| Ok([one(&self.joint, unit.metres(scene) * u)?]);
        Ok(given.each(py, ROWS_PER_TASK, one, |error| self.model.get().raise(py, error))?.remove(0))
    }
}
