//! `PartialSlip`: a closed joint under shear.

use asperity::ContactError;
use asperity::joints;
use pyo3::prelude::*;

use super::{ROWS_PER_TASK, Unloading};
use crate::ask::over::Given;
use crate::convert::numbers::texts_in_si;
use crate::convert::value_error;
use crate::model::engine::Engine;

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
    pub(super) fn new(unloading: Py<Unloading>, friction: f64) -> PyResult<Self> {
        let slip = joints::PartialSlip::new(&unloading.get().joint, friction);
        Ok(Self { slip: slip.map_err(value_error)?, unloading, friction })
    }

    /// Tangential force [N] at shifts of the first loading.
    fn force<'py>(&self, shift: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(shift, ("shift", "m"), |slip, u| Ok(slip.force(u)?.value()))
    }

    /// Tangential force [N] at shifts in a steady cycle: on the branch from +amplitude back, or,
    /// with ``forth``, from -amplitude.
    #[pyo3(signature = (shift, amplitude, *, forth=false))]
    fn loop_force<'py>(
        &self,
        shift: &Bound<'py, PyAny>,
        amplitude: &Bound<'py, PyAny>,
        forth: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        let amplitude: f64 =
            texts_in_si(amplitude, "m")?.as_ref().unwrap_or(amplitude).extract()?;
        self.over(shift, ("shift", "m"), |slip, u| slip.loop_force(u, amplitude, forth))
    }

    /// Energy [J] dissipated per cycle between -amplitude and +amplitude.
    fn loss<'py>(&self, amplitude: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(amplitude, ("amplitude", "m"), |slip, u| Ok(slip.loss(u)?.value()))
    }

    /// Loss factor of a cycle between -amplitude and +amplitude: the dissipated energy over pi
    /// times force times amplitude; 4/pi in full sliding.
    fn loss_factor<'py>(&self, amplitude: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.over(amplitude, ("amplitude", "m"), joints::PartialSlip::loss_factor)
    }

    /// Amplitude of shift [m] of cycles with these amplitudes of the tangential force [N], which
    /// are below ``limit``.
    fn amplitude_at<'py>(&self, force: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
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
        numbers: &Bound<'py, PyAny>,
        (name, unit): (&str, &str),
        one: impl Fn(&joints::PartialSlip, f64) -> Result<f64, ContactError> + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (given, _) = Given::read(numbers, name, unit)?;
        let (py, one) = (numbers.py(), |_, u: f64| Ok([one(&self.slip, u)?]));
        Ok(given.each(py, ROWS_PER_TASK, one, |error| self.engine().raise(py, error))?.remove(0))
    }
}
