//! `asperity init`: a scene to start from.

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;

use crate::output;

/// A commented scene file to start from
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  asperity init
  asperity init --output my-scene.toml")]
pub struct Init {
    /// Write to a file in place of the standard output
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Replace the file if it exists
    #[arg(long)]
    force: bool,
}

impl Init {
    pub fn run(self) -> Result<()> {
        if let Some(path) = &self.output {
            output::refuse_to_replace(path, self.force)?;
        }
        output::write(self.output.as_deref(), |out| {
            out.write_all(asperity_scene::template().as_bytes())
        })
    }
}
