//! `asperity curve`: quantities against separation or load.

use anyhow::Result;
use asperity::{Quantity, linspace};
use clap::Args;

use crate::ask::Question;
use crate::input::args::{DrawnArgs, ModelArgs};
use crate::output::plot;
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
first on approach; a tension (dmt, jkr) has its stable separation, the smallest. Values that do not exist are blank; a message gives the reason.
Stiffness: tangent (-dF/dd) describes first loading and is what a solver needs;
unloading-stiffness (2 E times the sum of the contact radii, larger where asperities
yield) describes small vibrations, ultrasound and modal tests; tangential-stiffness
describes shear without slip.
Conductances are of the whole area, or with -per-area per nominal area.
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
  asperity curve scene.toml --model jg --separation 1um,2um --errors
  asperity curve scene.toml --model ke --pressure 1e6,1e7,1e8 --corrected"
)]
pub struct Curve {
    #[command(flatten)]
    asked: ModelArgs,
    /// Add a column <quantity>_error with a bound on the relative error of each quantity (on the
    /// absolute error for logarithms and shares)
    #[arg(long)]
    errors: bool,
    /// Add rows divided by the ratio to boundary elements that is expected from solved surfaces,
    /// with columns <quantity>_lower and _upper, also for the separation; at loads only
    #[arg(long, conflicts_with = "errors")]
    corrected: bool,
    #[command(flatten)]
    output: DrawnArgs,
}

impl Curve {
    pub fn run(self) -> Result<()> {
        self.output.check("curve");
        let scene = LoadedScene::load_for(&self.asked.scene, &self.asked.models)?;
        let request = self.asked.request(&scene.file, &linspace(0.0, 4.0, 401), &USUAL);
        let models = scene.models(&self.asked.models, &request.quantities)?;
        let mut question = Question::new(&scene, request);
        question.at_defaults = self.asked.is_nowhere();
        let table = match self.corrected {
            true => question.corrected(&models)?,
            false => question.table(&models, self.errors)?,
        };
        self.output
            .write(&table, || plot::svg(&table, &question.request, scene.file.separation_from))
    }
}
