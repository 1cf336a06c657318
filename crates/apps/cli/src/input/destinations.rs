//! Files that two arguments name: refused before any work, so that no result is lost after it.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use anyhow::{Result, ensure};
use clap::error::ErrorKind;
use clap::{ArgMatches, Command};

use crate::input::usage_error;
use crate::output::is_standard;

/// The files that will be written.
static DESTINATIONS: Mutex<Vec<PathBuf>> = Mutex::new(vec![]);
/// Options that name files to read.
const READ: [&str; 2] = ["with", "data"];

/// Ends the program if an output is another output or an input, or if two results go to standard
/// output.
pub fn check(program: &Command, matches: &ArgMatches) {
    let Some((command, matches)) = matches.subcommand() else { return };
    let options = program.find_subcommand(command).into_iter().flat_map(Command::get_opts);
    let options: Vec<&str> = options.map(|option| option.get_id().as_str()).collect();
    let refuse = |text: String| usage_error(command, ErrorKind::ArgumentConflict, &text);
    let paths = |id| matches.try_get_many::<PathBuf>(id).ok().flatten().into_iter().flatten();
    let is_data = matches.try_contains_id("output").is_ok();
    let of_data = is_data && paths("output").all(|to| is_standard(Some(to)));
    let mut standard = of_data.then_some("the data");
    let mut named: Vec<(&str, PathBuf)> = vec![];
    for id in matches.ids().map(|id| id.as_str()) {
        for file in paths(id) {
            if !is_standard(Some(file)) {
                named.push((id, place(file)));
            } else if let Some(other) = standard.replace(id).filter(|_| id != "output") {
                refuse(format!(
                    "--{id} - and {other} both use standard output; name a file for one of them"
                ));
            }
        }
    }
    let name = |id: &str| match options.contains(&id) {
        true => format!("--{}", id.replace('_', "-")),
        false => format!("<{}>", id.to_uppercase()),
    };
    let is_written = |id: &str| options.contains(&id) && !READ.contains(&id);
    for (k, (id, file)) in named.iter().enumerate() {
        for (other, _) in named[..k].iter().filter(|(_, known)| known == file) {
            if is_written(id) || is_written(other) {
                let [one, other] = [name(other), name(id)];
                refuse(format!("{one} and {other} name the same file; choose two names"));
            }
        }
    }
    let written = named.into_iter().filter(|(id, _)| is_written(id)).map(|(_, file)| file);
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
