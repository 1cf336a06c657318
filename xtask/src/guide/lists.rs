//! The parts of pages that are written from the code: contents, models and figures.

use anyhow::{Context, Result};
use asperity::{Code, Described, Model};

use super::chapters::{self, ALL, Chapter};
use super::site::Site;
use crate::figures::FIGURES;
use crate::folder::{read, root};
use crate::html::escape;

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

/// A table of all models but those on random surfaces.
///
/// # Errors
/// A guide without their chapters.
pub fn models() -> Result<String> {
    let heads = ["id", "name", "year", "authors", "equations", "valid for"];
    let heads = heads.map(|head| format!("<th>{head}</th>")).concat();
    let mut html = format!("<div class=\"wide\"><table><thead><tr>{heads}</tr></thead><tbody>\n");
    for model in Model::named().into_iter().filter(|model| model.equal().id() == model.id()) {
        let (citation, page) = (model.citation(), chapters::of_model(model.id())?.address());
        let cells = [
            model.name(),
            &citation.year.to_string(),
            citation.authors,
            &citation.provenance.to_string(),
            model.validity().valid_for,
        ];
        let cells = cells.map(|cell| format!("<td>{}</td>", escape(cell))).concat();
        let link = format!("<a href=\"{page}\"><code>{}</code></a>", model.id());
        html += &format!("<tr><td>{link}</td>{cells}</tr>\n");
    }
    Ok(html + "</tbody></table></div>\n")
}

/// All codes of findings, with what they mean and what to do.
#[must_use]
pub fn findings() -> String {
    let marked = |text: &str| {
        let parts = text.split('`').enumerate();
        let part = |(k, part): (usize, &str)| match k % 2 {
            0 => escape(part),
            _ => format!("<code>{}</code>", escape(part)),
        };
        parts.map(part).collect::<String>()
    };
    let entry = |Code { name, meaning, harmless, remedy }: Code| {
        let [meaning, harmless, remedy] = [meaning, harmless, remedy].map(marked);
        format!(
            "<h3 id=\"{name}\"><code>{name}</code></h3>\n<p>{meaning}</p>\n<p>Harmless: {harmless}</p>\n<p>To do: {remedy}</p>\n"
        )
    };
    Code::all().map(entry).collect()
}

/// Every committed figure under its title.
///
/// # Errors
/// A figure that cannot be read.
pub fn figures(site: &mut Site) -> Result<String> {
    let mut html = String::from("<h2 id=\"pictures\">Pictures</h2>\n");
    for (name, ..) in &FIGURES {
        let [svg, csv] = ["svg", "csv"].map(|end| format!("figures/{name}.{end}"));
        let picture = read(&root().join(&svg))?;
        let title = picture.split_once("<title>").and_then(|(_, rest)| rest.split_once("</title>"));
        let (title, _) = title.with_context(|| format!("{svg} has no title"))?;
        html += &figure(&site.file(svg.as_ref()), title);
        let numbers = site.file(csv.as_ref());
        html += &format!("<p><a href=\"{numbers}\">Numbers (csv)</a></p>\n");
    }
    Ok(html)
}
