//! The commands, one a file, in the order of the help: scenes, answers, joints, boundary elements,
//! tables for solvers, help.

mod answer;
mod bem;
mod check;
mod curve;
mod export;
mod fit;
mod generate;
mod init;
mod joint;
mod list;
mod pull_off;
mod scales;
mod surface;

use anyhow::Result;
use clap::Subcommand;

#[derive(Debug, Subcommand)]
pub enum Command {
    Init(init::Init),
    Surface(surface::Surface),
    Generate(generate::Generate),
    Check(check::Check),
    List(list::List),
    Answer(answer::Answer),
    Curve(curve::Curve),
    Fit(fit::FitCommand),
    Joint(joint::Joint),
    Bem(bem::BemCommand),
    Export(export::ExportCommand),
}

impl Command {
    pub fn run(self) -> Result<()> {
        match self {
            Self::Init(command) => command.run(),
            Self::Surface(command) => command.run(),
            Self::Generate(command) => command.run(),
            Self::Check(command) => command.run(),
            Self::List(command) => command.run(),
            Self::Answer(command) => command.run(),
            Self::Curve(command) => command.run(),
            Self::Fit(command) => command.run(),
            Self::Joint(command) => command.run(),
            Self::Bem(command) => command.run(),
            Self::Export(command) => command.run(),
        }
    }
}
