//! Words of instruments and their meanings, and what is written beside them: numbers and units.

use std::collections::HashMap;
use std::sync::LazyLock;

type Meanings = HashMap<(&'static str, String), Vec<&'static str>>;

/// Of a kind (`header`, `column`, `unit`) and a word.
static MEANINGS: LazyLock<Meanings> = LazyLock::new(|| {
    let mut meanings = Meanings::new();
    for row in include_str!("words.csv").lines().filter(|row| !row.starts_with('#')) {
        let (head, words) = row.split_once(',').unwrap_or((row, ""));
        let (kind, meaning) = head.split_once(' ').unwrap_or((head, ""));
        for word in words.split(',') {
            let known = meanings.entry((kind, plain(word))).or_default();
            if !known.contains(&meaning) {
                known.push(meaning);
            }
        }
    }
    meanings
});

/// The characters that words are compared without.
const IGNORED: &str = "_-.'\"#()[]";

/// A word as it is compared.
pub(crate) fn plain(word: &str) -> String {
    let kept = |c: &char| !c.is_whitespace() && !IGNORED.contains(*c);
    word.chars().filter(kept).flat_map(char::to_lowercase).collect()
}

/// The meanings of a word of a kind.
pub(crate) fn meanings(kind: &'static str, word: &str) -> &'static [&'static str] {
    MEANINGS.get(&(kind, plain(word))).map_or(&[], Vec::as_slice)
}

/// What a unit is: the name of a unit of length, `points`, or `other`.
pub(crate) fn unit_meaning(text: &str) -> Option<&'static str> {
    let text = text.trim().trim_matches(['"', '\'', '.', '[', ']', '(', ')']).trim();
    match text {
        "A" => Some("angstrom"),
        _ if text.contains([' ', '-', '.', '_']) => None,
        _ => meanings("unit", text).first().copied(),
    }
}

/// A name and the unit after it: `x [mm]`, `z (-> µm)`, `x_mm`, `x / mm`, `x in mm`, `Lateral mm`,
/// or `mm` alone.
pub(crate) fn named(text: &str) -> (&str, Option<&str>) {
    let text = text.trim().trim_matches('"').trim();
    let known = |unit: &&str| unit_meaning(unit).is_some();
    if let Some((name, rest)) = text.split_once(['[', '(']) {
        let unit = rest.trim_end_matches([']', ')', '"']).rsplit("->").next();
        let unit = unit.map(str::trim).filter(known);
        return (if name.is_empty() && unit.is_none() { text } else { name.trim() }, unit);
    }
    let at = text.rfind(['_', '/', ' ']).map_or(0, |at| at + 1);
    let (name, unit) = text.split_at(at);
    // A single letter is the name of a column, as in `a`, and points are counted.
    let alone = |meaning: &str| at > 0 || unit.chars().count() > 1 && meaning != "points";
    if !unit_meaning(unit).is_some_and(alone) {
        return (text, None);
    }
    let name = name.trim_end_matches(['_', '/', ' ']);
    (name.strip_suffix(" in").unwrap_or(name), Some(unit))
}

/// The numbers in a text and the word after the last of them: `10.0 x 5 µm`, `"250.000","nm"`.
/// Numbers have a decimal point or comma; `separator` parts them as spaces do.
pub(crate) fn quantities(text: &str, separator: char) -> (Vec<f64>, Option<&str>) {
    let (mut numbers, mut unit) = (vec![], None);
    let part = |c: char| c.is_whitespace() || c == separator || "\";".contains(c);
    for word in text.split(part).filter(|word| !word.is_empty()) {
        let letter = |c: char| c.is_alphabetic() && !matches!(c, 'e' | 'E');
        let end = if number(word).is_some() { None } else { word.find(letter) };
        let (value, rest) = word.split_at(end.unwrap_or(word.len()));
        match number(value) {
            Some(value) => {
                numbers.push(value);
                unit = Some(rest).filter(|rest| !rest.is_empty());
            }
            None => unit = unit.or(Some(word).filter(|_| !numbers.is_empty() && word != "x")),
        }
    }
    (numbers, unit)
}

/// A number with a decimal point or comma.
pub(crate) fn number(text: &str) -> Option<f64> {
    text.parse().ok().or_else(|| text.replacen(',', ".", 1).parse().ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_have_meanings_in_several_spellings() {
        for word in ["Pixel_Size", "pixel size", "PixelSize", "Cellsize"] {
            assert_eq!(meanings("header", word), ["pixel"], "{word}");
        }
        assert_eq!(meanings("header", "Bit2nm"), ["factor@nm"]);
        assert_eq!(meanings("header", "magnification factor"), [""; 0]);
        assert_eq!(meanings("column", "#"), ["index"]);
        for (text, meaning) in [
            ("um.", Some("um")),
            ("A", Some("angstrom")),
            ("a", None),
            ("N/m", None),
            ("N-m", None),
        ] {
            assert_eq!(unit_meaning(text), meaning, "{text}");
        }
    }

    #[test]
    fn units_stand_behind_names() {
        for (text, found) in [
            ("x [\u{b5}m]", ("x", Some("\u{b5}m"))),
            ("X_(microns)", ("X_", Some("microns"))),
            ("z_um", ("z", Some("um"))),
            ("y in \u{3bc}m", ("y", Some("\u{3bc}m"))),
            ("Raw Micrometer", ("Raw", Some("Micrometer"))),
            ("Slope (urad)", ("Slope", Some("urad"))),
            ("factor (-> m)", ("factor", Some("m"))),
            ("um", ("", Some("um"))),
            ("m", ("m", None)),
            ("Height [trace]", ("Height", None)),
            ("y1", ("y1", None)),
        ] {
            assert_eq!(named(text), found, "{text}");
        }
    }

    #[test]
    fn quantities_are_numbers_and_a_unit() {
        for (text, numbers, unit) in [
            ("12.00 \u{b5}m", vec![12.0], Some("\u{b5}m")),
            ("5678,9nm", vec![5678.9], Some("nm")),
            ("3.5e-007 m", vec![3.5e-7], Some("m")),
            ("10 x 5 um (scan)", vec![10.0, 5.0], Some("um")),
            ("\"250.000\",\"nm\"", vec![250.0], Some("nm")),
            ("7\t4\t0.002", vec![7.0, 4.0, 0.002], None),
            ("none", vec![], None),
        ] {
            assert_eq!(
                quantities(text, if text.starts_with('"') { ',' } else { ' ' }),
                (numbers, unit)
            );
        }
    }
}
