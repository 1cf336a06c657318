//! `SceneFile`: what is in contact, as a scene file says it; the package's `Scene` is made of one.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use asperity::{
    ContactError, Datum, HeightDistribution, SeparationUnit, TabulatedHeights, WeibullHeights,
};
use pyo3::prelude::*;
use serde_json::Value;

use crate::error::{refused, value_error, warn};
use crate::fields::Asperity;
use crate::fields::{Interface, Surface};

/// A scene with the options of its models and the plane of its separations.
#[pyclass(frozen, module = "asperity._asperity")]
pub(crate) struct SceneFile(pub(crate) Arc<asperity_scene::SceneFile>);

/// The fields of the dataclass `Scene`.
#[derive(FromPyObject, IntoPyObject)]
pub(crate) struct Fields {
    interface: Interface,
    surface: Surface,
    nominal_area: f64,
    heights: Heights,
    separation_from: String,
    mean_plane_offset: Option<f64>,
    options: BTreeMap<String, OptionValue>,
}

/// A name, a skewness, or a table of heights [m] and densities [1/m].
#[derive(FromPyObject, IntoPyObject)]
enum Heights {
    Name(String),
    Named(BTreeMap<String, f64>),
    Table(Vec<f64>, Vec<f64>),
}

/// A word, a number, or named numbers.
#[derive(FromPyObject, IntoPyObject)]
pub(crate) enum OptionValue {
    Word(String),
    Number(f64),
    Numbers(BTreeMap<String, f64>),
}

impl From<OptionValue> for asperity_scene::OptionValue {
    fn from(value: OptionValue) -> Self {
        match value {
            OptionValue::Word(word) => Self::Word(word),
            OptionValue::Number(number) => Self::Number(number),
            OptionValue::Numbers(numbers) => Self::Numbers(numbers),
        }
    }
}

impl From<asperity_scene::OptionValue> for OptionValue {
    fn from(value: asperity_scene::OptionValue) -> Self {
        match value {
            asperity_scene::OptionValue::Word(word) => Self::Word(word),
            asperity_scene::OptionValue::Number(number) => Self::Number(number),
            asperity_scene::OptionValue::Numbers(numbers) => Self::Numbers(numbers),
        }
    }
}

#[pymethods]
impl SceneFile {
    /// Of the dataclass `Scene`.
    #[new]
    fn new(fields: Fields) -> PyResult<Self> {
        let (interface, surface) = (fields.interface.into(), fields.surface.into());
        let scene = asperity::Scene::new(interface, surface, fields.nominal_area);
        let mut file = asperity_scene::SceneFile::from(scene);
        match fields.heights {
            Heights::Name(name) if name == "gaussian" => {}
            Heights::Name(name) if name == "exponential" => {
                file.scene.heights = HeightDistribution::Exponential;
            }
            Heights::Name(name) => {
                return Err(value_error(format!(
                    "heights is {name:?}: \"gaussian\", \"exponential\", {{\"skewness\": value}} or a table (heights [m], densities [1/m]) was required"
                )));
            }
            Heights::Named(named) => {
                let Some(skewness) = named.get("skewness").filter(|_| named.len() == 1) else {
                    let keys: Vec<&String> = named.keys().collect();
                    return Err(value_error(format!(
                        "heights has the keys {keys:?}: {{\"skewness\": value}} was required"
                    )));
                };
                let heights = WeibullHeights::new(*skewness).map_err(refused)?;
                file.scene.heights = HeightDistribution::Weibull(heights);
            }
            Heights::Table(z, density) if z.len() != density.len() => {
                return Err(value_error(format!(
                    "heights is a table of {} heights and {} densities: as many of both was required",
                    z.len(),
                    density.len()
                )));
            }
            Heights::Table(z, density) => {
                let points: Vec<(f64, f64)> = z.into_iter().zip(density).collect();
                let table = TabulatedHeights::new("table", &points).map_err(refused)?;
                file.scene.heights = HeightDistribution::other(table.clone());
                file.table = Some(table);
            }
        }
        let from = serde_json::from_value(Value::String(fields.separation_from));
        file.separation_from =
            from.map_err(|error| value_error(format!("separation_from: {error}")))?;
        file.scene.mean_plane_offset = fields.mean_plane_offset;
        for (name, value) in fields.options {
            file.options.set(&name, &value.into()).map_err(value_error)?;
        }
        let file = with_numbers(&file, []).map_err(refused)?;
        // That there is a mean plane.
        file.separation(0.0, SeparationUnit::Metres)
            .measured_in(SeparationUnit::Metres, Datum::AsperityMean, &file.scene)
            .map_err(refused)?;
        Ok(Self(Arc::new(file)))
    }

    /// Reads a scene file and the files it names.
    #[staticmethod]
    fn load(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        Self::read(py, py.detach(|| asperity_scene::load(&path)))
    }

    /// Reads the text of a scene file; relative paths in it begin at `directory`.
    #[staticmethod]
    fn parse(py: Python<'_>, text: &str, directory: PathBuf) -> PyResult<Self> {
        Self::read(py, py.detach(|| asperity_scene::parse(text, &directory)))
    }

    /// The same scene with other numbers.
    fn replace(&self, numbers: BTreeMap<String, f64>) -> PyResult<Self> {
        let inputs = inputs(numbers.keys())?;
        let numbers = inputs.into_iter().zip(numbers.into_values());
        let file = with_numbers(&self.0, numbers).map_err(refused)?;
        Ok(Self(Arc::new(file)))
    }

    /// What it was made of, or would be.
    fn fields(&self) -> PyResult<Fields> {
        let Self(file) = self;
        let heights = match (&file.table, &file.scene.heights) {
            (None, HeightDistribution::Weibull(heights)) => {
                Heights::Named([("skewness".into(), heights.skewness())].into())
            }
            (None, heights) => Heights::Name(heights.name().into()),
            (Some(table), _) => {
                let (z, density) = table.points().iter().copied().unzip();
                Heights::Table(z, density)
            }
        };
        let from = serde_json::to_value(file.separation_from).map_err(value_error)?;
        let options = file.options.changed().into_iter();
        Ok(Fields {
            interface: file.scene.interface.into(),
            surface: file.scene.surface.into(),
            nominal_area: file.scene.nominal_area,
            heights,
            separation_from: from.as_str().unwrap_or_default().into(),
            // A table's own mean is not given.
            mean_plane_offset: file.scene.mean_plane_offset.filter(|_| file.table.is_none()),
            options: options.map(|(name, value)| (name, value.into())).collect(),
        })
    }

    /// One asperity of the surface.
    fn asperity(&self) -> PyResult<Asperity> {
        self.0.scene.asperity().map(Into::into).map_err(refused)
    }

    /// The number of asperities.
    fn asperities(&self) -> f64 {
        self.0.scene.asperities()
    }

    /// The square root of height_std over the critical interference.
    fn plasticity_index(&self) -> PyResult<f64> {
        self.0.scene.plasticity_index().map_err(refused)
    }

    /// The text of a scene file that reads back exactly; a table of heights stands in a file of its
    /// own.
    #[pyo3(signature = (heights_file, comments))]
    fn to_toml(&self, heights_file: Option<&str>, comments: Vec<String>) -> PyResult<String> {
        let Self(file) = self;
        if file.table.is_some() && heights_file.is_none() {
            let needed =
                "heights is a table: a path to write to was required, beside which it goes";
            return Err(value_error(needed));
        }
        let comments: Vec<&str> = comments.iter().map(String::as_str).collect();
        let text = asperity_scene::write(&file.scene, &file.options, heights_file, &comments);
        // What is not among the numbers: the plane of the separations.
        let from = match file.separation_from {
            Datum::SurfaceMean => "separation_from = \"surface-mean\"\n",
            _ => "",
        };
        Ok(match text.split_once("\n[options]") {
            Some((before, options)) => format!("{before}{from}\n[options]{options}"),
            None => text + from,
        })
    }

    /// The id of the model that others are held against where none is named.
    fn usual_reference(&self) -> &'static str {
        asperity::usual_reference(&self.0.scene)
    }

    /// The ids of the models that this scene allows, simplest first.
    fn models(&self) -> Vec<String> {
        self.0.models().0.iter().map(|model| model.id().to_string()).collect()
    }
}

impl SceneFile {
    fn read(
        py: Python<'_>,
        read: Result<asperity_scene::SceneFile, asperity_scene::SceneError>,
    ) -> PyResult<Self> {
        let file = read.map_err(value_error)?;
        file.warnings.iter().try_for_each(|warning| warn(py, warning, 1))?;
        Ok(Self(Arc::new(file)))
    }
}

/// A number of a scene that can be another.
#[derive(Clone, Copy)]
pub(crate) enum Input {
    /// One that is a field.
    Field(fn(&mut asperity::Scene, f64)),
    /// One of the two that radius and density follow from.
    PlasticityIndex,
    RoughnessParameter,
}

/// By the names of a scene file.
const INPUTS: [(&str, Input); 15] = [
    ("equivalent_modulus", Input::Field(|s, v| s.interface.equivalent_modulus = v)),
    (
        "equivalent_shear_modulus",
        Input::Field(|s, v| s.interface.equivalent_shear_modulus = Some(v)),
    ),
    ("poissons_ratio", Input::Field(|s, v| s.interface.poissons_ratio = v)),
    ("hardness", Input::Field(|s, v| s.interface.hardness = Some(v))),
    ("yield_strength", Input::Field(|s, v| s.interface.yield_strength = Some(v))),
    ("pressure_factor", Input::Field(|s, v| s.interface.pressure_factor = Some(v))),
    ("thermal_conductivity", Input::Field(|s, v| s.interface.thermal_conductivity = Some(v))),
    ("electrical_resistivity", Input::Field(|s, v| s.interface.electrical_resistivity = Some(v))),
    ("work_of_adhesion", Input::Field(|s, v| s.interface.work_of_adhesion = Some(v))),
    ("asperity_radius", Input::Field(|s, v| s.surface.asperity_radius = v)),
    ("asperity_density", Input::Field(|s, v| s.surface.asperity_density = v)),
    ("asperity_height_std", Input::Field(|s, v| s.surface.asperity_height_std = v)),
    ("nominal_area", Input::Field(|s, v| s.nominal_area = v)),
    ("plasticity_index", Input::PlasticityIndex),
    ("roughness_parameter", Input::RoughnessParameter),
];

/// Refuses names that there are not, and those that say the same thing twice.
#[pyfunction]
pub(crate) fn check_inputs(names: Vec<String>) -> PyResult<()> {
    inputs(names.iter()).map(drop)
}

/// The inputs of these names.
pub(crate) fn inputs<'n>(names: impl Iterator<Item = &'n String> + Clone) -> PyResult<Vec<Input>> {
    let given = |wanted: &&str| names.clone().any(|name| name == wanted);
    let roughness = ["plasticity_index", "roughness_parameter"];
    if let (true, Some(follows)) = (
        roughness.iter().any(given),
        ["asperity_radius", "asperity_density"].iter().find(|name| given(name)),
    ) {
        return Err(value_error(format!(
            "{follows} is given beside {}: the one follows from the others, leave it out",
            roughness.join(" or ")
        )));
    }
    let input = |name: &String| {
        let found = INPUTS.iter().find(|(known, _)| known == name);
        found.map(|(_, input)| *input).ok_or_else(|| {
            let known = INPUTS.map(|(name, _)| name).join(", ");
            value_error(format!("{name} is not an input of a scene: one of {known} was required"))
        })
    };
    names.clone().map(input).collect()
}

/// A scene with other numbers.
pub(crate) fn with_numbers(
    file: &asperity_scene::SceneFile,
    numbers: impl IntoIterator<Item = (Input, f64)>,
) -> Result<asperity_scene::SceneFile, ContactError> {
    let mut scene = file.scene.clone();
    let (mut index, mut parameter) = (None, None);
    for (input, value) in numbers {
        match input {
            Input::Field(set) => set(&mut scene, value),
            Input::PlasticityIndex => index = Some(value),
            Input::RoughnessParameter => parameter = Some(value),
        }
    }
    if index.is_some() || parameter.is_some() {
        let index = index.map_or_else(|| file.scene.plasticity_index(), Ok)?;
        let parameter = parameter.unwrap_or_else(|| file.scene.surface.roughness_parameter());
        let height_std = scene.surface.asperity_height_std;
        scene.surface = asperity::Surface::from_plasticity_index(
            index,
            parameter,
            height_std,
            &scene.interface,
        )?;
    }
    file.with_numbers(scene.interface, scene.surface, scene.nominal_area)
}

/// A commented scene file with every key there is.
#[pyfunction]
pub(crate) fn template() -> &'static str {
    asperity_scene::template()
}
