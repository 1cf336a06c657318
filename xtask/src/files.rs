//! Writing the figures, or checking that the committed ones are what would be written.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use rayon::prelude::*;

use crate::draw::draw;
use crate::figures::{FIGURES, FigureSpec};
use crate::table::{GUARD, agree};

/// The workspace's `figures` folder.
#[must_use]
pub fn figures_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../figures")
}

/// The texts of one figure as they should be committed, beside those that are.
struct Fresh {
    name: &'static str,
    csv: String,
    svg: String,
}

/// The committed csv stays while its numbers agree with fresh ones; the svg is drawn from it.
fn fresh(folder: &Path, spec: &FigureSpec) -> Result<Fresh> {
    let name = spec.name;
    let numbers = (spec.table)().with_context(|| format!("the table of {name}"))?.into_text();
    let csv = match fs::read_to_string(folder.join(format!("{name}.csv"))) {
        Ok(committed) if agree(&committed, &numbers, GUARD) => committed,
        _ => numbers,
    };
    let figure = (spec.style)(&csv).with_context(|| format!("the style of {name}"))?;
    let svg = draw(&figure, &csv).with_context(|| format!("the picture of {name}"))?;
    Ok(Fresh { name, csv, svg })
}

fn all(folder: &Path, names: &[&str]) -> Result<Vec<Fresh>> {
    if let Some(name) = names.iter().find(|n| !FIGURES.iter().any(|f| f.name == **n)) {
        let known: Vec<&str> = FIGURES.iter().map(|f| f.name).collect();
        bail!("{name:?} is no figure; the figures are {}", known.join(", "));
    }
    let wanted = |spec: &&FigureSpec| names.is_empty() || names.contains(&spec.name);
    FIGURES.par_iter().filter(wanted).map(|spec| fresh(folder, spec)).collect()
}

/// Writes the figures of these names (all, if none is given); returns the paths written.
///
/// # Errors
/// An unknown name, a figure that cannot be computed, a file that cannot be written.
pub fn write(folder: &Path, names: &[&str]) -> Result<Vec<PathBuf>> {
    fs::create_dir_all(folder)?;
    let mut paths = vec![];
    for Fresh { name, csv, svg } in all(folder, names)? {
        for (text, ending) in [(csv, "csv"), (svg, "svg")] {
            let path = folder.join(format!("{name}.{ending}"));
            fs::write(&path, text).with_context(|| path.display().to_string())?;
            paths.push(path);
        }
    }
    Ok(paths)
}

/// The names of the files that differ from what [`write()`] would write. Writes nothing.
///
/// # Errors
/// An unknown name, or a figure that cannot be computed.
pub fn stale(folder: &Path, names: &[&str]) -> Result<Vec<String>> {
    let mut stale = vec![];
    for Fresh { name, csv, svg } in all(folder, names)? {
        for (text, ending) in [(csv, "csv"), (svg, "svg")] {
            let file = format!("{name}.{ending}");
            if fs::read_to_string(folder.join(&file)).ok().as_deref() != Some(text.as_str()) {
                stale.push(file);
            }
        }
    }
    Ok(stale)
}
