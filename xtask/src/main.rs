//! The tasks `figures`, `report`, `truth`, `guide`, `page` and `dist` of `cargo xtask`.
//!
//! `guide` starts the program again with a feature, `report` and `truth` start the program of the
//! studies.

use std::ffi::OsString;
use std::process::Command;

use anyhow::{Result, ensure};
use clap::Parser;
use xtask::command::{cargo, run};
use xtask::files;
use xtask::folder::{figures_folder, root};

/// The workspace's own tasks
#[derive(Parser)]
#[command(name = "cargo xtask", version)]
enum Task {
    /// Write figures/<name>.csv and figures/<name>.svg
    Figures {
        /// Only compare: fail and name the committed files that are stale
        #[arg(long)]
        check: bool,
    },
    /// Measure speed against error, in some minutes: `asperity-studies report`
    Report,
    /// Compare models with boundary elements, in an hour: `asperity-studies truth`, with its
    /// options
    #[command(disable_help_flag = true)]
    Truth {
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        options: Vec<OsString>,
    },
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
}

fn main() -> Result<()> {
    let task = Task::parse();
    let written = match task {
        Task::Figures { check: true } => return compare(),
        Task::Figures { check: false } => files::write(&figures_folder())?,
        Task::Dist { quick } => {
            let quick = quick.then_some("--quick");
            return run(Command::new("bash").arg(root().join("xtask/dist.sh")).args(quick));
        }
        // Users do not meet the times of a development build.
        Task::Report => return start("report", &["--release"], &[]),
        Task::Truth { options } => return start("truth", &[], &options),
        #[cfg(feature = "guide")]
        Task::Guide => vec![xtask::guide::write()?],
        Task::Page { serve, keep_module } => {
            let index = xtask::page::write(keep_module)?;
            println!("{}\nthe guide beside it: cargo xtask guide", index.display());
            return if serve { xtask::page::serve(&index.with_file_name("")) } else { Ok(()) };
        }
        #[cfg(not(feature = "guide"))]
        Task::Guide => {
            let program = ["run", "--package", "xtask", "--features", "guide", "--", "guide"];
            return run(cargo().args(program));
        }
    };
    written.iter().for_each(|path| println!("{}", path.display()));
    Ok(())
}

fn compare() -> Result<()> {
    let stale = files::stale(&figures_folder())?.join(", ");
    ensure!(
        stale.is_empty(),
        "stale: {stale}\nrun `cargo xtask figures`, look at the pictures, commit them"
    );
    println!("all figures are up to date");
    Ok(())
}

/// Runs a study with its options.
fn start(name: &str, build: &[&str], options: &[OsString]) -> Result<()> {
    let package = ["run", "--package", "asperity-studies"];
    run(cargo().args(package).args(build).args(["--", name]).args(options))
}
