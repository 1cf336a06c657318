//! The room that text takes, by a table of widths instead of the system's fonts:
//! the same on every machine, and rather too wide than too narrow.

/// Widths of the letters from blank to tilde in hundredths of the size (DejaVu
/// Sans, which is wider than the other usual sans-serif fonts).
const WIDTHS: [u8; 95] = [
    32, 40, 46, 84, 64, 95, 78, 27, 39, 39, 50, 84, 32, 36, 32, 34, 64, 64, 64, 64, 64, 64, 64, 64,
    64, 64, 34, 34, 84, 84, 84, 53, 100, 68, 69, 70, 77, 63, 58, 77, 75, 29, 29, 66, 56, 86, 75,
    79, 60, 79, 69, 63, 61, 73, 68, 99, 69, 61, 69, 39, 34, 39, 84, 50, 50, 61, 63, 55, 63, 62, 35,
    63, 63, 28, 28, 58, 28, 97, 63, 61, 63, 63, 41, 52, 39, 63, 59, 82, 59, 59, 52, 64, 34, 64, 84,
];

/// Height of a line of text, in units of its size.
pub(crate) const LINE: f64 = 1.3;

/// Height of a capital letter, in units of its size.
pub(crate) const CAPITAL: f64 = 0.73;

/// The width of a text of this size in pixels, with three per cent to spare for
/// viewers that round the widths of letters up.
pub(crate) fn width(text: &str, size: f64) -> f64 {
    text.chars().map(|letter| f64::from(letter_width(letter))).sum::<f64>() * size / 97.0
}

fn letter_width(letter: char) -> u8 {
    let place = (letter as usize).wrapping_sub(32);
    if let Some(width) = WIDTHS.get(place) {
        return *width;
    }
    match letter {
        '\u{a0}' | '·' => 32,
        '⁻' | '⁺' => 53,
        '⁰' | '¹' | '²' | '³' | '⁴'..='⁹' | '₀'..='₉' => 40,
        '–' | '°' => 50,
        '×' | '−' | '≤' | '≥' | '≈' | 'ω' | '∞' => 84,
        '—' | '…' => 100,
        _ => 68,
    }
}

/// Breaks a text at its blanks and line breaks so that no line is wider than
/// asked, unless a single word is.
pub(crate) fn wrap(text: &str, size: f64, widest: f64) -> Vec<String> {
    let mut lines = Vec::new();
    for paragraph in text.lines() {
        let mut line = String::new();
        for word in paragraph.split(' ').filter(|word| !word.is_empty()) {
            let longer = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
            if line.is_empty() || width(&longer, size) <= widest {
                line = longer;
            } else {
                lines.push(std::mem::replace(&mut line, word.to_owned()));
            }
        }
        lines.push(line);
    }
    lines
}

/// The width of the widest of some lines.
pub(crate) fn widest(lines: &[String], size: f64) -> f64 {
    lines.iter().map(|line| width(line, size)).fold(0.0, f64::max)
}

/// A power of ten in raised figures, such as 10⁻³.
pub(crate) fn power_of_ten(exponent: i32) -> String {
    let raised = |digit: char| match digit {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        _ => '⁰',
    };
    let digits: String = exponent.to_string().chars().map(raised).collect();
    format!("10{digits}")
}

/// A number with a fixed count of decimals, a true minus sign and no minus zero.
pub(crate) fn decimal(value: f64, decimals: usize) -> String {
    let plain = format!("{value:.decimals$}");
    match plain.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| c == '0' || c == '.') => rest.to_owned(),
        Some(rest) => format!("−{rest}"),
        None => plain,
    }
}

/// The font size of an SVG text tag; `None` for any other line.
pub(super) fn size(line: &str) -> Option<f64> {
    let after = line.strip_prefix("<text ")?.split_once("font-size=\"")?.1;
    after.split_once('"')?.0.parse().ok()
}

/// Lowers the character after each underline of an SVG text, which then goes: `w_c` reads as people
/// write it. The character after that comes back to the line.
pub(super) fn subscripts(words: &str, size: f64) -> String {
    // Plain numbers: viewers disagree on em and per cent.
    let (small, drop) = (0.7 * size, 0.2 * size);
    let mut out = String::with_capacity(words.len());
    let mut rest = words;
    while let Some((before, after)) = rest.split_once('_') {
        out.push_str(before);
        let Some(index) = after.chars().next().filter(|c| c.is_alphanumeric()) else {
            out.push('_');
            rest = after;
            continue;
        };
        out.push_str(&format!("<tspan dy=\"{drop:.1}\" font-size=\"{small:.1}\">{index}</tspan>"));
        rest = &after[index.len_utf8()..];
        let next = match rest.find(';') {
            Some(end) if rest.starts_with('&') => end + 1,
            _ => rest.chars().next().map_or(0, char::len_utf8),
        };
        if next > 0 {
            out.push_str(&format!("<tspan dy=\"-{drop:.1}\">{}</tspan>", &rest[..next]));
            rest = &rest[next..];
        }
    }
    out + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_wrapped_within_the_width_and_loses_no_word() {
        let text = "one two three four five six seven eight nine ten";
        let lines = wrap(text, 40.0, 400.0);
        assert!(lines.len() > 1);
        assert!(lines.iter().all(|line| width(line, 40.0) <= 400.0));
        assert_eq!(lines.join(" "), text);
    }

    #[test]
    fn numbers_are_typeset() {
        assert_eq!(power_of_ten(-12), "10⁻¹²");
        assert_eq!(decimal(-0.001, 1), "0.0");
        assert_eq!(decimal(-2.5, 1), "−2.5");
    }

    #[test]
    fn underlines_lower_one_character_and_come_back() {
        assert_eq!(
            super::subscripts("w_c/R_p&lt;1", 100.0),
            "w<tspan dy=\"20.0\" font-size=\"70.0\">c</tspan><tspan dy=\"-20.0\">/</tspan>R<tspan dy=\"20.0\" font-size=\"70.0\">p</tspan><tspan dy=\"-20.0\">&lt;</tspan>1"
        );
        assert_eq!(super::subscripts("a_ b", 10.0), "a_ b");
        assert_eq!(super::size("<text x=\"1\" font-size=\"96.5\" y=\"2\">"), Some(96.5));
    }
}
