//! Files that two arguments name: refused before any work, so that no result is lost after it.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use anyhow::{Result, ensure};
use clap::error::ErrorKind;
use clap::{ArgMatches, Command};

use crate::input::usage_error;
use crate::output::{self, is_standard};

/// The files that will be written.
static DESTINATIONS: Mutex<Vec<PathBuf>> = Mutex::new(vec![]);

/// Ends the program if an output is another output or an input, or if two results go to standard
/// output.
pub fn check(program: &Command, matches: &ArgMatches) {
    let Some((command, matches)) = matches.subcommand() else { return };
    let arguments =
        || program.find_subcommand(command).into_iter().flat_map(Command::get_arguments);
    let is_option = |id: &str| arguments().any(|one| one.get_id() == id && !one.is_positional());
    let paths = |id: &str| matches.try_get_many::<PathBuf>(id).ok().flatten();
    let refuse = |text: &str| usage_error(command, ErrorKind::ArgumentConflict, text);
    let mut named: Vec<(&str, PathBuf)> = vec![];
    for id in matches.ids().map(|id| id.as_str()) {
        for file in paths(id).into_iter().flatten() {
            if is_standard(Some(file)) {
                let mut data = paths("output").into_iter().flatten();
                if id != "output" && is_option(id) && data.all(|to| is_standard(Some(to))) {
                    refuse(&format!(
                        "--{id} - and the data both use standard output; name a file for the data with --output"
                    ));
                }
                continue;
            }
            let file = place(file);
            for (other, _) in named.iter().filter(|(_, known)| *known == file) {
                let names = [*other, id].map(|id| match is_option(id) {
                    true => format!("--{id}"),
                    false => format!("<{}>", id.to_uppercase()),
                });
                // What is read may be named twice.
                if names.iter().any(|name| name.starts_with('-')) && *other != id {
                    let [one, other] = names;
                    refuse(&format!("{one} and {other} name the same file; choose two names"));
                }
            }
            if is_option(id) && !matches!(id, "with" | "data") {
                // Those that write scenes have --force.
                let of_scene = id == "scene" || command == "init";
                let is_scene = !of_scene && file.extension().is_some_and(|end| end == "toml");
                let is_binary = matches!(id, "map" | "picture" | "flow_picture");
                if is_scene && file.exists() {
                    let file = file.display();
                    refuse(&format!(
                        "--{id} {file} exists and may be a scene; choose another name"
                    ));
                } else if !is_result(&file, is_binary || command == "generate") {
                    let (id, file) = (id.replace('_', "-"), file.display());
                    refuse(&format!(
                        "--{id} {file} exists and is no result of this kind, perhaps a scan; choose another name"
                    ));
                }
                DESTINATIONS.lock().unwrap_or_else(PoisonError::into_inner).push(file.clone());
            }
            named.push((id, file));
        }
    }
}

/// First bytes of binary files that are written, by their endings.
const BINARY: [(&str, &[u8]); 3] = [("npy", b"\x93NUMPY"), ("png", b"\x89PNG"), ("x3p", b"PK")];
/// Whether a file is absent, or of the kind that will be written there: text or, where an output
/// may be `binary`, what its ending names.
fn is_result(file: &Path, binary: bool) -> bool {
    let mut first = [0; 512];
    let read = |mut file: fs::File| file.read(&mut first);
    let is_file = fs::metadata(file).is_ok_and(|found| found.is_file());
    let Ok(length) = fs::File::open(file).and_then(read) else { return true };
    let first = &first[..length];
    let is_one = |(ending, _): &&(&str, &[u8])| {
        binary && file.extension().is_some_and(|end| end.eq_ignore_ascii_case(ending))
    };
    let is_kind = match BINARY.iter().find(is_one) {
        Some((_, magic)) => first.starts_with(magic),
        // Scans in SDF may be text.
        None => {
            !first.contains(&0) && !matches!(first.get(1..5), Some(b"ISO-" | b"BCR-" | b"NPL-"))
        }
    };
    !is_file || first.is_empty() || is_kind
}

/// Refuses an input that an output would overwrite, and protects it.
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
    output::keep(input);
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
