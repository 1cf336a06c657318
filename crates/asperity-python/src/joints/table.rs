//! `JointTable`: loading, unloading and reloading, for codes that step in time.

use asperity::joints;
use asperity::{Datum, Separation, SeparationUnit, Tolerance};
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::convert::axis::Axis;
use crate::convert::error::{value_error, warn};
use crate::convert::numbers::floats;
use crate::joints::SIGMAS;
use crate::model::engine::Engine;
use crate::scene::SceneFile;

/// Numbers in the shape of the argument.
type Column<'py> = Bound<'py, PyArrayDyn<f64>>;

/// Force and stiffness of a joint step by step: first loading, unloading, and reloading on the
/// unloading curve, in some tens of nanoseconds.
///
/// Made by ``Model.joint_table``. Separations are in ``separation_unit``, from the scene's plane.
/// The state of a joint is its closest approach: infinity for a new one.
#[pyclass(frozen, module = "asperity")]
pub(crate) struct JointTable {
    model: Py<Engine>,
    /// The scene.
    #[pyo3(get)]
    scene: Py<SceneFile>,
    /// The unloading law of an asperity: "hertz", "brake" or "etsion".
    #[pyo3(get)]
    law: String,
    /// The tabulated range of closest approaches; beyond the larger, loading is elastic.
    #[pyo3(get)]
    ends: (f64, f64),
    /// Largest error of an unloading force, over the force at its closest approach.
    #[pyo3(get)]
    tolerance: f64,
    /// The unit of the separations: "asperity_height_std" or "m".
    #[pyo3(get)]
    separation_unit: String,
    /// The length of that unit [m].
    metres: f64,
    /// Height of the scene's plane above the mean of the asperity heights [m].
    plane: f64,
    table: joints::JointTable,
}

#[pymethods]
impl JointTable {
    /// The table of a `Model` on a `Scene`.
    #[new]
    fn new(
        py: Python<'_>,
        model: Py<Engine>,
        scene: Py<SceneFile>,
        ends: (f64, f64),
        law: &str,
        tolerance: f64,
        separation_unit: Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        let file = scene.get().0.clone();
        let parsed = law.parse().map_err(|error| value_error(format!("law: {error}")))?;
        let unit: Axis = separation_unit.extract()?;
        let raise = |error| model.get().raise(py, error);
        let sigma = file.scene.surface.asperity_height_std;
        let metres = if unit == SIGMAS { sigma } else { 1.0 };
        let zero =
            Separation { value: 0.0, unit: SeparationUnit::Metres, from: file.separation_from };
        let mean = zero.measured_in(SeparationUnit::Metres, Datum::AsperityMean, &file.scene);
        let plane = mean.map_err(raise)?.value;
        for end in [ends.0, ends.1] {
            let mistaken = unit.mistaken_unit("separation", end, sigma);
            mistaken.map_or(Ok(()), |text| warn(py, &text, 1))?;
        }
        let named = model.get().on(&file)?;
        let range = (metres * ends.0 + plane, metres * ends.1 + plane);
        let table = py.detach(|| {
            joints::Joint::new(&named, &file.scene, parsed, Tolerance::default())?
                .table(range, tolerance)
        });
        let (table, law) = (table.map_err(raise)?, law.to_string());
        let separation_unit = separation_unit.extract()?;
        Ok(Self { model, scene, law, ends, tolerance, separation_unit, metres, plane, table })
    }

    /// Force [N], stiffness -dF/dd [N/m] and closest approach at a separation of a joint whose
    /// closest approach so far is ``closest``; the returned one is that of the next step.
    #[pyo3(signature = (separation, closest=f64::INFINITY))]
    fn step(&self, py: Python<'_>, separation: f64, closest: f64) -> PyResult<(f64, f64, f64)> {
        let reply = self.table.at(self.above_mean(separation), self.above_mean(closest));
        let reply = reply.map_err(|error| self.model.get().raise(py, error))?;
        Ok((reply.force, reply.stiffness, closest.min(separation)))
    }

    /// Force [N] and stiffness [N/m] of a new joint along a sequence of separations.
    fn history<'py>(&self, separation: &Bound<'py, PyAny>) -> PyResult<(Column<'py>, Column<'py>)> {
        let py = separation.py();
        let numbers = floats(separation, "separation")?.readonly();
        let given = numbers.as_slice()?;
        let (mut force, mut stiffness) = (vec![], vec![]);
        let passed = py.detach(|| {
            let mut contact = self.table.new_contact();
            given.iter().try_for_each(|separation| {
                let reply = contact.step(self.above_mean(*separation))?;
                force.push(reply.force);
                stiffness.push(reply.stiffness);
                Ok(())
            })
        });
        passed.map_err(|error| self.model.get().raise(py, error))?;
        let shaped = |column| PyArray1::from_vec(py, column).reshape(numbers.shape());
        Ok((shaped(force)?, shaped(stiffness)?))
    }

    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let Self { model, scene, ends, law, tolerance, separation_unit, .. } = slf.get();
        let arguments = (model, scene, ends, law, tolerance, separation_unit);
        Ok((slf.get_type().into_any(), arguments.into_pyobject(slf.py())?))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let name = self.model.bind(py).getattr("name")?;
        let Self { law, ends: (deepest, open), tolerance, separation_unit, .. } = self;
        Ok(format!(
            "<asperity.JointTable of {name} by {law} from {deepest:?} to {open:?} {separation_unit} to {tolerance:e}; {}>",
            self.scene.bind(py).repr()?
        ))
    }
}

impl JointTable {
    /// A separation from the mean of the asperity heights [m].
    fn above_mean(&self, separation: f64) -> f64 {
        self.metres * separation + self.plane
    }
}
