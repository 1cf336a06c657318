//! `asperity pull-off`: the largest tension of surfaces with adhesion.

use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use asperity::{
    ContactModel, Quantity, Request, Scene, SeparationUnit, Tolerance, pull_off, short,
};
use clap::Args;

use crate::input::args::{OutputArgs, model_id, tolerance};
use crate::input::numbers::{of_unit, positive};
use crate::output::number::rounded;
use crate::output::table::{Cell, Table};
use crate::output::{once, print_message};
use crate::scene::LoadedScene;

/// Largest tension of surfaces with adhesion, and its separation
#[derive(Debug, Args)]
#[command(
    name = "pull-off",
    after_help = "Columns: model, force_N and pressure_Pa (below 0), separation_over_sigma and
separation_m there. Blank if there is no tensile force; a note gives the
reason. jkr means jkr-separation here, the branch on which surfaces separate: contacts
stay in contact beyond 0. dmt is for small, hard asperities (tabor_parameter below 0.1),
jkr for large, soft ones (above 5); `asperity check` prints the tabor_parameter.

Examples:
  asperity pull-off scene.toml --work-of-adhesion 50mJ/m2
  asperity pull-off scene.toml --work-of-adhesion 0.05 --model jkr --format csv"
)]
pub struct PullOff {
    /// Scene file; `asperity init` writes an example
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Models with adhesion
    #[arg(long = "model", value_name = "M", value_delimiter = ',', value_parser = model_id)]
    #[arg(default_value = "dmt,jkr-separation")]
    models: Vec<String>,
    /// Work of adhesion in J/m^2, or with a unit, for example 50mJ/m2, instead of the scene's
    #[arg(long, value_name = "W", value_parser = work)]
    work_of_adhesion: Option<f64>,
    /// Relative tolerance of every value, from 1e-15 to 0.1
    #[arg(long, value_name = "T", value_parser = tolerance, default_value = "1e-10")]
    tolerance: Tolerance,
    #[command(flatten)]
    output: OutputArgs,
}

impl PullOff {
    pub fn run(self) -> Result<()> {
        let mut scene = LoadedScene::read(&self.scene)?;
        let work = &mut scene.file.scene.interface.work_of_adhesion;
        *work = self.work_of_adhesion.or(*work);
        if work.is_none() {
            let how = "set it in the scene, or use --work-of-adhesion 50mJ/m2";
            bail!("{}: work_of_adhesion is missing: {how}", scene.name);
        }
        // The report includes the given work of adhesion.
        scene.report_scene();
        let (contact, from) = (&scene.file.scene, scene.file.separation_from);
        let parting = |id: &String| if id == "jkr" { "jkr-separation".into() } else { id.clone() };
        let ids: Vec<String> = self.models.iter().map(parting).collect();
        let head = ["model", "force_N", "pressure_Pa", "separation_over_sigma", "separation_m"];
        let mut table = Table::new(&head);
        scene.note_adhesion();
        for id in once(&ids) {
            let named = scene.model(&id)?;
            let model = &named.1;
            if !model.validity().adhesive {
                bail!("{id} has no adhesion; use dmt, jkr or jkr-separation");
            }
            let context = || format!("{}: {id}", scene.name);
            let asked = [Quantity::Force, Quantity::Tangent];
            let request = Request::new(asked).within(self.tolerance);
            let compiled = model.compile(contact, &request).with_context(context)?;
            let mut row = vec![Cell::from(&*id)];
            match pull_off(&*compiled).with_context(context)? {
                None => {
                    row.extend([const { Cell::Number(None) }; 4]);
                    print_message("note", &format!("{id}: no pull-off force{}", hidden(contact)));
                }
                Some(found) => {
                    scene.report_answers(&[&named], &[found.separation.into()]);
                    let place = |unit| Ok(found.separation.measured_in(unit, from, contact)?.value);
                    let place: Result<Vec<f64>> = [SeparationUnit::Sigma, SeparationUnit::Metres]
                        .into_iter()
                        .map(place)
                        .collect();
                    let force = found.force.value();
                    note_reduction(&id, force, contact);
                    row.extend(
                        [force, force / contact.nominal_area].map(|x| Cell::Number(Some(x))),
                    );
                    row.extend(place?.into_iter().map(|x| Cell::Number(Some(x))));
                }
            }
            table.rows.push(row);
        }
        self.output.write(&table)
    }
}

/// Tension \[% of that of asperities of equal height\] below which there is practically none.
const SMALLEST: f64 = 1e-6;

/// Notes the tension relative to that of asperities of equal height.
fn note_reduction(id: &str, force: f64, scene: &Scene) {
    // Pull-off force of one asperity in units of pi R w_a.
    let single = match id {
        "jkr-separation" => 1.5,
        "dmt" => 2.0,
        _ => return,
    };
    let Some(work) = scene.interface.work_of_adhesion else { return };
    let single = single * std::f64::consts::PI * scene.surface.asperity_radius * work;
    let percent = -100.0 * force / (scene.asperities() * single);
    if percent < SMALLEST {
        let text = format!("{id}: practically no pull-off force{}", hidden(scene));
        return print_message("note", &text);
    }
    let percent = rounded(percent);
    print_message(
        "note",
        &format!(
            "{id}: roughness reduces the tension to {percent} % of that of asperities of equal height"
        ),
    );
}

/// Why there is no pull-off force.
fn hidden(scene: &Scene) -> String {
    scene.adhesion_parameter().map_or(String::new(), |theta| {
        format!(": adhesion_parameter is {}, and above 10 roughness hides adhesion", short(theta))
    })
}

fn work(text: &str) -> Result<f64, String> {
    of_unit(text, "J/m^2").and_then(positive)
}
