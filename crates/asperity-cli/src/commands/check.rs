//! `asperity check`: a scene that is looked at before it is believed.

use std::path::PathBuf;

use anyhow::{Result, bail};
use asperity::{At, Check as Looked, SeparationUnit, Severity};
use clap::Args;

use crate::input::args::{OutputArgs, model_id, separation_unit};
use crate::input::distances::{Distance, ask_unit};
use crate::input::numbers::{load_or_tension, pressure_or_tension};
use crate::output::table::{Cell, Format, Table};
use crate::output::{self, say};
use crate::scene::LoadedScene;

/// What follows from a scene, and what in it is unusual: units, sizes, ranges of models
#[derive(Debug, Args)]
#[command(
    after_help = "At a load, pressure or separation, also how much of the surface touches, in how
many contacts, how deep they are pressed, and whether the model is made for that.
An error means that the answers mean nothing until it is mended: exit code 1.
json: {\"numbers\": {name: value}, \"findings\": [{code, severity, field, value,
usual, message}]}.

Examples:
  asperity check scene.toml
  asperity check scene.toml --load 1200
  asperity check scene.toml --model gw --pressure 5e6 --format json"
)]
pub struct Check {
    /// Scene file; `asperity init` writes one to start from
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// The model of the answer [default: ke; gw where there is no hardness]
    #[arg(long, value_name = "M", value_parser = model_id)]
    model: Option<String>,
    /// A load in N, or with a unit as 2kN; a tension (dmt, jkr) below 0
    #[arg(long, value_name = "N", value_parser = load_or_tension, group = "place")]
    load: Option<f64>,
    /// A load as pressure on the nominal area, in Pa, or with a unit as 5MPa
    #[arg(long, value_name = "PA", value_parser = pressure_or_tension, group = "place")]
    pressure: Option<f64>,
    /// A separation, in sigma (of the asperity heights), or with a unit as 2um
    #[arg(long, value_name = "D", group = "place")]
    separation: Option<Distance>,
    /// Unit of a separation without one, sigma (of the asperity heights) or m
    #[arg(long = "separation-unit", value_name = "UNIT", value_parser = separation_unit)]
    #[arg(default_value = "sigma", requires = "separation")]
    unit: SeparationUnit,
    #[command(flatten)]
    output: OutputArgs,
}

impl Check {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::read(&self.scene)?;
        let separation = |distance: Distance| {
            let unit = distance.unit(self.unit);
            let height_std = scene.file.scene.surface.asperity_height_std;
            ask_unit("separation", &[distance.value], unit, height_std);
            At::from(scene.file.separation(distance.value, unit))
        };
        let place = self.load.map(At::Load).or(self.pressure.map(At::Pressure));
        let place = place.or(self.separation.map(separation));
        if self.model.is_some() && place.is_none() {
            let text =
                "--model: a place to ask it at, --load, --pressure or --separation, was expected";
            crate::input::usage_error(
                "check",
                clap::error::ErrorKind::MissingRequiredArgument,
                text,
            );
        }
        // Without an answer, what is wrong with the scene says why.
        let answered = place.map(|place| -> Result<Looked> {
            let (_, model) = scene.reference(self.model.as_deref())?;
            Ok(scene.file.check(Some((&model, place)))?)
        });
        let (looked, refused) = match answered {
            Some(Ok(looked)) => (looked, None),
            Some(Err(refused)) => (scene.file.check(None)?, Some(refused)),
            None => (scene.file.check(None)?, None),
        };
        if self.output.format == Format::Json {
            self.output.write_text(&(serde_json::to_string_pretty(&looked)? + "\n"))?;
        } else {
            let table = numbers(&looked);
            let findings = self.output.format == Format::Table;
            output::write(self.output.output.as_deref(), |out| {
                table.write(self.output.format, out)?;
                let told = if findings { &looked.findings[..] } else { &[] };
                told.iter().enumerate().try_for_each(|(k, finding)| {
                    let gap = if k == 0 { "\n" } else { "" };
                    writeln!(out, "{gap}{}: {finding}", finding.severity)
                })
            })?;
            if !findings {
                looked.findings.iter().for_each(|f| say(&f.severity.to_string(), &f.message));
            }
        }
        if let Some(refused) = refused {
            return Err(refused);
        }
        match looked.findings.iter().filter(|f| f.severity == Severity::Error).count() {
            0 => Ok(()),
            1 => bail!("{}: a number makes no sense", scene.name),
            count => bail!("{}: {count} numbers make no sense", scene.name),
        }
    }
}

fn numbers(looked: &Looked) -> Table {
    let mut table = Table::new(&["name", "value", "unit", "meaning"]);
    for number in &looked.numbers {
        let value = Cell::Number(Some(number.value));
        table.rows.push(vec![
            number.name.into(),
            value,
            number.unit.into(),
            (*number.meaning).into(),
        ]);
    }
    table
}
