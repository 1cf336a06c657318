//! The commented scene file that `asperity init` writes: a scene, with what the table of inputs
//! says of each key.

use std::sync::LazyLock;

use asperity::Surface;
use toml::Value;

use crate::keys::{KEYS, SURFACE};

/// A commented scene file with every key: machined steel on steel.
#[must_use]
pub fn template() -> &'static str {
    static TEXT: LazyLock<String> = LazyLock::new(|| explained(|_, _, _| None));
    &TEXT
}

/// The template for a measured surface: `keys` of `[surface]` have these values, and a comment
/// gives the resulting asperities, if it has any.
#[must_use]
pub fn template_on(surface: Option<&Surface>, keys: &[(&str, Value)]) -> String {
    explained(|section, name, code| {
        if section != "surface" {
            return None;
        }
        if let Some((_, value)) = keys.iter().find(|key| key.0 == name) {
            return Some(match value {
                Value::Float(small) if small.abs() < 1e-3 => format!("{name} = {small:e}"),
                value => format!("{name} = {value}"),
            });
        }
        let field = SURFACE.iter().find(|field| code.starts_with(field.name))?;
        Some(match surface.and_then(field.get) {
            Some(value) => format!("# {name} = {value:.5e}"),
            None => format!("# {code}"),
        })
    })
}

/// The lines of the scene, with its meaning behind the first line of each key; `replaced` gives
/// another line for a section, a key and its line.
fn explained(replaced: impl Fn(&str, &str, &str) -> Option<String>) -> String {
    let (mut section, mut left) = ("", KEYS.to_vec());
    let line = |line: &'static str| {
        let bare = line.trim_start_matches("# ");
        let is_header = bare.starts_with('[');
        let name = bare.split(" = ").next().unwrap_or(bare).trim_matches(['[', ']']);
        let at = if is_header { "" } else { section };
        section = if is_header { name } else { section };
        let code = replaced(at, name, line).unwrap_or_else(|| line.into());
        let key = left.iter().position(|key| key.section == at && key.name == name);
        match key.map_or("", |k| left.remove(k).meaning) {
            "" => format!("{code}\n"),
            meaning => format!("{code:<36}  # {meaning}\n"),
        }
    };
    include_str!("template.toml").lines().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_template_on_a_scan_keeps_all_other_lines() {
        let surface = Surface::new(1.234_567e-5, 2e10, 3e-7);
        let text =
            template_on(Some(&surface), &[("file", "a b.txt".into()), ("smooth", 2.5e-6.into())]);
        let changed: Vec<(&str, &str)> =
            template().lines().zip(text.lines()).filter(|(old, new)| old != new).collect();
        let new = |start: &str| changed.iter().find(|(_, new)| new.starts_with(start)).unwrap();
        assert_eq!(changed.len(), 5, "{changed:#?}");
        let (old, named) = new("file = \"a b.txt\" ");
        assert_eq!(old.split_once("# ").unwrap().1.split_once('#').unwrap().1, &named[39..]);
        new("smooth = 2.5e-6 ");
        new("# asperity_radius = 1.23457e-5 ");
    }
}
