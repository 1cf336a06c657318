//! `Engine`: one model, by its id and options or written in Python.

use std::collections::BTreeMap;
use std::sync::Arc;

use asperity::{
    Case, ContactError, Evaluation, Model, Quantity, Request, Sweep, Tolerance, testkit,
};
use asperity_scene::{ModelOptions, OptionValue, SceneFile};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use rayon::prelude::*;

use crate::arrays::{self, Grain};
use crate::contact::Contact;
use crate::error::{refused_at, value_error};
use crate::options::{option_objects, option_values, with_options};
use crate::pool::on_all_cores;
use crate::python_model::{PythonModel, Raised, is_class};
use crate::scene::Scene;
use crate::scenes::ManyScenes;

/// One model.
#[pyclass(frozen, module = "asperity._asperity")]
pub(crate) struct Engine(pub(crate) Arc<Kind>);

/// By id, or written in Python.
pub(crate) enum Kind {
    Named { id: String, given: BTreeMap<String, OptionValue> },
    Python { model: Model, class: Py<PyAny>, raised: Raised },
}

/// One array for each quantity.
type Columns<'py> = Vec<Bound<'py, PyArray1<f64>>>;

/// What is asked of every value.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Aspect {
    Value,
    LnValue,
    Error,
}

impl Aspect {
    pub(crate) fn named(name: &str) -> PyResult<Self> {
        match name {
            "value" => Ok(Self::Value),
            "ln_value" => Ok(Self::LnValue),
            "error" => Ok(Self::Error),
            _ => Err(value_error(format!("{name:?} is no aspect of a value"))),
        }
    }

    pub(crate) fn of(self) -> fn(&Evaluation) -> f64 {
        match self {
            Self::Value => Evaluation::value,
            Self::LnValue => Evaluation::ln_value,
            Self::Error => Evaluation::relative_error,
        }
    }
}

/// Quantities by their names.
pub(crate) fn quantities(names: &[String]) -> PyResult<Vec<Quantity>> {
    names.iter().map(|name| name.parse().map_err(value_error)).collect()
}

pub(crate) fn tolerance(rtol: f64) -> PyResult<Tolerance> {
    Tolerance::new(rtol).map_err(|e| crate::error::refused(&e))
}

impl Kind {
    /// The model that this is on a scene: the scene's options count where none were given.
    pub(crate) fn on(&self, scene: &SceneFile) -> PyResult<Model> {
        match self {
            Self::Named { id, given } => with_options(scene, given)?.model(id).map_err(value_error),
            Self::Python { model, .. } => Ok(model.clone()),
        }
    }

    /// The exception of a user's own code, or the library's refusal.
    pub(crate) fn raise(&self, py: Python<'_>, place: &str, refusal: &ContactError) -> PyErr {
        match self {
            Self::Python { raised, .. } => {
                raised.exception(py, refusal).unwrap_or_else(|| refused_at(place, refusal))
            }
            Self::Named { .. } => refused_at(place, refusal),
        }
    }

    /// The model with no scene in sight.
    fn plain(&self) -> PyResult<Model> {
        match self {
            Self::Named { id, given } => {
                let mut options = ModelOptions::default();
                given.iter().try_for_each(|(k, v)| options.set(k, v)).map_err(value_error)?;
                options.model(id).map_err(value_error)
            }
            Self::Python { model, .. } => Ok(model.clone()),
        }
    }
}

#[pymethods]
impl Engine {
    /// A model of this project by its id, with options that go before those of a scene.
    #[staticmethod]
    fn named(id: &str, options: &Bound<'_, PyDict>) -> PyResult<Self> {
        let kind = Kind::Named { id: id.into(), given: option_values(options)? };
        // A mistyped id or option is refused here, not when a scene comes.
        kind.plain()?;
        Ok(Self(Arc::new(kind)))
    }

    /// A model written in Python: a class, called with an asperity.
    #[staticmethod]
    #[pyo3(signature = (class, /))]
    fn of_class(class: &Bound<'_, PyAny>) -> PyResult<Self> {
        if !is_class(class) || !class.hasattr("force")? {
            return Err(value_error(format!(
                "{} is no model: an id, or a class with force(w) and area(w), was required",
                class.repr()?
            )));
        }
        let raised = Raised::default();
        let model = Model::new(PythonModel::new(class, raised.clone())?);
        let class = class.clone().unbind();
        Ok(Self(Arc::new(Kind::Python { model, class, raised })))
    }

    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let py = slf.py();
        match &*slf.get().0 {
            Kind::Named { id, given } => {
                let options = option_objects(py, given)?;
                Ok((slf.getattr("named")?, (id, options).into_pyobject(py)?))
            }
            Kind::Python { class, .. } => {
                Ok((slf.getattr("of_class")?, PyTuple::new(py, [class])?))
            }
        }
    }

    /// Id, name, authors, year, title and provenance.
    fn source(&self) -> PyResult<(String, String, &'static str, u16, &'static str, String)> {
        let model = self.0.plain()?;
        let source = model.source();
        let (authors, title) = (source.authors, source.title);
        let provenance = source.provenance.to_string();
        Ok((model.id().into(), model.name().into(), authors, source.year, title, provenance))
    }

    /// A scene prepared for many evaluations.
    fn compile(
        &self,
        py: Python<'_>,
        scene: &Scene,
        names: Vec<String>,
        rtol: f64,
    ) -> PyResult<Contact> {
        Contact::new(py, self.0.clone(), scene.0.clone(), names, rtol)
    }

    /// One column for each quantity, on scene `index[k]` at `separations[k]`; with the warnings.
    #[expect(clippy::too_many_arguments, reason = "called from one place, by the package itself")]
    fn sweep<'py>(
        &self,
        py: Python<'py>,
        scenes: &Bound<'py, PyAny>,
        index: PyReadonlyArray1<'py, i64>,
        separations: PyReadonlyArray1<'py, f64>,
        in_metres: bool,
        names: Vec<String>,
        rtol: f64,
        aspect: &str,
    ) -> PyResult<(Columns<'py>, Vec<String>)> {
        let scenes = ManyScenes::of(scenes)?;
        let (index, separations) = (index.as_slice()?.to_vec(), separations.as_slice()?.to_vec());
        let (quantities, tolerance) = (quantities(&names)?, tolerance(rtol)?);
        let aspect = Aspect::named(aspect)?;
        let Some(model) = self.model_of_all(&scenes)? else {
            let nothing = names.iter().map(|_| PyArray1::from_vec(py, vec![])).collect();
            return Ok((nothing, vec![]));
        };
        let rounded = aspect == Aspect::Error && scenes.round_separations(in_metres);
        let rounding = if rounded { f64::EPSILON } else { 0.0 };
        let sweep = Sweep::new(&*model, &quantities, tolerance).with_separation_rounding(rounding);
        let aspect = aspect.of();
        let mut columns = vec![Vec::with_capacity(index.len()); quantities.len()];
        let case = |k: usize| {
            scenes.with(index[k] as usize, |file| Case {
                separation: asperity_separation(file, separations[k], in_metres),
                scene: file.scene.clone(),
            })
        };
        let failed = |py, k: usize, error: &ContactError| {
            self.0.raise(py, &format!("scene {}: ", index[k]), error)
        };
        arrays::in_ranges(py, index.len(), Grain::Values, |range| {
            let first = range.start;
            let answers = py.detach(|| {
                on_all_cores(|| {
                    let cases = range.into_par_iter().with_min_len(256).map(case);
                    let cases: Result<Vec<Case>, ContactError> = cases.collect();
                    cases.map(|cases| sweep.evaluate_all(&cases))
                })
            });
            let Ok(answers) = answers else {
                // The first of those that cannot be made, whatever the threads did.
                let refused = (first..index.len()).find_map(|k| Some((k, case(k).err()?)));
                let (k, error) = refused.ok_or_else(|| value_error("a scene was refused"))?;
                return Err(failed(py, k, &error));
            };
            for (k, answer) in answers.into_iter().enumerate() {
                let answer = answer.map_err(|error| failed(py, first + k, &error))?;
                for (column, evaluation) in columns.iter_mut().zip(&answer) {
                    column.push(aspect(evaluation));
                }
            }
            Ok(())
        })?;
        let warnings = model.warnings().iter().map(ToString::to_string).collect();
        Ok((columns.into_iter().map(|c| PyArray1::from_vec(py, c)).collect(), warnings))
    }

    /// The law of one asperity of a scene at interferences [m], in SI units.
    fn law<'py>(
        &self,
        py: Python<'py>,
        scene: &Scene,
        quantity: &str,
        interferences: PyReadonlyArray1<'py, f64>,
        rtol: f64,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let quantity: Quantity = quantity.parse().map_err(value_error)?;
        let (model, tolerance) = (self.0.on(&scene.0)?, tolerance(rtol)?);
        let interferences = interferences.as_slice()?.to_vec();
        let raise = |error: &ContactError| self.0.raise(py, "", error);
        let law = py.detach(|| model.law(&scene.0.scene.asperity()?, quantity, tolerance));
        let law = law.map_err(|error| raise(&error))?;
        let value = |k: usize| law.value(interferences[k]);
        let values =
            arrays::collect(py, interferences.len(), Grain::Values, value, |_, source| {
                raise(&ContactError::Integral { quantity, separation: 0.0, source })
            })?;
        Ok(PyArray1::from_vec(py, values))
    }

    /// What is wrong with the laws on one asperity of a scene; nothing, for good laws.
    fn check(&self, py: Python<'_>, scene: &Scene) -> PyResult<Vec<String>> {
        let model = self.0.on(&scene.0)?;
        let found = py.detach(|| testkit::check(&*model, &scene.0.scene.asperity()?));
        let found = found.map_err(|error| self.0.raise(py, "", &error))?;
        Ok(found.iter().map(ToString::to_string).collect())
    }
}

impl Engine {
    /// The one model that this is on all scenes; none where there are no scenes.
    pub(crate) fn model_of_all(&self, scenes: &ManyScenes) -> PyResult<Option<Model>> {
        let files = scenes.given();
        let Some(first) = files.first().filter(|_| scenes.size() > 0) else { return Ok(None) };
        if let Kind::Named { given, .. } = &*self.0 {
            let options = with_options(first, given)?;
            for (k, file) in files.iter().enumerate() {
                if with_options(file, given)? != options {
                    return Err(value_error(format!(
                        "scene {k} has other options than scene 0: one model for all was required, give the options to asperity.model"
                    )));
                }
            }
        }
        self.0.on(first).map(Some)
    }
}

/// A user's separation as the library takes it.
pub(crate) fn asperity_separation(file: &SceneFile, separation: f64, in_metres: bool) -> f64 {
    file.to_asperity_mean(if in_metres { file.over_height_std(separation) } else { separation })
}

/// What is asked of a scene, without separations.
pub(crate) fn request(quantities: &[Quantity], tolerance: Tolerance) -> Request {
    Request::new(quantities.iter().copied()).within(tolerance)
}

/// The ids of all models, simplest first.
#[pyfunction]
pub(crate) fn model_ids() -> Vec<String> {
    Model::all().iter().map(|model| model.id().to_string()).collect()
}
