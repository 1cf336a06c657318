//! Values that the shell hands over apart: behind a dash, and before a unit.

use std::ffi::OsString;

/// `--separation -1:4:11` as `--separation=-1:4:11`: clap takes an argument that begins with a dash
/// for a flag.
pub fn with_negative_numbers(arguments: impl Iterator<Item = OsString>) -> Vec<OsString> {
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

/// A number and its unit as two arguments: `--load -1 kN`.
pub struct UnitApart {
    pub subcommand: String,
    pub message: String,
    /// All arguments, with the number and its unit in one.
    pub joined: Vec<OsString>,
}

/// The first option whose number and unit are two arguments.
pub fn unit_apart(arguments: &[OsString], is_known: impl Fn(&str) -> bool) -> Option<UnitApart> {
    let texts: Vec<&str> = arguments.iter().map(|one| one.to_str().unwrap_or_default()).collect();
    let (k, flag, number, unit) = texts.windows(3).enumerate().find_map(|(k, three)| {
        // A negative number has been joined to its option.
        let (flag, number) = three[1].split_once('=').unwrap_or((three[0], three[1]));
        let is_apart = flag.starts_with("--")
            && number.ends_with(|c: char| c.is_ascii_digit() || c == '.')
            && asperity_inputs::is_unit(three[2]);
        is_apart.then_some((k, flag, number, three[2]))
    })?;
    let message = format!(
        "{flag} {number} {unit} is two arguments, as a blank separates {number} from {unit}; write {flag} {number}{unit}, or {flag} \"{number} {unit}\""
    );
    // Options of the program may stand before the subcommand.
    let subcommand = texts.iter().skip(1).find(|text| is_known(text))?;
    let mut joined = arguments.to_vec();
    let unit = joined.remove(k + 2);
    joined.get_mut(k + 1)?.push(unit);
    Some(UnitApart { subcommand: subcommand.to_string(), message, joined })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arguments(text: &str) -> Vec<OsString> {
        with_negative_numbers(text.split(' ').map(OsString::from))
    }

    #[test]
    fn a_unit_behind_a_blank_is_recognised() {
        for (text, wanted) in [
            ("asperity curve a.toml --load -1 kN", Some("--load -1kN, or --load \"-1 kN\"")),
            ("asperity curve --separation 0:2 um a.toml", Some("write --separation 0:2um, or")),
            ("asperity --quiet curve a.toml --load 1 kN", Some("write --load 1kN, or")),
            ("asperity curve a.toml --load 1 --model ke", None),
            ("asperity curve a.toml --load 1 ke", None),
            ("asperity curve a.toml --load", None),
        ] {
            let found = unit_apart(&arguments(text), |name| name == "curve");
            let is_wanted = match (&found, wanted) {
                (Some(found), Some(wanted)) => {
                    found.subcommand == "curve" && found.message.contains(wanted)
                }
                (found, wanted) => found.is_none() && wanted.is_none(),
            };
            assert!(is_wanted, "{text}: {:?}", found.map(|found| found.message));
        }
    }

    #[test]
    fn negative_numbers_belong_to_the_flag_before_them_and_nothing_else_does() {
        let joined = |text: &str| {
            arguments(text)
                .iter()
                .map(|a| a.to_string_lossy().into_owned())
                .collect::<Vec<_>>()
                .join(" ")
        };
        assert_eq!(joined("a --separation -1:4:11 b"), "a --separation=-1:4:11 b");
        assert_eq!(joined("a --separation -.5 -- --x -1"), "a --separation=-.5 -- --x -1");
        for same in ["a --separation --model ke", "a --x=1 -1", "a b -1", "a --x 1 -1", "a -- -1"] {
            assert_eq!(joined(same), same);
        }
    }
}
