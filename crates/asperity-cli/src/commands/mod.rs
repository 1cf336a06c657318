//! The commands, one a file, in the order of the help: scenes, answers, joints, boundary elements,
//! tables for solvers, help.

mod bem;
mod check;
mod conductance;
mod conductance_picture;
mod conductivity;
mod curve;
mod export;
mod fit;
mod fit_lists;
mod generate;
mod init;
mod joint;
mod joint_plots;
mod list;
mod manual;
mod pull_off;
mod recommend;
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
    Materials(list::Materials),
    Models(list::Models),
    Solve(curve::Solve),
    Curve(curve::Curve),
    Compare(curve::Compare),
    Recommend(recommend::Recommend),
    Fit(fit::FitCommand),
    Plan(curve::Plan),
    Joint(joint::Joint),
    #[command(hide = true)]
    Unload(joint::Joint),
    #[command(hide = true)]
    #[command(mut_arg("friction", |arg| arg.required(true)))]
    #[command(mut_group("cycle", |group| group.required(true)))]
    Slip(joint::Joint),
    #[command(hide = true)]
    PullOff(pull_off::PullOff),
    Conductance(conductance::Conductance),
    Bem(bem::BemCommand),
    #[command(hide = true)]
    Truth(bem::BemCommand),
    Export(export::ExportCommand),
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
            Self::Joint(command) => command.run("joint"),
            Self::Unload(command) => command.run("unload"),
            Self::Slip(command) => command.run("slip"),
            Self::PullOff(command) => command.run(),
            Self::Conductance(command) => command.run(),
            Self::Bem(command) => command.run(),
            Self::Truth(command) => command.run_truth(),
            Self::Export(command) => command.run(),
            Self::Manual(command) => command.run(),
        }
    }
}
