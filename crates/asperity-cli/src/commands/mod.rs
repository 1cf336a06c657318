//! The commands, one a file, in the order of the help: scenes, answers, joints, boundary elements,
//! tables for solvers, help.

mod bem;
mod check;
mod conductance;
mod conductance_picture;
mod curve;
mod export;
mod fit;
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
use clap::{ArgGroup, Subcommand};

#[derive(Debug, Subcommand)]
pub enum Command {
    Init(init::Init),
    Surface(surface::Surface),
    Generate(generate::Generate),
    Check(check::Check),
    List(list::List),
    #[command(hide = true, group(ArgGroup::new("given").required(true)))]
    Solve(curve::Curve),
    Curve(curve::Curve),
    #[command(hide = true, mut_arg("format", |arg| arg.default_value("table")))]
    Compare(curve::Curve),
    Recommend(recommend::Recommend),
    Fit(fit::FitCommand),
    Joint(joint::Joint),
    #[command(hide = true)]
    #[command(mut_arg("friction", |arg| arg.required(true)))]
    #[command(mut_group("cycle", |group| group.required(true)))]
    Slip(joint::Joint),
    #[command(hide = true, mut_arg("format", |arg| arg.default_value("table")))]
    PullOff(curve::Curve),
    Conductance(conductance::Conductance),
    Bem(bem::BemCommand),
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
            Self::Solve(command) => command.run("solve"),
            Self::Curve(command) => command.run("curve"),
            Self::Compare(command) => command.run("compare"),
            Self::Recommend(command) => command.run(),
            Self::Fit(command) => command.run(),
            Self::Joint(command) => command.run("joint"),
            Self::Slip(command) => command.run("slip"),
            Self::PullOff(command) => command.run("pull-off"),
            Self::Conductance(command) => command.run(),
            Self::Bem(command) => command.run(),
            Self::Export(command) => command.run(),
            Self::Manual(command) => command.run(),
        }
    }
}
