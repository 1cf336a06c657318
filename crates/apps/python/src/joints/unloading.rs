//! `Unloading`, a joint that opens after its first closing, and `PartialSlip`, the same under
//! shear.

use asperity::{ContactError, Severity, joints};
use pyo3::prelude::*;

use super::ROWS_PER_TASK;
use crate::ask::advice::check_scene;
use crate::ask::over::Given;
use crate::convert::axis::{Axis, METRES};
use crate::convert::numbers::in_si;
use crate::convert::{Object, tolerance, value_error, warn, warn_of_ranges, warn_unless};
use crate::model::engine::Engine;
use crate::scene::SceneFile;

/// A joint that opens after its first closing.
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
    joint: joints::Unloading,
}

#[pymethods]
impl Unloading {
    /// The unloading of a `Model` on a `Scene`, from an axis and a number on it.
    #[new]
    fn new(
        py: Python<'_>,
        model: Py<Engine>,
        scene: Py<SceneFile>,
        place: (Object<'_>, f64),
        law: &str,
        rtol: f64,
        separation_unit: Object<'_>,
    ) -> PyResult<Self> {
        warn_of_ranges(py, &scene.get().0, 1)?;
        let file = scene.get().0.clone();
        let law = law.parse().map_err(|error| value_error(format!("law: {error}")))?;
        let (axis, unit): (Axis, Axis) = (place.0.extract()?, separation_unit.extract()?);
        axis.warn_of_unit(py, "separation", &[place.1], &file, 1)?;
        let (named, tolerance) = (model.get().on_flat(&file)?, tolerance(rtol)?);
        let at = axis.at(place.1, file.spec.separation_from);
        let (joint, whole, closest) = model.get().run(py, || {
            let whole = joints::Joint::new(&named, &file.scene, law, tolerance)?;
            let joint = whole.unloading(at)?;
            let closest = unit.of(joint.closest(), file.spec.separation_from, joint.scene())?;
            Ok((joint, whole, closest))
        })?;
        let found = py.detach(|| check_scene(model.get(), &named, &file, [at]));
        let found = file.accepted(found).at_least(Severity::Warning);
        found.iter().try_for_each(|found| warn(py, found, 1))?;
        let (place, separation_unit) = ((place.0.extract()?, place.1), separation_unit.extract()?);
        Ok(Self { model, scene, place, rtol, separation_unit, closest, unit, whole, joint })
    }

    /// Force [N] at retreats.
    fn force<'py>(&self, retreat: &Object<'py>) -> PyResult<Object<'py>> {
        self.over(retreat, |joint, u| Ok(joint.force(u)?.value()))
    }

    /// Real contact area [m^2] at retreats; not for the law "etsion".
    fn area<'py>(&self, retreat: &Object<'py>) -> PyResult<Object<'py>> {
        self.over(retreat, |joint, u| Ok(joint.area(u)?.value()))
    }

    /// Stiffness -dF/dd [N/m] at retreats.
    fn stiffness<'py>(&self, retreat: &Object<'py>) -> PyResult<Object<'py>> {
        self.over(retreat, |joint, u| Ok(joint.stiffness(u)?.value()))
    }

    /// Work [J] returned by unloading up to retreats.
    fn returned<'py>(&self, retreat: &Object<'py>) -> PyResult<Object<'py>> {
        self.over(retreat, |joint, u| Ok(joint.returned(u)?.value()))
    }

    /// Mean number of asperities in contact at retreats.
    fn contacts<'py>(&self, retreat: &Object<'py>) -> PyResult<Object<'py>> {
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
        let (name, law) = (self.model.bind(py).getattr("name")?, self.law());
        let (closest, unit) = (self.closest, &self.separation_unit);
        Ok(format!("<asperity.Unloading of {name} by {law} from {closest:.5e} {unit}>"))
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
        let accept = &self.scene.get().0.spec.accept;
        gain.map_or(Ok(()), |gain| warn_unless(py, accept, &gain.finding(), 0))?;
        Ok(work)
    }

    fn over<'py>(
        &self,
        retreat: &Object<'py>,
        one: impl Fn(&joints::Unloading, f64) -> Result<f64, ContactError> + Sync,
    ) -> PyResult<Object<'py>> {
        let (py, scene) = (retreat.py(), self.joint.scene());
        let (given, is_si) = Given::read(retreat, "retreat", "m")?;
        let unit = if is_si { METRES } else { self.unit };
        unit.warn_of_unit(py, "retreat", given.numbers()?, &self.scene.get().0, 0)?;
        let one = |_, u: f64| Ok([one(&self.joint, unit.metres(scene) * u)?]);
        Ok(given.each(py, ROWS_PER_TASK, one, |error| self.model.get().raise(py, error))?.remove(0))
    }
}

/// A joint that is sheared at a constant separation, for the first time or in cycles.
///
/// Made by ``Unloading.slip``. Shifts and amplitudes are in metres or texts with a unit, as "100
/// nm"; a float gives floats, an array gives arrays of its shape. The asperities respond
/// elastically, as in unloading.
#[pyclass(frozen, module = "asperity")]
pub(crate) struct PartialSlip {
    /// The joint under shear.
    #[pyo3(get)]
    unloading: Py<Unloading>,
    /// The coefficient of friction.
    #[pyo3(get)]
    friction: f64,
    slip: joints::PartialSlip,
}

#[pymethods]
impl PartialSlip {
    /// The partial slip of an `Unloading`.
    #[new]
    fn new(unloading: Py<Unloading>, friction: f64) -> PyResult<Self> {
        let slip = joints::PartialSlip::new(&unloading.get().joint, friction);
        Ok(Self { slip: slip.map_err(value_error)?, unloading, friction })
    }

    /// Tangential force [N] at shifts of the first loading.
    fn force<'py>(&self, shift: &Object<'py>) -> PyResult<Object<'py>> {
        self.over(shift, ("shift", "m"), |slip, u| Ok(slip.force(u)?.value()))
    }

    /// Tangential force [N] at shifts in a steady cycle: on the branch from +amplitude back, or,
    /// with ``forth``, from -amplitude.
    #[pyo3(signature = (shift, amplitude, *, forth=false))]
    fn loop_force<'py>(
        &self,
        shift: &Object<'py>,
        amplitude: &Object<'py>,
        forth: bool,
    ) -> PyResult<Object<'py>> {
        let amplitude: f64 = in_si(amplitude, "m", "")?.extract()?;
        self.over(shift, ("shift", "m"), |slip, u| slip.loop_force(u, amplitude, forth))
    }

    /// Energy [J] dissipated per cycle between -amplitude and +amplitude.
    fn loss<'py>(&self, amplitude: &Object<'py>) -> PyResult<Object<'py>> {
        self.over(amplitude, ("amplitude", "m"), |slip, u| Ok(slip.loss(u)?.value()))
    }

    /// Loss factor of a cycle between -amplitude and +amplitude: the dissipated energy over pi
    /// times force times amplitude; 4/pi in full sliding.
    fn loss_factor<'py>(&self, amplitude: &Object<'py>) -> PyResult<Object<'py>> {
        self.over(amplitude, ("amplitude", "m"), joints::PartialSlip::loss_factor)
    }

    /// Amplitude of shift [m] of cycles with these amplitudes of the tangential force [N], which
    /// are below ``limit``.
    fn amplitude_at<'py>(&self, force: &Object<'py>) -> PyResult<Object<'py>> {
        self.over(force, ("tangential_force", "N"), joints::PartialSlip::amplitude_at)
    }

    /// The tangential force [N] at which the joint slides: friction times the normal force.
    #[getter]
    fn limit(&self, py: Python<'_>) -> PyResult<f64> {
        self.engine().run(py, || self.slip.limit())
    }

    /// Shift [m] at which the tangential force reaches ``share`` of its limit, friction times the
    /// normal force.
    #[pyo3(signature = (share=0.99))]
    fn shift_at(&self, py: Python<'_>, share: f64) -> PyResult<f64> {
        self.engine().run(py, || self.slip.shift_at(share))
    }

    fn __getnewargs__(&self) -> (&Py<Unloading>, f64) {
        (&self.unloading, self.friction)
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let unloading = self.unloading.bind(py).repr()?;
        Ok(format!("<asperity.PartialSlip with friction {}; {unloading}>", self.friction))
    }
}

impl PartialSlip {
    fn engine(&self) -> &Engine {
        self.unloading.get().model.get()
    }

    fn over<'py>(
        &self,
        numbers: &Object<'py>,
        (name, unit): (&str, &str),
        one: impl Fn(&joints::PartialSlip, f64) -> Result<f64, ContactError> + Sync,
    ) -> PyResult<Object<'py>> {
        let (given, _) = Given::read(numbers, name, unit)?;
        let (py, one) = (numbers.py(), |_, u: f64| Ok([one(&self.slip, u)?]));
        Ok(given.each(py, ROWS_PER_TASK, one, |error| self.engine().raise(py, error))?.remove(0))
    }
}
