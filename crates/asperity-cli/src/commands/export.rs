//! `asperity export`: contact tables for finite-element codes.

use std::path::PathBuf;

use anyhow::{Context, Result};
use asperity::{
    At, ContactTable, Datum, Interpolation, Scene, Separation, SeparationUnit, Tolerance,
};
use clap::error::ErrorKind;
use clap::{Args, ValueEnum};

use crate::args::{model_id, separation_unit};
use crate::number::{exact, rounded};
use crate::numbers::{Span, positive_number, range};
use crate::output::{self, progress};
use crate::scene::LoadedScene;

/// Pressure against clearance as a table for a finite-element code
#[derive(Debug, Args)]
#[command(
    after_help = "csv holds the pressure and its tangent (its exact slope) at every node. Read as
cubics (Hermite), both are continuous, as Newton's method needs.
abaqus holds *SURFACE BEHAVIOR with pairs of pressure and overclosure, which the
code joins by straight lines.
Both state the interpolation error, measured between the nodes; --max-error adds
nodes until it is met. The N nodes of A:B:N are at equal distances of clearance.

Examples:
  asperity export scene.toml --model ke --as csv --separation 0:4:41
  asperity export scene.toml --model ke --as csv --pressure 1e4:1e7 --max-error 1e-3
  asperity export scene.toml --model ke --as abaqus --load 1:1e4 --max-error 1e-3 --output ke.inp"
)]
pub struct Export {
    /// Scene file; `asperity init` writes one to start from
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// The model; `asperity models` lists them
    #[arg(long, value_name = "M", value_parser = model_id)]
    model: String,
    /// Form of the table
    #[arg(long = "as", value_name = "FORM")]
    form: Form,
    #[command(flatten)]
    ends: Ends,
    /// Unit of the separations, sigma (of the asperity heights) or m
    #[arg(long = "separation-unit", value_name = "UNIT", value_parser = separation_unit)]
    #[arg(default_value = "sigma", requires = "separation")]
    #[arg(conflicts_with_all = ["load", "pressure"])]
    unit: SeparationUnit,
    /// Add nodes until no interpolated pressure is off by more than this, relatively
    #[arg(long, value_name = "X", value_parser = positive_number)]
    max_error: Option<f64>,
    /// Write to a file in place of the standard output
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// The range of the table, in one of three ways.
#[derive(Debug, Args)]
#[group(required = true, multiple = false)]
struct Ends {
    /// From one separation to another, in N nodes
    #[arg(long, value_name = "A:B[:N]", value_parser = range)]
    separation: Option<Span>,
    /// From one load to another, in N
    #[arg(long, value_name = "A:B[:N]", value_parser = range)]
    load: Option<Span>,
    /// From one pressure on the nominal area to another, in Pa
    #[arg(long, value_name = "A:B[:N]", value_parser = range)]
    pressure: Option<Span>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Form {
    /// Clearance, pressure and tangent, for cubics.
    Csv,
    /// Pressure and overclosure, for straight lines.
    Abaqus,
}

impl Export {
    pub fn run(self) -> Result<()> {
        let Ends { separation, load, pressure } = self.ends;
        let span = separation.or(load).or(pressure).context("a range was required")?;
        if span.count.is_none() && self.max_error.is_none() {
            let text = "A:B needs --max-error, or a number of nodes: A:B:N";
            crate::usage_error("export", ErrorKind::MissingRequiredArgument, text);
        }
        let scene = LoadedScene::load(&self.scene)?;
        let (id, model) = scene.model(&self.model)?;
        let contact = &scene.file.scene;
        let place = |value| match (separation, load) {
            (Some(_), _) => scene.file.separation(value, self.unit).into(),
            (_, Some(_)) => At::Load(value),
            _ => At::Pressure(value),
        };
        let range = (place(span.first), place(span.last), span.count.unwrap_or(2));
        let (write, interpolation): (Writer, _) = match self.form {
            Form::Csv => (csv, Interpolation::Hermite),
            Form::Abaqus => (abaqus, Interpolation::Linear),
        };
        let (working, tolerance) = (progress("nodes"), Tolerance::default());
        let table = match self.max_error {
            Some(error) => {
                ContactTable::within(&model, contact, tolerance, range, error, interpolation)
            }
            None => ContactTable::even(&model, contact, tolerance, range, interpolation),
        };
        drop(working);
        let table = table.with_context(|| format!("{}: {id}", scene.name))?;
        let title = format!("asperity {}, model {id}", env!("CARGO_PKG_VERSION"));
        let text = write(&table, contact, scene.file.separation_from, &title)?;
        output::write_text(self.output.as_deref(), &text)
    }
}

type Writer = fn(&ContactTable, &Scene, Datum, &str) -> Result<String>;

/// A separation of a table in metres, from the scene's own plane.
fn metres(sigmas: f64, scene: &Scene, from: Datum) -> Result<f64> {
    Ok(Separation::sigmas(sigmas).measured_in(SeparationUnit::Metres, from, scene)?.value)
}

fn csv(table: &ContactTable, scene: &Scene, from: Datum, title: &str) -> Result<String> {
    let nodes = table.nodes.len();
    let [pressure, slope] = [table.pressure_error, table.stiffness_error].map(rounded);
    let mut text = format!(
        "# {title}: contact pressure against clearance
# clearance is the separation from {from}
# tangent is -dp/dclearance: cubics through both (Hermite) are continuous with
# their slope and fall all the way
# interpolation error, measured at 7 points between any two of {nodes} nodes: pressure {pressure}, tangent {slope} (relative)
clearance_m,pressure_Pa,tangent_Pa_per_m
"
    );
    for node in &table.nodes {
        let clearance = metres(node.separation, scene, from)?;
        let [clearance, pressure, tangent] = [clearance, node.pressure, node.stiffness].map(exact);
        text += &format!("{clearance},{pressure},{tangent}\n");
    }
    Ok(text)
}

fn abaqus(table: &ContactTable, scene: &Scene, from: Datum, title: &str) -> Result<String> {
    let nodes = table.nodes.len();
    let [pressure, slope] = [table.pressure_error, table.stiffness_error].map(rounded);
    let mut text = format!(
        "** {title}: contact pressure against overclosure, in Pa and m
** overclosure = -(separation from {from})
** so that a negative overclosure is a clearance and 0 is where the nominal surfaces meet
** straight lines between {nodes} nodes: largest relative error {pressure} of the pressure, {slope} of its slope,
** measured at 7 points between any two; the slope jumps at the nodes
** the first pair is where the tangent of the second reaches 0: the model's pressure there,
** below that of the second pair, is left out; beyond the last pair the last slope goes on
** to be included after *SURFACE INTERACTION, NAME=...
*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR
"
    );
    let end = table.cut_off().map(|separation| (separation, 0.0));
    let nodes = table.nodes.iter().rev().map(|node| (node.separation, node.pressure));
    for (separation, pressure) in end.into_iter().chain(nodes) {
        let overclosure = -metres(separation, scene, from)?;
        text += &format!("{}, {}\n", exact(pressure), exact(overclosure));
    }
    Ok(text)
}
