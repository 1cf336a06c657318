//! Parsing of the command line: arguments, numbers, separations.

pub mod args;
pub mod destinations;
pub mod distances;
pub mod lists;
pub mod numbers;
pub mod varied;

use std::ffi::OsString;
use std::path::Path;
use std::sync::OnceLock;

use asperity::units;
use clap::Command;
use clap::error::ErrorKind;

/// Makes the definition of the program, for the usage beside an error.
static PROGRAM: OnceLock<fn() -> Command> = OnceLock::new();

/// Sets the program whose usage [`usage_error`] shows.
pub fn set_program(program: fn() -> Command) {
    let _ = PROGRAM.set(program);
}

/// Ends the program where a unit stands behind its number as an argument of its own.
pub fn check_units(arguments: &[OsString]) {
    let is_unit =
        |text: &str| units().iter().flat_map(|of| &of.decimal).any(|(unit, _)| *unit == text);
    for pair in arguments.windows(2) {
        let [Some(number), Some(unit)] = [&pair[0], &pair[1]].map(|text| text.to_str()) else {
            continue;
        };
        let is_number = number.split([',', ':']).all(|part| part.parse::<f64>().is_ok());
        if is_number && is_unit(unit) && !Path::new(unit).exists() {
            let command = arguments.get(1).and_then(|name| name.to_str()).unwrap_or_default();
            let first = number.split([',', ':']).next().unwrap_or(number);
            let text = format!(
                "{unit} behind {number} is an argument of its own: write a number and its unit as one, for example {first}{unit}"
            );
            usage_error(command, ErrorKind::UnknownArgument, &text);
        }
    }
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
