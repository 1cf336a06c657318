//! Parsing of the command line: arguments, numbers, separations.

pub mod args;
pub mod destinations;
pub mod distances;
pub mod lists;
pub mod numbers;
pub mod target;
pub mod varied;

use std::sync::OnceLock;

use clap::Command;
use clap::error::ErrorKind;

/// Makes the definition of the program, for the usage beside an error.
static PROGRAM: OnceLock<fn() -> Command> = OnceLock::new();

/// Sets the program whose usage [`usage_error`] shows.
pub fn set_program(program: fn() -> Command) {
    let _ = PROGRAM.set(program);
}

/// What the arguments say, or the end of the program as for arguments that clap refuses.
pub fn valid<T>(subcommand: &str, found: Result<T, impl ToString>) -> T {
    found.unwrap_or_else(|error| {
        usage_error(subcommand, ErrorKind::ValueValidation, &error.to_string())
    })
}

/// Ends the program as clap does for arguments that it refuses.
pub fn usage_error(subcommand: &str, kind: ErrorKind, text: &str) -> ! {
    let mut program = PROGRAM.get().map_or_else(Command::default, |make| make());
    program.build();
    let command = program.find_subcommand(subcommand).cloned();
    command.unwrap_or(program).error(kind, text).exit()
}
