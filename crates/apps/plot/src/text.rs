//! The width of text by a table of letter widths: the same on every machine and in a browser, and
//! rather too wide than too narrow.

/// Widths of the letters from blank to tilde in hundredths of the size (DejaVu Sans, which is wider
/// than the other usual sans-serif fonts).
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
/// Size of a lowered letter, in units of the others'.
const LOWERED: f64 = 0.7;

/// The width of a text of this size, with three per cent to spare for viewers that round the widths
/// of letters up.
pub(crate) fn width(text: &str, size: f64) -> f64 {
    let (mut sum, mut lowered) = (0.0, false);
    for letter in text.chars() {
        if letter != '_' {
            sum += letter_width(letter) * if lowered { LOWERED } else { 1.0 };
        }
        lowered = letter == '_';
    }
    sum * size / 97.0
}

fn letter_width(letter: char) -> f64 {
    let listed = (letter as usize).checked_sub(32).and_then(|place| WIDTHS.get(place));
    f64::from(listed.copied().unwrap_or(match letter {
        '\u{a0}' | '·' => 32,
        '⁻' | '⁺' => 53,
        '⁰' | '¹' | '²' | '³' | '⁴'..='⁹' | '₀'..='₉' => 40,
        '–' | '°' => 50,
        '×' | '−' | '≤' | '≥' | '≈' | 'ω' | '∞' => 84,
        '—' | '…' => 100,
        _ => 68,
    }))
}

/// The width of the widest of some lines.
pub(crate) fn widest<'a>(lines: impl IntoIterator<Item = &'a String>, size: f64) -> f64 {
    lines.into_iter().map(|line| width(line, size)).fold(0.0, f64::max)
}

/// Breaks a text at its blanks so that no line is wider than asked, unless a single word is.
pub(crate) fn wrap(text: &str, size: f64, widest: f64) -> Vec<String> {
    let mut lines: Vec<String> = vec![];
    for word in text.split_ascii_whitespace() {
        match lines.last_mut() {
            Some(line) if width(line, size) + width(" ", size) + width(word, size) <= widest => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.into()),
        }
    }
    lines
}

/// Decimal prefixes with their factors, from the largest.
pub const PREFIXES: [(f64, &str); 7] =
    [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n")];
/// Units that take a prefix.
const PREFIXED: [&str; 8] = ["N", "Pa", "m", "N/m", "W/K", "S", "W/m2/K", "S/m2"];

/// The unit in which a number in an SI unit is legible, over that unit and by its name:
/// `(1e6, "MN/m")`; that unit itself where it takes no prefix or the number is out of all.
#[must_use]
pub fn legible(value: f64, unit: &str) -> (f64, String) {
    let (size, name) = (value.abs(), unit.replace("m2", "m²").replace("m3", "m³"));
    if !PREFIXED.contains(&unit) || !(1e-12..1e15).contains(&size) {
        return (1.0, name);
    }
    let fits = PREFIXES.into_iter().find(|(factor, _)| size >= *factor);
    let (factor, prefix) = fits.unwrap_or(PREFIXES[PREFIXES.len() - 1]);
    (factor, format!("{prefix}{name}"))
}

/// A power of ten in raised figures, such as 10⁻³.
#[must_use]
pub(crate) fn power_of_ten(exponent: i32) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize]);
    format!("10{}", exponent.to_string().chars().map(raised).collect::<String>())
}

/// A number in the usual notation, with a true minus sign: 0.25, −3, 2.5·10⁻⁷.
#[must_use]
pub fn number(value: f64) -> String {
    // Five digits, without the rounding errors of a sum of steps.
    let rounded: f64 = format!("{value:.4e}").parse().unwrap_or(value);
    let (sign, size) = (if rounded < 0.0 { "−" } else { "" }, rounded.abs());
    if size == 0.0 || !size.is_finite() || (1e-3..1e5).contains(&size) {
        return format!("{sign}{size}");
    }
    let text = format!("{size:e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let power = power_of_ten(exponent.parse().unwrap_or(0));
    if digits == "1" { format!("{sign}{power}") } else { format!("{sign}{digits}·{power}") }
}

/// A number with the decimals of a step, and a true minus sign.
pub(crate) fn stepped(value: f64, step: f64) -> String {
    // A step of 0.1 may come as 0.0999.
    let decimals = (-(1.01 * step).log10().floor()).clamp(0.0, 12.0) as usize;
    // No minus at 0.
    let rounded = if value.abs() < 1e-6 * step { 0.0 } else { value };
    format!("{rounded:.decimals$}").replace('-', "−")
}

pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// The content of a text tag: letters after an underscore are lowered, and the rest follows in a
/// span that raises the line again, blanks included.
pub(crate) fn spans(text: &str, size: f64) -> String {
    let mut pieces = text.split('_');
    let mut out = escaped(pieces.next().unwrap_or_default());
    for piece in pieces {
        let Some(index) = piece.chars().next().filter(|c| c.is_alphanumeric()) else {
            out += &format!("_{}", escaped(piece));
            continue;
        };
        // Plain numbers: viewers disagree on em and per cent.
        let (small, drop) = (LOWERED * size, 0.2 * size);
        let rest = escaped(&piece[index.len_utf8()..]);
        out += &format!("<tspan dy=\"{drop:.1}\" font-size=\"{small:.1}\">{index}</tspan>");
        out += &format!("<tspan dy=\"-{drop:.1}\">{rest}</tspan>");
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_typeset() {
        assert_eq!(power_of_ten(-12), "10⁻¹²");
        let texts = [0.30000000000000004, -3.0, 0.0, 1e-7, 2.5e-7, 1234.0, 2e5].map(number);
        assert_eq!(texts, ["0.3", "−3", "0", "10⁻⁷", "2.5·10⁻⁷", "1234", "2·10⁵"]);
    }
}
