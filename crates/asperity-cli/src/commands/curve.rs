//! `asperity curve`: quantities against separation or load, and its forms `solve`, `compare` and
//! `plan`.

use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use asperity::{At, ContactModel, Quantity, linspace};
use asperity_answer::{Beside, Inquiry, Sheet};
use clap::{ArgGroup, Args};

use crate::commands::pull_off::{PullOff, work};
use crate::input::args::{DrawnArgs, ModelArgs, OutputArgs, model_id};
use crate::output::{self, Terminal, plot};
use crate::scene::LoadedScene;

/// The default quantities.
pub const USUAL: [Quantity; 3] = [Quantity::Force, Quantity::Area, Quantity::Tangent];

/// Tabulate or plot quantities against separation, load or pressure
#[derive(Debug, Args)]
#[command(
    mut_arg("format", |arg| arg.default_value("csv")),
    after_help = "Columns: model, load_N and pressure_Pa at loads, separation_over_sigma,
separation_m, then the quantities with their units: force_N, area_m2.
Where several separations carry a load (jg, at), the largest is used, which is the
first on approach, or --all give each its row, the smallest first; a tension (dmt, jkr) has
its stable separation, the smallest. Values that do not exist are blank; a message gives the
reason.
Stiffness: tangent (-dF/dd) describes first loading and is what a solver needs;
unloading-stiffness (2 E times the sum of the contact radii, larger where asperities
yield) describes small vibrations, ultrasound and modal tests; tangential-stiffness
describes shear without slip.
With --pull-off, force_N and pressure_Pa are below 0, or blank where there is no tension;
jkr means jkr-separation then, the branch on which surfaces separate. dmt is for small,
hard asperities (tabor_parameter below 0.1), jkr for large, soft ones (above 5); `asperity
check` prints the tabor_parameter.
Conductances are of the whole area, or with -per-area per nominal area.
With --reference, deviations are relative to that model (differences for logarithms and
shares), and 0 where two values differ by less than their error bounds. At a load, each
model has its own separation.
With --corrected each model has two sets of rows: ke, as it is, and ke-corrected with the
intervals, which hold nine of ten surfaces; quantities and loads without evidence are
blank there, and a message gives the reason.
Default: force, area and tangent (at loads without the force) at separations of
0:4:401 in units of asperity_height_std.

Examples:
  asperity curve scene.toml --format table --model gw,ke --separation -1:4:6
  asperity curve scene.toml --quantity mean-pressure --output curve.csv --plot curve.svg
  asperity curve scene.toml --model ke --load 1:1000:50:log --output loads.csv --plot loads.svg
  asperity curve scene.toml --model ke --load 1kN --quantity tangent,unloading-stiffness
  asperity curve scene.toml --model at --load 0.1,1,10 --all
  asperity curve scene.toml --reference jg --load 10,100 --quantity area,mean-pressure
  asperity curve scene.toml --model jg --separation 1um,2um --errors
  asperity curve scene.toml --model ke --pressure 1e6,1e7,1e8 --corrected
  asperity curve scene.toml --pull-off --work-of-adhesion 50mJ/m2 --format table
  asperity curve scene.toml --plan --model ke --load 10:1000:50"
)]
pub struct Curve {
    #[command(flatten)]
    asked: ModelArgs,
    #[command(flatten)]
    beside: BesideArgs,
    /// Add a column <quantity>_deviation relative to this model
    #[arg(long, value_name = "M", value_parser = model_id)]
    #[arg(conflicts_with_all = ["errors", "corrected", "all"])]
    reference: Option<String>,
    /// Print how the values are computed instead: the integrals, their number of terms, and the
    /// terms left out
    #[arg(long, conflicts_with_all = ["errors", "corrected", "all", "reference"])]
    plan: bool,
    /// Print the largest tension of models with adhesion instead (dmt and jkr-separation, if none
    /// is named), and its separation
    #[arg(long, conflicts_with_all = ["errors", "corrected", "all", "reference", "plan", "given"])]
    #[arg(conflicts_with_all = ["separations", "quantities", "plot"])]
    pull_off: bool,
    /// Work of adhesion in J/m^2, or with a unit, for example 50mJ/m2, instead of the scene's
    #[arg(long, value_name = "W", value_parser = work, requires = "pull_off")]
    work_of_adhesion: Option<f64>,
    #[command(flatten)]
    output: DrawnArgs,
}

/// What stands beside the quantities.
#[derive(Debug, Args)]
struct BesideArgs {
    /// Give every separation that carries the load, instead of the largest alone
    #[arg(long)]
    all: bool,
    /// Add a column <quantity>_error with a bound on the relative error of each quantity (on the
    /// absolute error for logarithms and shares)
    #[arg(long)]
    errors: bool,
    /// Add rows divided by the ratio to boundary elements that is expected from solved surfaces,
    /// with columns <quantity>_lower and _upper, also for the separation; at loads only
    #[arg(long, conflicts_with_all = ["errors", "all"])]
    corrected: bool,
}

impl Curve {
    pub fn run(self) -> Result<()> {
        if self.plan {
            let output = self.output.output.output;
            return Plan { asked: self.asked, output }.run();
        }
        if self.pull_off {
            return self.pull_off();
        }
        self.output.check("curve");
        let scene = LoadedScene::load_for(&self.asked.scene, &self.asked.models)?;
        let reference = self.reference.as_deref().map(Some);
        let separations = linspace(0.0, 4.0, 401);
        let (sheet, inquiry) = answer(&scene, &self.asked, &separations, self.beside, reference)?;
        self.output
            .write(&sheet, || plot::svg(&sheet, &inquiry.request, scene.file.separation_from))
    }
}

impl Curve {
    /// Writes the largest tension.
    fn pull_off(self) -> Result<()> {
        let ModelArgs { scene, models, tolerance, .. } = self.asked;
        let adhesive = || ["dmt", "jkr-separation"].map(String::from).into();
        let models = if models.is_empty() { adhesive() } else { models };
        let (work_of_adhesion, output) = (self.work_of_adhesion, self.output.output);
        PullOff { scene, models, work_of_adhesion, tolerance, output }.run()
    }
}

/// Find the separations that carry a load, and the quantities there: `curve --load`
#[derive(Debug, Args)]
#[command(
    hide = true,
    group(ArgGroup::new("given").required(true)),
    mut_arg("separations", |arg| arg.hide(true)),
    mut_arg("unit", |arg| arg.hide(true)),
    mut_arg("format", |arg| arg.default_value("csv"))
)]
pub struct Solve {
    #[command(flatten)]
    asked: ModelArgs,
    #[command(flatten)]
    beside: BesideArgs,
    #[command(flatten)]
    output: OutputArgs,
}

impl Solve {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::load_for(&self.asked.scene, &self.asked.models)?;
        let (sheet, _) = answer(&scene, &self.asked, &[], self.beside, None)?;
        self.output.write(&sheet)
    }
}

/// Models beside a reference at one separation, or at loads: `curve --reference`
#[derive(Debug, Args)]
#[command(hide = true)]
pub struct Compare {
    #[command(flatten)]
    asked: ModelArgs,
    /// Reference model [default: ke; gw without a hardness]
    #[arg(long, value_name = "M", value_parser = model_id)]
    reference: Option<String>,
    #[command(flatten)]
    output: OutputArgs,
}

impl Compare {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::load(&self.asked.scene)?;
        let beside = BesideArgs { all: false, errors: false, corrected: false };
        let reference = Some(self.reference.as_deref());
        let (sheet, _) = answer(&scene, &self.asked, &[2.0], beside, reference)?;
        self.output.write(&sheet)
    }
}

/// How a result is computed: `curve --plan`
#[derive(Debug, Args)]
#[command(hide = true)]
pub struct Plan {
    #[command(flatten)]
    asked: ModelArgs,
    /// Write to this file, which is overwritten, instead of standard output
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Plan {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::load(&self.asked.scene)?;
        let request = self.asked.request(&scene.file, &linspace(0.0, 4.0, 401), &USUAL);
        let mut plans = String::new();
        for (id, model) in scene.models(&self.asked.models, &request.quantities)? {
            let plan = model.compile(&scene.file.scene, &request).and_then(|c| c.plan(&request));
            plans += &plan.with_context(|| format!("{}: {id}", scene.name))?.to_string();
        }
        output::write_text(self.output.as_deref(), &plans)
    }
}

/// The sheet of an inquiry, at these separations if none is given, and beside a reference if there
/// is one, the usual unless it is named.
fn answer<'s>(
    scene: &'s LoadedScene,
    asked: &ModelArgs,
    separations: &[f64],
    BesideArgs { all, errors, corrected }: BesideArgs,
    reference: Option<Option<&str>>,
) -> Result<(Sheet, Inquiry<'s>)> {
    let file = &scene.file;
    let request = asked.request(file, separations, &USUAL);
    scene.answer(|sheet| {
        let reference = reference.map(|id| asperity_answer::reference(file, id, sheet));
        let reference = reference.transpose()?;
        let models = asperity_answer::models(file, &asked.models, &request.quantities, sheet)?;
        if corrected && request.at.iter().any(|at| matches!(at, At::Separation(_))) {
            bail!(
                "--corrected needs --load or --pressure: models are compared with boundary elements at equal loads"
            );
        }
        let beside = match reference {
            Some(reference) => Beside::Deviations(reference),
            None if corrected => Beside::Intervals,
            None if errors => Beside::Errors,
            None => Beside::Nothing,
        };
        let at_defaults = asked.is_nowhere();
        let inquiry = Inquiry { beside, all, at_defaults, ..Inquiry::new(file, models, request) };
        inquiry.answer(sheet, &Terminal::default())?;
        Ok(inquiry)
    })
}
