//! `asperity init`: an example scene.

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;

use crate::output;

/// Write a commented example scene with every key
#[derive(Debug, Args)]
#[command(after_help = include_str!("../help/init.txt"))]
pub struct Init {
    /// File to write instead of standard output; an existing file is kept
    file: Option<PathBuf>,
}

impl Init {
    pub fn run(self) -> Result<()> {
        self.file.as_deref().map_or(Ok(()), output::refuse_to_replace)?;
        output::write_text(self.file.as_deref(), asperity_scene::template())
    }
}
