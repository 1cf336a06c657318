//! `asperity list`: models and materials, with their sources; also `models` and `materials`.

use anyhow::{Result, ensure};
use asperity::{Described, Model};
use asperity_answer::{Cell, Sheet};
use clap::{Args, ValueEnum};

use crate::input::args::OutputArgs;
use crate::output::{self, table::Format};

/// Models or materials, with their sources
#[derive(Debug, Args)]
#[command(
    after_help = include_str!("help/list.txt")
)]
pub struct List {
    what: What,
    #[command(flatten)]
    like: Like,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum What {
    Models,
    Materials,
}

/// The word that models or materials are chosen by, and the output.
#[derive(Debug, Args)]
pub struct Like {
    /// Only models of this id, or with this word in their name, authors or year; or materials with
    /// this word in their name, or the nearest ones
    word: Option<String>,
    #[command(flatten)]
    output: OutputArgs,
}

impl List {
    pub fn run(self) -> Result<()> {
        match self.what {
            What::Models => self.like.show(models),
            What::Materials => self.like.show(materials),
        }
    }
}

impl Like {
    /// Writes a list, narrow in a terminal, and its notes.
    pub fn show(self, list: fn(&str, bool) -> Result<Sheet>) -> Result<()> {
        let narrow = self.output.format == Format::Table;
        let sheet = list(&self.word.unwrap_or_default(), narrow)?;
        self.output.write(&sheet)?;
        output::show(&sheet.findings);
        Ok(())
    }
}

/// The tags of the column `equations`, as the crates' READMEs define them.
const TAGS: [(&str, &str); 3] = [
    ("seen", "read in public text or code that quotes the paper"),
    ("derived", "proved or checked numerically, not read in the paper"),
    ("recalled", "from general knowledge of the literature, the paper was not available"),
];

/// The columns of models.
const OF_MODELS: [&str; 9] =
    ["model", "name", "year", "authors", "valid_for", "title", "equations", "notes", "variant"];
/// Those of a terminal, as places in [`OF_MODELS`]; the others are too wide.
const NARROW: [usize; 6] = [0, 1, 2, 3, 6, 4];

pub fn models(word: &str, narrow: bool) -> Result<Sheet> {
    let all: Vec<usize> = (0..OF_MODELS.len()).collect();
    let shown = if narrow { &NARROW[..] } else { &all };
    let mut sheet = Sheet::new(&shown.iter().map(|k| OF_MODELS[*k]).collect::<Vec<_>>());
    for model in like(word)? {
        let (source, validity) = (model.citation(), model.validity());
        let (year, equations) = (source.year.to_string(), source.provenance.to_string());
        let notes: Vec<String> = model.notes().iter().map(ToString::to_string).collect();
        let (notes, variant) = (notes.join("; "), model.variant().join("; "));
        if narrow && !variant.is_empty() {
            sheet.note("variant", format!("{}: {variant}", source.id));
        }
        let (title, valid_for) = (source.title, validity.valid_for);
        let row: [&str; OF_MODELS.len()] = [
            source.id,
            source.name,
            &year,
            source.authors,
            valid_for,
            title,
            &equations,
            &notes,
            &variant,
        ];
        sheet.rows.push(shown.iter().map(|k| row[*k].into()).collect());
    }
    if narrow {
        for (tag, meaning) in TAGS {
            sheet.note("provenance", format!("equations {tag}: {meaning}"));
        }
    }
    Ok(sheet)
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
        "no model has the id {word:?}, or this word in its name, authors or year; `asperity list models` lists all but bem and those with -random"
    );
    Ok(all)
}

/// The columns of materials; the last is too wide for a terminal.
const OF_MATERIALS: [&str; 9] = [
    "material",
    "youngs_modulus_Pa",
    "poissons_ratio",
    "hardness_Pa",
    "yield_strength_Pa",
    "thermal_conductivity_W_per_m_K",
    "electrical_resistivity_ohm_m",
    "name",
    "source",
];

pub fn materials(word: &str, narrow: bool) -> Result<Sheet> {
    let mut sheet = Sheet::new(&OF_MATERIALS[..OF_MATERIALS.len() - usize::from(narrow)]);
    let found = asperity_inputs::materials_like(word);
    ensure!(!found.is_empty(), "no material is like {word:?}; `asperity list materials` lists all");
    for material in found {
        let body = &material.body;
        let numbers = [
            Some(body.youngs_modulus),
            Some(body.poissons_ratio),
            body.hardness,
            body.yield_strength,
            body.thermal_conductivity,
            body.electrical_resistivity,
        ];
        let mut row = vec![Cell::from(&*material.id)];
        row.extend(numbers.map(Cell::from));
        row.extend([Cell::from(&*material.name), Cell::from(&*material.source)]);
        row.truncate(sheet.heads.len());
        sheet.rows.push(row);
    }
    Ok(sheet)
}
