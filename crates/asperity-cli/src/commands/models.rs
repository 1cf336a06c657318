//! `asperity models`: the models, their range of validity and their sources.

use anyhow::{Result, ensure};
use asperity::{Described, Model};
use clap::Args;

use crate::input::args::OutputArgs;
use crate::output::print_message;
use crate::output::table::{Format, Table};

/// The tags of the column `equations`, as the crates' READMEs define them.
const TAGS: [(&str, &str); 3] = [
    ("seen", "read in public text or code that quotes the paper"),
    ("derived", "proved or checked numerically, not read in the paper"),
    ("recalled", "from general knowledge of the literature, the paper was not available"),
];

/// The models: range of validity, sources
#[derive(Debug, Args)]
#[command(
    after_help = "R is the radius of an asperity, w_c the critical interference, at which it begins to
yield (w_c' with another constant in jg, w_1 in zmc). The column equations holds
the provenance of each model's equations:
  seen      read in public text or code that quotes the paper
  derived   proved or checked numerically, not read in the paper
  recalled  from general knowledge of the literature, the paper was not available
csv and json also hold titles, notes and how variants differ. The models from gw to af,
and ghaednia, exist with -random behind the id as well: averaged over the asperities of
a random surface, whose heights and radii differ. bem, boundary elements, needs a scan.

Examples:
  asperity models
  asperity models ke
  asperity models --format csv --output models.csv"
)]
pub struct Models {
    /// Only the models of this id, or with this word in their name, authors or year
    word: Option<String>,
    #[command(flatten)]
    output: OutputArgs,
}

const COLUMNS: [&str; 9] =
    ["model", "name", "year", "authors", "valid_for", "title", "equations", "notes", "variant"];
/// The columns of a table in the terminal, as places in [`COLUMNS`]; the others are too wide.
const TERMINAL: [usize; 6] = [0, 1, 2, 3, 6, 4];

impl Models {
    pub fn run(self) -> Result<()> {
        let terminal = self.output.format == Format::Table;
        let shown: Vec<usize> =
            if terminal { TERMINAL.to_vec() } else { (0..COLUMNS.len()).collect() };
        let mut table = Table::new(&shown.iter().map(|k| COLUMNS[*k]).collect::<Vec<_>>());
        let mut variants = vec![];
        for model in like(&self.word.unwrap_or_default())? {
            let (source, validity) = (model.citation(), model.validity());
            let (year, equations) = (source.year.to_string(), source.provenance.to_string());
            let notes: Vec<String> = model.notes().iter().map(ToString::to_string).collect();
            let (notes, variant) = (notes.join("; "), model.variant().join("; "));
            if terminal && !variant.is_empty() {
                variants.push(format!("{}: {variant}", source.id));
            }
            let row: [&str; COLUMNS.len()] = [
                source.id,
                source.name,
                &year,
                source.authors,
                validity.valid_for,
                source.title,
                &equations,
                &notes,
                &variant,
            ];
            table.rows.push(shown.iter().map(|k| row[*k].into()).collect());
        }
        self.output.write(&table)?;
        variants.iter().for_each(|variant| print_message("note", variant));
        if terminal {
            TAGS.iter().for_each(|(tag, meaning)| {
                print_message("note", &format!("equations {tag}: {meaning}"))
            });
        }
        Ok(())
    }
}

/// The models of this id and its variants; without any, those with the word in their name, authors
/// or year.
fn like(word: &str) -> Result<Vec<Model>> {
    let wanted = word.trim().to_lowercase();
    // Random asperities have the row of equal ones.
    let equal = wanted.strip_suffix("-random").filter(|_| wanted.parse::<Model>().is_ok());
    let wanted = equal.unwrap_or(&wanted);
    let mut all =
        [Model::all(), Model::whole_surface(), Model::adhesive(), Model::hardening()].concat();
    let of_id = |model: &Model| {
        let rest = model.id().strip_prefix(wanted);
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('-'))
    };
    let has_word = |model: &Model| {
        let source = model.citation();
        let words = format!("{} {} {}", source.name, source.authors, source.year);
        words.to_lowercase().contains(wanted)
    };
    let any = all.iter().any(of_id);
    all.retain(|model| if any { of_id(model) } else { has_word(model) });
    ensure!(
        !all.is_empty(),
        "no model has the id {word:?}, or this word in its name, authors or year; `asperity models` lists all but bem and those with -random"
    );
    Ok(all)
}
