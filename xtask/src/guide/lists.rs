//! The lists that are written from the code: models and figures.

use std::fmt::Write as _;
use std::path::Path;

use anyhow::{Context, Result};
use asperity::{Described, Model};

use super::chapters;
use super::site::{self, Site};
use super::source::root;
use super::template::figure;
use crate::figures::FIGURES;
use crate::html::escape;

/// A table of all models but those on random surfaces.
#[must_use]
pub fn models() -> String {
    let heads = ["id", "name", "year", "authors", "equations", "valid for"];
    let mut html = String::from("<div class=\"wide\"><table><thead><tr>");
    // Writing to a string cannot fail.
    for head in heads {
        let _ = write!(html, "<th>{head}</th>");
    }
    html += "</tr></thead><tbody>\n";
    for model in Model::named().into_iter().filter(|model| model.equal().id() == model.id()) {
        let citation = model.citation();
        let cells = [
            model.name(),
            &citation.year.to_string(),
            citation.authors,
            &citation.provenance.to_string(),
            model.validity().valid_for,
        ];
        let _ = write!(
            html,
            "<tr><td><a href=\"{}\"><code>{}</code></a></td>",
            page(&model),
            model.id()
        );
        for cell in cells {
            let _ = write!(html, "<td>{}</td>", escape(cell));
        }
        html += "</tr>\n";
    }
    html + "</tbody></table></div>\n"
}

/// The page of a model.
fn page(model: &Model) -> String {
    let stem = model.id().split('-').next().unwrap_or_default();
    let own = chapters::all().find(|chapter| chapter.slug == stem);
    own.map_or_else(|| "adhesion.html".into(), site::address)
}

/// Every committed figure under its title.
///
/// # Errors
/// A figure that cannot be read.
pub fn figures(site: &mut Site) -> Result<String> {
    let mut html = String::from("<h2 id=\"pictures\">Pictures</h2>\n");
    for spec in &FIGURES {
        let [svg, csv] = ["svg", "csv"].map(|end| format!("figures/{}.{end}", spec.name));
        let title = title(&root().join(&svg))?;
        html += &figure(&site.file(Path::new(&svg)), &title);
        // Writing to a string cannot fail.
        let _ =
            writeln!(html, "<p><a href=\"{}\">Numbers (csv)</a></p>", site.file(Path::new(&csv)));
    }
    Ok(html)
}

/// The title of an svg.
fn title(path: &Path) -> Result<String> {
    let name = || path.display().to_string();
    let svg = std::fs::read_to_string(path).with_context(name)?;
    let after = svg.split_once("<title>").map(|(_, after)| after);
    let title = after.and_then(|after| after.split_once("</title>")).map(|(title, _)| title);
    Ok(title.with_context(|| format!("{} has no title", path.display()))?.to_owned())
}
