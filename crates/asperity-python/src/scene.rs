//! `Scene`: what is in contact, as a scene file says it.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use asperity::{HeightDistribution, TabulatedHeights};
use asperity_scene::{OptionValue, SceneFile, SeparationFrom};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::asperity::Asperity;
use crate::bodies::Interface;
use crate::error::{refused, value_error, warn};
use crate::options::{option_objects, option_values};
use crate::scenes::{Scenes, input};
use crate::surface::Surface;

/// Two bodies, their equivalent rough surface, and how much of it there is.
///
/// Parameters
/// ----------
/// interface : Interface
///     The two bodies.
/// surface : Surface
///     The equivalent rough surface.
/// nominal_area : float
///     The apparent area of contact [m^2], above 0.
/// heights : "gaussian", "exponential" or (heights, densities)
///     How the asperity heights are spread. A table has heights [m], ascending, and the density
///     there [1/m]: linear between its points, 0 outside; heights count from the table's own mean.
/// separation_from : "asperity-mean" or "surface-mean"
///     The plane that separations are measured from: the mean of the asperity heights (for
///     exponential heights: the lowest asperity), or the mean plane of the surface.
/// separation_offset : float, optional
///     With "surface-mean": how far the mean of the asperity heights lies above the mean plane
///     [m]; when not given, that of the table of heights, or of an isotropic Gaussian surface.
/// options : dict, optional
///     Options of the models, as in the section [options] of a scene file.
///
/// Examples
/// --------
/// >>> import asperity
/// >>> interface = asperity.Interface(116e9, 0.31, hardness=1.12e9)
/// >>> scene = asperity.Scene(interface, asperity.Surface(3.6e-4, 1.1e8, 1e-6), nominal_area=3e-5)
/// >>> round(scene.plasticity_index, 2)
/// 5.98
/// >>> scene.replace(hardness=2.24e9).interface.hardness
/// 2240000000.0
#[pyclass(frozen, module = "asperity")]
pub(crate) struct Scene(pub(crate) Arc<SceneFile>);

/// How the asperity heights of a scene are given.
#[derive(FromPyObject)]
pub(crate) enum HeightsArgument<'py> {
    Name(String),
    Table(PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>),
}

/// What a scene is made of, in the order of its arguments.
type Arguments<'py> = (
    Interface,
    Surface,
    f64,
    Bound<'py, PyAny>,
    &'static str,
    Option<f64>,
    BTreeMap<String, Bound<'py, PyAny>>,
);

#[pymethods]
impl Scene {
    #[new]
    #[pyo3(signature = (interface, surface, nominal_area, heights=None, separation_from="asperity-mean", separation_offset=None, options=None))]
    fn new(
        interface: &Interface,
        surface: &Surface,
        nominal_area: f64,
        heights: Option<HeightsArgument<'_>>,
        separation_from: &str,
        separation_offset: Option<f64>,
        options: Option<Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let mut file = SceneFile::from(asperity::Scene::new(interface.0, surface.0, nominal_area));
        match heights {
            None => {}
            Some(HeightsArgument::Name(name)) => {
                file.scene.heights = match name.as_str() {
                    "gaussian" => HeightDistribution::Gaussian,
                    "exponential" => HeightDistribution::Exponential,
                    _ => {
                        return Err(value_error(format!(
                            "heights is {name:?}: \"gaussian\", \"exponential\" or a table (heights [m], densities [1/m]) was required"
                        )));
                    }
                }
            }
            Some(HeightsArgument::Table(z, density)) => {
                let (z, density) = (z.as_array(), density.as_array());
                if z.len() != density.len() {
                    return Err(value_error(format!(
                        "heights is a table of {} heights and {} densities: as many of both was required",
                        z.len(),
                        density.len()
                    )));
                }
                let points: Vec<(f64, f64)> =
                    z.iter().copied().zip(density.iter().copied()).collect();
                let table = TabulatedHeights::new("table", &points).map_err(|e| refused(&e))?;
                file.table = Some(table);
            }
        }
        file.separation_from = match separation_from {
            "asperity-mean" => SeparationFrom::AsperityMean,
            "surface-mean" if matches!(file.scene.heights, HeightDistribution::Exponential) => {
                return Err(value_error(
                    "separation_from is \"surface-mean\": \"asperity-mean\" was required for exponential heights, to which no mean plane belongs",
                ));
            }
            "surface-mean" => SeparationFrom::SurfaceMean,
            _ => {
                return Err(value_error(format!(
                    "separation_from is {separation_from:?}: \"asperity-mean\" or \"surface-mean\" was required"
                )));
            }
        };
        file.separation_offset = match (file.separation_from, separation_offset) {
            (SeparationFrom::SurfaceMean, Some(offset)) if offset.is_finite() => offset,
            (SeparationFrom::SurfaceMean, None) => match &file.table {
                Some(table) => table.mean(),
                None => surface.0.mean_plane_offset(),
            },
            (_, None) => 0.0,
            (_, Some(offset)) => {
                return Err(value_error(format!(
                    "separation_offset is {offset:?}: a finite number, with separation_from \"surface-mean\", was required"
                )));
            }
        };
        if let Some(options) = options {
            for (name, value) in option_values(&options)? {
                file.options.set(&name, &value).map_err(value_error)?;
            }
        }
        let file = file.with_numbers(interface.0, surface.0, nominal_area);
        Ok(Self(Arc::new(file.map_err(|e| refused(&e))?)))
    }

    /// Reads a scene file and the files it names.
    #[staticmethod]
    fn from_toml(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        Self::read(py, py.detach(|| asperity_scene::load(&path)))
    }

    /// Reads a scene from the text of a scene file; relative paths in it begin at `directory`.
    #[staticmethod]
    #[pyo3(signature = (text, directory=PathBuf::from(".")))]
    fn parse(py: Python<'_>, text: &str, directory: PathBuf) -> PyResult<Self> {
        Self::read(py, py.detach(|| asperity_scene::parse(text, &directory)))
    }

    /// The same scene with other numbers, by the names of the scene's inputs:
    /// equivalent_modulus, equivalent_shear_modulus, poissons_ratio, hardness, yield_strength,
    /// pressure_factor, asperity_radius, asperity_density, asperity_height_std, nominal_area.
    #[pyo3(signature = (**numbers))]
    fn replace(&self, numbers: Option<Bound<'_, PyDict>>) -> PyResult<Self> {
        let mut scene = self.0.scene.clone();
        for (name, value) in numbers.iter().flatten() {
            let name: String = name.extract()?;
            input(&name).map_err(value_error)?(&mut scene, value.extract()?);
        }
        let file = self.0.with_numbers(scene.interface, scene.surface, scene.nominal_area);
        Ok(Self(Arc::new(file.map_err(|e| refused(&e))?)))
    }

    /// Many scenes like this one: the same names as in `replace`, with arrays that are broadcast.
    #[pyo3(signature = (**columns))]
    fn vary(slf: Bound<'_, Self>, columns: Option<Bound<'_, PyDict>>) -> PyResult<Scenes> {
        Scenes::broadcast(&slf, columns.as_ref())
    }

    /// The two bodies.
    #[getter]
    fn interface(&self) -> Interface {
        Interface(self.0.scene.interface)
    }

    /// The equivalent rough surface.
    #[getter]
    fn surface(&self) -> Surface {
        Surface(self.0.scene.surface)
    }

    /// The apparent area of contact [m^2].
    #[getter]
    fn nominal_area(&self) -> f64 {
        self.0.scene.nominal_area
    }

    /// "gaussian", "exponential" or a table (heights [m], densities [1/m]).
    #[getter]
    fn heights<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        match &self.0.table {
            None => self.0.scene.heights.name().into_bound_py_any(py),
            Some(table) => {
                let (z, density): (Vec<f64>, Vec<f64>) = table.points().iter().copied().unzip();
                (PyArray1::from_vec(py, z), PyArray1::from_vec(py, density)).into_bound_py_any(py)
            }
        }
    }

    /// The plane that separations are measured from: "asperity-mean" or "surface-mean".
    #[getter]
    fn separation_from(&self) -> &'static str {
        match self.0.separation_from {
            SeparationFrom::SurfaceMean => "surface-mean",
            _ => "asperity-mean",
        }
    }

    /// How far the mean of the asperity heights lies above that plane [m].
    #[getter]
    fn separation_offset(&self) -> f64 {
        self.0.separation_offset
    }

    /// The options of the models that differ from their defaults.
    #[getter]
    fn options<'py>(&self, py: Python<'py>) -> PyResult<BTreeMap<String, Bound<'py, PyAny>>> {
        option_objects(py, &self.0.options.changed())
    }

    /// One asperity of the surface, with every input resolved.
    #[getter]
    fn asperity(&self) -> PyResult<Asperity> {
        self.0.scene.asperity().map(Asperity).map_err(|e| refused(&e))
    }

    /// The number of asperities: density times nominal area.
    #[getter]
    fn asperities(&self) -> f64 {
        self.0.scene.asperities()
    }

    /// The square root of height_std over the critical interference.
    #[getter]
    fn plasticity_index(&self) -> PyResult<f64> {
        self.0.scene.plasticity_index().map_err(|e| refused(&e))
    }

    /// The ids of the models that this scene allows, simplest first.
    fn models(&self) -> Vec<String> {
        self.0.models().0.iter().map(|model| model.id().to_string()).collect()
    }

    pub(crate) fn __repr__(&self) -> String {
        let Self(file) = self;
        let mut text = format!(
            "Scene({}, {}, nominal_area={:?}",
            self.interface().__repr__(),
            self.surface().__repr__(),
            file.scene.nominal_area
        );
        match &file.table {
            Some(table) => text += &format!(", heights=<table of {} points>", table.points().len()),
            None if file.scene.heights.name() == "gaussian" => {}
            None => text += &format!(", heights='{}'", file.scene.heights.name()),
        }
        if file.separation_from != SeparationFrom::AsperityMean {
            text += &format!(
                ", separation_from='surface-mean', separation_offset={:?}",
                file.separation_offset
            );
        }
        let options = file.options.changed();
        if !options.is_empty() {
            let one = |(name, value): (&String, &OptionValue)| format!("{name} = {value}");
            text +=
                &format!(", options=<{}>", options.iter().map(one).collect::<Vec<_>>().join(", "));
        }
        text + ")"
    }

    fn __eq__(&self, other: &Self) -> bool {
        let (a, b) = (&self.0, &other.0);
        let table = |file: &SceneFile| file.table.as_ref().map(|t| t.points().to_vec());
        a.scene.interface == b.scene.interface
            && a.scene.surface == b.scene.surface
            && a.scene.nominal_area.total_cmp(&b.scene.nominal_area).is_eq()
            && a.scene.heights.name() == b.scene.heights.name()
            && a.options == b.options
            && a.separation_from == b.separation_from
            && a.separation_offset.total_cmp(&b.separation_offset).is_eq()
            && table(a) == table(b)
    }

    fn __getnewargs__<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        Ok((
            self.interface(),
            self.surface(),
            self.nominal_area(),
            self.heights(py)?,
            self.separation_from(),
            (self.0.separation_from == SeparationFrom::SurfaceMean)
                .then_some(self.0.separation_offset),
            self.options(py)?,
        ))
    }
}

impl Scene {
    fn read(py: Python<'_>, read: Result<SceneFile, asperity_scene::SceneError>) -> PyResult<Self> {
        let file = read.map_err(value_error)?;
        file.warnings.iter().try_for_each(|warning| warn(py, warning))?;
        Ok(Self(Arc::new(file)))
    }
}

/// A commented scene file with every key there is.
#[pyfunction]
pub(crate) fn template() -> &'static str {
    asperity_scene::template()
}
