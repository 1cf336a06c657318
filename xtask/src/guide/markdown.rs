//! Markdown to html that needs no inline style or script.

use std::collections::HashMap;

use anyhow::Result;
use pulldown_cmark::{
    BrokenLink, CodeBlockKind, CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd, html,
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
    /// The words below it, without code.
    pub words: String,
}

/// Where a link leads.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LinkTarget {
    /// An address to link.
    Address(String),
    /// Nowhere in the guide: the text stays, followed by this, if it is not empty.
    Text(String),
}

/// Ids of headings, unique on one page.
#[derive(Debug, Default)]
pub struct Ids(HashMap<String, usize>);

impl Ids {
    /// The id of a heading in the way of GitHub.
    fn of(&mut self, text: &str) -> String {
        let lower = text.to_lowercase().replace(' ', "-");
        let kept = |c: &char| c.is_alphanumeric() || matches!(c, '-' | '_');
        let slug: String = lower.chars().filter(kept).collect();
        let count = self.0.entry(slug.clone()).or_default();
        *count += 1;
        if *count == 1 { slug } else { format!("{slug}-{}", *count - 1) }
    }
}

fn parse(text: &str) -> impl Iterator<Item = Event<'_>> {
    // A link of rustdoc has no address here.
    let broken = |link: BrokenLink| {
        link.reference.starts_with('`').then_some((CowStr::from("::"), CowStr::from("")))
    };
    let options = Options::ENABLE_TABLES | Options::ENABLE_STRIKETHROUGH;
    Parser::new_with_broken_link_callback(text, options, Some(broken))
}

/// A text by its headings.
pub struct Outline {
    /// The words before the first heading below the title.
    pub lead: String,
    /// The headings below the title, in order.
    pub headings: Vec<Heading>,
}

impl Outline {
    /// That of a text, with ids that are new among `ids`.
    pub fn new(text: &str, ids: &mut Ids) -> Self {
        let mut found = Self { lead: String::new(), headings: vec![] };
        let (mut own, mut title, mut in_code) = (Ids::default(), None::<String>, false);
        for event in parse(text) {
            let Self { lead, headings } = &mut found;
            let words = headings.last_mut().map_or(lead, |heading| &mut heading.words);
            match event {
                Event::Start(Tag::Heading { .. }) => title = Some(String::new()),
                Event::End(TagEnd::Heading(level)) => {
                    let text = title.take().unwrap_or_default();
                    let anchor = own.of(&text);
                    if level != HeadingLevel::H1 {
                        let (id, words) = (ids.of(&text), String::new());
                        headings.push(Heading { id, text, anchor, words });
                    }
                }
                Event::Start(Tag::CodeBlock(_)) => in_code = true,
                Event::End(TagEnd::CodeBlock) => in_code = false,
                Event::Text(part) | Event::Code(part) if !in_code => {
                    *title.as_mut().unwrap_or(words) += &part;
                }
                // Words of two blocks or cells are apart.
                Event::End(TagEnd::Link | TagEnd::Emphasis | TagEnd::Strong | TagEnd::Image) => {}
                Event::SoftBreak | Event::HardBreak | Event::End(_) => words.push(' '),
                _ => {}
            }
        }
        found
    }
}

/// Writes a text as html. Its title is left out, as the page has one; `headings` are those of
/// its [`Outline`], blocks of plain text that hold equations become tables, and `resolve` returns
/// where a link (`false`) or a picture (`true`) leads.
///
/// # Errors
/// Those of `resolve`.
pub fn render(
    text: &str,
    headings: &[Heading],
    mut resolve: impl FnMut(&str, bool) -> Result<LinkTarget>,
) -> Result<String> {
    let mut ids = headings.iter().map(|heading| CowStr::from(heading.id.as_str()));
    let (mut events, mut in_title) = (vec![], false);
    // The text of a block of code.
    let mut code = None::<String>;
    // What stands behind the text of a link that leads nowhere.
    let mut links: Vec<Option<String>> = vec![];
    for event in parse(text) {
        match event {
            Event::Start(Tag::Heading { level: HeadingLevel::H1, .. }) => in_title = true,
            Event::End(TagEnd::Heading(HeadingLevel::H1)) => in_title = false,
            _ if in_title => {}
            Event::Start(Tag::Heading { level, classes, attrs, .. }) => {
                events.push(Event::Start(Tag::Heading { level, id: ids.next(), classes, attrs }));
            }
            Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
                links.push(match resolve(&dest_url, false)? {
                    LinkTarget::Text(behind) => Some(behind),
                    LinkTarget::Address(address) => {
                        let dest_url = address.into();
                        events.push(Event::Start(Tag::Link { link_type, dest_url, title, id }));
                        None
                    }
                });
            }
            Event::End(TagEnd::Link) => events.push(match links.pop().flatten() {
                Some(behind) => Event::Text(behind.into()),
                None => Event::End(TagEnd::Link),
            }),
            Event::Start(Tag::Image { link_type, dest_url, title, id }) => {
                let (LinkTarget::Address(dest_url) | LinkTarget::Text(dest_url)) =
                    resolve(&dest_url, true)?;
                let dest_url = dest_url.into();
                events.push(Event::Start(Tag::Image { link_type, dest_url, title, id }));
            }
            Event::Start(Tag::CodeBlock(kind)) => {
                code = Some(String::new());
                events.push(Event::Start(Tag::CodeBlock(kind)));
            }
            Event::Text(text) if code.is_some() => code.iter_mut().for_each(|code| *code += &text),
            Event::End(TagEnd::CodeBlock) => {
                let start = events.pop();
                events.extend(block(start, &code.take().unwrap_or_default()));
            }
            Event::Text(text) if text.contains(['_', '^']) => {
                events.push(Event::InlineHtml(equations::letters(&text).into()));
            }
            // No text of the repository is written as html.
            Event::Html(html) | Event::InlineHtml(html) => events.push(Event::Text(html)),
            other => events.push(other),
        }
    }
    let mut written = String::new();
    html::push_html(&mut written, events.into_iter());
    for (tag, wide) in [
        ("<table><thead>", "<div class=\"wide\"><table><thead>"),
        ("</tbody></table>\n", "</tbody></table>\n</div>\n"),
        ("<img src=", "<img loading=\"lazy\" src="),
    ] {
        written = written.replace(tag, wide);
    }
    // The only inline styles that are written; in text, quotes of attributes are not within a tag.
    for (side, cell) in ["left", "center", "right"].iter().flat_map(|s| [(s, "td"), (s, "th")]) {
        let styled = format!("<{cell} style=\"text-align: {side}\">");
        written = written.replace(&styled, &format!("<{cell} class=\"{side}\">"));
    }
    Ok(written)
}

/// A block of code: equations as tables, and Rust, by name or in a comment of rustdoc without one,
/// without the lines that rustdoc hides.
fn block<'t>(start: Option<Event<'t>>, code: &str) -> Vec<Event<'t>> {
    let name = match &start {
        Some(Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(name)))) => name,
        _ => "indented",
    };
    let hidden = |line: &&str| matches!(line.trim_end_matches('\n'), "#") || line.starts_with("# ");
    let shown = match name {
        "text" if equations::is_equations(code) => {
            let tables = format!("<div class=\"wide\">{}</div>\n", equations::tables(code));
            return vec![Event::Html(tables.into())];
        }
        "text" => {
            return vec![Event::Html(format!("<pre><code>{}</code></pre>\n", escape(code)).into())];
        }
        name if name.is_empty() || name.starts_with("rust") => {
            code.split_inclusive('\n').filter(|line| !hidden(line)).collect()
        }
        _ => code.to_owned(),
    };
    start.into_iter().chain([Event::Text(shown.into()), Event::End(TagEnd::CodeBlock)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn html(text: &str) -> String {
        let found = Outline::new(text, &mut Ids::default()).headings;
        let resolve = |address: &str, _| {
            Ok(match address.contains("::") {
                true => LinkTarget::Text(String::new()),
                false => LinkTarget::Address(format!("to/{address}")),
            })
        };
        render(text, &found, resolve).unwrap()
    }

    #[test]
    fn headings_have_ids_and_the_title_is_left_out() {
        let text = "# Title\n\n## F_n(h), and `K`\n\n## A\n\n### A\n";
        let found = Outline::new(text, &mut Ids::default()).headings;
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
        let Outline { lead, headings: found } = Outline::new(text, &mut Ids::default());
        let all = [&lead].into_iter().chain(found.iter().map(|heading| &heading.words));
        let words: Vec<Vec<&str>> = all.map(|s| s.split_whitespace().collect()).collect();
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
        let behind = |_: &str, _| Ok(LinkTarget::Text(" (example.org)".into()));
        let html = render("[there](https://example.org)", &[], behind).unwrap();
        assert_eq!(html, "<p>there (example.org)</p>\n");
    }
}
