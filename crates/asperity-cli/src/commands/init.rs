//! `asperity init`: a scene to start from.

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;

use crate::output;

/// A commented scene file to start from
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  asperity init
  asperity init my-scene.toml")]
pub struct Init {
    /// Write to this file in place of the standard output
    file: Option<PathBuf>,
    /// The same, as with the other commands
    #[arg(long, value_name = "FILE", conflicts_with = "file")]
    output: Option<PathBuf>,
    /// Replace the file if it exists
    #[arg(long)]
    force: bool,
}

impl Init {
    pub fn run(self) -> Result<()> {
        let file = self.file.or(self.output);
        if let Some(path) = &file {
            output::refuse_to_replace(path, self.force)?;
        }
        output::write_text(file.as_deref(), asperity_scene::template())
    }
}
