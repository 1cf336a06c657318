//! The program `asperity`: rough contact from a scene file.
//!
//! Data goes to standard output, messages to standard error; exit code 0, 1 for bad input, 2 for
//! bad usage. Parsing and printing only: the libraries compute.

mod commands;
mod input;
mod interrupt;
mod output;
mod scene;

use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches, Parser};

/// Contact of rough surfaces: force, real contact area and stiffness from published models and
/// boundary elements
#[derive(Debug, Parser)]
#[command(name = "asperity", version, arg_required_else_help = true)]
#[command(after_help = include_str!("help/asperity.txt"))]
struct Cli {
    #[command(subcommand)]
    command: commands::Command,
    /// Print errors only, without warnings and notes
    #[arg(long, global = true, display_order = 100)]
    quiet: bool,
}

fn main() -> ExitCode {
    input::set_program(Cli::command);
    let arguments = input::blanks::with_negative_numbers(std::env::args_os());
    let mut program = Cli::command();
    let matches = program.try_get_matches_from_mut(input::former::renamed(arguments));
    let matches = matches.unwrap_or_else(|e| e.exit());
    input::destinations::check(&program, &matches);
    let Cli { command, quiet } = Cli::from_arg_matches(&matches).unwrap_or_else(|e| e.exit());
    output::set_quiet(quiet);
    match command.run() {
        Ok(()) if output::has_error() => ExitCode::FAILURE,
        Ok(()) => ExitCode::SUCCESS,
        Err(error) if output::is_broken_pipe(&error) => ExitCode::SUCCESS,
        Err(error) => {
            output::print_message("error", &output::summary(&error));
            ExitCode::FAILURE
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clap_accepts_the_definitions() {
        Cli::command().debug_assert();
    }
}
