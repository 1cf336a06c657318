//! Text in html, and the head of every page of the explorer.

/// Text as html, also within an attribute.
#[must_use]
pub fn escape(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    text.replace('"', "&quot;")
}

/// A page of the explorer, whose title, description and script, if it has one, are stated in a
/// comment before its body; `None` without. It may load nothing but its own files, and no script or
/// style within it.
#[must_use]
pub fn of_explorer(text: &str) -> Option<String> {
    let (stated, body) = text.strip_prefix("<!-- head\n")?.split_once("-->\n")?;
    let of = |key: &str| stated.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(": "));
    let [title, description] = [of("title")?, of("description")?].map(escape);
    let script = of("script");
    let (allowed, state) = match script {
        None => ("", ""),
        Some(_) => (
            " script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'; worker-src 'self';",
            " data-state=\"loading\"",
        ),
    };
    let script = script.map_or_else(String::new, |name| {
        format!("<script type=\"module\" src=\"{name}\"></script>\n")
    });
    let page = include_str!("head.html")
        .replace("<!-- state -->", state)
        .replace("<!-- allowed -->", allowed)
        .replace("<!-- description -->", &description)
        .replace("<!-- title -->", &title)
        .replace("<!-- script -->\n", &script)
        .replace("<!-- body -->\n", body);
    Some(page)
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
