//! `asperity plan`: what would be integrated.

use std::path::PathBuf;

use anyhow::{Context, Result};
use asperity::{Output, Quantity};
use clap::Args;

use crate::args::{ModelArgs, QuantityArgs, SceneArgs, SeparationArgs, once};
use crate::output;
use crate::progress::Progress;
use crate::scene::LoadedScene;

/// What is integrated for an answer, with how many nodes, and what is left out
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  asperity plan scene.toml --model ke --quantity force,tangent
  asperity plan scene.toml --model gw,zmc --separation 0:2:3 --tolerance 1e-6")]
pub struct Plan {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    models: ModelArgs,
    #[command(flatten)]
    quantities: QuantityArgs,
    #[command(flatten)]
    separations: SeparationArgs,
    /// Write to a file in place of the standard output
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Plan {
    pub fn run(self) -> Result<()> {
        let scene = LoadedScene::load(&self.scene.scene)?;
        let models = scene.models(&self.models.models)?;
        let mut request = self.separations.request(&scene, self.quantities.tolerance);
        let needs = |output: Output| output.needs().iter().copied();
        let needed: Vec<Quantity> = self.quantities.outputs().into_iter().flat_map(needs).collect();
        request.quantities = once(&needed);
        let progress = Progress::new("plans", models.len());
        let mut plans = String::new();
        for (id, model) in &models {
            let plan = model.compile(scene.scene(), &request).and_then(|c| c.plan(&request));
            plans.push_str(
                &plan.with_context(|| format!("{}: {id}", self.scene.scene.display()))?.to_string(),
            );
            progress.step();
        }
        drop(progress);
        output::write(self.output.as_deref(), |out| out.write_all(plans.as_bytes()))
    }
}
