//! The program as an archive: binary without shared libraries, manual, completions, licences.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};

use super::{Build, VERSION, archive, cargo, licences, output, run};
use crate::folder::target_folder;
use crate::guide::root;

const TARGET: &str = "x86_64-unknown-linux-musl";
/// What a user reads, from the root of the repository.
const TEXTS: [&str; 4] = [
    "crates/asperity-cli/README.md",
    "crates/asperity/CHANGELOG.md",
    "LICENSE-APACHE",
    "LICENSE-MIT",
];

/// Builds, tries and packs the program; returns the archive. To be unpacked over `~/.local` or
/// `/usr/local`.
pub fn write(build: Build, folder: &Path) -> Result<PathBuf> {
    let built = build_program(build)?;
    let name = format!("asperity-{VERSION}-x86_64-linux");
    let stage = folder.join(&name);
    let texts = stage.join("share/doc/asperity");
    for path in [stage.join("bin"), texts.clone()] {
        fs::create_dir_all(&path).with_context(|| path.display().to_string())?;
    }
    let binary = stage.join("bin/asperity");
    copy(&built, &binary)?;
    for text in TEXTS {
        let path = root().join(text);
        copy(&path, &texts.join(path.file_name().unwrap_or_default()))?;
    }
    let notices = licences::notices("asperity-cli", TARGET)?;
    fs::write(texts.join("THIRD-PARTY.txt"), notices).context("THIRD-PARTY.txt")?;
    try_out(&binary, &stage)?;
    let packed = folder.join(format!("{name}.tar.gz"));
    archive::tar(&stage, &packed)?;
    fs::remove_dir_all(&stage).with_context(|| stage.display().to_string())?;
    Ok(packed)
}

/// Builds the program; a quick build is that of the tests.
fn build_program(build: Build) -> Result<PathBuf> {
    let mut command = cargo();
    let (what, folder) = match build {
        Build::Quick => (&["--workspace"][..], target_folder().join("debug")),
        Build::Release => {
            let what = &["--package", "asperity-cli", "--profile", "program", "--target", TARGET];
            (&what[..], target_folder().join(TARGET).join("program"))
        }
    };
    command.args(["build", "--bin", "asperity"]).args(what);
    run(&mut command)?;
    Ok(folder.join("asperity"))
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    fs::copy(from, to).with_context(|| from.display().to_string())?;
    Ok(())
}

/// Writes the manual by the program itself, and answers from its own example.
fn try_out(binary: &Path, stage: &Path) -> Result<()> {
    let program = |arguments: &[&str]| {
        let mut command = Command::new(binary);
        command.args(arguments).env_clear();
        command
    };
    run(program(&["manual", "share"]).current_dir(stage))?;
    let folder = tempfile::tempdir().context("a folder for the trial")?;
    run(program(&["init", "scene.toml"]).current_dir(&folder))?;
    let solve = ["--quiet", "solve", "scene.toml", "--model", "ke", "--load", "100"];
    let answer = output(program(&solve).current_dir(&folder))?;
    ensure!(answer.lines().count() > 1, "the program gave no answer: {answer}");
    Ok(())
}
