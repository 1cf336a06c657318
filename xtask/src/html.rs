//! Text in html.

/// Text as html, also within an attribute.
#[must_use]
pub fn escape(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    text.replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_no_markup_and_ends_no_attribute() {
        assert_eq!(escape("a > b & \"<c>\""), "a &gt; b &amp; &quot;&lt;c&gt;&quot;");
    }
}
