//! The largest tension of surfaces with adhesion: `curve --pull-off`, and the hidden command
//! `pull-off`.

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
#[command(name = "pull-off")]
pub struct PullOff {
    /// Scene file; `asperity init` writes an example
    #[arg(value_name = "SCENE")]
    pub scene: PathBuf,
    /// Models with adhesion
    #[arg(long = "model", value_name = "M", value_delimiter = ',', value_parser = model_id)]
    #[arg(default_value = "dmt,jkr-separation")]
    pub models: Vec<String>,
    /// Work of adhesion in J/m^2, or with a unit, for example 50mJ/m2, instead of the scene's
    #[arg(long, value_name = "W", value_parser = work)]
    pub work_of_adhesion: Option<f64>,
    /// Relative tolerance of every value, from 1e-15 to 0.1
    #[arg(long, value_name = "T", value_parser = tolerance, default_value = "1e-10")]
    pub tolerance: Tolerance,
    #[command(flatten)]
    pub output: OutputArgs,
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

/// A work of adhesion.
pub fn work(text: &str) -> Result<f64, String> {
    of_unit(text, "J/m^2").and_then(positive)
}
