//! `asperity models`: what there is, what it is good for, and where it comes from.

use anyhow::Result;
use asperity::{Described, Model};
use clap::Args;

use crate::input::args::OutputArgs;
use crate::output::table::{Format, Table};

/// The models: what they are valid for, their sources
#[derive(Debug, Args)]
#[command(
    after_help = "The interference of an asperity at which it begins to yield is w_c (w_c' with
another constant in jg), R is its radius. csv and json hold the titles of the
papers, how well the text of the equations is known, and notes as well.
Those from gw to af are known with -random behind the id as well: on asperities of
a random surface, whose heights and radii are spread together.

Examples:
  asperity models
  asperity models --format csv --output models.csv"
)]
pub struct Models {
    #[command(flatten)]
    output: OutputArgs,
}

impl Models {
    pub fn run(self) -> Result<()> {
        let all = ["model", "name", "year", "authors", "valid_for", "title", "equations", "notes"];
        // The last ones are too wide to be looked at.
        let shown = if self.output.format == Format::Table { 5 } else { all.len() };
        let mut table = Table::new(&all[..shown]);
        for model in [Model::all(), Model::whole_surface(), Model::adhesive()].concat() {
            let (source, validity) = (model.citation(), model.validity());
            let (year, equations) = (source.year.to_string(), source.provenance.to_string());
            let notes: String = model.notes().iter().map(ToString::to_string).collect();
            let row: [&str; 8] = [
                source.id,
                source.name,
                &year,
                source.authors,
                validity.valid_for,
                source.title,
                &equations,
                &notes,
            ];
            table.rows.push(row[..shown].iter().map(|cell| (*cell).into()).collect());
        }
        self.output.write(&table)
    }
}
