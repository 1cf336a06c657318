//! `asperity models`: what there is, and where it comes from.

use std::path::PathBuf;

use anyhow::Result;
use asperity::Model;
use clap::Args;

use crate::output;
use crate::table::{Format, Table};

/// The models, with their sources
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  asperity models
  asperity models --format csv --output models.csv")]
pub struct Models {
    /// Form of the answer
    #[arg(long, value_name = "FORM", default_value = "table")]
    format: Format,
    /// Write to a file in place of the standard output
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl Models {
    pub fn run(self) -> Result<()> {
        let models = Model::all();
        let mut table = Table::default();
        let mut column = |name: &str, cell: fn(&Model) -> String| {
            table.words(name, models.iter().map(cell).collect());
        };
        column("model", |m| m.id().into());
        column("name", |m| m.name().into());
        column("year", |m| m.source().year.to_string());
        column("authors", |m| m.source().authors.into());
        column("title", |m| m.source().title.into());
        column("equations", |m| m.source().provenance.to_string());
        output::write(self.output.as_deref(), |out| table.write(self.format, out))
    }
}
