//! The largest tension of surfaces with adhesion: the hidden command `pull-off`.

use std::path::PathBuf;

use anyhow::{Result, bail};
use asperity::Tolerance;
use asperity_answer::{Sheet, pull_off};
use clap::Args;

use crate::input::args::{OutputArgs, model_id, tolerance};
use crate::input::numbers::{of_unit, positive};
use crate::output::once;
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
        scene.note_adhesion();
        let parting = |id: &String| if id == "jkr" { "jkr-separation".into() } else { id.clone() };
        let ids: Vec<String> = self.models.iter().map(parting).collect();
        let mut models = vec![];
        for id in once(&ids) {
            let named = scene.model(&id)?;
            if !named.1.validity().adhesive {
                bail!("{id} has no adhesion; use dmt, jkr or jkr-separation");
            }
            models.push(named);
        }
        let fill = |sheet: &mut Sheet| Ok(pull_off(&scene.file, &models, self.tolerance, sheet)?);
        self.output.write(&scene.answer(fill)?.0)
    }
}

fn work(text: &str) -> Result<f64, String> {
    of_unit(text, "J/m^2").and_then(positive)
}
