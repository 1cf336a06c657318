//! The program `asperity`: rough contact from a scene file.
//!
//! Data goes to standard output, messages to standard error; exit code 0, 1 without an answer, 2
//! for bad usage. Parsing and printing only: the libraries compute.

mod commands;
mod input;
mod interrupt;
mod output;
mod scene;

use std::any::TypeId;
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Arg, Command, CommandFactory, FromArgMatches, Parser};

/// Contact of rough surfaces: force, real contact area and stiffness from published models and
/// boundary elements
#[derive(Debug, Parser)]
#[command(name = "asperity", version, arg_required_else_help = true)]
#[command(after_help = include_str!("help/asperity.txt"))]
struct Cli {
    #[command(subcommand)]
    command: commands::Command,
    #[command(flatten)]
    treatment: output::Treatment,
}

/// The definition of the program. The options of every command stand in `asperity --help` alone,
/// and every value but the name of a file may begin with a dash, as a negative number does.
fn program() -> Command {
    let program = Cli::command();
    let global = program.get_arguments().filter(|arg| arg.is_global_set());
    let hidden: Vec<Arg> = global.map(|arg| arg.clone().hide(true)).collect();
    let with_dash = |arg: Arg| {
        let is_file = arg.get_value_parser().type_id() == TypeId::of::<PathBuf>();
        let has_value = arg.get_action().takes_values() && !arg.is_positional();
        if has_value && !is_file { arg.allow_hyphen_values(true) } else { arg }
    };
    program.mut_subcommands(|command| command.args(&hidden).mut_args(with_dash))
}

fn main() -> ExitCode {
    input::set_program(program);
    let mut program = program();
    let arguments: Vec<OsString> = std::env::args_os().collect();
    input::check_units(&arguments);
    let matches = program.try_get_matches_from_mut(arguments);
    let matches = matches.unwrap_or_else(|e| e.exit());
    input::destinations::check(&program, &matches);
    let Cli { command, treatment } = Cli::from_arg_matches(&matches).unwrap_or_else(|e| e.exit());
    output::treat(treatment);
    let failure = match command.run() {
        Ok(()) => output::strict_failure(),
        Err(error) if output::is_broken_pipe(&error) => None,
        Err(error) => Some(output::summary(&error)),
    };
    let Some(failure) = failure else { return ExitCode::SUCCESS };
    output::print_error(&failure);
    ExitCode::FAILURE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clap_accepts_the_definitions() {
        program().debug_assert();
    }
}
