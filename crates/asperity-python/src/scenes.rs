//! `Scenes`: many scenes as columns of numbers.

use std::sync::Arc;

use asperity::ContactError;
use asperity_scene::{SceneFile, SeparationFrom};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArrayDyn};
use pyo3::exceptions::{PyIndexError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyTuple};

use crate::error::{refused_at, value_error};
use crate::scene::Scene;

/// Puts a number where it belongs.
type Setter = fn(&mut asperity::Scene, f64);

/// The numbers of a scene, by the names of its scene file.
const INPUTS: [(&str, Setter); 10] = [
    ("equivalent_modulus", |s, v| s.interface.equivalent_modulus = v),
    ("equivalent_shear_modulus", |s, v| s.interface.equivalent_shear_modulus = Some(v)),
    ("poissons_ratio", |s, v| s.interface.poissons_ratio = v),
    ("hardness", |s, v| s.interface.hardness = Some(v)),
    ("yield_strength", |s, v| s.interface.yield_strength = Some(v)),
    ("pressure_factor", |s, v| s.interface.pressure_factor = Some(v)),
    ("asperity_radius", |s, v| s.surface.asperity_radius = v),
    ("asperity_density", |s, v| s.surface.asperity_density = v),
    ("asperity_height_std", |s, v| s.surface.asperity_height_std = v),
    ("nominal_area", |s, v| s.nominal_area = v),
];

/// The setter of a name.
pub(crate) fn input(name: &str) -> Result<Setter, String> {
    let found = INPUTS.iter().find(|(known, _)| *known == name);
    found.map(|(_, setter)| *setter).ok_or_else(|| {
        let known: Vec<&str> = INPUTS.iter().map(|(name, _)| *name).collect();
        format!("{name} is not an input of a scene: one of {} was required", known.join(", "))
    })
}

/// Many scenes that differ from one in some of its numbers; made by ``Scene.vary``.
///
/// Wherever a scene is taken, so are many; they are broadcast against separations and loads.
///
/// Examples
/// --------
/// >>> import asperity
/// >>> interface = asperity.Interface(116e9, 0.31, hardness=1.12e9)
/// >>> scene = asperity.Scene(interface, asperity.Surface(3.6e-4, 1.1e8, 1e-6), nominal_area=3e-5)
/// >>> scenes = scene.vary(asperity_height_std=[1e-6, 2e-6, 3e-6])
/// >>> scenes
/// <asperity.Scenes of shape (3,), asperity_height_std varies>
/// >>> asperity.model("gw").solve(scenes, separation=1.0).force.shape
/// (3,)
#[pyclass(frozen, module = "asperity")]
#[derive(Clone)]
pub(crate) struct Scenes {
    base: Arc<SceneFile>,
    columns: Vec<Column>,
    shape: Vec<usize>,
}

#[derive(Clone)]
struct Column {
    name: String,
    setter: Setter,
    values: Arc<[f64]>,
}

impl Scenes {
    /// Columns of any shapes that fit each other.
    pub(crate) fn broadcast(
        base: &Bound<'_, Scene>,
        columns: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let py = base.py();
        let given: Vec<(String, Bound<'_, PyAny>)> = columns
            .iter()
            .flat_map(|columns| columns.iter())
            .map(|(name, value)| Ok((name.extract()?, value)))
            .collect::<PyResult<_>>()?;
        let arrays = PyTuple::new(py, given.iter().map(|(_, value)| value))?;
        let arrays = py.import("numpy")?.call_method1("broadcast_arrays", arrays)?;
        let mut scenes = Self { base: base.get().0.clone(), columns: vec![], shape: vec![] };
        for ((name, _), array) in given.into_iter().zip(arrays.try_iter()?) {
            let array = array?.call_method1("astype", ("float64",))?;
            let array: PyReadonlyArrayDyn<'_, f64> = array.extract()?;
            scenes.shape = array.as_array().shape().to_vec();
            let setter = input(&name).map_err(value_error)?;
            let values = array.as_array().iter().copied().collect();
            scenes.columns.push(Column { name, setter, values });
        }
        Ok(scenes)
    }

    /// How many there are.
    pub(crate) fn size(&self) -> usize {
        self.shape.iter().product()
    }

    /// One of them, by its place in the order of memory.
    pub(crate) fn scene(&self, index: usize) -> Result<SceneFile, ContactError> {
        let mut scene = self.base.scene.clone();
        for column in &self.columns {
            (column.setter)(&mut scene, column.values[index]);
        }
        self.base.with_numbers(scene.interface, scene.surface, scene.nominal_area)
    }

    /// The scene that they are like.
    pub(crate) fn base(&self) -> &Arc<SceneFile> {
        &self.base
    }
}

#[pymethods]
impl Scenes {
    /// Shape of the columns, broadcast.
    #[getter]
    fn shape<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, &self.shape)
    }

    /// How many there are along the first axis.
    fn __len__(&self) -> PyResult<usize> {
        self.shape.first().copied().ok_or_else(|| PyTypeError::new_err("len() of one scene"))
    }

    /// The same scenes in another shape; -1 stands for what is left.
    #[pyo3(signature = (*shape))]
    fn reshape(&self, py: Python<'_>, shape: &Bound<'_, PyTuple>) -> PyResult<Self> {
        let places = py.import("numpy")?.call_method1("empty", (self.size(), "bool"))?;
        let shape = places.call_method1("reshape", shape)?.getattr("shape")?.extract()?;
        Ok(Self { shape, ..self.clone() })
    }

    /// One scene; one index for each axis.
    fn __getitem__(&self, py: Python<'_>, index: &Bound<'_, PyAny>) -> PyResult<Scene> {
        let numpy = py.import("numpy")?;
        let places = numpy.call_method1("arange", (self.size(),))?;
        let places = places.call_method1("reshape", (PyTuple::new(py, &self.shape)?,))?;
        let place = places.get_item(index)?;
        let place: usize = place.extract().map_err(|_| {
            PyIndexError::new_err(
                "one index for each axis was required: scenes are taken one by one",
            )
        })?;
        let file = self.scene(place).map_err(|e| refused_at(&format!("scene {place}: "), &e))?;
        Ok(Scene(Arc::new(file)))
    }

    fn __repr__(&self) -> String {
        let shape: Vec<String> = self.shape.iter().map(ToString::to_string).collect();
        let comma = if shape.len() == 1 { "," } else { "" };
        let names: Vec<&str> = self.columns.iter().map(|c| c.name.as_str()).collect();
        let varies = match names.as_slice() {
            [] => "nothing varies".into(),
            [one] => format!("{one} varies"),
            many => format!("{} vary", many.join(", ")),
        };
        format!("<asperity.Scenes of shape ({}{comma}), {varies}>", shape.join(", "))
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let (py, scenes) = (slf.py(), slf.get());
        let columns = PyDict::new(py);
        for column in &scenes.columns {
            let values = PyArray1::from_slice(py, &column.values);
            columns.set_item(&column.name, values.reshape(scenes.shape.clone())?)?;
        }
        let base = Bound::new(py, Scene(scenes.base.clone()))?;
        let arguments = PyTuple::new(py, [base.into_any(), columns.into_any()])?;
        Ok((slf.get_type().getattr("_rebuilt")?, arguments.into_any()))
    }

    #[staticmethod]
    fn _rebuilt(base: &Bound<'_, Scene>, columns: &Bound<'_, PyDict>) -> PyResult<Self> {
        Self::broadcast(base, Some(columns))
    }
}

/// Where scenes come from: one by one, or columns.
pub(crate) enum ManyScenes {
    List(Vec<Arc<SceneFile>>),
    Columns(Scenes),
}

impl ManyScenes {
    pub(crate) fn of(scenes: &Bound<'_, PyAny>) -> PyResult<Self> {
        if let Ok(columns) = scenes.cast::<Scenes>() {
            return Ok(Self::Columns(columns.get().clone()));
        }
        let list = scenes.cast::<PyList>()?;
        let one = |scene: Bound<'_, PyAny>| Ok(scene.cast::<Scene>()?.get().0.clone());
        list.iter().map(one).collect::<PyResult<_>>().map(Self::List)
    }

    pub(crate) fn size(&self) -> usize {
        match self {
            Self::List(list) => list.len(),
            Self::Columns(columns) => columns.size(),
        }
    }

    /// One of them; what is not in memory is made.
    pub(crate) fn with<T>(
        &self,
        index: usize,
        use_it: impl FnOnce(&SceneFile) -> T,
    ) -> Result<T, ContactError> {
        Ok(match self {
            Self::List(list) => use_it(&list[index]),
            Self::Columns(columns) => use_it(&columns.scene(index)?),
        })
    }

    /// Whether a separation is rounded on its way to the library.
    pub(crate) fn round_separations(&self, in_metres: bool) -> bool {
        let moved = |file: &Arc<SceneFile>| file.separation_from != SeparationFrom::AsperityMean;
        in_metres || self.given().iter().any(moved)
    }

    /// Those that were given: each, or the one that all are like.
    pub(crate) fn given(&self) -> &[Arc<SceneFile>] {
        match self {
            Self::List(list) => list,
            Self::Columns(columns) => std::slice::from_ref(columns.base()),
        }
    }
}
