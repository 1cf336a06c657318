//! A scene in words: what is in contact, for the head of an answer and of an exported file.

use std::path::Path;

use asperity::{Body, short};

use crate::curvature::Curvature;
use crate::keys::{CURVATURE, Field, Key};
use crate::measured::Source;
use crate::scene_file::SceneFile;
use crate::spec::{Bodies, Description, SurfaceSpec};

impl SceneFile {
    /// The bodies and the surfaces in the order in which they were written: `steel-4140-tempered on
    /// aluminium-6082-t6, ground, ra 0.8 um`.
    #[must_use]
    pub fn in_words(&self) -> String {
        let surfaces = self.spec.surfaces().map(|(_, one)| one.in_words());
        let surfaces = surfaces.collect::<Vec<_>>().join(" on ");
        let radius = |field: &Field<Curvature>| {
            let value = (field.get)(self.spec.curvature.as_ref()?)?;
            Some(format!(", {} {} m", field.name, short(value)))
        };
        let radii: String = CURVATURE.iter().filter_map(radius).collect();
        format!("{}, {surfaces}{radii}", self.spec.bodies.in_words())
    }
}

impl Bodies {
    fn in_words(&self) -> String {
        let Self::Each { bodies, materials, .. } = self else {
            let modulus = self.interface().map_or(f64::NAN, |one| one.equivalent_modulus);
            return format!("equivalent modulus {}", number(modulus, "Pa"));
        };
        let name = |(body, material): (&Body, &Option<&crate::Material>)| match material {
            Some(material) => material.id.clone(),
            None => format!("E {}", number(body.youngs_modulus, "Pa")),
        };
        let named: Vec<String> = bodies.iter().zip(materials).map(name).collect();
        match &named[..] {
            [only] => format!("{only} on a rigid counterface"),
            several => several.join(" on "),
        }
    }
}

impl SurfaceSpec {
    pub(crate) fn in_words(&self) -> String {
        let numbers = self.numbers().into_iter().map(|(key, value)| {
            let unit = Key::find("surface", key).map_or("", |key| key.unit);
            format!("{key} {}", number(value, unit)).trim_end().to_string()
        });
        match &self.by {
            Description::Scan(scan) => {
                let Some(Source { path, written, .. }) = &scan.source else {
                    return "a scan".into();
                };
                let named = Path::new(path.file_name().unwrap_or(path.as_os_str()));
                let keys = written.iter().filter(|(key, _)| *key != "file");
                let keys = keys.map(|(key, value)| format!(", {key} = {value}"));
                format!("scan {}{}", named.display(), keys.collect::<String>())
            }
            Description::Drawing(drawing) => {
                let finish = drawing.finish.into_iter().map(String::from);
                finish.chain(numbers).collect::<Vec<_>>().join(", ")
            }
            Description::Numbers(_) => numbers.collect::<Vec<_>>().join(", "),
        }
    }
}

/// A number in the unit that engineers write.
fn number(value: f64, unit: &str) -> String {
    let (factor, unit) = match unit {
        "m" => (1e6, "um"),
        "Pa" => (1e-9, "GPa"),
        other => (1.0, other),
    };
    format!("{} {unit}", short(value * factor))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;

    #[test]
    fn bodies_and_surfaces_are_named_by_what_was_written() {
        let words = |bodies: &str, surface: &str| {
            let text = format!("nominal_area = 1e-4\n{bodies}\n[surface]\n{surface}");
            parse(&text, Path::new("s.toml")).unwrap().in_words()
        };
        let pair = "[[body]]\nmaterial = \"42CrMo4\"\n[[body]]\nyoungs_modulus = 70e9\npoissons_ratio = 0.3";
        let ground = "ra = 0.8e-6\nfinish = \"ground\"\ncounterface = \"smooth\"";
        let interface = "[interface]\nequivalent_modulus = 115e9\npoissons_ratio = 0.3";
        insta::assert_snapshot!(
            [words(pair, ground), words(interface, "m0 = 1e-12\nm2 = 1e-4\nm4 = 5e4")].join("\n")
        );
    }
}
