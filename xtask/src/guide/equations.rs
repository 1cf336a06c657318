//! Equations as people read them: blocks of plain text as tables with raised and lowered letters.
//!
//! The files themselves keep plain text, which GitHub, rustdoc and an editor show alike.

use std::collections::BTreeSet;

use crate::html::escape;

/// Whether a block of text holds equations, not numbers or the output of a program.
#[must_use]
pub fn is_equations(block: &str) -> bool {
    block.contains('=') || block.contains('^') || block.contains('≤')
}

/// A block as tables, one for each part between empty lines. What starts at the same place of two
/// lines is in the same column.
#[must_use]
pub fn tables(block: &str) -> String {
    let lines: Vec<&str> = block.trim_end().lines().collect();
    lines.split(|line| line.trim().is_empty()).map(table).collect()
}

fn table(lines: &[&str]) -> String {
    let rows: Vec<Vec<(usize, String)>> = lines.iter().map(|line| segments(line)).collect();
    let starts: BTreeSet<usize> = rows.iter().flatten().map(|(start, _)| *start).collect();
    // Each symbol is followed by its description.
    let described = |pair: &[(usize, String)]| pair.len() == 2 && words(&pair[1].1) > 0;
    let is_list = rows.iter().all(|row| row.chunks(2).all(described));
    let symbols = if is_list { " symbols" } else { "" };
    let row = |row: &Vec<(usize, String)>| {
        let cell = |(k, (start, text)): (usize, &(usize, String))| {
            let end = row.get(k + 1).map_or(usize::MAX, |(next, _)| *next);
            let span = starts.range(start..&end).count();
            let span = if span > 1 { format!(" colspan=\"{span}\"") } else { String::new() };
            // Words about a symbol, which may take several lines.
            let class = if words(text) > 1 { " class=\"words\"" } else { "" };
            format!("<td{span}{class}>{}</td>", formula(text))
        };
        let cells: String = row.iter().enumerate().map(cell).collect();
        let first = row.first().map_or(0, |(start, _)| *start);
        match starts.range(..first).count() {
            0 => format!("<tr>{cells}</tr>\n"),
            indent => format!("<tr><td colspan=\"{indent}\"></td>{cells}</tr>\n"),
        }
    };
    let rows: String = rows.iter().map(row).collect();
    format!("<table class=\"equations{symbols}\">\n{rows}</table>\n")
}

/// The words of a part that are longer than the name of a function.
fn words(text: &str) -> usize {
    let letters = |word: &&str| word.chars().filter(|c| c.is_alphabetic()).count() > 3;
    text.split(' ').filter(letters).count()
}

/// The parts of a line between two or more spaces, with the places of their first letters; what
/// follows a comma belongs to the part before.
fn segments(line: &str) -> Vec<(usize, String)> {
    let (mut found, mut spaces) = (Vec::<(usize, String)>::new(), 2);
    for (at, letter) in line.chars().enumerate() {
        let goes_on = found.last().is_some_and(|(_, text)| text.ends_with(','));
        match letter {
            ' ' => spaces += 1,
            _ if spaces > 1 && !goes_on => {
                found.push((at, letter.to_string()));
                spaces = 0;
            }
            _ => {
                if let Some((_, text)) = found.last_mut() {
                    let wide = if spaces > 1 { "\u{2003}" } else { " " };
                    text.push_str(if spaces > 0 { wide } else { "" });
                    text.push(letter);
                }
                spaces = 0;
            }
        }
    }
    found
}

/// A formula as html: `w^(3/2)` raised, `w_c` lowered, and minus signs as wide as plus signs.
fn formula(text: &str) -> String {
    // Names of code stay as they are.
    let parts = text.split('`').enumerate().map(|(k, part)| match k % 2 {
        0 => letters(&minus(part)),
        _ => format!("<code>{}</code>", escape(part)),
    });
    parts.collect()
}

/// A text with hyphens only within words: a minus follows no word of several letters.
fn minus(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let in_word = |k: usize| k >= 2 && letters[k - 2..k].iter().all(|c| c.is_alphabetic());
    let wide = |(k, c): (usize, &char)| if *c == '-' && !in_word(k) { '−' } else { *c };
    letters.iter().enumerate().map(wide).collect()
}

/// Text as html, with `σ_z` and `x^1.5` as people read them. Longer names with `_` are not changed.
#[must_use]
pub fn letters(text: &str) -> String {
    let (mut html, mut rest) = (String::new(), text);
    let mut before = [None, None];
    while let Some(letter) = rest.chars().next() {
        let after = &rest[letter.len_utf8()..];
        let joins = before[1].is_some_and(|c: char| c.is_alphanumeric() || ")]}'".contains(c));
        // A word has one letter before its lowered part.
        let single = !before[0].is_some_and(|c: char| c.is_alphabetic() || c == '_');
        let tag = match letter {
            '^' if joins => Some("sup"),
            '_' if joins && single && before[1] != Some(')') => Some("sub"),
            _ => None,
        };
        match tag.and_then(|tag| Some((tag, moved(after, tag)?))) {
            Some((tag, (inner, used))) => {
                html += &format!("<{tag}>{}</{tag}>", letters(&minus(inner)));
                rest = &after[used..];
                before = [None, Some('\'')];
            }
            None => {
                html += &escape(&letter.to_string());
                before = [before[1], Some(letter)];
                rest = after;
            }
        }
    }
    html
}

/// What is raised or lowered at the start of a text, without its brackets, and its length with
/// them.
fn moved<'t>(text: &'t str, tag: &str) -> Option<(&'t str, usize)> {
    let open = text.chars().next()?;
    if open == '{' || open == '(' && tag == "sup" {
        let (close, mut depth) = (if open == '{' { '}' } else { ')' }, 0);
        let (end, _) = text.char_indices().find(|(_, c)| {
            depth += i32::from(*c == open) - i32::from(*c == close);
            depth == 0
        })?;
        return Some((&text[1..end], end + 1));
    }
    let unsigned = if tag == "sup" { text.trim_start_matches(['-', '−']) } else { text };
    let while_in = |set: fn(char) -> bool| unsigned.find(|c| !set(c)).unwrap_or(unsigned.len());
    let start = unsigned.chars().next()?;
    let length = match (start, tag) {
        ('0'..='9' | '.', _) => while_in(|c| c.is_ascii_digit() || c == '.'),
        (letter, "sup") if letter.is_ascii_alphabetic() || letter == '∞' => letter.len_utf8(),
        (_, "sup") => return None,
        _ => while_in(|c| c.is_ascii_alphanumeric()),
    };
    // A full stop ends the sentence.
    let found = text[..text.len() - unsigned.len() + length].trim_end_matches('.');
    (!found.is_empty()).then_some((found, found.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_are_raised_and_lowered() {
        for (text, html) in [
            ("E √R w^(3/2)", "E √R w<sup>3/2</sup>"),
            ("1.03 x^1.425 < w_c.", "1.03 x<sup>1.425</sup> &lt; w<sub>c</sub>."),
            ("F_{3/2}(t), w_c' = 10^-5", "F<sub>3/2</sub>(t), w<sub>c</sub>' = 10<sup>−5</sup>"),
            ("1-x^-.28", "1-x<sup>−.28</sup>"),
            ("(x/1.9)^B", "(x/1.9)<sup>B</sup>"),
            ("∫ₜ^∞ (s-t)^n", "∫ₜ<sup>∞</sup> (s-t)<sup>n</sup>"),
            ("x^((a-1)/2) y", "x<sup>(a−1)/2</sup> y"),
            ("nominal_area, at-additive, a ^ b", "nominal_area, at-additive, a ^ b"),
            ("π R w_c S H", "π R w<sub>c</sub> S H"),
        ] {
            assert_eq!(letters(text), html);
        }
        assert_eq!(formula("-dF/dd - `a-b`"), "−dF/dd − <code>a-b</code>");
        assert_eq!(formula("elastic-plastic (y-1)"), "elastic-plastic (y−1)");
    }

    #[test]
    fn what_starts_at_the_same_place_is_in_the_same_column() {
        let block = "x ≤ 1    x^1.5   x\nx > 1            2x\n\nF  force (N)\n";
        let html = tables(block);
        assert_eq!(html.matches("<table").count(), 2);
        assert!(html.contains("<tr><td>x ≤ 1</td><td>x<sup>1.5</sup></td><td>x</td></tr>"));
        assert!(html.contains("<tr><td colspan=\"2\">x &gt; 1</td><td>2x</td></tr>"), "{html}");
        assert_eq!(segments("F = x,   A = y    area")[0], (0, "F = x,\u{2003}A = y".into()));
        for (block, symbols) in [
            ("F    force (N)    E   modulus (Pa)\nw_c = S R    critical interference (m)", true),
            ("x <= 1    x^1.5    x\nx > 1    3 x    2x    plastic, mean pressure", false),
        ] {
            assert_eq!(tables(block).contains("equations symbols"), symbols, "{block}");
        }
        assert!(!is_equations("x    2   3\nforce  -16.6  -15.5\n"));
    }
}
