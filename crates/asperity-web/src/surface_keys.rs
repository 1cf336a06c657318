//! The ways to describe a surface, and a scene's surface in another of them.

use std::collections::BTreeMap;

use asperity::short;
use asperity_scene::SceneFile;

use crate::message::Change;
use crate::refusal::Refusal;

/// Ways with their keys. The first key of each tells it from the others.
const WAYS: [(&str, &[&str]); 5] = [
    ("scan", &["file", "files"]),
    ("moments", &["m0", "m2", "m4"]),
    ("iso", &["sq", "spd", "spc"]),
    ("index", &["plasticity_index", "roughness_parameter", "asperity_height_std"]),
    ("asperities", &["asperity_radius", "asperity_density", "asperity_height_std"]),
];
/// Keys of a scan alone, or of a surface that it replaces.
const OF_SCANS: [&str; 14] = [
    "unit",
    "pixel_size",
    "channel",
    "estimator",
    "level",
    "filter",
    "smooth",
    "periodic",
    "max_missing",
    "fill_missing",
    "despike",
    "surface_height_std",
    "heights",
    "mean_plane_offset",
];

/// The way in which the keys of a text describe the surface.
pub(crate) fn way(fields: &BTreeMap<String, String>) -> &'static str {
    let has = |key: &str| fields.contains_key(&format!("surface.{key}"));
    let of = |(_, keys): &&(&str, &[&str])| keys.iter().take(2).any(|key| has(key));
    WAYS.iter().find(of).map_or("asperities", |(way, _)| way)
}

/// The changes that describe the surface of a scene in another way, to six digits.
pub(crate) fn changes(way: &str, file: &SceneFile) -> Result<Vec<Change>, Refusal> {
    let surface = file.scene.surface;
    let moments = surface.moments();
    let [radius, density] = [surface.asperity_radius, surface.asperity_density];
    let std = surface.asperity_height_std;
    let (_, keys) = known(way)?;
    let numbers = match way {
        "moments" => [moments.m0, moments.m2, moments.m4],
        "iso" => [moments.m0.sqrt(), density, 1.0 / radius],
        "index" => [file.scene.plasticity_index()?, density * radius * std, std],
        "asperities" => [radius, density, std],
        _ => return Err(Refusal::new("drop or choose a scan file instead")),
    };
    let mut changes = removals(keys);
    changes.extend(
        keys.iter().zip(numbers).map(|(key, number)| Change {
            path: format!("surface.{key}"),
            value: Some(six(number)),
        }),
    );
    Ok(changes)
}

/// The changes that make a file the surface, with these keys to read it.
pub(crate) fn scan(name: &str, keys: &[(&str, &str)]) -> Vec<Change> {
    let mut changes = removals(&[]);
    let all = [("file", name)].into_iter().chain(keys.iter().copied());
    changes.extend(all.map(|(key, value)| {
        // In quotes, so that no name of a file reads as anything else.
        let value = if key == "file" { quoted(value) } else { value.into() };
        Change { path: format!("surface.{key}"), value: Some(value) }
    }));
    changes
}

fn quoted(name: &str) -> String {
    toml_edit::Value::from(name).to_string()
}

fn known(way: &str) -> Result<(&'static str, &'static [&'static str]), Refusal> {
    let found = WAYS.into_iter().find(|(name, _)| *name == way);
    found.ok_or_else(|| Refusal::new(format!("{way:?} is no description of a surface")))
}

fn removals(kept: &[&str]) -> Vec<Change> {
    let all = WAYS.into_iter().flat_map(|(_, keys)| keys).copied().chain(OF_SCANS);
    let removed = all.filter(|key| !kept.contains(key));
    removed.map(|key| Change { path: format!("surface.{key}"), value: None }).collect()
}

/// A number to six digits.
fn six(number: f64) -> String {
    let six: f64 = format!("{number:.5e}").parse().unwrap_or(number);
    match six.abs() {
        size if (1e-3..1e5).contains(&size) => short_digits(six),
        _ => format!("{six:e}"),
    }
}

fn short_digits(number: f64) -> String {
    let text = asperity::shortest_digits(number);
    if text.len() > 12 { short(number) } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fields::{edit, fields};

    #[test]
    fn a_surface_is_the_same_in_every_way() {
        let text = include_str!("../../asperity-scene/examples/ground-steel.toml");
        let folder = std::path::Path::new(".");
        let file = asperity_scene::parse(text, folder).unwrap();
        assert_eq!(way(&fields(text)), "moments");
        for (name, _) in &WAYS[1..] {
            let edited = edit(text, &changes(name, &file).unwrap()).unwrap();
            assert_eq!(way(&fields(&edited)), *name);
            let found = asperity_scene::parse(&edited, folder).unwrap().scene.surface;
            let wanted = file.scene.surface;
            let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 5e-5, "{name}: {a} {b}");
            near(found.asperity_radius, wanted.asperity_radius);
            near(found.asperity_density, wanted.asperity_density);
            near(found.asperity_height_std, wanted.asperity_height_std);
        }
        let scanned = edit(text, &scan("a \"b\".x3p", &[("periodic", "true")])).unwrap();
        let found = fields(&scanned);
        assert_eq!((way(&found), found["surface.file"].as_str()), ("scan", "a \"b\".x3p"));
        assert!(!found.contains_key("surface.m0") && found["surface.periodic"] == "true");
        assert!(changes("scan", &file).is_err() && changes("x", &file).is_err());
    }
}
