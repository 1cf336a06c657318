//! Notes on lists of the command line.

use clap::{ArgMatches, Command};

use crate::input::ambiguous::single_values;
use crate::input::distances::{Distance, Distances};
use crate::input::lists::Numbers;
use crate::output::print_always;

/// Prints a note for each list of values whose digits may be one number.
pub fn note_lists(command: &Command, arguments: &ArgMatches) {
    for argument in command.get_arguments() {
        let id = argument.get_id().as_str();
        let is_list = arguments.try_get_many::<Numbers>(id).is_ok()
            || arguments.try_get_many::<Distances>(id).is_ok()
            || arguments.try_get_many::<[Distance; 2]>(id).is_ok();
        let Some(name) = argument.get_long().filter(|_| is_list) else { continue };
        let given = arguments.get_raw(id).into_iter().flatten();
        for text in given.filter_map(|text| text.to_str()) {
            let single = single_values(text).join(" or ");
            if !single.is_empty() {
                let values: Vec<&str> = text.split(',').map(str::trim).collect();
                let (last, others) = values.split_last().unwrap_or((&text, &[]));
                let count = if values.len() == 2 { "two".into() } else { values.len().to_string() };
                let others = others.join(", ");
                // Also where other notes are left out, as results may be those of other loads.
                print_always(
                    "note",
                    &format!(
                        "--{name} {text} is read as {count} values, {others} and {last}; a single value is written {single}"
                    ),
                );
            }
        }
    }
}
