//! A scene in words: what is in contact, for the head of an answer and of an exported file.

use std::path::Path;

use asperity::{Body, short, written};
use toml::Value;

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
            Some(format!(", {} {}", field.name, number(value, "m")))
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
                let keys = keys.map(|(key, value)| format!(", {key} = {}", of_key(value)));
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

/// The value of a key of a scan.
fn of_key(value: &Value) -> String {
    match value {
        Value::Float(number) => written(*number),
        Value::Array(items) => {
            format!("[{}]", items.iter().map(of_key).collect::<Vec<_>>().join(", "))
        }
        other => other.to_string(),
    }
}

/// A number in the unit that engineers write.
fn number(value: f64, unit: &str) -> String {
    let (factor, unit) = match (unit, value.abs()) {
        ("m", below) if below < 1e-7 => (1e9, "nm"),
        ("m", below) if below < 1e-3 => (1e6, "um"),
        ("m", below) if below < 0.1 => (1e3, "mm"),
        ("Pa", below) if below < 1e6 => (1e-3, "kPa"),
        ("Pa", below) if below < 1e9 => (1e-6, "MPa"),
        ("Pa", _) => (1e-9, "GPa"),
        (other, _) => (1.0, other),
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
        let soft = "[interface]\nequivalent_modulus = 2e6\npoissons_ratio = 0.5";
        let moments = "m0 = 1e-12\nm2 = 1e-4\nm4 = 5e4";
        let fine = "asperity_radius = 5e-8\nasperity_density = 1e15\nasperity_height_std = 1e-9";
        let all = [words(pair, ground), words(interface, moments), words(soft, fine)];
        insta::assert_snapshot!(all.join("\n"));
        let small = Value::from(vec![3e-7, 0.5]);
        assert_eq!(of_key(&small), "[3e-7, 0.5]");
    }
}
