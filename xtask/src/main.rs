//! `cargo xtask figures [--check]` and `cargo xtask report [--quick] [--out DIR]`.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use anyhow::{Context, Result, bail, ensure};
use xtask::files;
use xtask::report::{self, Scope, throughput};

const HELP: &str = "\
cargo xtask figures            write figures/<name>.csv and figures/<name>.svg
cargo xtask figures --check    fail, naming them, if committed files are stale; write nothing
cargo xtask figures NAME ...   only these figures
cargo xtask report             measure: write figures/speed-vs-error.* and figures/hard-cases.*
cargo xtask report --quick     a few of all rows in seconds, to target/report
cargo xtask report --out DIR   write there
";

fn main() -> ExitCode {
    match run(std::env::args().skip(1).collect()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: Vec<String>) -> Result<()> {
    let mut words = arguments.iter().map(String::as_str);
    match words.next() {
        Some("figures") => figures(words.collect()),
        Some("report") => report(&words.collect::<Vec<_>>()),
        Some(throughput::TASK) => {
            println!("{}", throughput::run(&words.collect::<Vec<_>>())?);
            Ok(())
        }
        Some("--help" | "-h" | "help") | None => {
            print!("{HELP}");
            Ok(())
        }
        Some(other) => bail!("{other:?} is no task\n\n{HELP}"),
    }
}

fn figures(words: Vec<&str>) -> Result<()> {
    let (flags, names): (Vec<&str>, Vec<&str>) = words.iter().partition(|w| w.starts_with('-'));
    if let Some(unknown) = flags.iter().find(|flag| **flag != "--check") {
        bail!("{unknown:?} is no option of figures\n\n{HELP}");
    }
    let folder = files::figures_folder();
    if flags.is_empty() {
        for path in files::write(&folder, &names)? {
            println!("{}", path.display());
        }
        return Ok(());
    }
    let stale = files::stale(&folder, &names)?;
    if stale.is_empty() {
        println!("all figures are up to date");
        return Ok(());
    }
    bail!(
        "stale: {}\nrun `cargo xtask figures`, look at the pictures, commit them",
        stale.join(", ")
    )
}

fn report(words: &[&str]) -> Result<()> {
    let (mut scope, mut folder) = (Scope::Full, None);
    let mut rest = words.iter();
    while let Some(word) = rest.next() {
        match *word {
            "--quick" => scope = Scope::Quick,
            "--out" => {
                folder = Some(PathBuf::from(rest.next().context("--out DIR: DIR is missing")?))
            }
            other => bail!("{other:?} is no option of report\n\n{HELP}"),
        }
    }
    if scope == Scope::Full && cfg!(debug_assertions) {
        return again_with_optimisation(words);
    }
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = folder.unwrap_or_else(|| match scope {
        Scope::Full => files::figures_folder(),
        Scope::Quick => workspace.join("target/report"),
    });
    for path in report::write(scope, &folder)? {
        println!("{}", path.display());
    }
    Ok(())
}

/// Times of a development build say nothing of what users get: the same command, in release.
fn again_with_optimisation(words: &[&str]) -> Result<()> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(cargo)
        .args(["run", "--quiet", "--release", "--package", "xtask", "--", "report"])
        .args(words)
        .status()
        .context("cargo")?;
    ensure!(status.success(), "the release build's report failed: {status}");
    Ok(())
}
