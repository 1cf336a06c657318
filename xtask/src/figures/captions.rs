//! The words of the figures: titles and captions by name, and what several captions have in common.

use anyhow::{Context, Result};
use asperity_plot::Figure;

const TEXT: &str = include_str!("captions.txt");

/// The texts of a figure: a title, paragraphs, and a line `- key: label` for a curve.
fn part(name: &str) -> Result<&'static str> {
    let start = format!("## {name}: ");
    let own = TEXT.split("\n\n").find_map(|part| part.trim().strip_prefix(&start));
    own.with_context(|| format!("{name} has no caption"))
}

/// The title and the paragraphs of a caption.
///
/// # Errors
/// A name without a caption.
pub fn of(name: &str) -> Result<(String, Vec<String>)> {
    let mut lines = part(name)?.lines().filter(|line| !line.starts_with("- ")).map(filled);
    Ok((lines.next().unwrap_or_default(), lines.collect()))
}

/// A paragraph with what stands for `{words}` in it.
fn filled(paragraph: &str) -> String {
    let mut filled = paragraph.to_owned();
    for (key, words) in TEXT.lines().filter_map(|line| line.strip_prefix('{')?.split_once("}: ")) {
        filled = filled.replace(&format!("{{{key}}}"), words);
    }
    filled
}

/// A figure with its title, its caption, to which it adds the paragraphs that it has, and the
/// labels of its curves.
///
/// # Errors
/// A name without a caption.
pub fn with_caption(name: &str, mut figure: Figure) -> Result<Figure> {
    let (title, mut caption) = of(name)?;
    caption.extend(figure.caption.iter().map(|paragraph| filled(paragraph)));
    (figure.title, figure.caption) = (title, caption);
    let curves = figure.panels.iter_mut().flat_map(|panel| &mut panel.curves);
    for curve in curves.filter(|curve| curve.label.is_empty()) {
        let start = format!("- {}: ", curve.key);
        let label = part(name)?.lines().find_map(|line| line.strip_prefix(&start));
        label.into_iter().for_each(|label| curve.label = label.into());
    }
    Ok(figure)
}
