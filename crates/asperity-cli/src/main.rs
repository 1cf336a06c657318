//! The program `asperity`: rough contact from a scene file.
//!
//! Data goes to standard output, messages to standard error; exit code 0, 1 for bad input, 2 for
//! bad usage. Parsing and printing only: the libraries compute.

mod ask;
mod commands;
mod input;
mod interrupt;
mod joints;
mod output;
mod pressed;
mod scene;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches, Parser};

/// Contact of rough surfaces: force, real contact area and stiffness from published models and
/// boundary elements
#[derive(Debug, Parser)]
#[command(name = "asperity", version, arg_required_else_help = true)]
#[command(after_help = "Examples:
  asperity init scene.toml
  asperity curve scene.toml --model gw,ke --separation 0:4:5 --format table
  asperity solve scene.toml --model ke --load 100

Results go to standard output; errors, warnings and notes go to standard error.
Exit code: 0 done; 1 bad input, or a result that an error declares invalid; 2 bad usage.")]
struct Cli {
    #[command(subcommand)]
    command: commands::Command,
    /// Print errors only, without warnings and notes
    #[arg(long, global = true)]
    quiet: bool,
}

fn main() -> ExitCode {
    input::set_program(Cli::command());
    let program = Cli::command();
    let arguments = with_negative_numbers(std::env::args_os());
    let arguments = program.clone().get_matches_from(arguments);
    let Cli { command, quiet } =
        Cli::from_arg_matches(&arguments).unwrap_or_else(|error| error.exit());
    output::set_quiet(quiet);
    if let Some((name, given)) = arguments.subcommand()
        && let Some(used) = program.find_subcommand(name)
    {
        input::list_notes::note_lists(used, given);
    }
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

/// `--separation -1:4:11` as `--separation=-1:4:11`: clap takes an argument that begins with a dash
/// for a flag.
fn with_negative_numbers(arguments: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let mut joined: Vec<OsString> = vec![];
    let mut flags_end = false;
    for argument in arguments {
        let bytes = argument.as_encoded_bytes();
        let is_negative = matches!(bytes, [b'-', b'0'..=b'9' | b'.', ..]);
        flags_end |= bytes == b"--";
        match joined.last_mut() {
            Some(flag) if is_negative && !flags_end && is_bare_flag(flag) => {
                flag.push("=");
                flag.push(argument);
            }
            _ => joined.push(argument),
        }
    }
    joined
}

fn is_bare_flag(argument: &OsString) -> bool {
    let bytes = argument.as_encoded_bytes();
    bytes.len() > 2 && bytes.starts_with(b"--") && !bytes.contains(&b'=')
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
            let arguments = with_negative_numbers(text.split(' ').map(OsString::from));
            arguments.iter().map(|a| a.to_string_lossy().into_owned()).collect::<Vec<_>>().join(" ")
        };
        assert_eq!(joined("a --separation -1:4:11 b"), "a --separation=-1:4:11 b");
        assert_eq!(joined("a --separation -.5 -- --x -1"), "a --separation=-.5 -- --x -1");
        for same in ["a --separation --model ke", "a --x=1 -1", "a b -1", "a --x 1 -1", "a -- -1"] {
            assert_eq!(joined(same), same);
        }
    }
}
