//! `Contact`: one model compiled on one scene for many evaluations.

use std::sync::{Arc, Mutex, PoisonError};

use asperity::{At, ContactError, ContactModel, Evaluation, Quantity, Request};
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyTuple};

use crate::ask::answer::{Aspect, Question, Source};
use crate::ask::rows::View;
use crate::convert::axis::Axis;
use crate::convert::error::{value_error, warn};
use crate::convert::numbers::{floats, scalar, texts_in_si};
use crate::model::engine::{Engine, request_of};
use crate::scene::SceneFile;

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
    file: Arc<asperity_inputs::SceneFile>,
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
        quantities: Vec<String>,
        rtol: f64,
        separation_unit: Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        let file = scene.get().0.clone();
        let request = request_of(&quantities, rtol)?;
        let request = request.at_loads([1.0]);
        let compiled = Mutex::new(compile(py, model.get(), &file, &request)?);
        let (axis, separation_unit) = (separation_unit.extract()?, separation_unit.extract()?);
        Ok(Self { model, scene, rtol, separation_unit, axis, file, request, compiled })
    }

    /// Force [N] at separations.
    fn force<'py>(&self, separation: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.values(Quantity::Force, self.axis, separation)
    }

    /// Force [N] and tangent -dF/dd [N/m] at separations, in one pass.
    fn force_and_tangent<'py>(
        &self,
        separation: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyTuple>> {
        let one = |contact: &dyn asperity::Contact, at| {
            contact.force_and_tangent_at(at).map(|(force, tangent)| [force, tangent])
        };
        let both = self.over([Quantity::Force, Quantity::Tangent], self.axis, separation, one)?;
        PyTuple::new(separation.py(), both)
    }

    /// One of the compiled quantities, in SI units, at separations or under loads [N] or pressures
    /// [Pa].
    #[pyo3(signature = (quantity, separation=None, *, load=None, pressure=None))]
    fn evaluate<'py>(
        &self,
        quantity: &str,
        separation: Option<&Bound<'py, PyAny>>,
        load: Option<&Bound<'py, PyAny>>,
        pressure: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let quantity: Quantity = quantity.parse().map_err(value_error)?;
        match (separation, load, pressure) {
            (Some(separation), None, None) => self.values(quantity, self.axis, separation),
            (None, Some(load), None) => self.values(quantity, Axis::Load, load),
            (None, None, Some(pressure)) => self.values(quantity, Axis::Pressure, pressure),
            _ => Err(PyTypeError::new_err(
                "exactly one of separation, load and pressure was required",
            )),
        }
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

    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let Self { model, scene, rtol, separation_unit, .. } = slf.get();
        let arguments = (model, scene, slf.get().names(), rtol, separation_unit);
        Ok((slf.get_type().into_any(), arguments.into_pyobject(slf.py())?))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        Ok(format!(
            "<asperity.Contact of {}: {}; rtol={:e}; separations in {}; {}>",
            self.model(),
            self.names().join(", "),
            self.rtol,
            self.separation_unit,
            self.scene.bind(py).repr()?
        ))
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
        numbers: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let one = |contact: &dyn asperity::Contact, at| Ok([contact.evaluate_at(quantity, at)?]);
        Ok(self.over([quantity], axis, numbers, one)?.remove(0))
    }

    /// Quantities at a number, by `one`, or at every number of an array: floats for a float, arrays
    /// of its shape for an array.
    fn over<'py, const N: usize>(
        &self,
        quantities: [Quantity; N],
        axis: Axis,
        numbers: &Bound<'py, PyAny>,
        one: impl Fn(&dyn asperity::Contact, At) -> Result<[Evaluation; N], ContactError> + Sync,
    ) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let (py, file) = (numbers.py(), &self.file);
        if let Some(&quantity) = quantities.iter().find(|q| !self.request.quantities.contains(q)) {
            return Err(value_error(ContactError::NotRequested { quantity }));
        }
        let read = texts_in_si(numbers, axis.si())?;
        let (numbers, axis) = match &read {
            Some(read) => (read, axis.in_si()),
            None => (numbers, axis),
        };
        if let Some(number) = scalar(numbers) {
            let mistaken =
                axis.mistaken_unit("separation", number, file.scene.surface.asperity_height_std);
            mistaken.map_or(Ok(()), |text| warn(py, &text, 0))?;
            let contact = self.current();
            let found = py.detach(|| one(&*contact, axis.at(number, file.separation_from)));
            let found = found.map_err(|error| self.raise(py, error))?;
            let float = |evaluation: Evaluation| PyFloat::new(py, evaluation.value()).into_any();
            return Ok(found.map(float).into());
        }
        let numbers = floats(numbers, "separation")?.readonly();
        let rows = View::of_one(file, axis, numbers.as_slice()?);
        rows.mistaken_unit().map_or(Ok(()), |text| warn(py, &text, 0))?;
        let request = Request::new(quantities).within(self.request.tolerance);
        let contact = self.current();
        let source = Source::Contact(contact.clone());
        let question = Question { rows: &rows, source, request, aspect: Aspect::Value };
        let mut filled = Vec::with_capacity(N);
        for quantity in quantities {
            let column = PyArrayDyn::zeros(py, numbers.shape(), false);
            if !question.fill(py, &*contact, quantity, column.readwrite().as_slice_mut()?)? {
                break;
            }
            filled.push(column.into_any());
        }
        if filled.len() == N {
            return Ok(filled);
        }
        let answer = question.answer(py, None, true, |error| self.raise(py, error))?;
        if let Some((_, error)) = answer.failures.into_iter().next() {
            return Err(error);
        }
        let shaped =
            |column| Ok(PyArray1::from_vec(py, column).reshape(numbers.shape())?.into_any());
        answer.columns.into_iter().map(shaped).collect()
    }
}

fn compile(
    py: Python<'_>,
    engine: &Engine,
    file: &asperity_inputs::SceneFile,
    request: &Request,
) -> PyResult<Arc<dyn asperity::Contact>> {
    let model = engine.on(file)?;
    let compiled = py.detach(|| model.compile(&file.scene, request));
    compiled.map(Arc::from).map_err(|error| engine.raise(py, error))
}
