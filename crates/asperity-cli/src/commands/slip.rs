//! `asperity slip`: tangential force against shift.

use anyhow::{Context, Result};
use asperity::joints::{PartialSlip, UnloadingLaw};
use asperity::linspace;
use clap::Args;
use clap::builder::RangedU64ValueParser;

use crate::args::{Closed, OutputArgs};
use crate::numbers::positive_number;
use crate::output::say;
use crate::table::{Cell, Table};

/// Tangential force against shift: from virgin, and in a steady cycle
#[derive(Debug, Args)]
#[command(
    mut_arg("format", |arg| arg.default_value("csv")),
    after_help = "The separation stays what it is. Columns: model, shift_m, force_N at a first shift
(blank below 0), back_N and forth_N in a steady cycle between -amplitude and
+amplitude (Masing). The energy lost in a cycle is said beside the data.
Partial slip of every asperity (Cattaneo, Mindlin), which answers as elastically as in
unloading by --law: exact for gw; for models that yield, at constant normal load on each.
Needs equivalent_shear_modulus, or the bodies. Models of upright asperities only.

Examples:
  asperity slip scene.toml --model gw --friction 0.2 --pressure 5e6 --amplitude 1e-7
  asperity slip scene.toml --model ke --friction 0.3 --closest 2 --amplitude 1e-6 --points 11 --format table"
)]
pub struct Slip {
    #[command(flatten)]
    closed: Closed,
    /// How the asperities answer, as in unloading by hertz, brake or etsion
    #[arg(long, value_name = "LAW", default_value = "hertz")]
    law: UnloadingLaw,
    /// Coefficient of friction
    #[arg(long, value_name = "MU", value_parser = positive_number)]
    friction: f64,
    /// Largest shift, in m
    #[arg(long, value_name = "M", value_parser = positive_number)]
    amplitude: f64,
    /// Shifts from -amplitude to +amplitude
    #[arg(long, value_name = "N", default_value = "101")]
    #[arg(value_parser = RangedU64ValueParser::<usize>::new().range(2..=100_000))]
    points: usize,
    #[command(flatten)]
    output: OutputArgs,
}

impl Slip {
    pub fn run(self) -> Result<()> {
        let (scene, id, joint) = self.closed.joint(self.law)?;
        let named = || format!("{}: {id}", scene.name);
        let slip = PartialSlip::new(&joint, self.friction).with_context(named)?;
        let mut table = Table::new(&["model", "shift_m", "force_N", "back_N", "forth_N"]);
        for shift in linspace(-self.amplitude, self.amplitude, self.points) {
            let force = if shift < 0.0 { None } else { Some(slip.force(shift)?.value()) };
            let [back, forth] = [false, true].map(|f| slip.loop_force(shift, self.amplitude, f));
            let numbers = [Some(shift), force, Some(back?), Some(forth?)];
            let mut row = vec![Cell::from(&*id)];
            row.extend(numbers.map(Cell::Number));
            table.rows.push(row);
        }
        let loss = slip.loss(self.amplitude).with_context(named)?.value();
        say("note", &format!("{id}: a cycle of this amplitude loses {loss:e} J"));
        self.output.write(&table)
    }
}
