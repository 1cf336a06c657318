//! Former names of commands, which still work.

use std::ffi::OsString;

/// Each with the words instead.
const FORMER: [(&str, &[&str]); 5] = [
    ("materials", &["list", "materials"]),
    ("models", &["list", "models"]),
    ("plan", &["curve", "--plan"]),
    ("truth", &["bem", "--compare"]),
    ("unload", &["joint"]),
];

/// The arguments with the present name of the command, which is the first that is no flag.
pub fn renamed(mut arguments: Vec<OsString>) -> Vec<OsString> {
    let is_name = |argument: &OsString| !argument.as_encoded_bytes().starts_with(b"-");
    let name = arguments.iter().skip(1).position(is_name).map(|k| k + 1);
    let known = name.and_then(|k| FORMER.iter().find(|(former, _)| arguments[k] == *former));
    if let (Some(k), Some((_, words))) = (name, known) {
        arguments.splice(k..=k, words.iter().map(OsString::from));
    }
    arguments
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn former_names_are_those_of_commands_only() {
        let renamed = |text: &str| {
            let renamed = renamed(text.split(' ').map(OsString::from).collect());
            renamed.join(" ".as_ref()).to_string_lossy().into_owned()
        };
        assert_eq!(renamed("a truth s.toml --model ke"), "a bem --compare s.toml --model ke");
        assert_eq!(renamed("a --quiet models ke"), "a --quiet list models ke");
        for same in ["a", "a --help", "a curve models", "a init plan"] {
            assert_eq!(renamed(same), same);
        }
    }
}
