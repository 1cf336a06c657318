//! The tasks `figures`, `report`, `truth`, `docs`, `guide`, `page` and `dist` of `cargo xtask`.

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use clap::Parser;
use xtask::dist::{self, Build};
use xtask::files;
use xtask::folder::{figures_folder, target_folder};
use xtask::report::{self, Scope, throughput};
use xtask::{docs, guide, page, truth};

/// The workspace's own tasks
#[derive(Parser)]
#[command(name = "cargo xtask", version)]
enum Task {
    /// Write figures/<name>.csv and figures/<name>.svg
    Figures {
        /// Only compare: fail and name the committed files that are stale
        #[arg(long)]
        check: bool,
        /// Only these figures
        names: Vec<String>,
    },
    /// Measure times and errors: write figures/speed-vs-error.* and figures/hard-cases.*
    Report {
        /// Measure a few rows in seconds, and write to target/report
        #[arg(long)]
        quick: bool,
        /// Folder to write to
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
    },
    /// Compare every model with boundary elements on random surfaces, in an hour; solved cases are
    /// kept in target/truth: write crates/asperity/data/truth.csv and figures/truth-*
    Truth {
        /// Solve a sketch in two minutes: target/truth-quick
        #[arg(long, conflicts_with_all = ["small", "models", "kept"])]
        quick: bool,
        /// Write what is kept, and solve nothing
        #[arg(long, conflicts_with_all = ["small", "models"])]
        kept: bool,
        /// Solve only the small case of the tests: tests/reference/truth_small.csv
        #[arg(long)]
        small: bool,
        /// Solve all cases that target/truth does not hold, those of the committed table too
        #[arg(long, conflicts_with_all = ["quick", "small", "models"])]
        anew: bool,
        /// Evaluate the models anew, keep the committed boundary-element solutions, and draw
        #[arg(long, conflicts_with = "small")]
        models: bool,
    },
    /// Write the documentation of all crates, with an index page: target/doc/index.html
    Docs,
    /// Build and try what users install: target/dist/ with wheel, program, page and checksums.
    /// Needs Python with venv, and the target x86_64-unknown-linux-musl
    Dist {
        /// Without optimisation, to target/dist-quick: tests the packaging in some minutes
        #[arg(long)]
        quick: bool,
    },
    /// Write the guide: target/page/guide/index.html
    Guide {
        /// Also the documentation of the crates and of the Python package in target/python, beside
        /// the guide
        #[arg(long)]
        api: bool,
    },
    /// Build the explorer and the guide, which any static server serves: target/page
    Page {
        /// Serve it on this machine, and print the address
        #[arg(long)]
        serve: bool,
        /// Keep the module that was built before
        #[arg(long)]
        keep_module: bool,
    },
    #[command(name = throughput::TASK, hide = true)]
    Throughput { model: String, kind: String, count: usize, threads: usize },
}

fn main() -> Result<()> {
    match Task::parse() {
        Task::Figures { check, names } => figures(check, &names),
        Task::Report { quick: false, .. } if cfg!(debug_assertions) => run_in_release(),
        Task::Truth { small, models, quick, kept, anew } => {
            print(match (small, models) {
                (true, _) => truth::write_small()?,
                (_, true) => truth::update_models(&figures_folder())?,
                _ if quick => truth::write_quick()?,
                _ => truth::write(&figures_folder(), !kept, anew)?,
            });
            Ok(())
        }
        Task::Report { quick, out } => {
            let scope = if quick { Scope::Quick } else { Scope::Full };
            let target = target_folder().join("report");
            let folder = if quick { target } else { figures_folder() };
            print(report::write(scope, &out.unwrap_or(folder))?);
            Ok(())
        }
        Task::Docs => {
            println!("{}", docs::write()?.display());
            Ok(())
        }
        Task::Dist { quick } => {
            print(dist::write(if quick { Build::Quick } else { Build::Release })?);
            Ok(())
        }
        Task::Guide { api } => {
            let page = target_folder().join("page");
            if api {
                guide::api::write(&page)?;
            }
            println!("{}", guide::write(&page)?.display());
            Ok(())
        }
        Task::Page { serve, keep_module } => {
            let folder = page::write(keep_module)?;
            println!("{}", folder.join("index.html").display());
            if serve { page::serve(&folder) } else { Ok(()) }
        }
        Task::Throughput { model, kind, count, threads } => {
            println!("{}", throughput::run(&model, &kind, count, threads)?);
            Ok(())
        }
    }
}

fn print(paths: Vec<PathBuf>) {
    paths.iter().for_each(|path| println!("{}", path.display()));
}

fn figures(check: bool, names: &[String]) -> Result<()> {
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    if !check {
        print(files::write(&figures_folder(), &names)?);
        return Ok(());
    }
    let stale = files::stale(&figures_folder(), &names)?;
    if !stale.is_empty() {
        let stale = stale.join(", ");
        bail!("stale: {stale}\nrun `cargo xtask figures`, look at the pictures, commit them");
    }
    println!("all figures are up to date");
    Ok(())
}

/// Runs the same command in a release build: times of a development build are not those of users.
fn run_in_release() -> Result<()> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(cargo)
        .args(["run", "--quiet", "--release", "--package", "xtask", "--"])
        .args(std::env::args_os().skip(1))
        .status()
        .context("cargo")?;
    ensure!(status.success(), "the release build's report failed: {status}");
    Ok(())
}
