//! The template: the one list of the sections, their keys, and what these mean.

/// A commented scene file with every key there is: steel on steel, machined.
#[must_use]
pub fn template() -> &'static str {
    include_str!("template.toml")
}

/// What the template says of a key, or of a section.
pub(crate) struct Key {
    pub(crate) name: &'static str,
    /// Header of the section that it stands in, as `[surface]`; empty for the top of the file.
    pub(crate) section: &'static str,
    /// Its unit and meaning; empty where these go without saying.
    pub(crate) meaning: &'static str,
}

/// The keys of the template, in its order.
pub(crate) fn keys() -> impl Iterator<Item = Key> {
    let mut inside = "";
    template().lines().filter_map(move |line| {
        let line = line.trim_start_matches("# ");
        let (code, meaning) = line.split_once('#').unwrap_or((line, ""));
        let (code, meaning) = (code.trim_end(), meaning.trim());
        match code.split_once(" = ") {
            Some((name, _)) => Some(Key { name, section: inside, meaning }),
            None if code.starts_with('[') => {
                inside = code;
                Some(Key { name: code.trim_matches(['[', ']']), section: "", meaning })
            }
            None => None,
        }
    })
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
}
