//! `asperity unload`: back from the closest approach.

use anyhow::{Context, Result};
use asperity::joints::UnloadingLaw;
use asperity::{Evaluation, SeparationUnit};
use asperity_plot::{Axis, Curve};
use clap::Args;

use crate::args::{Closed, DrawnArgs};
use crate::numbers::Numbers;
use crate::plot;
use crate::table::{Cell, Table};

/// Force, area and stiffness as a joint opens again
#[derive(Debug, Args)]
#[command(
    mut_arg("format", |arg| arg.default_value("csv")),
    after_help = "The joint has been closed for the first time as far as --closest, --load or
--pressure says, and goes back by the retreats. Columns: model, law, retreat_m,
separation_over_sigma, force_N, area_m2 (not by etsion), stiffness_N_per_m (-dF/dd).
hertz: as a Hertzian contact of the force and area at the closest approach; brake:
Brake 2015, whose area jumps at the start; etsion: Etsion, Kligerman & Kadin 2005.
Coming closer again retraces these curves, and then follows the virgin one. Models of
upright asperities with circular contacts only.

Examples:
  asperity unload scene.toml --model ke --closest 1 --retreat 0:0.5:6 --format table
  asperity unload scene.toml --model zmc --law etsion --load 100 --retreat 0:1e-7:11 --retreat-unit m
  asperity unload scene.toml --model ke --pressure 5e6 --retreat 0:2:81 --output back.csv --plot back.svg"
)]
pub struct Unload {
    #[command(flatten)]
    closed: Closed,
    /// How the asperities come back, hertz, brake or etsion
    #[arg(long, value_name = "LAW", default_value = "hertz")]
    law: UnloadingLaw,
    /// How far the joint opens from its closest approach
    #[arg(long, value_name = "A:B:N[:log]|v,v", required = true)]
    retreat: Numbers,
    /// Unit of the retreats, sigma (of the asperity heights) or m
    #[arg(long = "retreat-unit", value_name = "UNIT", value_parser = crate::args::separation_unit)]
    #[arg(default_value = "sigma")]
    unit: SeparationUnit,
    #[command(flatten)]
    output: DrawnArgs,
}

impl Unload {
    pub fn run(self) -> Result<()> {
        self.output.check("unload");
        let (scene, id, joint) = self.closed.joint(self.law)?;
        let sigma = scene.file.scene.surface.asperity_height_std;
        let head = [
            "model",
            "law",
            "retreat_m",
            "separation_over_sigma",
            "force_N",
            "area_m2",
            "stiffness_N_per_m",
        ];
        let with_area = self.law != UnloadingLaw::Etsion;
        let mut table = Table::new(
            &head
                .map(|name| (with_area || name != "area_m2").then_some(name))
                .into_iter()
                .flatten()
                .collect::<Vec<_>>(),
        );
        let from = scene.file.separation_from;
        let closest = joint.closest().measured_in(SeparationUnit::Sigma, from, joint.scene())?;
        for retreat in self.retreat.0 {
            let metres = if self.unit == SeparationUnit::Sigma { retreat * sigma } else { retreat };
            let of = |found: Result<Evaluation, _>| {
                let found = found.with_context(|| format!("{}: {id}", scene.name))?;
                anyhow::Ok(Cell::Number(Some(found.value())))
            };
            let place = [metres, closest.value + metres / sigma].map(|x| Cell::Number(Some(x)));
            let mut row = vec![Cell::from(&*id), Cell::from(&*self.law.to_string())];
            row.extend(place);
            row.push(of(joint.force(metres))?);
            if with_area {
                row.push(of(joint.area(metres))?);
            }
            row.push(of(joint.stiffness(metres))?);
            table.rows.push(row);
        }
        self.output.write(&table, || {
            let x = Axis::new("retreat_m", "retreat (µm)").times(1e6);
            let columns = [
                ("force_N", "force (N)"),
                ("area_m2", "area (m²)"),
                ("stiffness_N_per_m", "stiffness (N/m)"),
            ];
            let curves = [Curve::new(0, &id, &format!("{id}, back by {}", self.law))];
            plot::against(&table, &x, &columns[..], &curves)
        })
    }
}
