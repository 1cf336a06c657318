//! `Engine`: a model by id and options, or written in Python.

use std::collections::BTreeMap;
use std::sync::Arc;

use asperity::bem::Bem;
use asperity::{Citation, ContactError, Model, Quantity, testkit};
use asperity_answer::{AnswerError, Sheet};
use asperity_scene::{ModelOptions, SceneFile};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

use crate::convert::{Object, Quantities, refused, tolerance, value_error};
use crate::model::python_model::{PythonModel, Raised};
use crate::scene::{self, arguments::KeyValue};

/// A model: the base of the package's `Model`.
#[pyclass(frozen, subclass, module = "asperity._asperity")]
pub(crate) struct Engine(Kind);

/// The origin of a model.
enum Kind {
    Named { id: String, given: BTreeMap<String, asperity_scene::OptionValue> },
    Python { model: Model, raised: Raised },
}

#[pymethods]
impl Engine {
    /// A model by its id, with options that replace the scene's; or a model written in Python,
    /// as the package's `_model.Laws` of a class.
    #[new]
    fn new(model: &Object<'_>, options: BTreeMap<String, KeyValue>) -> PyResult<Self> {
        let Ok(id) = model.extract() else {
            let raised = Raised::default();
            let model = Model::new(PythonModel::new(model, raised.clone())?);
            return Ok(Self(Kind::Python { model, raised }));
        };
        let given = options.into_iter().map(|(name, value)| (name, value.into())).collect();
        let engine = Self(Kind::Named { id, given });
        // Refuses a mistyped id or option, and an option of other models.
        engine.alone()?;
        engine.options(ModelOptions::default())?;
        if let Kind::Named { id, given } = &engine.0 {
            let mut names = given.keys();
            names.try_for_each(|name| ModelOptions::check_for(id, name)).map_err(value_error)?;
        }
        Ok(engine)
    }

    /// Short name in lower case: ``ke``.
    #[getter]
    fn id(&self) -> PyResult<String> {
        Ok(self.alone()?.map_or(Bem::ID.into(), |model| model.id().into()))
    }

    /// The acronym: ``KE``.
    #[getter]
    fn name(&self) -> PyResult<String> {
        Ok(self.alone()?.map_or(Bem::SOURCE.name.into(), |model| model.name().into()))
    }

    /// The entry of the paper for a BibTeX file; empty for a model written in Python.
    ///
    /// >>> import asperity
    /// >>> print(asperity.model("ceb").bibtex())
    /// @article{chang1987,
    ///   author = {Chang, W. R. and Etsion, I. and Bogy, D. B.},
    ///   title = {{An elastic-plastic model for the contact of rough surfaces}},
    ///   year = {1987},
    ///   journal = {Journal of Tribology},
    ///   volume = {109},
    ///   number = {2},
    ///   pages = {257--263},
    /// }
    /// <BLANKLINE>
    fn bibtex(&self) -> PyResult<String> {
        match self.0 {
            Kind::Python { .. } => Ok(String::new()),
            Kind::Named { .. } => Ok(self.citation()?.bibtex()),
        }
    }

    /// Authors, year, title and provenance of the paper.
    #[getter(_citation)]
    fn cited(&self) -> PyResult<(&'static str, u16, &'static str, String)> {
        let Citation { authors, year, title, provenance, .. } = self.citation()?;
        Ok((authors, year, title, provenance.to_string()))
    }

    /// The law of one asperity of a scene at interferences [m], in SI units.
    #[pyo3(name = "_law")]
    fn law<'py>(
        &self,
        py: Python<'py>,
        scene: &scene::SceneFile,
        quantity: &str,
        interferences: PyReadonlyArray1<'py, f64>,
        rtol: f64,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let quantity: Quantity = quantity.parse().map_err(value_error)?;
        let (model, tolerance) = (self.on(&scene.0)?, tolerance(rtol)?);
        let interferences = interferences.as_slice()?;
        let values: Vec<f64> = self.run(py, || {
            let law = model.law(&scene.0.scene.asperity()?, quantity, tolerance)?;
            let refused = |source| ContactError::Integral { quantity, at: 0.0.into(), source };
            interferences.iter().map(|w| law.value(*w).map_err(refused)).collect()
        })?;
        Ok(PyArray1::from_vec(py, values))
    }

    /// Faults of the laws on one asperity of a scene; empty for correct laws.
    #[pyo3(name = "_check")]
    fn check(&self, py: Python<'_>, scene: &scene::SceneFile) -> PyResult<Vec<String>> {
        let model = self.on(&scene.0)?;
        let found = self.run(py, || testkit::check(&model, &scene.0.scene.asperity()?))?;
        Ok(found.iter().map(ToString::to_string).collect())
    }
}

impl Engine {
    /// The options of a scene, replaced by this model's.
    fn options(&self, mut options: ModelOptions) -> PyResult<ModelOptions> {
        if let Kind::Named { given, .. } = &self.0 {
            given.iter().try_for_each(|(k, v)| options.set(k, v)).map_err(value_error)?;
        }
        Ok(options)
    }

    /// Whether the model is boundary elements, which exist on a scan only.
    fn is_bem(&self) -> bool {
        matches!(&self.0, Kind::Named { id, .. } if id.trim().eq_ignore_ascii_case(Bem::ID))
    }

    /// The model without a scene; none for boundary elements.
    fn alone(&self) -> PyResult<Option<Model>> {
        match self.is_bem() {
            true => Ok(None),
            false => self.with(ModelOptions::default(), None).map(Some),
        }
    }

    fn citation(&self) -> PyResult<Citation> {
        Ok(self.alone()?.map_or(Bem::SOURCE, |model| *model.citation()))
    }

    /// The model with options, on the scan of a scene, if given.
    fn with(&self, options: ModelOptions, file: Option<&SceneFile>) -> PyResult<Model> {
        match (&self.0, file) {
            (Kind::Named { id, .. }, Some(file)) => {
                file.model_with(&self.options(options)?, id).map_err(value_error)
            }
            (Kind::Named { id, .. }, None) => self.options(options)?.model(id).map_err(value_error),
            (Kind::Python { model, .. }, Some(file)) => Ok(file.between(model.clone())),
            (Kind::Python { model, .. }, None) => Ok(model.clone()),
        }
    }

    /// The model on a scene; options of the model replace the scene's.
    pub(crate) fn on(&self, file: &SceneFile) -> PyResult<Model> {
        self.with(file.spec.options, Some(file))
    }

    /// The model on a scene of flat bodies.
    pub(crate) fn on_flat(&self, file: &SceneFile) -> PyResult<Model> {
        file.need_flat().map_err(value_error)?;
        self.on(file)
    }

    /// The model on all scenes, whose options must agree.
    pub(crate) fn on_all(&self, files: &[Arc<SceneFile>]) -> PyResult<Model> {
        if let [file] = files {
            return self.on(file);
        }
        if self.is_bem() {
            let (count, id) = (files.len(), Bem::ID);
            let text = format!("{count} scenes were given: {id} needs a single scene with a scan");
            return Err(value_error(text));
        }
        let first = files.first().map_or_else(ModelOptions::default, |file| file.spec.options);
        for (k, file) in files.iter().enumerate() {
            if file.spec.options != first {
                return Err(value_error(format!(
                    "scene {k} has other options than scene 0: give all the same, or the options to asperity.model"
                )));
            }
        }
        self.with(first, None)
    }

    /// Whether the model is written in Python: a refusal may then be an exception of the user's
    /// code.
    pub(crate) fn is_written(&self) -> bool {
        matches!(self.0, Kind::Python { .. })
    }

    /// Runs `work` without the interpreter; raises its refusal.
    pub(crate) fn run<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce() -> Result<T, ContactError> + Send,
    ) -> PyResult<T> {
        py.detach(work).map_err(|error| self.raise(py, error))
    }

    /// The exception of a refusal: from the user's own code, or the library's.
    pub(crate) fn raise(&self, py: Python<'_>, refusal: ContactError) -> PyErr {
        let own = self.raised().and_then(|raised| raised.exception(py, &refusal));
        own.unwrap_or_else(|| refused(refusal))
    }

    /// What the user's own code has raised.
    fn raised(&self) -> Option<&Raised> {
        match &self.0 {
            Kind::Python { raised, .. } => Some(raised),
            Kind::Named { .. } => None,
        }
    }
}

/// The error of an answer, with the reasons why its sheet has no values.
pub(crate) fn without(sheet: &Sheet, error: AnswerError) -> PyErr {
    let missing = sheet.findings.iter().filter(|one| one.code.name() == "no-value");
    let reasons = missing.map(ToString::to_string).collect::<Vec<_>>();
    value_error([error.to_string()].into_iter().chain(reasons).collect::<Vec<_>>().join(": "))
}

/// The ids of all models.
#[pyfunction]
pub(crate) fn model_ids() -> Vec<String> {
    let ids = Model::all().into_iter().map(|model| model.id().to_string());
    ids.chain([Bem::ID.into()]).collect()
}

/// The head of a table's column for an input of scenes.
#[pyfunction]
pub(crate) fn column_of(input: &str) -> String {
    asperity_scene::column_of(input)
}

/// Table columns by the names of quantities; without names, of all.
#[pyfunction]
#[pyo3(signature = (names=None))]
pub(crate) fn quantities(py: Python<'_>, names: Option<Quantities>) -> PyResult<Bound<'_, PyDict>> {
    let wanted = names.map_or(Quantity::ALL.to_vec(), |names| names.0);
    wanted.iter().map(|quantity| (quantity.to_string(), quantity.column())).into_py_dict(py)
}
