//! `cargo xtask figures [--check]`.

use std::process::ExitCode;

use anyhow::{Result, bail};
use xtask::files;

const HELP: &str = "\
cargo xtask figures            write figures/<name>.csv and figures/<name>.svg
cargo xtask figures --check    fail, naming them, if committed files are stale; write nothing
cargo xtask figures NAME ...   only these figures
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
