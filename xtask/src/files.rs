//! Writing the figures, or checking that the committed ones are up to date.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use asperity::Evidence;
use asperity_plot::draw;
use rayon::prelude::*;

use crate::figures::captions::with_caption;
use crate::figures::{FIGURES, FigureSpec, measured, world};
use crate::folder::{Fresh, read, save};
use crate::table::{GUARD, agree};

/// A figure's csv and svg. A committed csv stays while its numbers agree with fresh ones; the svg
/// is drawn from it.
///
/// # Errors
/// A figure that cannot be computed or drawn.
pub fn fresh(folder: &Path, (name, table, style): &FigureSpec) -> Result<[Fresh; 2]> {
    let numbers = table().with_context(|| format!("the table of {name}"))?.into_text();
    let csv = match read(&folder.join(format!("{name}.csv"))) {
        Ok(committed) if agree(&committed, &numbers, GUARD) => committed,
        _ => numbers,
    };
    let svg = style(&csv).and_then(|figure| Ok(draw(&with_caption(name, figure)?, &csv)?));
    let svg = svg.with_context(|| format!("the picture of {name}"))?;
    Ok([(format!("{name}.csv"), csv), (format!("{name}.svg"), svg)])
}

/// All figures, and what is made of the committed measurements and of the figures' numbers.
fn all(folder: &Path) -> Result<Vec<Fresh>> {
    let figures = FIGURES.par_iter().map(|spec| fresh(folder, spec));
    let mut all = figures.collect::<Result<Vec<_>>>()?.concat();
    all.push(measured::picture(folder)?);
    let text = |name: &str| {
        let found = all.iter().find(|(file, _)| *file == format!("{name}.csv"));
        found.map(|(_, text)| text.as_str()).with_context(|| name.to_owned())
    };
    let world = world::summary::table(text, &Evidence::with_models()?)?;
    all.push(("world.md".to_owned(), world));
    Ok(all)
}

/// Writes the figures; returns the paths written.
///
/// # Errors
/// A figure that cannot be computed, a file that cannot be written.
pub fn write(folder: &Path) -> Result<Vec<PathBuf>> {
    save(folder, all(folder)?)
}

/// The names of the files that differ from what [`write()`] would write. Writes nothing.
///
/// # Errors
/// A figure that cannot be computed.
pub fn stale(folder: &Path) -> Result<Vec<String>> {
    let same =
        |(name, text): &Fresh| read(&folder.join(name)).is_ok_and(|committed| committed == *text);
    Ok(all(folder)?.into_iter().filter(|f| !same(f)).map(|(name, _)| name).collect())
}
