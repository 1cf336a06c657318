//! Parsing of the command line: arguments, numbers, separations.

pub mod args;
pub mod destinations;
pub mod distances;
pub mod lists;
pub mod numbers;
pub mod varied;

use std::env;
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
            let first = number.split([',', ':']).next().unwrap_or(number);
            usage_error(&format!(
                "{unit} behind {number} is an argument of its own: write a number and its unit as one, for example {first}{unit}"
            ));
        }
    }
}

/// What the arguments say, or the end of the program as for arguments that clap refuses.
pub fn valid<T>(found: Result<T, impl ToString>) -> T {
    found.unwrap_or_else(|error| usage_error(&error.to_string()))
}

/// Ends the program with the text of the first conflict of arguments, if there is one.
pub fn refuse<T: AsRef<str>>(conflicts: impl IntoIterator<Item = (bool, T)>) {
    if let Some((_, text)) = conflicts.into_iter().find(|(is_there, _)| *is_there) {
        usage_error(text.as_ref());
    }
}

/// Ends the program as clap does for arguments that it refuses, with the usage of its command.
pub fn usage_error(text: &str) -> ! {
    let mut program = PROGRAM.get().map_or_else(Command::default, |make| make());
    program.build();
    let command = env::args_os().skip(1).find_map(|name| program.find_subcommand(name).cloned());
    command.unwrap_or(program).error(ErrorKind::ValueValidation, text).exit()
}
