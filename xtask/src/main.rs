//! The tasks `figures`, `report`, `truth`, `docs`, `guide`, `page` and `dist` of `cargo xtask`.
//!
//! The figures and the documentation are compiled by default; another task starts the program again
//! with its feature.

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use clap::Parser;
use xtask::folder::figures_folder;
use xtask::{docs, files, needs};

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
    /// One sweep of the report, in a process of its own
    #[command(name = "report-throughput", hide = true)]
    Throughput { model: String, kind: String, count: usize, threads: usize },
}

impl Task {
    /// The name of the task, and of its feature if it has one.
    fn name(&self) -> &'static str {
        match self {
            Self::Figures { .. } => "figures",
            Self::Report { .. } | Self::Throughput { .. } => "report",
            Self::Truth { .. } => "truth",
            Self::Docs => "docs",
            Self::Dist { .. } => "dist",
            Self::Guide { .. } => "guide",
            Self::Page { .. } => "page",
        }
    }
}

fn main() -> Result<()> {
    let task = Task::parse();
    needs::check(task.name(), matches!(task, Task::Dist { quick: true }))?;
    match task {
        Task::Figures { check, names } => figures(check, &names),
        Task::Docs => {
            println!("{}", docs::write()?.display());
            Ok(())
        }
        #[cfg(feature = "report")]
        Task::Report { quick, out } if !cfg!(debug_assertions) => report(quick, out),
        #[cfg(feature = "report")]
        Task::Throughput { model, kind, count, threads } => {
            println!("{}", xtask::report::throughput::run(&model, &kind, count, threads)?);
            Ok(())
        }
        #[cfg(feature = "truth")]
        Task::Truth { small, models, quick, kept, anew } => {
            use xtask::truth;
            print(match (small, models) {
                (true, _) => truth::write_small()?,
                (_, true) => truth::update_models(&figures_folder())?,
                _ if quick => truth::write_quick()?,
                _ => truth::write(&figures_folder(), !kept, anew)?,
            });
            Ok(())
        }
        #[cfg(feature = "dist")]
        Task::Dist { quick } => {
            use xtask::dist::{Build, write};
            print(write(if quick { Build::Quick } else { Build::Release })?);
            Ok(())
        }
        #[cfg(feature = "guide")]
        Task::Guide { api } => {
            let page = xtask::folder::target_folder().join("page");
            if api {
                xtask::guide::api::write(&page)?;
            }
            println!("{}", xtask::guide::write(&page)?.display());
            Ok(())
        }
        #[cfg(feature = "page")]
        Task::Page { serve, keep_module } => {
            use xtask::page;
            let folder = page::write(keep_module)?;
            println!("{}", folder.join("index.html").display());
            if serve { page::serve(&folder) } else { Ok(()) }
        }
        #[allow(unreachable_patterns, reason = "with all features only the report is left")]
        other => start_again(other.name()),
    }
}

#[cfg(feature = "report")]
fn report(quick: bool, out: Option<PathBuf>) -> Result<()> {
    use xtask::report::{self, Scope};
    let scope = if quick { Scope::Quick } else { Scope::Full };
    let target = xtask::folder::target_folder().join("report");
    let folder = if quick { target } else { figures_folder() };
    print(report::write(scope, &out.unwrap_or(folder))?);
    Ok(())
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

/// Runs the same command in a program with the feature of the task; the report in a release build:
/// times of a development build are not those of users.
fn start_again(feature: &str) -> Result<()> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let release: &[&str] = if feature == "report" { &["--release"] } else { &[] };
    let status = Command::new(cargo)
        .args(["run", "--quiet", "--package", "xtask", "--features", feature])
        .args(release)
        .arg("--")
        .args(std::env::args_os().skip(1))
        .status()
        .context("cargo")?;
    ensure!(status.success(), "cargo xtask {feature} failed: {status}");
    Ok(())
}
