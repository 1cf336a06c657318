//! `Contact`: one model on one scene, prepared for many evaluations.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use asperity::{Compiled, ContactError, Quantity, Request, Warning};
use asperity_scene::SceneFile;
use numpy::{AllowTypeChange, PyArray1, PyArrayLikeDyn, PyArrayMethods, PyReadonlyArray1};
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyFloat, PyInt, PyTuple};

use crate::arrays::{self, Grain};
use crate::engine::{Aspect, Engine, Kind, asperity_separation, quantities, request, tolerance};
use crate::error::value_error;
use crate::scene::Scene;

/// Name, regime and shares of one part of a law.
type ShareColumn<'py> = (String, String, Bound<'py, PyArray1<f64>>);
/// Law, quantities, method, nodes and samples of one step of a plan.
type StepRow = (String, Vec<String>, String, Option<(usize, usize)>, usize);

/// One model on one scene, prepared for many evaluations: for codes that step in time.
///
/// Made by ``Model.compile``. A gap is a separation in metres, from the scene's plane; a float
/// gives floats, an array gives arrays of its shape. All threads may use one contact at once.
#[pyclass(frozen, module = "asperity")]
pub(crate) struct Contact {
    kind: Arc<Kind>,
    file: Arc<SceneFile>,
    request: Request,
    names: Vec<String>,
    compiled: Mutex<Arc<Compiled>>,
    /// The same, with bounds that hold for separations that were rounded.
    rounding: OnceLock<Arc<Compiled>>,
}

impl Contact {
    pub(crate) fn new(
        py: Python<'_>,
        kind: Arc<Kind>,
        file: Arc<SceneFile>,
        names: Vec<String>,
        rtol: f64,
    ) -> PyResult<Self> {
        let request = request(&quantities(&names)?, tolerance(rtol)?);
        let compiled = Mutex::new(compiled(py, &kind, &file, &request)?);
        Ok(Self { kind, file, request, names, compiled, rounding: OnceLock::new() })
    }

    /// What is to be used now.
    fn now(&self) -> Arc<Compiled> {
        self.compiled.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// What is to be used for bounds.
    fn for_bounds(&self, py: Python<'_>, in_metres: bool) -> PyResult<Arc<Compiled>> {
        if !in_metres && self.file.separation_offset == 0.0 {
            return Ok(self.now());
        }
        if let Some(ready) = self.rounding.get() {
            return Ok(ready.clone());
        }
        let request = Request { separation_rounding: f64::EPSILON, ..self.request.clone() };
        let made = compiled(py, &self.kind, &self.file, &request)?;
        Ok(self.rounding.get_or_init(|| made).clone())
    }

    /// The exception of a refusal. What a user's law raised may not be raised next time, as an
    /// interrupt is not: the rules are built anew then.
    fn raise(&self, py: Python<'_>, refusal: &ContactError) -> PyErr {
        if let Kind::Python { .. } = &*self.kind
            && let Ok(anew) = compiled(py, &self.kind, &self.file, &self.request)
        {
            *self.compiled.lock().unwrap_or_else(PoisonError::into_inner) = anew;
        }
        self.kind.raise(py, "", refusal)
    }

    /// `one` of a gap, or of every gap of an array.
    fn over<'py, T: Clone + Default + Send>(
        &self,
        py: Python<'py>,
        gap: &Bound<'py, PyAny>,
        one: impl Fn(&Compiled, f64) -> Result<T, ContactError> + Sync,
        scalar: impl Fn(T) -> PyResult<Bound<'py, PyAny>>,
        array: impl Fn(Vec<T>, &[usize]) -> PyResult<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let compiled = self.now();
        let at = |gap: f64| one(&compiled, asperity_separation(&self.file, gap, true));
        if gap.is_instance_of::<PyFloat>() || gap.is_instance_of::<PyInt>() {
            let gap: f64 = gap.extract()?;
            return scalar(py.detach(|| at(gap)).map_err(|e| self.raise(py, &e))?);
        }
        let gaps = real_numbers(gap)?;
        let gaps = gaps.as_array();
        let flat: Vec<f64> = gaps.iter().copied().collect();
        let raise = |_, error: ContactError| self.raise(py, &error);
        let found = arrays::collect(py, flat.len(), Grain::Values, |k| at(flat[k]), raise)?;
        array(found, gaps.shape())
    }
}

/// Numbers in any shape; texts, which NumPy would read as numbers, are none.
fn real_numbers<'py>(
    numbers: &Bound<'py, PyAny>,
) -> PyResult<PyArrayLikeDyn<'py, f64, AllowTypeChange>> {
    let array = numbers.py().import("numpy")?.call_method1("asarray", (numbers,))?;
    let kind: String = array.getattr("dtype")?.getattr("kind")?.extract()?;
    if !matches!(kind.as_str(), "f" | "i" | "u" | "b") {
        let kind = array.getattr("dtype")?.str()?;
        return Err(PyTypeError::new_err(format!(
            "numbers of type {kind} were given: real ones were required"
        )));
    }
    array.extract()
}

fn compiled(
    py: Python<'_>,
    kind: &Kind,
    file: &SceneFile,
    request: &Request,
) -> PyResult<Arc<Compiled>> {
    let model = kind.on(file)?;
    let compiled = py.detach(|| model.compile(&file.scene, request));
    compiled.map(Arc::new).map_err(|error| kind.raise(py, "", &error))
}

fn shaped<'py>(py: Python<'py>, values: Vec<f64>, shape: &[usize]) -> PyResult<Bound<'py, PyAny>> {
    Ok(PyArray1::from_vec(py, values).reshape(shape.to_vec())?.into_any())
}

#[pymethods]
impl Contact {
    /// Force [N] at a gap [m].
    fn force<'py>(&self, gap: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.evaluate("force", gap)
    }

    /// Force [N] and tangent -dF/d(gap) [N/m] at a gap [m], in one pass.
    fn force_and_tangent<'py>(&self, gap: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let py = gap.py();
        let one = |compiled: &Compiled, s: f64| {
            compiled.force_and_tangent(s).map(|(f, k)| (f.value(), k.value()))
        };
        let array = |found: Vec<(f64, f64)>, shape: &[usize]| {
            let (force, tangent) = found.into_iter().unzip();
            let both = [shaped(py, force, shape)?, shaped(py, tangent, shape)?];
            Ok(PyTuple::new(py, both)?.into_any())
        };
        self.over(py, gap, one, |both| both.into_bound_py_any(py), array)
    }

    /// One of the compiled quantities at a gap [m], in SI units.
    fn evaluate<'py>(
        &self,
        quantity: &str,
        gap: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let py = gap.py();
        let quantity: Quantity = quantity.parse().map_err(value_error)?;
        let one = |compiled: &Compiled, s: f64| compiled.evaluate(quantity, s).map(|e| e.value());
        let array = |found: Vec<f64>, shape: &[usize]| shaped(py, found, shape);
        self.over(py, gap, one, |value| value.into_bound_py_any(py), array)
    }

    /// One aspect of a quantity at separations: value (with a warning, where one is due), ln_value
    /// or error.
    #[pyo3(name = "_column")]
    fn column<'py>(
        &self,
        py: Python<'py>,
        quantity: &str,
        separations: PyReadonlyArray1<'py, f64>,
        in_metres: bool,
        aspect: &str,
    ) -> PyResult<(Bound<'py, PyArray1<f64>>, Option<String>)> {
        let quantity: Quantity = quantity.parse().map_err(value_error)?;
        let aspect = Aspect::named(aspect)?;
        let separations = separations.as_slice()?.to_vec();
        let compiled =
            if aspect == Aspect::Error { self.for_bounds(py, in_metres)? } else { self.now() };
        let of = aspect.of();
        let one = |k: usize| {
            let s = asperity_separation(&self.file, separations[k], in_metres);
            compiled.evaluate(quantity, s).map(|evaluation| of(&evaluation))
        };
        let found =
            arrays::collect(py, separations.len(), Grain::Values, one, |_, e| self.raise(py, &e))?;
        let first = found.iter().position(|value| *value < 0.0);
        let warning = first.filter(|_| aspect == Aspect::Value).map(|first| {
            let negative = Warning::Negative {
                model: compiled.model().into(),
                quantity,
                count: found.iter().filter(|value| **value < 0.0).count(),
                separation: asperity_separation(&self.file, separations[first], in_metres),
                value: found[first],
            };
            negative.to_string()
        });
        Ok((PyArray1::from_vec(py, found), warning))
    }

    /// Name, regime and share of every part of the law at separations.
    #[pyo3(name = "_shares")]
    fn shares<'py>(
        &self,
        py: Python<'py>,
        quantity: &str,
        separations: PyReadonlyArray1<'py, f64>,
        in_metres: bool,
    ) -> PyResult<Vec<ShareColumn<'py>>> {
        let quantity: Quantity = quantity.parse().map_err(value_error)?;
        let compiled = self.now();
        let law = compiled.law(quantity).map_err(|e| self.raise(py, &e))?;
        let name = |part: &asperity::Part| (part.name.to_string(), part.regime.to_string());
        let names: Vec<_> = law.parts.iter().map(name).collect();
        let separations = separations.as_slice()?.to_vec();
        let mut columns = vec![Vec::with_capacity(separations.len()); names.len()];
        arrays::in_ranges(py, separations.len(), Grain::Values, |range| {
            for s in &separations[range] {
                let s = asperity_separation(&self.file, *s, in_metres);
                let shares = py.detach(|| compiled.shares(quantity, s));
                let shares = shares.map_err(|error| self.raise(py, &error))?;
                columns
                    .iter_mut()
                    .zip(&shares)
                    .for_each(|(column, share)| column.push(share.share));
            }
            Ok(())
        })?;
        let columns = names.into_iter().zip(columns);
        Ok(columns.map(|((n, r), c)| (n, r, PyArray1::from_vec(py, c))).collect())
    }

    /// What is done for these separations: a text, and (law, quantities, method, nodes, samples).
    #[pyo3(name = "_plan")]
    fn plan(
        &self,
        py: Python<'_>,
        separations: PyReadonlyArray1<'_, f64>,
        in_metres: bool,
    ) -> PyResult<(String, Vec<StepRow>)> {
        let user = separations.as_slice()?.iter();
        let separations: Vec<f64> =
            user.map(|s| asperity_separation(&self.file, *s, in_metres)).collect();
        let request = self.request.clone().at(separations);
        let compiled = self.now();
        let plan = py.detach(|| compiled.plan(&request)).map_err(|e| self.raise(py, &e))?;
        let step = |step: &asperity::Step| {
            let quantities = step.quantities.iter().map(ToString::to_string).collect();
            let (law, method) = (step.law.to_string(), step.method.to_string());
            (law, quantities, method, step.nodes, step.samples)
        };
        Ok((plan.to_string(), plan.steps.iter().map(step).collect()))
    }

    /// What the model's options deserve to be warned of.
    #[pyo3(name = "_warnings")]
    fn warnings(&self) -> Vec<String> {
        self.now().warnings().iter().map(ToString::to_string).collect()
    }

    /// The model's name.
    #[getter]
    fn model(&self) -> String {
        self.now().model().into()
    }

    /// The scene.
    #[getter]
    fn scene(&self) -> Scene {
        Scene(self.file.clone())
    }

    /// The quantities it was compiled for.
    #[getter]
    fn quantities<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, &self.names)
    }

    /// The relative tolerance.
    #[getter]
    fn rtol(&self) -> f64 {
        self.request.tolerance.relative()
    }

    fn __reduce__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let engine = Bound::new(py, Engine(self.kind.clone()))?;
        let arguments = (self.scene(), &self.names, self.rtol()).into_pyobject(py)?;
        Ok((engine.getattr("compile")?, arguments))
    }

    fn __repr__(&self) -> String {
        format!(
            "<asperity.Contact of {}: {}; rtol={:e}; {}>",
            self.model(),
            self.names.join(", "),
            self.rtol(),
            self.scene().__repr__()
        )
    }
}
