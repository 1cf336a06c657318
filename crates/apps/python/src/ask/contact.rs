//! `Contact`: one model compiled on one scene for many evaluations.

use std::ops::Range;
use std::sync::{Arc, Mutex, PoisonError};

use asperity::{At, ContactError, ContactModel, Evaluation, Quantity, Request};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::ask::answer::{ROWS_PER_TASK_ON_ONE_SCENE, filled};
use crate::ask::long::run_stretches;
use crate::ask::over::Given;
use crate::ask::rows::sigmas;
use crate::convert::axis::Axis;
use crate::convert::{Object, Quantities, value_error, warn_of_ranges};
use crate::model::engine::Engine;
use crate::scene::SceneFile;

/// Values of one task, where they go into plain arrays: fewer take less time than to wake a thread.
const VALUES_PER_TASK: usize = 16_384;
/// Fewer values are as fast one by one.
const FEW: usize = 16;

/// One model compiled on one scene for many evaluations, as in codes that step in time.
///
/// Made by ``Model.compile``. Separations are in ``separation_unit``, from the scene's plane; a
/// float gives floats, an array gives arrays of its shape. Threads may share a contact.
#[pyclass(frozen, module = "asperity")]
pub(crate) struct Contact {
    model: Py<Engine>,
    /// The scene.
    #[pyo3(get)]
    scene: Py<SceneFile>,
    /// The relative tolerance.
    #[pyo3(get)]
    rtol: f64,
    /// The unit of the separations: "asperity_height_std" or "m".
    #[pyo3(get)]
    separation_unit: String,
    axis: Axis,
    file: Arc<asperity_scene::SceneFile>,
    request: Request,
    compiled: Mutex<Arc<dyn asperity::Contact>>,
}

#[pymethods]
impl Contact {
    /// Of a `Model` on a `Scene`.
    #[new]
    fn new(
        py: Python<'_>,
        model: Py<Engine>,
        scene: Py<SceneFile>,
        quantities: Quantities,
        rtol: f64,
        separation_unit: Object<'_>,
    ) -> PyResult<Self> {
        warn_of_ranges(py, &scene.get().0, 1)?;
        let file = scene.get().0.clone();
        let request = quantities.request(rtol)?.at_loads([1.0]);
        let compiled = Mutex::new(compile(py, model.get(), &file, &request)?);
        let (axis, separation_unit) = (separation_unit.extract()?, separation_unit.extract()?);
        Ok(Self { model, scene, rtol, separation_unit, axis, file, request, compiled })
    }

    /// Force [N] at separations.
    fn force<'py>(&self, separation: &Object<'py>) -> PyResult<Object<'py>> {
        self.values(Quantity::Force, self.axis, separation)
    }

    /// Force [N] and tangent -dF/dd [N/m] at separations, in one pass.
    fn force_and_tangent<'py>(&self, separation: &Object<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let one = |contact: &dyn asperity::Contact, at| {
            contact.force_and_tangent_at(at).map(|(force, tangent)| [force, tangent])
        };
        let both = self.over([Quantity::Force, Quantity::Tangent], self.axis, separation, one)?;
        PyTuple::new(separation.py(), both)
    }

    /// One of the compiled quantities, in SI units, at separations or under loads [N] or pressures
    /// [Pa]; of curved bodies under loads or at approaches [m].
    #[pyo3(signature = (quantity, separation=None, *, load=None, pressure=None, approach=None))]
    fn evaluate<'py>(
        &self,
        quantity: &str,
        separation: Option<&Object<'py>>,
        load: Option<&Object<'py>>,
        pressure: Option<&Object<'py>>,
        approach: Option<&Object<'py>>,
    ) -> PyResult<Object<'py>> {
        let quantity: Quantity = quantity.parse().map_err(value_error)?;
        let given = [
            (self.axis, separation),
            (Axis::Load, load),
            (Axis::Pressure, pressure),
            (Axis::Approach, approach),
        ];
        let mut given = given.into_iter().filter_map(|(axis, numbers)| Some((axis, numbers?)));
        match (given.next(), given.next()) {
            (Some((axis, numbers)), None) => self.values(quantity, axis, numbers),
            _ => Err(PyTypeError::new_err(
                "exactly one of separation, load, pressure and approach was required",
            )),
        }
    }

    /// Computes now all that later calls at separations from ``low`` to ``high`` need, so that the
    /// first of them takes no longer than any other and allocates nothing. Exact for Gaussian
    /// heights, above -64 asperity_height_std.
    ///
    /// >>> import asperity
    /// >>> scene = asperity.Scene.parse(asperity.template())
    /// >>> contact = asperity.model("ke").compile(scene, separation_unit="m")
    /// >>> contact.prepare(0.0, "5 um")
    fn prepare(&self, low: &Object<'_>, high: &Object<'_>) -> PyResult<()> {
        let contact = self.current();
        let end = |name: &str, given: &Object<'_>| {
            let (number, is_si) = Given::read(given, name, self.axis.si())?;
            let axis = if is_si { self.axis.in_si() } else { self.axis };
            let found =
                sigmas(number.numbers()?, axis, self.file.spec.separation_from, contact.scene());
            let none = || value_error(format!("{name} has no separation of the asperities"));
            found.as_deref().and_then(<[f64]>::first).copied().ok_or_else(none)
        };
        let (low_end, high_end) = (end("low", low)?, end("high", high)?);
        self.model.get().run(low.py(), || contact.prepare(low_end, high_end))
    }

    /// The compiled quantities.
    #[getter]
    fn quantities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.names())
    }

    /// The model's name.
    #[getter]
    fn model(&self) -> String {
        self.current().model().into()
    }

    fn __getnewargs__(&self) -> (&Py<Engine>, &Py<SceneFile>, Vec<String>, f64, &str) {
        (&self.model, &self.scene, self.names(), self.rtol, &self.separation_unit)
    }

    fn __repr__(&self) -> String {
        let (model, names, unit) = (self.model(), self.names().join(", "), &self.separation_unit);
        format!(
            "<asperity.Contact of {model}: {names}; rtol={:e}; separations in {unit}>",
            self.rtol
        )
    }
}

impl Contact {
    fn names(&self) -> Vec<String> {
        self.request.quantities.iter().map(ToString::to_string).collect()
    }

    /// The compiled contact in use.
    fn current(&self) -> Arc<dyn asperity::Contact> {
        self.compiled.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// The exception of a refusal. A model in Python is compiled again: its law may have raised
    /// only once, as at an interrupt.
    fn raise(&self, py: Python<'_>, refusal: ContactError) -> PyErr {
        let model = self.model.get();
        if model.is_written()
            && let Ok(compiled) = compile(py, model, &self.file, &self.request)
        {
            *self.compiled.lock().unwrap_or_else(PoisonError::into_inner) = compiled;
        }
        model.raise(py, refusal)
    }

    fn values<'py>(
        &self,
        quantity: Quantity,
        axis: Axis,
        numbers: &Object<'py>,
    ) -> PyResult<Object<'py>> {
        let one = |contact: &dyn asperity::Contact, at| Ok([contact.evaluate_at(quantity, at)?]);
        Ok(self.over([quantity], axis, numbers, one)?.remove(0))
    }

    /// Quantities at a number, by `one`, or at every number of an array: floats for a float, arrays
    /// of its shape for an array.
    fn over<'py, const N: usize>(
        &self,
        quantities: [Quantity; N],
        axis: Axis,
        numbers: &Object<'py>,
        one: impl Fn(&dyn asperity::Contact, At) -> Result<[Evaluation; N], ContactError> + Sync,
    ) -> PyResult<Vec<Object<'py>>> {
        let (py, from) = (numbers.py(), self.file.spec.separation_from);
        if let Some(&quantity) = quantities.iter().find(|q| !self.request.quantities.contains(q)) {
            return Err(value_error(ContactError::NotRequested { quantity }));
        }
        axis.check(&self.file)?;
        let (given, is_si) = Given::read(numbers, "separation", axis.si())?;
        let axis = if is_si { axis.in_si() } else { axis };
        axis.warn_of_unit(py, "separation", given.numbers()?, &self.file, 0)?;
        let contact = self.current();
        if let Some(columns) = self.filled(py, &*contact, quantities, axis, given.numbers()?)? {
            return given.shaped(py, columns);
        }
        let one = |_, number| {
            Ok(one(&*contact, axis.at(number, from))?.map(|evaluation| evaluation.value()))
        };
        let together = if self.file.shape().is_some() { 1 } else { ROWS_PER_TASK_ON_ONE_SCENE };
        given.each(py, together, one, |error| self.raise(py, error))
    }

    /// Columns of many values at separations, in a few nanoseconds each; none if a row needs more.
    fn filled<const N: usize>(
        &self,
        py: Python<'_>,
        contact: &dyn asperity::Contact,
        quantities: [Quantity; N],
        axis: Axis,
        numbers: &[f64],
    ) -> PyResult<Option<[Vec<f64>; N]>> {
        if !matches!(axis, Axis::Separation(_)) || numbers.len() < FEW {
            return Ok(None);
        }
        let (scene, from) = (contact.scene(), self.file.spec.separation_from);
        let fill = |range: Range<usize>| {
            let places = sigmas(&numbers[range], axis, from, scene)?;
            Some(filled(contact, &quantities, &places)?.0)
        };
        let tasks = (numbers.len(), VALUES_PER_TASK);
        let mut columns = [(); N].map(|()| Vec::with_capacity(numbers.len()));
        for found in run_stretches(py, tasks, fill, Option::is_none)? {
            let Some(found) = found else { return Ok(None) };
            columns.iter_mut().zip(found).for_each(|(column, found)| column.extend(found));
        }
        Ok(Some(columns))
    }
}

fn compile(
    py: Python<'_>,
    engine: &Engine,
    file: &asperity_scene::SceneFile,
    request: &Request,
) -> PyResult<Arc<dyn asperity::Contact>> {
    let model = engine.on(file)?;
    engine.run(py, || model.compile(&file.scene, request)).map(Arc::from)
}
