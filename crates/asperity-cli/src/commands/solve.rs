//! `asperity solve`: separations at given loads.

use anyhow::Result;
use clap::{ArgGroup, Args};

use crate::ask::Question;
use crate::commands::curve::USUAL;
use crate::input::args::{ModelArgs, OutputArgs};
use crate::scene::LoadedScene;

/// Find the separations that carry a load, and the quantities there
#[derive(Debug, Args)]
#[command(
    group(ArgGroup::new("given").required(true)),
    mut_arg("separations", |arg| arg.hide(true)),
    mut_arg("unit", |arg| arg.hide(true)),
    mut_arg("format", |arg| arg.default_value("csv")),
    after_help = "Columns: model, load_N, pressure_Pa, separation_over_sigma, separation_m, then
the quantities (default: area and tangent) with their units.
Where the force does not fall steadily with the separation (at, jg), several
separations may carry one load. The result has the largest, which is the first on
approach; --all gives each its row, the smallest first.

Examples:
  asperity solve scene.toml --model ke --load 100
  asperity solve scene.toml --model at --load 0.1,1,10 --all
  asperity solve scene.toml --model gw,ke --pressure 1e5,1e6,1e7 --quantity area-fraction,tangent"
)]
pub struct Solve {
    #[command(flatten)]
    asked: ModelArgs,
    /// Give every separation that carries the load, instead of the largest alone
    #[arg(long)]
    all: bool,
    /// Add a column <quantity>_error with a bound on the error of each quantity
    #[arg(long)]
    errors: bool,
    /// Add rows divided by the ratio to boundary elements that is expected from solved surfaces,
    /// with columns <quantity>_lower and _upper, also for the separation
    #[arg(long, conflicts_with_all = ["errors", "all"])]
    corrected: bool,
    #[command(flatten)]
    output: OutputArgs,
}

impl Solve {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::load_for(&self.asked.scene, &self.asked.models)?;
        let request = self.asked.request(&scene.file, &[], &USUAL);
        let models = scene.models(&self.asked.models, &request.quantities)?;
        let mut question = Question::new(&scene, request);
        question.all = self.all;
        let table = match self.corrected {
            true => question.corrected(&models)?,
            false => question.table(&models, self.errors)?,
        };
        self.output.write(&table)
    }
}
