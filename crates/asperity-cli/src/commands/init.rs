//! `asperity init`: an example scene.

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;

use crate::output;

/// Write a commented example scene with every key
#[derive(Debug, Args)]
#[command(after_help = include_str!("../help/init.txt"))]
pub struct Init {
    /// File to write instead of standard output
    file: Option<PathBuf>,
    /// The same file by the option of the other commands
    #[arg(long, value_name = "FILE", conflicts_with = "file")]
    output: Option<PathBuf>,
    /// Overwrite the file if it exists; without --force an existing scene is kept
    #[arg(long)]
    force: bool,
}

impl Init {
    pub fn run(self) -> Result<()> {
        let file = self.file.or(self.output);
        if let Some(path) = &file {
            output::refuse_to_replace(path, self.force)?;
        }
        output::write_text(file.as_deref(), asperity_inputs::template())
    }
}
