//! Text in html, and the head of every page: of the explorer, its other pages, and the guide.

/// Text as html, also within an attribute.
#[must_use]
pub fn escape(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    text.replace('"', "&quot;")
}

/// A whole page, by its title and a sentence about it, its style beside the common one, and its
/// script, if it has one, with whether that starts the module and says on the page how far it is.
/// It may load nothing but its own files, and no script or style within it.
#[must_use]
pub fn page(about: [&str; 2], style: &str, script: Option<(&str, bool)>, body: &str) -> String {
    let [title, description] = about.map(escape);
    let (allowed, state) = match script {
        None => ("", ""),
        Some((_, false)) => (" script-src 'self'; connect-src 'self';", ""),
        Some((_, true)) => (
            " script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'; worker-src 'self';",
            " data-state=\"loading\"",
        ),
    };
    let script = script.map_or_else(String::new, |(name, _)| {
        format!("<script type=\"module\" src=\"{name}\"></script>\n")
    });
    include_str!("head.html")
        .replace("<!-- state -->", state)
        .replace("<!-- allowed -->", allowed)
        .replace("<!-- description -->", &description)
        .replace("<!-- title -->", &title)
        .replace("<!-- style -->", style)
        .replace("<!-- script -->\n", &script)
        .replace("<!-- body -->\n", body)
}

/// A page of the explorer, whose head is stated in a comment before its body; `None` without one.
#[must_use]
pub fn of_explorer(text: &str) -> Option<String> {
    let (stated, body) = text.strip_prefix("<!-- head\n")?.split_once("-->\n")?;
    let of = |key: &str| stated.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(": "));
    let script = of("script").map(|script| (script, true));
    Some(page([of("title")?, of("description")?], "style.css", script, body))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_no_markup_and_ends_no_attribute() {
        assert_eq!(escape("a > b & \"<c>\""), "a &gt; b &amp; &quot;&lt;c&gt;&quot;");
    }

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
