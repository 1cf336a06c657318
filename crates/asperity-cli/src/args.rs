//! Arguments that several commands share.

use std::path::PathBuf;

use anyhow::Result;
use asperity::{Model, Output, Request, Tolerance, linspace};
use clap::{ArgAction, Args, ValueEnum};

use crate::numbers::{Numbers, numbers, positive_numbers};
use crate::scene::LoadedScene;
use crate::table::{Format, Table};

/// The scene file, and where the answer goes.
#[derive(Debug, Args)]
pub struct SceneArgs {
    /// Scene file; `asperity init` writes one to start from
    #[arg(value_name = "SCENE")]
    pub scene: PathBuf,
}

/// Which models.
#[derive(Debug, Args)]
pub struct ModelArgs {
    /// Models, all that the scene allows by default; `asperity models` lists them
    #[arg(long = "model", value_name = "M", value_delimiter = ',', value_parser = model_id)]
    pub models: Vec<String>,
}

/// Which models, where one must be named.
#[derive(Debug, Args)]
pub struct RequiredModelArgs {
    /// Models; `asperity models` lists them
    #[arg(long = "model", value_name = "M", value_delimiter = ',', value_parser = model_id)]
    #[arg(required = true)]
    pub models: Vec<String>,
}

/// Which quantities, and how well.
#[derive(Debug, Args)]
pub struct QuantityArgs {
    /// Quantities: force, area, stiffness, tangent, pressure, area-fraction, contacts,
    /// mean-pressure, ln-force, ln-area, elastic-share, elastic-plastic-share, plastic-share
    #[arg(long = "quantity", value_name = "Q", value_delimiter = ',')]
    #[arg(default_value = "force,area,stiffness")]
    pub quantities: Vec<Output>,
    /// Relative tolerance of every value, from 1e-15 to 0.1
    #[arg(long, value_name = "T", value_parser = tolerance, default_value = "1e-10")]
    pub tolerance: Tolerance,
}

/// The unit of separations on the command line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum SeparationUnit {
    /// Standard deviations of the asperity heights.
    Sigma,
    /// Metres.
    M,
}

/// Which separations.
#[derive(Debug, Args)]
pub struct SeparationArgs {
    /// Separations: A:B:N for N from A to B, or v,v,... [default: 0:4:401 in sigma]
    #[arg(long = "separation", value_name = "A:B:N|v,v", value_parser = numbers)]
    #[arg(action = ArgAction::Append)]
    separations: Vec<Numbers>,
    /// Unit of the separations
    #[arg(long = "separation-unit", value_name = "UNIT", default_value = "sigma")]
    unit: SeparationUnit,
}

/// Loads, one way or the other.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
pub struct LoadArgs {
    /// Loads in N
    #[arg(long = "load", value_name = "N,N", value_parser = positive_numbers)]
    #[arg(action = ArgAction::Append)]
    pub loads: Vec<Numbers>,
    /// Loads as pressures on the nominal area, in Pa
    #[arg(long = "pressure", value_name = "PA,PA", value_parser = positive_numbers)]
    #[arg(action = ArgAction::Append)]
    pub pressures: Vec<Numbers>,
}

/// Form and place of the answer.
#[derive(Debug, Args)]
pub struct OutputArgs {
    /// Form of the answer
    #[arg(long, value_name = "FORM", default_value = "csv")]
    pub format: Format,
    /// Write to a file in place of the standard output
    #[arg(long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

impl QuantityArgs {
    /// Each quantity once, in the order asked.
    pub fn outputs(&self) -> Vec<Output> {
        once(&self.quantities)
    }
}

impl SeparationArgs {
    /// The separations as given and their unit; the default ones are multiples of sigma, whatever
    /// the unit.
    pub fn given(&self) -> (Vec<f64>, SeparationUnit) {
        match &self.separations[..] {
            [] => (linspace(0.0, 4.0, 401), SeparationUnit::Sigma),
            lists => (flat(lists), self.unit),
        }
    }

    /// A request for them.
    pub fn request(&self, scene: &LoadedScene, tolerance: Tolerance) -> Request {
        let (given, unit) = self.given();
        scene.request(&given, unit).within(tolerance)
    }
}

impl LoadArgs {
    /// The loads in newtons.
    pub fn newtons(&self, scene: &LoadedScene) -> Vec<f64> {
        let pressures = flat(&self.pressures);
        let loads = pressures.into_iter().map(|pressure| scene.load_at(pressure));
        flat(&self.loads).into_iter().chain(loads).collect()
    }
}

impl OutputArgs {
    /// Whether the answer goes to the standard output.
    pub fn is_standard(&self) -> bool {
        crate::output::is_standard(self.output.as_deref())
    }

    /// Writes a table.
    pub fn write(&self, table: &Table) -> Result<()> {
        crate::output::write(self.output.as_deref(), |out| table.write(self.format, out))
    }
}

/// Each once, in order.
pub fn once<T: PartialEq + Clone>(all: &[T]) -> Vec<T> {
    let mut kept: Vec<T> = vec![];
    for item in all {
        if !kept.contains(item) {
            kept.push(item.clone());
        }
    }
    kept
}

fn flat(lists: &[Numbers]) -> Vec<f64> {
    lists.iter().flat_map(|list| list.0.iter().copied()).collect()
}

/// The id of a model of this project.
pub fn model_id(name: &str) -> Result<String, String> {
    name.parse::<Model>().map(|model| model.id().to_string()).map_err(|e| e.to_string())
}

fn tolerance(text: &str) -> Result<Tolerance, String> {
    Tolerance::new(crate::numbers::number(text)?).map_err(|e| e.to_string())
}
