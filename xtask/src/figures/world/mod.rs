//! Models beside other methods: finite elements of one sphere, other people's simulations, and a
//! measurement. The numbers are in `xtask/data/world`, each with its source.

pub mod closure;
pub mod gfmd;
pub mod sphere;
pub mod summary;

use std::path::PathBuf;

use anyhow::Result;
use serde::de::DeserializeOwned;

use crate::folder::root;
use crate::table::rows_of;

/// The folder of the numbers.
#[must_use]
pub fn folder() -> PathBuf {
    root().join("xtask/data/world")
}

/// The rows of a csv of the folder; lines with `#` are its source.
///
/// # Errors
/// A file that cannot be read, or has other columns.
pub fn rows<T: DeserializeOwned>(name: &str) -> Result<Vec<T>> {
    rows_of(&folder().join(name))
}
