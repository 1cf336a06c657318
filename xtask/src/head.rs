//! The head of every html page: of the explorer, its other pages, and the guide.

use crate::html::escape;

/// What a page has in its head.
#[derive(Debug, Clone, Copy)]
pub struct Head<'a> {
    /// Its title.
    pub title: &'a str,
    /// A sentence about it.
    pub description: &'a str,
    /// Its style, beside the common one.
    pub style: &'a str,
    /// Its script, if it has one.
    pub script: Option<&'a str>,
    /// Whether the script starts the module and says on the page how far it is.
    pub module: bool,
}

impl Head<'_> {
    /// A whole page with this head.
    #[must_use]
    pub fn page(&self, body: &str) -> String {
        let [title, description] = [self.title, self.description].map(escape);
        let (policy, style) = (self.policy(), self.style);
        let state = if self.module { " data-state=\"loading\"" } else { "" };
        let script =
            self.script.map(|name| format!("<script type=\"module\" src=\"{name}\"></script>\n"));
        let script = script.unwrap_or_default();
        format!(
            r##"<!DOCTYPE html>
<html lang="en"{state}>
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="referrer" content="no-referrer">
<meta name="description" content="{description}">
<title>{title}</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="common.css">
<link rel="stylesheet" href="{style}">
{script}</head>
{body}</html>
"##
        )
    }

    /// What the page may load: nothing but its own files, and no script or style within it.
    fn policy(&self) -> String {
        let script = match (self.script, self.module) {
            (None, _) => "",
            (Some(_), false) => " script-src 'self'; connect-src 'self';",
            (Some(_), true) => {
                " script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'; worker-src 'self';"
            }
        };
        format!(
            "default-src 'none';{script} style-src 'self'; img-src 'self' data:; base-uri 'none'; form-action 'none'"
        )
    }
}

/// A page of the explorer, whose head is stated in a comment before its body; `None` without one.
#[must_use]
pub fn of_explorer(text: &str) -> Option<String> {
    let (stated, body) = text.strip_prefix("<!-- head\n")?.split_once("-->\n")?;
    let of = |key: &str| stated.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(": "));
    let script = of("script");
    let (title, description) = (of("title")?, of("description")?);
    let head = Head { title, description, style: "style.css", script, module: script.is_some() };
    Some(head.page(body))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_may_load_what_its_script_needs_and_nothing_inline() {
        let text = "<!-- head\ntitle: a & b\ndescription: c\nscript: d.js\n-->\n<body></body>\n";
        let page = of_explorer(text).unwrap();
        assert!(page.contains("<title>a &amp; b</title>") && page.contains("src=\"d.js\""));
        assert!(page.contains("script-src 'self' 'wasm-unsafe-eval';"), "{page}");
        let still = of_explorer(&text.replace("script: d.js\n", "")).unwrap();
        assert!(
            !still.contains("<script")
                && !still.contains("script-src")
                && !page.contains("unsafe-inline"),
            "{still}"
        );
        assert!(of_explorer("<body></body>").is_none());
    }
}
