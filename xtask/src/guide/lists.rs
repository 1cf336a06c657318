//! The parts of pages that are written from the code: contents, models and figures.

use anyhow::{Context, Result};
use asperity::{Code, Described, Model};

use super::chapters::{self, ALL, Chapter};
use crate::figures::FIGURES;
use crate::folder::{read, root};
use crate::html::escape;
use crate::table::{markdown_head, markdown_row};

/// The contents, with the current chapter marked, and the documentation beside the guide, by
/// address and name.
#[must_use]
pub fn contents(current: &Chapter, api: &[(&str, &str)]) -> String {
    let item = |address: &str, here: &str, name: &str| {
        format!("<li><a href=\"{address}\"{here}>{}</a></li>\n", escape(name))
    };
    let group = |title: &str, items: String| format!("<h2>{title}</h2>\n<ul>\n{items}</ul>\n");
    let chapter = |chapter: &Chapter| {
        let here = if chapter.slug == current.slug { " aria-current=\"page\"" } else { "" };
        item(&chapter.address(), here, chapter.title)
    };
    let groups = ALL.chunk_by(|a, b| a.group == b.group);
    let mut html: String =
        groups.map(|all| group(all[0].group, all.iter().map(chapter).collect())).collect();
    if !api.is_empty() {
        html += &group("Interfaces", api.iter().map(|(to, name)| item(to, "", name)).collect());
    }
    html
}

/// Links to the chapters before and after.
#[must_use]
pub fn neighbours(current: &Chapter) -> String {
    let here = ALL.iter().position(|chapter| chapter.slug == current.slug).unwrap_or_default();
    let link = |(at, rel, word): (Option<usize>, &str, &str)| {
        let chapter = ALL.get(at?)?;
        let (address, title) = (chapter.address(), escape(chapter.title));
        Some(format!("<a rel=\"{rel}\" href=\"{address}\">{word}: {title}</a>\n"))
    };
    let both = [(here.checked_sub(1), "prev", "Before"), (Some(here + 1), "next", "Next")];
    both.into_iter().filter_map(link).collect()
}

/// A picture with the text that stands for it.
#[must_use]
pub fn figure(address: &str, alt: &str) -> String {
    format!("<figure><img src=\"{address}\" alt=\"{}\" loading=\"lazy\"></figure>\n", escape(alt))
}

/// The markdown of a list by its name; `None` of other names.
///
/// # Errors
/// A guide without the chapter of a model, a figure that cannot be read.
pub fn named(list: &str) -> Result<Option<String>> {
    Ok(match list {
        "list of models" => Some(models()?),
        "list of findings" => Some(Code::all().map(finding).collect()),
        "list of figures" => Some(figures()?),
        _ => None,
    })
}

/// A table of all models but those on random surfaces.
fn models() -> Result<String> {
    let mut rows = markdown_head(&["id", "name", "year", "authors", "equations", "valid for"], 0);
    for model in Model::all().into_iter().filter(|model| model.equal().id() == model.id()) {
        let (citation, page) = (model.citation(), chapters::of_model(model.id())?.address());
        rows += &markdown_row(&[
            &format!("[`{}`]({page})", model.id()),
            model.name(),
            &citation.year.to_string(),
            citation.authors,
            &citation.provenance.to_string(),
            model.validity().valid_for,
        ]);
    }
    Ok(rows)
}

/// What the code of a warning or note means, and what to do.
fn finding(Code { name, meaning, harmless, remedy }: Code) -> String {
    format!("### `{name}`\n\n{meaning}\n\nHarmless: {harmless}\n\nTo do: {remedy}\n\n")
}

/// Every committed figure under its title.
fn figures() -> Result<String> {
    let mut text = String::from("## Pictures\n\n");
    for (name, ..) in &FIGURES {
        let file = format!("figures/{name}");
        let picture = read(&root().join(&file).with_extension("svg"))?;
        let title = picture.split_once("<title>").and_then(|(_, rest)| rest.split_once("</title>"));
        let (title, _) = title.with_context(|| format!("{file}.svg has no title"))?;
        text += &format!("![{title}]({file}.svg)\n\n[Numbers (csv)]({file}.csv)\n\n");
    }
    Ok(text)
}
