//! The program `asperity`: rough contact from a scene file.
//!
//! Data goes to the standard output, words to the standard error; exit code 0, 1 for bad input,
//! 2 for bad usage. Parsing and printing only: what is computed is computed by the libraries.

mod args;
mod ask;
mod commands;
mod contact_map;
mod distances;
mod interrupt;
mod joints;
mod number;
mod numbers;
mod output;
mod plot;
mod pressed;
mod scene;
mod table;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};

use commands::{
    bem, check, compare, conductance, curve, export, init, models, plan, pull_off, recommend, slip,
    solve, surface, truth, unload,
};

/// Rough surfaces in contact: force, real area and stiffness by published models, beside boundary elements
#[derive(Debug, Parser)]
#[command(name = "asperity", version, arg_required_else_help = true)]
#[command(after_help = "Examples:
  asperity init scene.toml
  asperity curve scene.toml --model gw,ke --separation 0:4:5 --format table
  asperity solve scene.toml --model ke --load 100

Data goes to standard output, words to standard error.
Exit code: 0 done, 1 bad input, 2 bad usage.")]
struct Cli {
    #[command(subcommand)]
    command: Command,
    /// Print errors only, without warnings and notes
    #[arg(long, global = true)]
    quiet: bool,
}

#[derive(Debug, Subcommand)]
enum Command {
    Check(check::Check),
    Curve(curve::Curve),
    Solve(solve::Solve),
    Compare(compare::Compare),
    Plan(plan::Plan),
    Recommend(recommend::Recommend),
    Models(models::Models),
    Init(init::Init),
    Surface(surface::Surface),
    Export(export::Export),
    Bem(bem::BemCommand),
    Truth(truth::TruthCommand),
    Unload(unload::Unload),
    Slip(slip::Slip),
    PullOff(pull_off::PullOff),
    Conductance(conductance::Conductance),
}

fn main() -> ExitCode {
    let Cli { command, quiet } = Cli::parse_from(with_negative_numbers(std::env::args_os()));
    output::set_quiet(quiet);
    let done = match command {
        Command::Check(command) => command.run(),
        Command::Curve(command) => command.run(),
        Command::Solve(command) => command.run(),
        Command::Compare(command) => command.run(),
        Command::Plan(command) => command.run(),
        Command::Recommend(command) => command.run(),
        Command::Models(command) => command.run(),
        Command::Init(command) => command.run(),
        Command::Surface(command) => command.run(),
        Command::Export(command) => command.run(),
        Command::Bem(command) => command.run(),
        Command::Truth(command) => command.run(),
        Command::Unload(command) => command.run(),
        Command::Slip(command) => command.run(),
        Command::PullOff(command) => command.run(),
        Command::Conductance(command) => command.run(),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) if output::is_broken_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            output::say("error", &output::told(&error));
            ExitCode::FAILURE
        }
    }
}

/// `--separation -1:4:11` as `--separation=-1:4:11`: clap takes words that begin with a dash for
/// flags, unless it is told to swallow flags as well.
fn with_negative_numbers(words: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let mut joined: Vec<OsString> = vec![];
    let mut flags_end = false;
    for word in words {
        let bytes = word.as_encoded_bytes();
        let is_negative = matches!(bytes, [b'-', b'0'..=b'9' | b'.', ..]);
        flags_end |= bytes == b"--";
        match joined.last_mut() {
            Some(flag) if is_negative && !flags_end && is_bare_flag(flag) => {
                flag.push("=");
                flag.push(word);
            }
            _ => joined.push(word),
        }
    }
    joined
}

fn is_bare_flag(word: &OsString) -> bool {
    let bytes = word.as_encoded_bytes();
    bytes.len() > 2 && bytes.starts_with(b"--") && !bytes.contains(&b'=')
}

/// Ends the program as clap does for arguments that it refuses.
fn usage_error(subcommand: &str, kind: ErrorKind, text: &str) -> ! {
    let mut all = Cli::command();
    all.build();
    let command = all.find_subcommand(subcommand).cloned();
    command.unwrap_or(all).error(kind, text).exit()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clap_accepts_the_definitions() {
        Cli::command().debug_assert();
    }

    #[test]
    fn negative_numbers_belong_to_the_flag_before_them_and_nothing_else_does() {
        let joined = |text: &str| {
            let words = with_negative_numbers(text.split(' ').map(OsString::from));
            words.iter().map(|w| w.to_string_lossy().into_owned()).collect::<Vec<_>>().join(" ")
        };
        assert_eq!(joined("a --separation -1:4:11 b"), "a --separation=-1:4:11 b");
        assert_eq!(joined("a --separation -.5 -- --x -1"), "a --separation=-.5 -- --x -1");
        for same in ["a --separation --model ke", "a --x=1 -1", "a b -1", "a --x 1 -1", "a -- -1"] {
            assert_eq!(joined(same), same);
        }
    }
}
