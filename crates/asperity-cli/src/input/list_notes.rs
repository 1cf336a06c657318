//! Notes on lists of the command line.

use clap::{ArgMatches, Command};

use crate::input::ambiguous::may_be_decimal;
use crate::input::distances::{Distance, Distances};
use crate::input::lists::Numbers;
use crate::output::print_message;

/// Says of each list of two values that may be one decimal how it was read.
pub fn note_lists(command: &Command, arguments: &ArgMatches) {
    for argument in command.get_arguments() {
        let id = argument.get_id().as_str();
        let is_list = arguments.try_get_many::<Numbers>(id).is_ok()
            || arguments.try_get_many::<Distances>(id).is_ok()
            || arguments.try_get_many::<[Distance; 2]>(id).is_ok();
        let Some(name) = argument.get_long().filter(|_| is_list) else { continue };
        let given = arguments.get_raw(id).into_iter().flatten();
        for text in given.filter_map(|text| text.to_str()) {
            let read = may_be_decimal(text).zip(text.split_once(','));
            if let Some((decimal, (first, second))) = read {
                let how = format!(
                    "--{name} {text} is read as two values, {first} and {second}; a decimal is written {decimal}"
                );
                print_message("note", &how);
            }
        }
    }
}
