//! Values behind a dash, which clap takes for flags.

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

#[cfg(test)]
mod tests {
    use super::*;

    fn arguments(text: &str) -> Vec<OsString> {
        with_negative_numbers(text.split(' ').map(OsString::from))
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
