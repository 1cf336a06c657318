//! The frame around the text of a page: contents, search, links to the explorer.

use std::fmt::Write as _;

use super::chapters::{Chapter, GROUPS};
use super::site;
use crate::head::Head;
use crate::html::escape;

/// The explorer, seen from the guide.
pub const EXPLORER: &str = "../index.html";

/// What is the same on all pages.
pub struct Frame {
    /// Addresses and names of the documentation beside the guide.
    pub api: Vec<(&'static str, &'static str)>,
}

impl Frame {
    /// A whole page.
    #[must_use]
    pub fn page(&self, chapter: &Chapter, body: &str) -> String {
        let title = escape(chapter.title);
        let contents = self.contents(chapter);
        let neighbours = neighbours(chapter);
        let body = format!(
            r##"<body>
<a class="skip" href="#text">Skip to the text</a>
<header>
<a class="home" href="{EXPLORER}">asperity</a>
<a href="{EXPLORER}">Explorer</a>
<a href="index.html">Guide</a>
<search id="search" hidden>
<label for="query">Search</label>
<input id="query" type="search" autocomplete="off" aria-controls="found" placeholder="words of the guide">
<ul id="found" aria-label="Results" aria-live="polite"></ul>
</search>
</header>
<div class="columns">
<nav aria-label="Contents">
<details open>
<summary>Contents</summary>
{contents}</details>
</nav>
<main id="text">
<h1>{title}</h1>
{body}
{neighbours}</main>
</div>
</body>
"##
        );
        let description = format!("{}, a chapter of the guide to asperity.", chapter.title);
        let head = Head {
            title: &format!("{} · asperity", chapter.title),
            description: &description,
            style: "guide.css",
            script: Some("search.js"),
            module: false,
        };
        head.page(&body)
    }

    fn contents(&self, current: &Chapter) -> String {
        let mut html = String::new();
        // Writing to a string cannot fail.
        for group in GROUPS {
            let _ = writeln!(html, "<h2>{}</h2>\n<ul>", escape(group.title));
            for chapter in group.chapters {
                let here = if chapter.slug == current.slug { " aria-current=\"page\"" } else { "" };
                let (address, title) = (site::address(chapter), escape(chapter.title));
                let _ = writeln!(html, "<li><a href=\"{address}\"{here}>{title}</a></li>");
            }
            html += "</ul>\n";
        }
        if !self.api.is_empty() {
            html += "<h2>Interfaces</h2>\n<ul>\n";
            for (address, name) in &self.api {
                let _ = writeln!(html, "<li><a href=\"{address}\">{name}</a></li>");
            }
            html += "</ul>\n";
        }
        html
    }
}

/// Links to the chapters before and after.
fn neighbours(current: &Chapter) -> String {
    let all: Vec<&Chapter> = GROUPS.iter().flat_map(|group| group.chapters).collect();
    let here = all.iter().position(|chapter| chapter.slug == current.slug).unwrap_or_default();
    let link = |chapter: Option<&&Chapter>, rel: &str, word: &str| {
        chapter.map_or(String::new(), |chapter| {
            let (address, title) = (site::address(chapter), escape(chapter.title));
            format!("<a rel=\"{rel}\" href=\"{address}\">{word}: {title}</a>\n")
        })
    };
    let before = link(here.checked_sub(1).and_then(|at| all.get(at)), "prev", "Before");
    let after = link(all.get(here + 1), "next", "Next");
    format!("<nav class=\"neighbours\" aria-label=\"Neighbours\">\n{before}{after}</nav>\n")
}

/// A picture with the text that stands for it.
#[must_use]
pub fn figure(address: &str, alt: &str) -> String {
    format!("<figure><img src=\"{address}\" alt=\"{}\" loading=\"lazy\"></figure>\n", escape(alt))
}
