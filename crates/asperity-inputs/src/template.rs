//! The commented scene file that `asperity init` writes.

use asperity::Surface;
use toml::Value;

/// A commented scene file with every key: machined steel on steel.
#[must_use]
pub fn template() -> &'static str {
    include_str!("template.toml")
}

/// The template for a measured surface: `keys` of `[surface]` have these values, and a comment
/// gives the resulting asperities, if it has any.
#[must_use]
pub fn template_on(surface: Option<&Surface>, keys: &[(&str, Value)]) -> String {
    let of = |number: fn(&Surface) -> f64| surface.map(number);
    let three = [
        ("asperity_radius", of(|surface| surface.asperity_radius)),
        ("asperity_density", of(|surface| surface.asperity_density)),
        ("asperity_height_std", of(|surface| surface.asperity_height_std)),
    ];
    let mut inside = false;
    let line = |line: &str| {
        inside = if line.starts_with('[') { line.starts_with("[surface]") } else { inside };
        let (code, meaning) = line.trim_start_matches("# ").split_once('#').unwrap_or((line, ""));
        let name = code.trim_start_matches("# ").split(" = ").next().unwrap_or("");
        let code = if let Some((_, value)) = keys.iter().find(|key| inside && key.0 == name) {
            match value {
                Value::Float(small) if *small < 1e-3 => format!("{name} = {small:e}"),
                value => format!("{name} = {value}"),
            }
        } else if let Some((_, value)) = three.iter().find(|key| line.starts_with(key.0)) {
            match value {
                Some(value) => format!("# {name} = {value:.5e}"),
                None => format!("# {}", code.trim_end()),
            }
        } else {
            return format!("{line}\n");
        };
        match meaning {
            "" => format!("{code}\n"),
            meaning => format!("{code:<37} #{meaning}\n"),
        }
    };
    template().lines().map(line).collect()
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
