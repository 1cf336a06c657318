//! Arguments that several commands share: parsing and defaults, nothing else.

use std::path::{Path, PathBuf};

use anyhow::Result;
use asperity::{At, Described, Model, Quantity, Request, SeparationUnit, Tolerance};
use asperity_scene::SceneFile;
use clap::builder::{PathBufValueParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::{ArgAction, Args};
use serde::Deserialize;
use serde::de::IntoDeserializer;
use serde::de::value::{Error, StrDeserializer};

use crate::input::distances::{Distances, ask_unit};
use crate::input::numbers::{
    Numbers, loads, loads_or_tensions, number, pressures, pressures_or_tensions,
};
use crate::output::table::{Format, Table};
use crate::output::{self, once};
use crate::scene::{LoadedScene, NamedModel};

/// What is asked of which models of a scene.
#[derive(Debug, Args)]
pub struct Asked {
    /// Scene file; `asperity init` writes one to start from
    #[arg(value_name = "SCENE")]
    pub scene: PathBuf,
    /// Models, all that the scene allows by default; `asperity models` lists them
    #[arg(long = "model", value_name = "M", value_delimiter = ',', value_parser = model_id)]
    pub models: Vec<String>,
    /// Separations: N from A to B, in equal steps or (log) ratios, or v,v,...; in sigma (of the
    /// asperity heights), or with a unit as 2um
    #[arg(long = "separation", value_name = "A:B:N[:log]|v,v", conflicts_with = "given")]
    #[arg(action = ArgAction::Append)]
    separations: Vec<Distances>,
    /// Unit of separations without one, sigma (of the asperity heights) or m
    #[arg(long = "separation-unit", value_name = "UNIT", value_parser = separation_unit)]
    #[arg(default_value = "sigma", requires = "separations", conflicts_with = "given")]
    unit: SeparationUnit,
    /// Loads in N, or with a unit as 2kN, written as separations are; tensions (dmt, jkr) below 0
    #[arg(long = "load", value_name = "A:B:N[:log]|v,v", value_parser = loads_or_tensions)]
    #[arg(action = ArgAction::Append, group = "given")]
    loads: Vec<Numbers>,
    /// Loads as pressures on the nominal area, in Pa, or with a unit as 5MPa
    #[arg(long = "pressure", value_name = "A:B:N[:log]|v,v", value_parser = pressures_or_tensions)]
    #[arg(action = ArgAction::Append, group = "given")]
    pressures: Vec<Numbers>,
    /// Quantities: force, area, stiffness, tangent, pressure, area-fraction, contacts, mean-pressure,
    /// ln-force, ln-area, elastic-share, elastic-plastic-share, plastic-share; of equal asperities with
    /// circular contacts contact-radius-sum, unloading-stiffness, tangential-stiffness,
    /// thermal-conductance, electrical-conductance and both with -per-area
    #[arg(long = "quantity", value_name = "Q", value_delimiter = ',')]
    quantities: Vec<Quantity>,
    /// Relative tolerance of every value, from 1e-15 to 0.1
    #[arg(long, value_name = "T", value_parser = tolerance, default_value = "1e-10")]
    tolerance: Tolerance,
}

/// A joint that has been closed.
#[derive(Debug, Args)]
pub struct Closed {
    /// Scene file; `asperity init` writes one to start from
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// The model; `asperity models` lists them
    #[arg(long, value_name = "M", value_parser = one_model_id)]
    model: String,
    #[command(flatten)]
    place: Place,
}

/// Where it was closed to.
#[derive(Debug, Args)]
#[group(id = "place", required = true, multiple = false)]
struct Place {
    /// The closest approach, in sigma (of the asperity heights), or with a unit as 2um
    #[arg(long, value_name = "D")]
    closest: Option<Distances>,
    /// The largest load, in N, or with a unit as 2kN
    #[arg(long, value_name = "P", value_parser = loads)]
    load: Option<Numbers>,
    /// The largest load as a pressure on the nominal area, in Pa, or with a unit as 5MPa
    #[arg(long, value_name = "P", value_parser = pressures)]
    pressure: Option<Numbers>,
}

impl Closed {
    /// The scene and the model.
    pub fn open(&self) -> Result<(LoadedScene, NamedModel)> {
        let scene = LoadedScene::load(&self.scene)?;
        let model = scene.model(&self.model)?;
        Ok((scene, model))
    }

    /// Where the joint was closed to, once or, for one each, several times; what is unusual about it
    /// is said.
    pub fn places(&self, scene: &LoadedScene, model: &NamedModel) -> Vec<At> {
        let file = &scene.file;
        let Place { closest, load, pressure } = &self.place;
        let separations = closest.iter().flat_map(|list| {
            let unit = list.unit(SeparationUnit::Sigma);
            ask_unit("closest", &list.values, unit, file.scene.surface.asperity_height_std);
            list.values.iter().map(move |value| At::from(file.separation(*value, unit)))
        });
        let [loads, pressures] = [load, pressure].map(|list| list.iter().flat_map(|l| &l.0));
        let places: Vec<At> = separations
            .chain(loads.copied().map(At::Load))
            .chain(pressures.copied().map(At::Pressure))
            .collect();
        scene.tell(&[model], &places);
        places
    }
}

/// Form and place of the answer.
#[derive(Debug, Args)]
pub struct OutputArgs {
    /// Form of the answer
    #[arg(long, value_name = "FORM", default_value = "table")]
    pub format: Format,
    /// Write to a file in place of the standard output
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// Form and place of the answer, and of its picture.
#[derive(Debug, Args)]
pub struct DrawnArgs {
    #[command(flatten)]
    output: OutputArgs,
    /// Draw the answer as well, one panel for each quantity
    #[arg(long, value_name = "FILE.svg", value_parser = PathBufValueParser::new().try_map(svg_file))]
    plot: Option<PathBuf>,
}

impl Asked {
    /// As a request, with what is asked for unless something is given.
    pub fn request(&self, scene: &SceneFile, separations: &[f64], usual: &[Quantity]) -> Request {
        for list in &self.separations {
            let height_std = scene.scene.surface.asperity_height_std;
            ask_unit("separation", &list.values, list.unit(self.unit), height_std);
        }
        let at = self.at(scene, separations);
        let quantities = match (&self.quantities[..], &at[..], usual) {
            // At a load, the force is what was given.
            ([], [At::Load(_) | At::Pressure(_), ..], [Quantity::Force, others @ ..]) => others,
            ([], ..) => usual,
            (given, ..) => given,
        };
        Request::new(once(quantities)).at(at).within(self.tolerance)
    }

    /// Whether separations and loads are left to the command.
    pub fn is_nowhere(&self) -> bool {
        self.separations.is_empty() && self.loads.is_empty() && self.pressures.is_empty()
    }

    /// The default ones are multiples of sigma.
    fn at(&self, scene: &SceneFile, otherwise: &[f64]) -> Vec<At> {
        let separation = |value, unit| At::from(scene.separation(value, unit));
        let flat = |lists: &[Numbers]| lists.iter().flat_map(|l| l.0.clone()).collect::<Vec<_>>();
        let separations = self.separations.iter().flat_map(|list| {
            let unit = list.unit(self.unit);
            list.values.iter().map(move |value| separation(*value, unit))
        });
        let loads = flat(&self.loads).into_iter().map(At::Load);
        let pressures = flat(&self.pressures).into_iter().map(At::Pressure);
        let given: Vec<At> = separations.chain(loads).chain(pressures).collect();
        if given.is_empty() {
            otherwise.iter().map(|s| separation(*s, self.unit)).collect()
        } else {
            given
        }
    }
}

impl OutputArgs {
    pub fn write(&self, table: &Table) -> Result<()> {
        output::write(self.output.as_deref(), |out| table.write(self.format, out))
    }

    pub fn write_text(&self, text: &str) -> Result<()> {
        output::write_text(self.output.as_deref(), text)
    }
}

impl DrawnArgs {
    /// Ends the `command` where picture and data would go to the same place.
    pub fn check(&self, command: &str) {
        let files = [self.plot.as_deref(), self.output.output.as_deref()];
        if self.plot.is_some() && files.map(output::is_standard) == [true; 2] {
            let text = "--plot - leaves no place for the data: name a file with --output";
            crate::input::usage_error(command, ErrorKind::ArgumentConflict, text);
        }
        if let [Some(plot), Some(output)] = files
            && output::is_same(plot, output)
        {
            let text = "--plot and --output name the same file: two were expected";
            crate::input::usage_error(command, ErrorKind::ArgumentConflict, text);
        }
    }

    /// The table, and its picture if one was asked for.
    pub fn write(&self, table: &Table, picture: impl FnOnce() -> Result<String>) -> Result<()> {
        if self.plot.is_some() {
            output::write_text(self.plot.as_deref(), &picture()?)?;
        }
        self.output.write(table)
    }
}

/// The id of a model of this project.
pub fn model_id(name: &str) -> Result<String, String> {
    if name.trim().is_empty() {
        return Err("a name is empty: models are separated by single commas, as gw,ke, and `asperity models` lists them".into());
    }
    // No model of the registry: it belongs to the scene's scan.
    if name.trim().eq_ignore_ascii_case("bem") {
        return Ok("bem".into());
    }
    name.parse::<Model>().map(|model| model.id().to_string()).map_err(|e| e.to_string())
}

/// The id of the one model of a command.
fn one_model_id(name: &str) -> Result<String, String> {
    match name.split_once(',') {
        Some((first, _)) => Err(format!("one model at a time was expected, as {first}")),
        None => model_id(name),
    }
}

/// The unit of a separation by its name.
pub fn separation_unit(name: &str) -> Result<SeparationUnit, String> {
    let name: StrDeserializer<'_, Error> = name.into_deserializer();
    SeparationUnit::deserialize(name).map_err(|e| e.to_string())
}

/// The name of a picture.
pub fn svg_file(name: PathBuf) -> Result<PathBuf, &'static str> {
    let is_svg = name.extension().is_some_and(|end| end.eq_ignore_ascii_case("svg"));
    match is_svg || output::is_standard(Some(&name)) {
        true => Ok(name),
        false => Err("pictures are svg: a name that ends with .svg was expected"),
    }
}

/// The name of a picture that may be one of pixels.
pub fn svg_or_png_file(name: PathBuf) -> Result<PathBuf, &'static str> {
    let is_png = is_png(&name);
    svg_file(name.clone()).or(if is_png { Ok(name) } else { Err(()) }).map_err(
        |()| "these pictures are svg or png: a name that ends with .svg or .png was expected",
    )
}

pub fn is_png(name: &Path) -> bool {
    name.extension().is_some_and(|end| end.eq_ignore_ascii_case("png"))
}

/// The name of a matrix.
pub fn npy_file(name: PathBuf) -> Result<PathBuf, &'static str> {
    let is_npy = name.extension().is_some_and(|end| end.eq_ignore_ascii_case("npy"));
    match is_npy || output::is_standard(Some(&name)) {
        true => Ok(name),
        false => Err("maps are matrices of NumPy: a name that ends with .npy was expected"),
    }
}

fn tolerance(text: &str) -> Result<Tolerance, String> {
    Tolerance::new(number(text)?).map_err(|e| e.to_string())
}
