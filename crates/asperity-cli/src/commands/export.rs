//! `asperity export`: contact tables for finite-element codes.

use std::io::{self, Write};
use std::path::PathBuf;

use anyhow::{Context, Result};
use asperity::{ContactTable, Interpolation, Tolerance};
use clap::error::ErrorKind;
use clap::{Args, ValueEnum};

use crate::args::{SceneArgs, SeparationUnit, model_id};
use crate::number::{exact, rounded};
use crate::numbers::{Span, positive_number, range};
use crate::output;
use crate::progress::Progress;
use crate::scene::LoadedScene;

/// Pressure against clearance as a table for a finite-element code
#[derive(Debug, Args)]
#[command(
    after_help = "csv holds pressure and stiffness (its exact slope) at every node. Read as cubics
(Hermite), both are continuous, as Newton's method needs.
abaqus holds *SURFACE BEHAVIOR with pairs of pressure and overclosure, which the
code joins by straight lines.
Both state the interpolation error, measured between the nodes; --max-error adds
nodes until it is met.

Examples:
  asperity export scene.toml --model ke --as csv --range 0:4:41
  asperity export scene.toml --model ke --as abaqus --range -1:4 --max-error 1e-3 --output ke.inp"
)]
pub struct Export {
    #[command(flatten)]
    scene: SceneArgs,
    /// The model; `asperity models` lists them
    #[arg(long, value_name = "M", value_parser = model_id)]
    model: String,
    /// Form of the table
    #[arg(long = "as", value_name = "FORM")]
    form: Form,
    /// Separations from A to B, in N nodes at equal distances
    #[arg(long, value_name = "A:B[:N]", value_parser = range)]
    range: Span,
    /// Unit of the separations
    #[arg(long = "separation-unit", value_name = "UNIT", default_value = "sigma")]
    unit: SeparationUnit,
    /// Add nodes until no interpolated pressure is off by more than this, relatively
    #[arg(long, value_name = "X", value_parser = positive_number)]
    max_error: Option<f64>,
    /// Write to a file in place of the standard output
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Form {
    /// Clearance, pressure and stiffness, for cubics.
    Csv,
    /// Pressure and overclosure, for straight lines.
    Abaqus,
}

impl Export {
    pub fn run(self) -> Result<()> {
        if self.range.count.is_none() && self.max_error.is_none() {
            let text = "--range A:B needs --max-error, or a number of nodes: A:B:N";
            crate::usage_error("export", ErrorKind::MissingRequiredArgument, text);
        }
        let scene = LoadedScene::load(&self.scene.scene)?;
        let (id, model) = scene.model(&self.model)?;
        let ends = scene.request(&[self.range.first, self.range.last], self.unit).separations;
        let range = (ends[0], ends[1], self.range.count.unwrap_or(2));
        let interpolation = match self.form {
            Form::Csv => Interpolation::Hermite,
            Form::Abaqus => Interpolation::Linear,
        };
        let progress = Progress::new("nodes", 0);
        let (contact, tolerance) = (scene.scene(), Tolerance::default());
        let table = match self.max_error {
            Some(error) => {
                ContactTable::within(&model, contact, tolerance, range, error, interpolation)
            }
            None => ContactTable::even(&model, contact, tolerance, range, interpolation),
        };
        drop(progress);
        let table = table.with_context(|| format!("{}: {id}", self.scene.scene.display()))?;
        let title = format!("asperity {}, model {id}", env!("CARGO_PKG_VERSION"));
        output::write(self.output.as_deref(), |out| match self.form {
            Form::Csv => csv(&table, &scene, &title, out),
            Form::Abaqus => abaqus(&table, &scene, &title, out),
        })
    }
}

fn csv(
    table: &ContactTable,
    scene: &LoadedScene,
    title: &str,
    out: &mut dyn Write,
) -> io::Result<()> {
    writeln!(out, "# {title}: contact pressure against clearance")?;
    writeln!(out, "# clearance is the separation from {}", scene.datum())?;
    writeln!(
        out,
        "# stiffness is -dp/dclearance: cubics through both (Hermite) are continuous with"
    )?;
    writeln!(out, "# their slope and fall all the way")?;
    writeln!(
        out,
        "# interpolation error, measured at 7 points between any two of {} nodes: pressure {}, stiffness {} (relative)",
        table.nodes.len(),
        rounded(table.pressure_error),
        rounded(table.stiffness_error)
    )?;
    writeln!(out, "clearance_m,pressure_pa,stiffness_pa_per_m")?;
    let places = scene.found(&table.nodes.iter().map(|n| n.separation).collect::<Vec<_>>());
    for (node, metres) in table.nodes.iter().zip(&places.metres) {
        writeln!(out, "{},{},{}", exact(*metres), exact(node.pressure), exact(node.stiffness))?;
    }
    Ok(())
}

fn abaqus(
    table: &ContactTable,
    scene: &LoadedScene,
    title: &str,
    out: &mut dyn Write,
) -> io::Result<()> {
    writeln!(out, "** {title}: contact pressure against overclosure, in Pa and m")?;
    writeln!(out, "** overclosure = -(separation from {})", scene.datum())?;
    writeln!(
        out,
        "** so that a negative overclosure is a clearance and 0 is where the nominal surfaces meet"
    )?;
    writeln!(
        out,
        "** straight lines between {} nodes: largest relative error {} of the pressure, {} of its slope,",
        table.nodes.len(),
        rounded(table.pressure_error),
        rounded(table.stiffness_error)
    )?;
    writeln!(out, "** measured at 7 points between any two; the slope jumps at the nodes")?;
    writeln!(
        out,
        "** the first pair is where the tangent of the second reaches 0: the model's pressure there,"
    )?;
    writeln!(
        out,
        "** below that of the second pair, is left out; beyond the last pair the last slope goes on"
    )?;
    writeln!(out, "** to be included after *SURFACE INTERACTION, NAME=...")?;
    writeln!(out, "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR")?;
    let end = table.cut_off().map(|separation| (separation, 0.0));
    let nodes = table.nodes.iter().rev().map(|node| (node.separation, node.pressure));
    let (separations, pressures): (Vec<f64>, Vec<f64>) = end.into_iter().chain(nodes).unzip();
    for (metres, pressure) in scene.found(&separations).metres.iter().zip(pressures) {
        writeln!(out, "{}, {}", exact(pressure), exact(-metres))?;
    }
    Ok(())
}
