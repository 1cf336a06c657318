//! Files that two arguments name: refused before any work, so that no result is lost after it.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use anyhow::{Result, ensure};
use clap::{ArgMatches, Command};

use crate::input::usage_error;
use crate::output::is_standard;

/// The files that will be written.
static DESTINATIONS: Mutex<Vec<PathBuf>> = Mutex::new(vec![]);

/// Ends the program if an output is an input.
pub fn check(program: &Command, matches: &ArgMatches) {
    let Some((command, matches)) = matches.subcommand() else { return };
    let options = program.find_subcommand(command).into_iter().flat_map(Command::get_opts);
    let options: Vec<&str> = options.map(|option| option.get_id().as_str()).collect();
    let paths = |id| matches.try_get_many::<PathBuf>(id).ok().flatten().into_iter().flatten();
    let named = matches.ids().map(|id| id.as_str()).flat_map(|id| {
        paths(id).filter(|file| !is_standard(Some(file))).map(move |file| (id, place(file)))
    });
    // Options name files to write, the other arguments files to read.
    let (written, read): (Vec<_>, Vec<_>) = named.partition(|(id, _)| options.contains(id));
    for (id, file) in &read {
        if let Some((output, _)) = written.iter().find(|(_, to)| to == file) {
            let (input, output) = (id.to_uppercase(), output.replace('_', "-"));
            usage_error(&format!("<{input}> and --{output} name the same file; choose two names"));
        }
    }
    let written = written.into_iter().map(|(_, file)| file);
    DESTINATIONS.lock().unwrap_or_else(PoisonError::into_inner).extend(written);
}

/// Refuses an input that an output would overwrite.
///
/// # Errors
/// The name of such an input.
pub fn protect(input: &Path) -> Result<()> {
    let destinations = DESTINATIONS.lock().unwrap_or_else(PoisonError::into_inner);
    ensure!(
        !destinations.contains(&place(input)),
        "an output would overwrite {}, which the scene names; choose another name",
        input.display()
    );
    Ok(())
}

/// A file in its folder without links, whether or not it is there.
fn place(file: &Path) -> PathBuf {
    let in_folder = || {
        let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty());
        Some(fs::canonicalize(folder.unwrap_or(Path::new("."))).ok()?.join(file.file_name()?))
    };
    fs::canonicalize(file).ok().or_else(in_folder).unwrap_or_else(|| file.into())
}
