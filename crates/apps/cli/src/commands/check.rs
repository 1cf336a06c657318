//! `asperity check`: derived numbers of a scene, and findings.

use std::path::PathBuf;

use anyhow::Result;
use asperity::{At, Check as CheckedScene};
use asperity_answer::check_sheet;
use clap::Args;

use crate::input::args::{OutputArgs, model_id};
use crate::input::numbers::{load_or_tension, pressure_or_tension};
use crate::output;
use crate::output::table::Format;
use crate::scene::LoadedScene;

/// Check a scene: derived numbers, unusual values, likely unit errors, validity of a model
#[derive(Debug, Args)]
#[command(
    after_help = include_str!("../help/check.txt")
)]
pub struct Check {
    /// Scene file; `asperity init` writes an example
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Model at the load [default: ke; gw without a hardness]
    #[arg(long, value_name = "M", value_parser = model_id, requires = "place")]
    model: Option<String>,
    /// Load in N, or with a unit, for example 2kN; negative for tension (dmt, jkr)
    #[arg(long, value_name = "N", value_parser = load_or_tension, group = "place")]
    load: Option<f64>,
    /// Load as a pressure on the nominal area, in Pa, or with a unit, for example 5MPa
    #[arg(long, value_name = "PA", value_parser = pressure_or_tension, group = "place")]
    pressure: Option<f64>,
    #[command(flatten)]
    output: OutputArgs,
}

impl Check {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::open(&self.scene)?;
        let place = self.load.map(At::Load).or(self.pressure.map(At::Pressure));
        // If the model is refused, the findings of the scene give the reason.
        let answered = place.map(|place| -> Result<CheckedScene> {
            let middle = LoadedScene { file: scene.file.middle()?, name: scene.name.clone() };
            let model = middle.model(self.model.as_deref())?;
            Ok(scene.file.check(Some((&model, place)))?)
        });
        let (mut checked, refused) = match answered {
            Some(Ok(checked)) => (checked, None),
            Some(Err(refused)) => (scene.file.check(None)?, Some(refused)),
            None => (scene.file.check(None)?, None),
        };
        checked.extend(scene.file.warnings.clone());
        let json = serde_json::to_string_pretty(&checked)? + "\n";
        let sheet = check_sheet(checked);
        match self.output.format() {
            Format::Json => self.output.write_text(&json)?,
            _ => self.output.write(&sheet)?,
        }
        output::show(&sheet.findings);
        refused.map_or(Ok(()), Err)
    }
}
