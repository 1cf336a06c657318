//! `asperity plan`: the integrals behind a result.

use std::path::PathBuf;

use anyhow::{Context, Result};
use asperity::{ContactModel, linspace};
use clap::Args;

use crate::commands::curve::USUAL;
use crate::input::args::ModelArgs;
use crate::output::{self, progress};
use crate::scene::LoadedScene;

/// Show how a result is computed: the integrals, their number of terms, the terms left out
#[derive(Debug, Args)]
#[command(
    after_help = "Default: force, area and tangent (at loads without the force) at separations of
0:4:401 in units of asperity_height_std.

Examples:
  asperity plan scene.toml --model ke --quantity force,tangent
  asperity plan scene.toml --model ke --load 10:1000:50
  asperity plan scene.toml --model gw,zmc --separation 0:2:3 --tolerance 1e-6"
)]
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
            let _progress = progress(&id);
            let plan = model.compile(&scene.file.scene, &request).and_then(|c| c.plan(&request));
            plans += &plan.with_context(|| format!("{}: {id}", scene.name))?.to_string();
        }
        output::write_text(self.output.as_deref(), &plans)
    }
}
