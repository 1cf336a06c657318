//! Markdown to html that needs no inline style or script.

use std::collections::HashMap;
use std::fmt::Write as _;

use anyhow::Result;
use pulldown_cmark::{
    BrokenLink, CodeBlockKind, CowStr, Event, HeadingLevel, LinkType, Options, Parser, Tag, TagEnd,
    html,
};

use super::equations;
use crate::html::escape;

/// A heading with the id of its element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Heading {
    /// Its text.
    pub text: String,
    /// The id on its page.
    pub id: String,
    /// The id that it would have if its file had a page of its own: what links in files name.
    pub anchor: String,
}

/// Where a link leads.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Target {
    /// An address to link.
    Address(String),
    /// Nowhere in the guide: the text stays, followed by this, if it is not empty.
    Text(String),
}

/// Ids of headings, unique on one page.
#[derive(Debug, Default)]
pub struct Ids(HashMap<String, usize>);

impl Ids {
    fn of(&mut self, text: &str) -> String {
        let slug = slug(text);
        let count = self.0.entry(slug.clone()).or_default();
        *count += 1;
        if *count == 1 { slug } else { format!("{slug}-{}", *count - 1) }
    }
}

/// The id of a heading in the way of GitHub.
fn slug(text: &str) -> String {
    let lower = text.to_lowercase();
    let kept = lower.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}

fn parse(text: &str) -> Vec<Event<'_>> {
    // A link of rustdoc has no address here.
    let broken = |link: BrokenLink| {
        link.reference.starts_with('`').then_some((CowStr::from("::"), CowStr::from("")))
    };
    let options = Options::ENABLE_TABLES | Options::ENABLE_STRIKETHROUGH;
    Parser::new_with_broken_link_callback(text, options, Some(broken)).collect()
}

/// The headings of a text below its title, in order, with ids that are new among `ids`.
pub fn headings(text: &str, ids: &mut Ids) -> Vec<Heading> {
    let (mut found, mut own, mut current) = (vec![], Ids::default(), None);
    for event in parse(text) {
        match event {
            Event::Start(Tag::Heading { .. }) => current = Some(String::new()),
            Event::End(TagEnd::Heading(level)) => {
                let text = current.take().unwrap_or_default();
                let anchor = own.of(&text);
                if level != HeadingLevel::H1 {
                    found.push(Heading { id: ids.of(&text), text, anchor });
                }
            }
            Event::Text(part) | Event::Code(part) => {
                if let Some(text) = &mut current {
                    text.push_str(&part);
                }
            }
            _ => {}
        }
    }
    found
}

/// The words of a text without its code: those before the first heading below the title, then those
/// under each of [`headings`].
pub fn sections(text: &str) -> Vec<String> {
    let (mut found, mut skipped) = (vec![String::new()], 0);
    for event in parse(text) {
        let last = found.len() - 1;
        match event {
            Event::Start(Tag::Heading { level, .. }) => {
                skipped += 1;
                if level != HeadingLevel::H1 {
                    found.push(String::new());
                }
            }
            Event::Start(Tag::CodeBlock(_)) => skipped += 1,
            Event::End(TagEnd::Heading(_) | TagEnd::CodeBlock) => skipped -= 1,
            Event::Text(part) | Event::Code(part) if skipped == 0 => found[last] += &part,
            // Words of two blocks or cells are apart.
            Event::End(TagEnd::Link | TagEnd::Emphasis | TagEnd::Strong | TagEnd::Image) => {}
            Event::SoftBreak | Event::HardBreak | Event::End(_) => found[last].push(' '),
            _ => {}
        }
    }
    found
}

/// Writes a text as html. Its title is left out, as the page has one; `headings` are those of
/// [`headings`], `equations` writes blocks of plain text that hold them as tables, and `resolve`
/// returns where a link (`false`) or a picture (`true`) leads.
///
/// # Errors
/// Those of `resolve`.
pub fn render(
    text: &str,
    headings: &[Heading],
    equations: bool,
    mut resolve: impl FnMut(&str, bool) -> Result<Target>,
) -> Result<String> {
    let mut ids = headings.iter().map(|heading| heading.id.as_str());
    let mut events = vec![];
    let (mut in_title, mut in_rust, mut in_code) = (false, false, false);
    // The text of a block that may hold equations.
    let mut block = None::<String>;
    // What stands behind the text of a link that leads nowhere.
    let mut links: Vec<Option<String>> = vec![];
    for event in parse(text) {
        match event {
            Event::Start(Tag::Heading { level: HeadingLevel::H1, .. }) => in_title = true,
            Event::End(TagEnd::Heading(HeadingLevel::H1)) => in_title = false,
            _ if in_title => {}
            Event::Start(Tag::Heading { level, .. }) => {
                let id = ids.next().map(|id| CowStr::from(id.to_owned()));
                let (classes, attrs) = (vec![], vec![]);
                events.push(Event::Start(Tag::Heading { level, id, classes, attrs }));
            }
            Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
                match link(&dest_url, link_type, &mut resolve)? {
                    Target::Text(behind) => links.push(Some(behind)),
                    Target::Address(address) => {
                        links.push(None);
                        let dest_url = address.into();
                        events.push(Event::Start(Tag::Link { link_type, dest_url, title, id }));
                    }
                }
            }
            Event::End(TagEnd::Link) => match links.pop().flatten() {
                Some(behind) => events.push(Event::Text(behind.into())),
                None => events.push(Event::End(TagEnd::Link)),
            },
            Event::Start(Tag::Image { link_type, dest_url, title, id }) => {
                let dest_url = match resolve(&dest_url, true)? {
                    Target::Address(address) | Target::Text(address) => address.into(),
                };
                events.push(Event::Start(Tag::Image { link_type, dest_url, title, id }));
            }
            Event::Start(Tag::CodeBlock(kind)) if equations && is_text(&kind) => {
                block = Some(String::new());
            }
            Event::Text(text) if block.is_some() => block.iter_mut().for_each(|b| *b += &text),
            Event::End(TagEnd::CodeBlock) if block.is_some() => {
                let block = block.take().unwrap_or_default();
                let html = match equations::is_equations(&block) {
                    true => format!("<div class=\"wide\">{}</div>\n", equations::tables(&block)),
                    false => format!("<pre><code>{}</code></pre>\n", escape(&block)),
                };
                events.push(Event::Html(html.into()));
            }
            Event::Start(Tag::CodeBlock(kind)) => {
                in_code = true;
                in_rust = is_rust(&kind);
                events.push(Event::Start(Tag::CodeBlock(kind)));
            }
            Event::Text(code) if in_rust => events.push(Event::Text(shown(&code).into())),
            Event::End(TagEnd::CodeBlock) => {
                (in_rust, in_code) = (false, false);
                events.push(Event::End(TagEnd::CodeBlock));
            }
            Event::Text(text) if !in_code && text.contains(['_', '^']) => {
                events.push(Event::InlineHtml(equations::letters(&text).into()));
            }
            Event::Start(Tag::Table(columns)) => {
                events.push(Event::Html("<div class=\"wide\">".into()));
                events.push(Event::Start(Tag::Table(columns)));
            }
            Event::End(TagEnd::Table) => {
                events.push(Event::End(TagEnd::Table));
                events.push(Event::Html("</div>\n".into()));
            }
            // No text of the repository is written as html.
            Event::Html(html) | Event::InlineHtml(html) => events.push(Event::Text(html)),
            other => events.push(other),
        }
    }
    let mut written = String::new();
    html::push_html(&mut written, events.into_iter());
    // The only inline styles that are written; in text, quotes of attributes are not within a tag.
    for side in ["left", "center", "right"] {
        for cell in ["td", "th"] {
            let styled = format!("<{cell} style=\"text-align: {side}\">");
            written = written.replace(&styled, &format!("<{cell} class=\"{side}\">"));
        }
    }
    Ok(written)
}

fn link(
    address: &str,
    link_type: LinkType,
    resolve: &mut impl FnMut(&str, bool) -> Result<Target>,
) -> Result<Target> {
    match link_type {
        LinkType::Email => Ok(Target::Text(String::new())),
        _ if address.contains("::") => Ok(Target::Text(String::new())),
        _ => resolve(address, false),
    }
}

fn is_text(kind: &CodeBlockKind) -> bool {
    matches!(kind, CodeBlockKind::Fenced(name) if &**name == "text")
}

/// Rust by name, or in a comment of rustdoc without one.
fn is_rust(kind: &CodeBlockKind) -> bool {
    match kind {
        CodeBlockKind::Fenced(name) => name.is_empty() || name.starts_with("rust"),
        CodeBlockKind::Indented => false,
    }
}

/// Without the lines that rustdoc hides.
fn shown(code: &str) -> String {
    let mut shown = String::new();
    for line in code.lines().filter(|line| *line != "#" && !line.starts_with("# ")) {
        // Writing to a string cannot fail.
        let _ = writeln!(shown, "{line}");
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    fn html(text: &str) -> String {
        let found = headings(text, &mut Ids::default());
        let resolve = |address: &str, _| Ok(Target::Address(format!("to/{address}")));
        render(text, &found, true, resolve).unwrap()
    }

    #[test]
    fn headings_have_ids_and_the_title_is_left_out() {
        let text = "# Title\n\n## F_n(h), and `K`\n\n## A\n\n### A\n";
        let found = headings(text, &mut Ids::default());
        let ids: Vec<&str> = found.iter().map(|heading| heading.id.as_str()).collect();
        assert_eq!(ids, ["f_nh-and-k", "a", "a-1"]);
        let html = html(text);
        assert!(
            html.starts_with("<h2 id=\"f_nh-and-k\">F<sub>n</sub>(h), and <code>K</code></h2>"),
            "{html}"
        );
        assert!(!html.contains("Title"));
    }

    #[test]
    fn nothing_in_a_text_becomes_an_element_or_a_style() {
        let html = html("<script>x</script> a <b>b</b>\n\n|a|\n|--:|\n|<i>|\n");
        for forbidden in ["<script", "<b>", "<i>", "style="] {
            assert!(!html.contains(forbidden), "{forbidden} in {html}");
        }
        assert!(html.contains("<td class=\"right\">"), "{html}");
    }

    #[test]
    fn equations_are_tables_and_letters_are_lowered_outside_code() {
        let html = html("w_c of `w_c`\n\n```text\nF = w^2\n```\n```sh\na_b = 2\n```\n");
        assert!(html.starts_with("<p>w<sub>c</sub> of <code>w_c</code></p>"), "{html}");
        assert!(html.contains("<td>F = w<sup>2</sup></td>") && html.contains(">a_b = 2"), "{html}");
    }

    #[test]
    fn sections_have_the_words_below_each_heading_without_code() {
        let text = "# T\n\nlead\nmore\n\n## A\n\n|a|b|\n|-|-|\n|`c`|d|\n\n```sh\nx\n```\n## B\n";
        let found = sections(text);
        let words: Vec<Vec<&str>> = found.iter().map(|s| s.split_whitespace().collect()).collect();
        assert_eq!(words, [vec!["lead", "more"], vec!["a", "b", "c", "d"], vec![]]);
    }

    #[test]
    fn links_of_rustdoc_are_text_and_its_hidden_lines_are_hidden() {
        let html =
            html("[`Joint::path`] [a](Joint::b) [c](d.md)\n\n```rust\n# hidden\n#[x]\n```\n");
        assert!(html.starts_with("<p><code>Joint::path</code> a <a href=\"to/d.md\">c</a></p>"));
        assert!(!html.contains("hidden") && html.contains("#[x]"), "{html}");
    }

    #[test]
    fn a_link_that_leads_nowhere_is_text_with_its_address() {
        let behind = |_: &str, _| Ok(Target::Text(" (example.org)".into()));
        let html = render("[there](https://example.org)", &[], false, behind).unwrap();
        assert_eq!(html, "<p>there (example.org)</p>\n");
    }
}
