//! `JointTable`: loading, unloading and reloading, for codes that step in time.

use asperity::joints;
use asperity::{ContactError, Datum, Separation, SeparationUnit, Tolerance};
use numpy::{PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyTuple};

use crate::ask::over::Given;
use crate::convert::axis::{Axis, METRES};
use crate::convert::numbers::{floats, scalar};
use crate::convert::{Object, value_error, warn_of_ranges};
use crate::model::engine::Engine;
use crate::scene::SceneFile;

/// Force and stiffness of a joint step by step: first loading, unloading, and reloading on the
/// unloading curve, in some tens of nanoseconds.
///
/// Made by ``Model.joint_table``. Separations are in ``separation_unit``, from the scene's plane.
/// The state of a joint is its closest approach, infinity for a new one: many joints, as the nodes
/// of a mesh, are arrays of separations and closest approaches, and saving the latter saves them.
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
    unit: SeparationUnit,
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
        separation_unit: Object<'_>,
    ) -> PyResult<Self> {
        warn_of_ranges(py, &scene.get().0, 1)?;
        let file = scene.get().0.clone();
        let parsed = law.parse().map_err(|error| value_error(format!("law: {error}")))?;
        let axis: Axis = separation_unit.extract()?;
        let unit = if axis == METRES { SeparationUnit::Metres } else { SeparationUnit::Sigma };
        for end in [ends.0, ends.1] {
            axis.warn_of_unit(py, "separation", &[end], &file, 1)?;
        }
        let named = model.get().on_flat(&file)?;
        let (metres, plane, table) = model.get().run(py, || {
            let joint = joints::Joint::new(&named, &file.scene, parsed, Tolerance::default())?;
            let metres = axis.metres(joint.scene());
            // The zero of the scene's separations.
            let zero = file.separation(0.0, SeparationUnit::Metres);
            let plane =
                zero.measured_in(SeparationUnit::Metres, Datum::AsperityMean, joint.scene())?;
            let range = (metres * ends.0 + plane.value, metres * ends.1 + plane.value);
            Ok((metres, plane.value, joint.table(range, tolerance)?))
        })?;
        let law = law.to_string();
        let separation_unit = separation_unit.extract()?;
        Ok(Self { model, scene, law, ends, tolerance, separation_unit, unit, metres, plane, table })
    }

    /// Force [N], stiffness -dF/dd [N/m] and closest approach at a separation of a joint whose
    /// closest approach so far is ``closest``; the returned one is for the next step. Floats
    /// give floats; arrays, broadcast, are many joints at once.
    ///
    /// The stiffness is the exact derivative of the force. In Newton's method every iteration of a
    /// step starts from the ``closest`` of the last converged one.
    ///
    /// >>> import asperity, numpy as np
    /// >>> scene = asperity.Scene.parse(asperity.template())
    /// >>> table = asperity.model("ke").joint_table(scene, 0.0, 4.0)
    /// >>> force, stiffness, closest = table.step(np.array([1.0, 2.0, 3.0]))
    /// >>> force, stiffness, closest = table.step(np.array([1.1, 2.1, 2.9]), closest)
    /// >>> force.round(2), closest
    /// (array([1609.77,  137.  ,   12.92]), array([1. , 2. , 2.9]))
    #[pyo3(signature = (separation, closest=None))]
    fn step<'py>(
        &self,
        separation: &Object<'py>,
        closest: Option<&Object<'py>>,
    ) -> PyResult<Bound<'py, PyTuple>> {
        let py = separation.py();
        let infinity = PyFloat::new(py, f64::INFINITY).into_any();
        let closest = closest.unwrap_or(&infinity);
        let raise = |error| self.model.get().raise(py, error);
        if let (Some(separation), Some(closest)) = (scalar(separation), scalar(closest)) {
            return PyTuple::new(py, self.one(separation, closest).map_err(raise)?);
        }
        let (mut separation, mut closest) =
            (floats(separation, "separation")?, floats(closest, "closest")?);
        if separation.shape() != closest.shape() {
            let numpy = py.import("numpy")?;
            let both = numpy.call_method1("broadcast_arrays", (separation, closest))?;
            let both: (Object<'py>, Object<'py>) = both.extract()?;
            (separation, closest) = (floats(&both.0, "separation")?, floats(&both.1, "closest")?);
        }
        let (separation, closest) =
            (Given::Many(separation.readonly()), Given::Many(closest.readonly()));
        let states = closest.numbers()?;
        let one = |k: usize, separation| self.one(separation, states[k]);
        PyTuple::new(py, separation.each(py, usize::MAX, one, raise)?)
    }

    #[expect(clippy::type_complexity, reason = "the arguments of a call")]
    fn __getnewargs__(&self) -> (&Py<Engine>, &Py<SceneFile>, (f64, f64), &str, f64, &str) {
        let Self { model, scene, law, separation_unit, .. } = self;
        (model, scene, self.ends, law, self.tolerance, separation_unit)
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let name = self.model.bind(py).getattr("name")?;
        let Self { law, ends: (deepest, open), tolerance, separation_unit, .. } = self;
        Ok(format!(
            "<asperity.JointTable of {name} by {law} from {deepest:?} to {open:?} {separation_unit} to {tolerance:e}>"
        ))
    }
}

impl JointTable {
    /// Force, stiffness and closest approach, for numbers in the table's unit.
    fn one(&self, separation: f64, closest: f64) -> Result<[f64; 3], ContactError> {
        // A refusal has the numbers as given.
        let refused = |error| match error {
            ContactError::BelowTable { field, .. } => {
                let value = if field == "closest" { closest } else { separation };
                let (unit, from) = (self.unit, self.scene.get().0.spec.separation_from);
                let given = |value| Separation { value, unit, from };
                let [separation, deepest] = [value, self.ends.0].map(given);
                ContactError::BelowTable { field, separation, deepest }
            }
            error => error,
        };
        let reply = self.table.at(self.above_mean(separation), self.above_mean(closest));
        let reply = reply.map_err(refused)?;
        Ok([reply.force, reply.stiffness, closest.min(separation)])
    }

    /// A separation from the mean of the asperity heights [m].
    fn above_mean(&self, separation: f64) -> f64 {
        self.metres * separation + self.plane
    }
}
