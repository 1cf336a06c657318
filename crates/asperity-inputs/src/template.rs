//! The template declares every section and key with its unit and meaning; accepted names, units,
//! suggestions and the order of written scenes follow from it.

use std::sync::LazyLock;

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

/// A key or a section of the template.
#[derive(Clone, Copy)]
pub(crate) struct Key {
    pub(crate) name: &'static str,
    /// Header of its section, such as `[surface]`; empty for the top of the file.
    pub(crate) section: &'static str,
    /// Its unit and meaning; empty if explained at another key.
    pub(crate) meaning: &'static str,
    /// Whether it is a key of measured surfaces.
    measured: bool,
}

/// The heading of those keys in the template; an empty line ends them.
const MEASURED: &str = "5. a measurement";

/// The keys of the template, in its order.
pub(crate) fn keys() -> impl Iterator<Item = Key> {
    static KEYS: LazyLock<Vec<Key>> = LazyLock::new(|| read_keys().collect());
    KEYS.iter().copied()
}

fn read_keys() -> impl Iterator<Item = Key> {
    let (mut inside, mut measured) = ("", false);
    template().lines().filter_map(move |line| {
        let line = line.trim_start_matches("# ");
        measured = line.starts_with(MEASURED) || measured && !line.is_empty();
        let (code, meaning) = line.split_once('#').unwrap_or((line, ""));
        let (code, meaning) = (code.trim_end(), meaning.trim());
        match code.split_once(" = ") {
            Some((name, _)) if name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') => {
                Some(Key { name, section: inside, meaning, measured })
            }
            _ if code.starts_with('[') => {
                inside = code;
                Some(Key { name: code.trim_matches(['[', ']']), section: "", meaning, measured })
            }
            _ => None,
        }
    })
}

/// The names of the keys of a section, each once, in the order of the template.
pub(crate) fn keys_of(section: &str) -> Vec<&'static str> {
    let mut names = vec![];
    for key in keys().filter(|key| key.section.trim_matches(['[', ']']) == section) {
        if !names.contains(&key.name) {
            names.push(key.name);
        }
    }
    names
}

/// The keys of `[surface]` for measured surfaces only.
pub(crate) fn measured_keys() -> impl Iterator<Item = &'static str> {
    keys().filter(|key| key.measured).map(|key| key.name)
}

/// The keys of the second surface: those of the first that describe one surface.
pub(crate) fn counterface_keys() -> Vec<&'static str> {
    let of_pair = [
        "files",
        "aligned",
        "counterface",
        "heights",
        "asperities",
        "separation_from",
        "mean_plane_offset",
    ];
    keys_of("surface").into_iter().filter(|name| !of_pair.contains(name)).collect()
}

/// A key behind its section.
pub(crate) fn joined(section: &str, key: &str) -> String {
    let dot = if section.is_empty() || key.is_empty() { "" } else { "." };
    format!("{section}{dot}{key}")
}

/// The key of this name in a section, or else the first of this name.
pub(crate) fn key(section: &str, name: &str) -> Option<Key> {
    let here = |key: &Key| key.section.trim_matches(['[', ']']) == section && key.name == name;
    keys().find(here).or_else(|| keys().find(|key| key.name == name))
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

    #[test]
    fn keys_are_found_with_their_section_and_meaning() {
        for (name, section, meaning) in [
            ("nominal_area", "", "m^2, the apparent area of contact"),
            ("youngs_modulus", "[[body]]", "Pa"),
            ("equivalent_modulus", "[interface]", "Pa, 1/E = (1-nu1^2)/E1 + (1-nu2^2)/E2"),
            ("m4", "[surface]", "1/m^2"),
            ("stick", "[options]", "\"unlimited\""),
        ] {
            let key = key("", name).unwrap();
            assert_eq!((key.section, key.meaning), (section, meaning), "{name}");
        }
        assert!(key("", "surface").unwrap().meaning.contains("exactly one of five ways"));
        assert_eq!(key("interface", "poissons_ratio").unwrap().meaning, "of the softer body");
        assert!(key("", "zeta").is_none() && key("", "").is_none());
    }

    #[test]
    fn every_key_of_a_section_is_declared() {
        let only_measured: Vec<&str> = measured_keys().collect();
        let wanted = "file files unit pixel_size channel estimator level filter smooth periodic max_missing fill_missing despike aligned";
        assert_eq!(only_measured.join(" "), wanted);
        let declared = |section: &str, fields: serde_json::Value, elsewhere: &[&str]| {
            let fields = fields.as_object().unwrap().keys().map(String::as_str);
            let mut fields: Vec<&str> = fields.filter(|name| !elsewhere.contains(name)).collect();
            let mut known = keys_of(section);
            fields.sort_unstable();
            known.sort_unstable();
            assert_eq!(known, fields, "{section}");
        };
        let body = asperity::Body::elastic(1e9, 0.3);
        let mut body = serde_json::to_value(body).unwrap();
        body["material"] = "steel-100cr6".into();
        declared("body", body, &[]);
        let interface = asperity::Interface::new(1e9, 0.3, 1e9);
        declared("interface", serde_json::to_value(interface).unwrap(), &[]);
        let options = crate::ModelOptions { hurst_exponent: Some(0.8), ..Default::default() };
        // In `[surface]`.
        declared("options", serde_json::to_value(options).unwrap(), &["asperities"]);
    }
}
