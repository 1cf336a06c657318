//! Names of units as they are compared.

/// A unit without ignored characters, in ASCII.
pub(crate) fn plain(unit: &str) -> String {
    let left_out = |c: char| c.is_whitespace() || "^*\u{b7}".contains(c);
    let text: String = unit.chars().filter(|c| !left_out(*c)).collect();
    let text = text.replace(['\u{b5}', '\u{3bc}'], "u").replace('\u{b2}', "2");
    text.replace('\u{207b}', "-").replace(['\u{3a9}', '\u{2126}'], "ohm")
}
