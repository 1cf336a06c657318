//! The documentation of all crates.

use std::path::PathBuf;

use anyhow::Result;

use crate::command::{cargo, run};
use crate::folder::{target_folder, write as save};

/// Leads to the facade, beside which rustdoc lists the other crates.
const INDEX: &str =
    "<!DOCTYPE html>\n<meta http-equiv=\"refresh\" content=\"0; url=asperity/index.html\">\n";

/// Runs `cargo doc` with warnings as errors; returns the path of an index page.
///
/// # Errors
/// A failure of cargo, a broken link in the documentation, a file that cannot be written.
pub fn write() -> Result<PathBuf> {
    let flags = std::env::var("RUSTDOCFLAGS").unwrap_or_default() + " -D warnings";
    run(cargo().args(["doc", "--workspace", "--no-deps"]).env("RUSTDOCFLAGS", flags))?;
    let path = target_folder().join("doc/index.html");
    save(&path, INDEX)?;
    Ok(path)
}
