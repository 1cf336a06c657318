//! `asperity list`: models and materials, with their sources, and what findings mean; also
//! `models` and `materials`.

use anyhow::{Result, ensure};
use asperity::{Asperities, Body, Code, Described, Model, nearest_hint, nearest_name};
use asperity_answer::{Cell, Sheet};
use asperity_inputs::{BODY, Field, Material, unit_of};
use clap::{Args, ValueEnum};

use crate::input::args::OutputArgs;
use crate::output::{self, table::Format};

/// Models or materials, with their sources, or what warnings and notes mean
#[derive(Debug, Args)]
#[command(
    after_help = include_str!("../help/list.txt")
)]
pub struct List {
    what: What,
    /// Of models, an id or words of the name, the authors, the year or the variant; of materials, a
    /// word of the name; of findings, a part of the code
    word: Vec<String>,
    #[command(flatten)]
    output: OutputArgs,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum What {
    Models,
    Materials,
    Findings,
}

impl List {
    /// Writes a list, narrow in a terminal, and its notes.
    pub fn run(self) -> Result<()> {
        let (narrow, word) = (self.output.format() == Format::Table, self.word.join(" "));
        let sheet = match self.what {
            What::Models => models(&word, narrow)?,
            What::Materials => materials(&word, narrow)?,
            What::Findings => findings(&word, narrow)?,
        };
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

/// The columns of a terminal, by their places; the others are too wide.
const NARROW: [usize; 6] = [0, 1, 2, 3, 6, 4];

fn models(word: &str, narrow: bool) -> Result<Sheet> {
    let mut sheet = Sheet::default();
    for model in like(word)? {
        let (source, notes) = (model.citation(), model.notes());
        let notes = notes.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ");
        let variant = model.variant().join("; ");
        if let Some(text) = model.variant().last().filter(|_| narrow) {
            // Of models on other asperities, their ending: it differs in the same way for all.
            let ending = model.id().strip_prefix(source.id).filter(|ending| !ending.is_empty());
            sheet.note("variant", format!("{}: {text}", ending.unwrap_or(model.id())));
        }
        let cells: [(&str, &str); 9] = [
            ("model", model.id()),
            ("name", model.name()),
            ("year", &source.year.to_string()),
            ("authors", source.authors),
            ("valid_for", model.validity().valid_for),
            ("title", source.title),
            ("equations", &source.provenance.to_string()),
            ("notes", &notes),
            ("variant", &variant),
        ];
        let shown = if narrow { NARROW.map(|k| cells[k]).to_vec() } else { cells.to_vec() };
        let (heads, row): (Vec<&str>, Vec<&str>) = shown.into_iter().unzip();
        sheet.under(&[&heads]);
        sheet.add(&row, [Cell::BLANK; 0]);
    }
    if narrow {
        for (tag, meaning) in TAGS {
            sheet.note("provenance", format!("equations {tag}: {meaning}"));
        }
    }
    Ok(sheet)
}

/// The models of this id and its variants; without any, those with all words in their name, authors
/// or year, and then those on other asperities, whose variant is described as well.
fn like(word: &str) -> Result<Vec<Model>> {
    let wanted = word.trim().to_lowercase();
    let is_equal = |model: &Model| model.asperities() == Asperities::Equal;
    if let Some(model) = wanted.parse().ok().filter(|model| !is_equal(model)) {
        return Ok(vec![model]);
    }
    let (mut all, others): (Vec<Model>, Vec<Model>) =
        Model::named().into_iter().partition(is_equal);
    let of_id = |model: &Model| {
        let rest = model.id().strip_prefix(&*wanted);
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('-'))
    };
    let has_word = |model: &Model| {
        let (source, variant) = (model.citation(), model.variant().join(" "));
        let text = format!("{} {} {} {variant}", model.name(), source.authors, source.year);
        let text = text.to_lowercase();
        wanted.split_whitespace().all(|word| text.contains(word))
    };
    let any = all.iter().any(of_id);
    all.retain(|model| if any { of_id(model) } else { has_word(model) });
    if all.is_empty() {
        all = others.into_iter().filter(has_word).collect();
    }
    ensure!(
        !all.is_empty(),
        "no model has the id {word:?}, or these words in its name, authors, year or variant; `asperity list models` lists all but bem and those with -random or -pairs"
    );
    Ok(all)
}

fn materials(word: &str, narrow: bool) -> Result<Sheet> {
    let mut sheet = Sheet::default();
    let found = asperity_inputs::materials_like(word);
    ensure!(!found.is_empty(), "no material is like {word:?}; `asperity list materials` lists all");
    let known = |key: &&Field<Body>| {
        asperity_inputs::materials().iter().any(|m| (key.get)(&m.body).is_some())
    };
    let keys: Vec<&Field<Body>> = BODY.iter().filter(known).collect();
    let heads: Vec<String> = keys.iter().map(|key| column(key.name)).collect();
    for Material { id, name, source, body, .. } in found {
        let numbers = keys.iter().map(|key| Cell::from((key.get)(body)));
        let mut cells = vec![("material", Cell::from(&**id))];
        cells.extend(heads.iter().map(|head| &**head).zip(numbers));
        cells.extend([("name", Cell::from(&**name)), ("source", Cell::from(&**source))]);
        // Too wide for a terminal.
        cells.truncate(cells.len() - usize::from(narrow));
        let (heads, row): (Vec<&str>, Vec<Cell>) = cells.into_iter().unzip();
        sheet.under(&[&heads]);
        sheet.rows.push(row);
    }
    Ok(sheet)
}

/// A key with its unit, as in other tables: `hardness_Pa`.
fn column(key: &str) -> String {
    let unit = unit_of(key).unwrap_or_default().replace(['(', ')'], "");
    let unit = unit.replace('/', "_per_").replace(' ', "_");
    if unit.is_empty() { key.into() } else { format!("{key}_{unit}") }
}

fn findings(word: &str, narrow: bool) -> Result<Sheet> {
    let mut sheet = Sheet::default();
    let found: Vec<Code> = Code::all().filter(|code| code.name.contains(word.trim())).collect();
    let near = || nearest_hint(nearest_name(word, Code::all().map(|code| code.name)));
    ensure!(!found.is_empty(), "no finding has the code {word:?}{}", near());
    for Code { name, meaning, harmless, remedy } in found {
        if narrow {
            sheet.under(&[&["code", "meaning"]]);
            for row in [
                [name, meaning],
                ["", &format!("Harmless: {harmless}")],
                ["", &format!("To do: {remedy}")],
            ] {
                sheet.add(&row, [Cell::BLANK; 0]);
            }
        } else {
            sheet.under(&[&["code", "meaning", "harmless", "to_do"]]);
            sheet.add(&[name, meaning, harmless, remedy], [Cell::BLANK; 0]);
        }
    }
    Ok(sheet)
}
