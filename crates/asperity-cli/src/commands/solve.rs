//! `asperity solve`: from loads to separations.

use anyhow::Result;
use clap::{ArgGroup, Args};

use crate::ask::Question;
use crate::commands::curve::USUAL;
use crate::input::args::{Asked, OutputArgs};
use crate::scene::LoadedScene;

/// The separations that carry a load, and the quantities there
#[derive(Debug, Args)]
#[command(
    group(ArgGroup::new("given").required(true)),
    mut_arg("separations", |arg| arg.hide(true)),
    mut_arg("unit", |arg| arg.hide(true)),
    mut_arg("format", |arg| arg.default_value("csv")),
    after_help = "Columns: model, load_N, pressure_Pa, separation_over_sigma, separation_m, then
the quantities as asked (area and tangent unless given), with their units.
A model whose force rises and falls (at, jg) may have several separations for
one load. The largest is given, where the surfaces first meet the load; with
--all each is a row, the smallest first.

Examples:
  asperity solve scene.toml --model ke --load 100
  asperity solve scene.toml --model at --load 0.1,1,10 --all
  asperity solve scene.toml --model gw,ke --pressure 1e5,1e6,1e7 --quantity area-fraction,tangent"
)]
pub struct Solve {
    #[command(flatten)]
    asked: Asked,
    /// Every separation that carries a load, and not just the largest
    #[arg(long)]
    all: bool,
    /// Add a column <quantity>_error for each: a bound on the error
    #[arg(long)]
    errors: bool,
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
        self.output.write(&question.table(&models, self.errors)?)
    }
}
