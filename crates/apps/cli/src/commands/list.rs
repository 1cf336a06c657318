//! `asperity list`: models and materials, with their sources, quantities, and what findings mean.

use anyhow::{Result, ensure};
use asperity::bem::Bem;
use asperity::{Body, Citation, Code, Described, Model, Quantity, nearest_hint, nearest_name};
use asperity_answer::{Cell, Sheet, grouped};
use asperity_scene::{BODY, Field, Material, column_of};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};

use crate::input::args::OutputArgs;
use crate::output::{self, table::Format};

/// Models or materials, with their sources, quantities, or what warnings and notes mean
#[derive(Debug, Args)]
#[command(
    mut_arg("format", |arg| arg
        .value_parser(PossibleValuesParser::new(["csv", "json", "table", "auto", "bibtex"]).try_map(format))
        .help("How the list is written; bibtex has the sources of models")),
    after_help = include_str!("../help/list.txt")
)]
pub struct List {
    what: What,
    /// Of models, an id or words of the name, the authors, the year or the variant; of materials, a
    /// word of the name; of quantities and findings, a part of the name
    word: Vec<String>,
    #[command(flatten)]
    output: OutputArgs,
}

/// A format by its name.
fn format(name: String) -> Result<Format, String> {
    if name == "bibtex" { Ok(Format::Bibtex) } else { Format::from_str(&name, false) }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum What {
    Models,
    Materials,
    Quantities,
    Findings,
}

impl List {
    /// Writes a list, narrow in a terminal, and what its words mean.
    pub fn run(self) -> Result<()> {
        let (narrow, word) = (self.output.format() == Format::Table, self.word.join(" "));
        let is_bibtex = self.output.format() == Format::Bibtex;
        ensure!(!is_bibtex || self.what == What::Models, "only models have sources in bibtex");
        let sheet = match self.what {
            What::Models if is_bibtex => sources(&word)?,
            What::Models => models(&word, narrow)?,
            What::Materials => materials(&word, narrow)?,
            What::Quantities => quantities(&word)?,
            What::Findings => findings(&word, narrow)?,
        };
        self.output.write(&sheet)?;
        output::print_results(&sheet.results);
        Ok(())
    }
}

/// The first columns, as a terminal has them; the others are too wide.
const NARROW: usize = 5;

/// A model as it is listed.
struct Listed {
    id: String,
    name: String,
    source: Citation,
    valid_for: &'static str,
    variant: Vec<&'static str>,
}

impl From<Model> for Listed {
    fn from(model: Model) -> Self {
        Self {
            id: model.id().into(),
            name: model.name().into(),
            source: *model.citation(),
            valid_for: model.validity().valid_for,
            variant: model.variant(),
        }
    }
}

/// Every model, also boundary elements, which need a scan.
fn all() -> Vec<Listed> {
    let (id, name) = (Bem::ID.into(), Bem::SOURCE.name.into());
    let (source, valid_for, variant) = (Bem::SOURCE, Bem::VALID_FOR, vec![]);
    let bem = Listed { id, name, source, valid_for, variant };
    Model::all().into_iter().map(Listed::from).chain([bem]).collect()
}

/// The columns of models.
const MODELS: [&str; 8] =
    ["model", "name", "year", "authors", "valid_for", "title", "equations", "variant"];

fn models(word: &str, narrow: bool) -> Result<Sheet> {
    let mut sheet = Sheet::new(&MODELS[..if narrow { NARROW } else { MODELS.len() }]);
    for Listed { id, name, source, valid_for, variant } in like(word)? {
        if let Some(text) = variant.last().filter(|_| narrow) {
            // Of models on other asperities, their ending: it differs in the same way for all.
            let ending = id.strip_prefix(source.id).filter(|ending| !ending.is_empty());
            sheet.result(format!("{}: {text}", ending.unwrap_or(&id)));
        }
        let (year, equations) = (source.year.to_string(), source.provenance.to_string());
        let variant = variant.join("; ");
        let Citation { authors, title, .. } = source;
        let cells = [&*id, &name, &year, authors, valid_for, title, &equations, &variant];
        sheet.add(&cells[..sheet.heads.len()], [Cell::BLANK; 0]);
    }
    Ok(sheet)
}

/// The entry of this program, which the README shows as well.
const PROGRAM: &str = concat!(
    "@misc{asperity,\n  author = {{The asperity developers}},\n",
    "  title = {{asperity: rough surfaces in contact}},\n  year = {2026},\n  version = {",
    env!("CARGO_PKG_VERSION"),
    "},\n}\n"
);

/// The entry of the program, and one for each source, under the ids of the models that it is for.
fn sources(word: &str) -> Result<Sheet> {
    let mut sheet = Sheet::new(&["entry"]);
    sheet.add(&[PROGRAM], [Cell::BLANK; 0]);
    for (entry, ids) in grouped(like(word)?.into_iter().map(|one| (one.source.bibtex(), one.id))) {
        // Text between entries is a comment.
        sheet.add(&[&format!("{}\n{entry}", ids.join(", "))], [Cell::BLANK; 0]);
    }
    Ok(sheet)
}

/// The models of this id and its variants; without any, those with all words in their name,
/// authors, year or variant.
fn like(word: &str) -> Result<Vec<Listed>> {
    let wanted = word.trim().to_lowercase();
    let of_id = |model: &Listed| {
        let rest = model.id.strip_prefix(&*wanted);
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('-'))
    };
    let has_words = |model: &Listed| {
        let Listed { name, source, variant, .. } = model;
        let text = format!("{name} {} {} {}", source.authors, source.year, variant.join(" "));
        let text = text.to_lowercase();
        wanted.split_whitespace().all(|word| text.contains(word))
    };
    let mut all = all();
    let is_id = all.iter().any(of_id);
    all.retain(|model| if is_id { of_id(model) } else { has_words(model) });
    ensure!(
        !all.is_empty(),
        "no model has the id {word:?}, or these words in its name, authors, year or variant; `asperity list models` lists all"
    );
    Ok(all)
}

fn materials(word: &str, narrow: bool) -> Result<Sheet> {
    let mut sheet = Sheet::default();
    let found = asperity_scene::materials_like(word);
    ensure!(!found.is_empty(), "no material is like {word:?}; `asperity list materials` lists all");
    let known = |key: &&Field<Body>| {
        asperity_scene::materials().iter().any(|m| (key.get)(&m.body).is_some())
    };
    let keys: Vec<&Field<Body>> = BODY.iter().filter(known).collect();
    let heads: Vec<String> = keys.iter().map(|key| column_of(key.name)).collect();
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

fn quantities(word: &str) -> Result<Sheet> {
    let mut sheet = Sheet::new(&["quantity", "symbol", "unit", "definition"]);
    let names = Quantity::ALL.map(|quantity| quantity.to_string());
    let near = || nearest_hint(nearest_name(word, names.iter().map(|name| &**name)));
    for (quantity, name) in Quantity::ALL.iter().zip(&names) {
        if name.contains(word.trim()) {
            let cells = [name, quantity.symbol(), quantity.unit(), quantity.definition()];
            sheet.add(&cells, [Cell::BLANK; 0]);
        }
    }
    ensure!(!sheet.rows.is_empty(), "no quantity has the name {word:?}{}", near());
    Ok(sheet)
}

fn findings(word: &str, narrow: bool) -> Result<Sheet> {
    let mut sheet = Sheet::default();
    let is_like = |code: &&Code| code.name().contains(word.trim());
    let found: Vec<&Code> = Code::ALL.iter().filter(is_like).collect();
    let near = || nearest_hint(nearest_name(word, Code::ALL.iter().map(|code| code.name())));
    ensure!(!found.is_empty(), "no finding has the code {word:?}{}", near());
    for code in found {
        // Markdown of the guide.
        let [meaning, harmless, remedy] = code.texts().map(|text| text.replace('`', ""));
        let (name, meaning) = (code.name(), &*meaning);
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
            sheet.add(&[name, meaning, &harmless, &remedy], [Cell::BLANK; 0]);
        }
    }
    Ok(sheet)
}
