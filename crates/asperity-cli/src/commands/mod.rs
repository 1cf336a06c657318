//! The commands, one a file, in the order of the help: scenes, answers, joints, boundary elements,
//! tables for solvers, help.

mod bem;
mod check;
mod conductance;
mod conductance_picture;
mod conductance_rows;
mod conductivity;
mod curve;
mod export;
mod fit;
mod fit_lists;
mod generate;
mod history;
mod init;
mod list;
mod manual;
mod pull_off;
mod recommend;
mod scales;
mod slip;
mod slip_forces;
mod slip_preloads;
mod surface;
mod truth;
mod unload;
mod unload_bem;

use anyhow::Result;
use clap::Subcommand;

#[derive(Debug, Subcommand)]
pub enum Command {
    Init(init::Init),
    Surface(surface::Surface),
    Generate(generate::Generate),
    Check(check::Check),
    List(list::List),
    Materials(list::Materials),
    Models(list::Models),
    Solve(curve::Solve),
    Curve(curve::Curve),
    Compare(curve::Compare),
    Recommend(recommend::Recommend),
    Fit(fit::FitCommand),
    Plan(curve::Plan),
    Unload(unload::Unload),
    Slip(slip::Slip),
    PullOff(pull_off::PullOff),
    Conductance(conductance::Conductance),
    Bem(bem::BemCommand),
    Truth(truth::TruthCommand),
    Export(export::Export),
    Manual(manual::Manual),
}

impl Command {
    pub fn run(self) -> Result<()> {
        match self {
            Self::Init(command) => command.run(),
            Self::Surface(command) => command.run(),
            Self::Generate(command) => command.run(),
            Self::Check(command) => command.run(),
            Self::List(command) => command.run(),
            Self::Materials(command) => command.run(),
            Self::Models(command) => command.run(),
            Self::Solve(command) => command.run(),
            Self::Curve(command) => command.run(),
            Self::Compare(command) => command.run(),
            Self::Recommend(command) => command.run(),
            Self::Fit(command) => command.run(),
            Self::Plan(command) => command.run(),
            Self::Unload(command) => command.run(),
            Self::Slip(command) => command.run(),
            Self::PullOff(command) => command.run(),
            Self::Conductance(command) => command.run(),
            Self::Bem(command) => command.run(),
            Self::Truth(command) => command.run(),
            Self::Export(command) => command.run(),
            Self::Manual(command) => command.run(),
        }
    }
}
