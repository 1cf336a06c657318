//! Solved contacts, kept by case.
//!
//! Numbers are dimensionless: areas over the nominal one, gaps over Sq, stiffnesses -dp/d(gap)
//! Sq/E.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use asperity::{Evidence, EvidenceCase};
use serde::{Deserialize, Serialize};

use super::family::FAMILIES;
use super::plan::Case;
use xtask::figures::compared::equal;

/// Patches behind a row, if the most seeds give as many.
const ENOUGH_PATCHES: f64 = 200.0;
/// Above this share of the area patches merge, and their number tells nothing.
const MERGED: f64 = 0.05;

/// The contact of one surface under one load.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Contact {
    /// p/(E g).
    pub load: f64,
    /// Real over nominal area.
    pub area: f64,
    /// Share of the surface at the hardness.
    pub plastic_area: f64,
    /// Distance of the mean planes: the mean gap, negative in plastic pixels.
    pub gap: f64,
    /// Of first loading.
    pub stiffness: f64,
    /// At the start of unloading.
    pub unloading_stiffness: f64,
    /// Patches of at least 12 pixels.
    pub patches: f64,
}

/// Cases in a folder: a file for each, a line for a surface.
#[derive(Debug, Clone, Default)]
pub struct Kept {
    folder: PathBuf,
    /// Rows of an earlier table with the names of their families.
    rows: Vec<(&'static str, EvidenceCase)>,
}

impl Kept {
    /// Cases in this folder, which is made.
    ///
    /// # Errors
    /// A folder that cannot be made.
    pub fn in_folder(folder: &Path) -> Result<Self> {
        fs::create_dir_all(folder).with_context(|| folder.display().to_string())?;
        Ok(Self { folder: folder.to_owned(), rows: vec![] })
    }

    /// Cases that this table holds count as solved.
    ///
    /// # Errors
    /// A family without moments.
    pub fn with_rows(mut self, table: &Evidence) -> Result<Self> {
        for family in &FAMILIES {
            let cases = family.cases(table)?;
            self.rows.extend(cases.into_iter().map(|case| (family.name, case.clone())));
        }
        Ok(self)
    }

    /// The row of a case in the earlier table.
    #[must_use]
    pub fn row(&self, case: &Case) -> Option<&EvidenceCase> {
        let same = |(name, row): &&(&str, EvidenceCase)| {
            *name == case.family.name
                && equal(row.plasticity_index, case.index)
                && equal(row.load, case.load)
        };
        self.rows.iter().find(same).map(|(_, row)| row)
    }

    fn path(&self, Case { family, index, load, .. }: &Case) -> PathBuf {
        let (name, pixels) = (family.name, family.pixels_for(*load));
        self.folder.join(format!("{name}-{pixels}-psi{index}-load{load:e}.csv"))
    }

    /// The contacts of seeds 1, 2, ... of a case, as far as they are kept and needed.
    #[must_use]
    pub fn seeds(&self, case: &Case) -> Vec<Contact> {
        contacts(&self.path(case)).into_iter().take(case.seeds[1] as usize).collect()
    }

    /// Whether no more seeds are needed.
    #[must_use]
    pub fn is_done(&self, case: &Case) -> bool {
        if self.row(case).is_some() {
            return true;
        }
        let found = self.seeds(case);
        let patches: f64 = found.iter().map(|contact| contact.patches).sum();
        let count = found.len() as u64;
        let merged = found.iter().all(|contact| contact.area > MERGED);
        count >= case.seeds[1] || count >= case.seeds[0] && (merged || patches >= ENOUGH_PATCHES)
    }

    /// Adds the contacts of the next seeds of a case.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn add(&self, case: &Case, new: &[Contact]) -> Result<()> {
        let path = self.path(case);
        let known = contacts(&path);
        let mut csv = csv::Writer::from_path(&path)?;
        known.iter().chain(new).try_for_each(|contact| csv.serialize(contact))?;
        Ok(csv.flush()?)
    }
}

/// The contacts of a file; none, if it is missing.
fn contacts(path: &Path) -> Vec<Contact> {
    let csv = csv::Reader::from_path(path);
    csv.map_or_else(|_| vec![], |csv| csv.into_deserialize().filter_map(Result::ok).collect())
}
