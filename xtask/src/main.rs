//! The tasks `figures`, `report`, `truth`, `docs`, `guide`, `page` and `dist` of `cargo xtask`.
//!
//! The figures and the documentation are compiled by default; a task with a feature starts the
//! program again with it.

use std::path::PathBuf;
use std::process::Command;

use anyhow::{Result, ensure};
use clap::Parser;
use xtask::command::{cargo, run};
use xtask::folder::{figures_folder, root};
use xtask::{docs, files};

/// The workspace's own tasks
#[derive(Parser)]
#[command(name = "cargo xtask", version)]
enum Task {
    /// Write figures/<name>.csv and figures/<name>.svg
    Figures {
        /// Only compare: fail and name the committed files that are stale
        #[arg(long)]
        check: bool,
        /// Only the figures whose names begin so: fig10
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
        /// Solve, in ten minutes, and fit what stands beside measurements and simulations of
        /// others: xtask/data/world
        #[arg(long, conflicts_with_all = ["quick", "small", "models", "kept", "anew"])]
        world: bool,
        /// Solve, in twenty minutes, single scans of few long waves that the intervals have to
        /// hold: xtask/data/scans.csv
        #[arg(long, conflicts_with_all = ["quick", "small", "models", "kept", "anew", "world"])]
        scans: bool,
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
    /// Write the guide by MkDocs, which is installed below target: target/page/guide/index.html
    Guide,
    /// Build the explorer, which any static server serves: target/page
    Page {
        /// Serve it on this machine by Python, and print the address
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

fn main() -> Result<()> {
    let task = Task::parse();
    // The name of the task, and of its feature if it has one.
    let name = std::env::args().nth(1).unwrap_or_default().replace("-throughput", "");
    let written = match task {
        Task::Figures { check, names } => {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            if check {
                return compare(&names);
            }
            files::write(&figures_folder(), &names)?
        }
        Task::Docs => vec![docs::write()?],
        Task::Dist { quick } => {
            let quick = quick.then_some("--quick");
            return run(Command::new("bash").arg(root().join("xtask/dist.sh")).args(quick));
        }
        #[cfg(feature = "report")]
        Task::Report { quick, out } if !cfg!(debug_assertions) => {
            use xtask::report::{Scope, write};
            let scope = if quick { Scope::Quick } else { Scope::Full };
            write(scope, &out.unwrap_or_else(|| scope.folder()))?
        }
        #[cfg(feature = "report")]
        Task::Throughput { model, kind, count, threads } => {
            println!("{}", xtask::report::throughput::run(&model, &kind, count, threads)?);
            vec![]
        }
        #[cfg(feature = "truth")]
        Task::Truth { small, models, quick, kept, anew, world, scans } => {
            use xtask::truth;
            match (small, models) {
                (true, _) => truth::write_small()?,
                (_, true) => truth::update_models()?,
                _ if scans => truth::scans::write()?,
                _ if world => truth::world::write()?,
                _ if quick => truth::write_quick()?,
                _ => truth::write(!kept, anew)?,
            }
        }
        #[cfg(feature = "guide")]
        Task::Guide => vec![xtask::guide::write()?],
        #[cfg(feature = "page")]
        Task::Page { serve, keep_module } => {
            let index = xtask::page::write(keep_module)?;
            println!("{}\nthe guide beside it: cargo xtask guide", index.display());
            return if serve { xtask::page::serve(&index.with_file_name("")) } else { Ok(()) };
        }
        #[allow(unreachable_patterns, reason = "with all features only the report is left")]
        _ => return start_again(&name),
    };
    written.iter().for_each(|path| println!("{}", path.display()));
    Ok(())
}

fn compare(names: &[&str]) -> Result<()> {
    let stale = files::stale(&figures_folder(), names)?.join(", ");
    ensure!(
        stale.is_empty(),
        "stale: {stale}\nrun `cargo xtask figures`, look at the pictures, commit them"
    );
    println!("all figures are up to date");
    Ok(())
}

/// Runs the same command in a program with the feature of the task; the report in a release build:
/// times of a development build are not those of users.
fn start_again(feature: &str) -> Result<()> {
    let release = (feature == "report").then_some("--release");
    let run_with = ["run", "--package", "xtask", "--features", feature];
    let arguments = std::env::args_os().skip(1);
    run(cargo().args(run_with).args(release).arg("--").args(arguments))
}
