//! Writing the figures, or checking that the committed ones are up to date.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use asperity::Evidence;
use asperity_plot::draw;
use rayon::prelude::*;

use crate::figures::captions::with_caption;
use crate::figures::{FIGURES, FigureSpec, measured, world};
use crate::folder::{Fresh, read, save};
use crate::table::{GUARD, agree};

/// A committed csv stays while its numbers agree with fresh ones; the svg is drawn from it.
fn fresh(folder: &Path, (name, table, style): &FigureSpec) -> Result<[Fresh; 2]> {
    let numbers = table().with_context(|| format!("the table of {name}"))?.into_text();
    let csv = match read(&folder.join(format!("{name}.csv"))) {
        Ok(committed) if agree(&committed, &numbers, GUARD) => committed,
        _ => numbers,
    };
    let svg = style(&csv).and_then(|figure| Ok(draw(&with_caption(name, figure)?, &csv)?));
    let svg = svg.with_context(|| format!("the picture of {name}"))?;
    Ok([(format!("{name}.csv"), csv), (format!("{name}.svg"), svg)])
}

/// The figures whose names begin so. Without names, all of them, and the picture of the report,
/// drawn from its committed measurements.
fn all(folder: &Path, names: &[&str]) -> Result<Vec<Fresh>> {
    if let Some(name) = names.iter().find(|n| !FIGURES.iter().any(|f| f.0.starts_with(**n))) {
        let known = FIGURES.map(|f| f.0).join(", ");
        bail!("{name:?} is not a figure; the figures are {known}");
    }
    let begins = |spec: &FigureSpec| names.iter().any(|name| spec.0.starts_with(name));
    let wanted = |spec: &&FigureSpec| names.is_empty() || begins(spec);
    let figures = FIGURES.par_iter().filter(wanted).map(|spec| fresh(folder, spec));
    let mut all = figures.collect::<Result<Vec<_>>>()?.concat();
    if names.is_empty() {
        all.push(measured::picture(folder)?);
        let text = |name: &str| {
            let found = all.iter().find(|(file, _)| *file == format!("{name}.csv"));
            found.map(|(_, text)| text.as_str()).with_context(|| name.to_owned())
        };
        let world = world::summary::table(text, Evidence::committed()?)?;
        all.push(("world.md".to_owned(), world));
    }
    Ok(all)
}

/// Writes the figures whose names begin so (all, if none is given); returns the paths written.
///
/// # Errors
/// An unknown name, a figure that cannot be computed, a file that cannot be written.
pub fn write(folder: &Path, names: &[&str]) -> Result<Vec<PathBuf>> {
    save(folder, all(folder, names)?)
}

/// The names of the files that differ from what [`write()`] would write. Writes nothing.
///
/// # Errors
/// An unknown name, or a figure that cannot be computed.
pub fn stale(folder: &Path, names: &[&str]) -> Result<Vec<String>> {
    let same =
        |(name, text): &Fresh| read(&folder.join(name)).is_ok_and(|committed| committed == *text);
    Ok(all(folder, names)?.into_iter().filter(|f| !same(f)).map(|(name, _)| name).collect())
}
