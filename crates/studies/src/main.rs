//! The studies, which write what is committed: speed against error, and models beside boundary
//! elements. `cargo xtask report` and `cargo xtask truth` start them; `cargo xtask figures` draws
//! what they write.

mod curved;
mod report;
mod rough_sphere;
mod truth;

use anyhow::Result;
use clap::Parser;

/// Studies whose results are committed
#[derive(Parser)]
#[command(name = "cargo xtask")]
enum Study {
    /// Measure times and errors: figures/speed-vs-error.*
    Report,
    /// Compare every model with boundary elements on random surfaces, in an hour; solved cases are
    /// kept in target/truth: crates/answer/judge/data/truth.csv, figures/truth*.md
    Truth {
        /// Evaluate the models anew beside what is kept and committed, and solve nothing
        #[arg(long)]
        kept: bool,
        /// Solve all cases that target/truth does not hold, also cases of the committed table
        #[arg(long, conflicts_with = "kept")]
        anew: bool,
    },
    /// Solve the small case of the tests: tests/reference/truth_small.csv
    Small,
    /// Solve, in ten minutes, and fit what stands beside measurements and simulations of others:
    /// xtask/data/world
    World,
    /// Solve, in a minute, curved bodies with rough surfaces: xtask/data/curved.csv
    Curved,
    /// Solve, in ten minutes, rough spheres by boundary elements: xtask/data/rough-sphere.csv
    RoughSphere,
    /// Solve, in twenty minutes, single scans of few long waves that the intervals have to hold:
    /// crates/studies/data/scans.csv
    Scans,
}

fn main() -> Result<()> {
    let written = match Study::parse() {
        Study::Report => report::write()?,
        Study::Truth { kept, anew } => truth::write(!kept, anew)?,
        Study::Small => truth::write_small()?,
        Study::World => truth::world::write()?,
        Study::Curved => curved::write()?,
        Study::RoughSphere => rough_sphere::write()?,
        Study::Scans => truth::scans::write()?,
    };
    written.iter().for_each(|path| println!("{}", path.display()));
    println!("the figures of these numbers: cargo xtask figures");
    Ok(())
}
