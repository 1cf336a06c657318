//! Parsing of the command line: arguments, numbers, separations.

pub mod ambiguous;
pub mod args;
pub mod blanks;
pub mod distances;
pub mod list_notes;
pub mod lists;
pub mod numbers;
pub mod target;

use std::sync::OnceLock;

use clap::Command;
use clap::error::ErrorKind;

/// The definition of the program, for the usage beside an error.
static PROGRAM: OnceLock<Command> = OnceLock::new();

/// Sets the program whose usage [`usage_error`] shows.
pub fn set_program(mut program: Command) {
    program.build();
    let _ = PROGRAM.set(program);
}

/// Ends the program as clap does for arguments that it refuses.
pub fn usage_error(subcommand: &str, kind: ErrorKind, text: &str) -> ! {
    let program = PROGRAM.get().cloned().unwrap_or_default();
    let command = program.find_subcommand(subcommand).cloned();
    command.unwrap_or(program).error(kind, text).exit()
}
