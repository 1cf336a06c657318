//! The ways to describe a surface, and a scene's surface in another of them.

use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::path::Path;

use asperity_answer::rounded;
use asperity_inputs::{KEYS, Key, SceneFile, Subject};
use serde_json::{Value, json};

use crate::fields::{edit, fields, files};
use crate::message::Change;
use crate::random::RANDOM;
use crate::refusal::Refusal;

/// Ways with their keys. The first two of each tell it from the others, of a finish any.
const WAYS: [(&str, &[&str]); 6] = [
    (FINISH, &["ra", "finish", "rdq", "rq", "rz", "rsm", "bandwidth"]),
    ("scan", &["file", "files"]),
    ("moments", &["m0", "m2", "m4"]),
    ("iso", &["sq", "spd", "spc"]),
    ("index", &["plasticity_index", "roughness_parameter", "asperity_height_std"]),
    ("asperities", &["asperity_radius", "asperity_density", "asperity_height_std"]),
];
const FINISH: &str = "finish";
/// The keys of the other surface that the form has beside a finish, with what the form says of it.
const OTHER: [&str; 2] = ["ra", "finish"];
/// Keys that say how a scan is treated, whatever its file.
const OF_TREATMENT: [&str; 5] = ["estimator", "level", "filter", "smooth", "despike"];
/// Largest relative difference of a surface from the numbers that were typed for it.
const SAME: f64 = 2e-5;
/// Keys of a scan that the form always shows.
const OF_SCANS: [&str; 4] = ["file", "unit", "pixel_size", "periodic"];
/// Keys that another description of the surface leaves: the second surface, and what models make of
/// both.
const OF_BOTH: [&str; 3] = ["counterface", "asperities", "separation_from"];

/// The fields of the form, of the two bodies, their contact and every surface, of each way to
/// describe a surface, and those that are rarely set for a scan. Each is a key with its label, and
/// a value as it may be typed, or the values to choose from, separated by `|`.
pub(crate) fn form() -> Value {
    let field = |key: &Key| [key.name, key.form[0], key.form[1]];
    let of = |is_of: &dyn Fn(&Key) -> bool| -> Vec<_> {
        KEYS.iter().filter(|key| !key.form[0].is_empty() && is_of(key)).map(field).collect()
    };
    let is_more = |key: &Key| key.subject == Subject::Scan && !OF_SCANS.contains(&key.name);
    let named = |name: &&str| Key::find("surface", name);
    let ways = WAYS.map(|(way, keys)| {
        let keys = if way == "scan" { &OF_SCANS[..] } else { keys };
        let fields = keys.iter().filter_map(named).map(|key| field(key).map(String::from));
        let other = OTHER.iter().filter(|_| way == FINISH).filter_map(named).map(|key| {
            let [name, label, typed] = field(key);
            [format!("counterface.{name}"), format!("{label}, other surface"), typed.into()]
        });
        (way, fields.chain(other).collect::<Vec<_>>())
    });
    json!({
        "area": Key::find("", "nominal_area").map(field),
        "body": of(&|key| key.subject == Subject::Body),
        "interface": of(&|key| key.subject == Subject::Interface),
        "ways": BTreeMap::from(ways),
        "more": of(&is_more),
        "every": of(&|key| key.subject == Subject::Surface),
    })
}

/// The way in which the keys of a text describe the surface.
pub(crate) fn way(fields: &BTreeMap<String, String>) -> &'static str {
    let has = |key: &str| fields.contains_key(&format!("surface.{key}"));
    let of = |(way, keys): &&(&str, &[&str])| {
        keys.iter().take(if *way == FINISH { keys.len() } else { 2 }).any(|key| has(key))
    };
    WAYS.iter().find(of).map_or("asperities", |(way, _)| way)
}

/// The text with the surface of its scene described in another way: with the fields that were
/// `typed` before in that way if the surface is still the same, else to six digits.
pub(crate) fn described(
    text: &str,
    way: &str,
    typed: &BTreeMap<String, String>,
    file: &SceneFile,
) -> Result<String, Refusal> {
    let asperities = |file: &SceneFile| {
        let surface = file.scene.surface;
        [surface.asperity_radius, surface.asperity_density, surface.asperity_height_std]
    };
    let [radius, density, std] = asperities(file);
    let moments = file.scene.surface.moments();
    let known = WAYS.iter().find(|(name, _)| *name == way && way != "scan");
    let (_, keys) = known.ok_or_else(|| Refusal::new("drop or choose a scan file instead"))?;
    let with = |values: Vec<Change>| {
        let mut changes = removals(|key| keys.contains(&key.name));
        // The numbers are those of both surfaces together.
        changes.push(surface_key("counterface", None));
        changes.extend(values);
        edit(text, &changes)
    };
    let as_typed = |key: &Key| {
        let value = typed.get(&format!("surface.{}", key.name))?;
        Some(surface_key(key.name, Some(value.clone())))
    };
    let numbers_of = KEYS.iter().filter(|key| key.subject == Subject::Roughness);
    let of_other = typed.iter().filter(|(path, _)| path.starts_with("surface.counterface."));
    let of_other =
        of_other.map(|(path, value)| Change { path: path.clone(), value: Some(value.clone()) });
    let before = with(numbers_of.filter_map(as_typed).chain(of_other).collect())?;
    let is_same = |before: SceneFile| {
        let both = asperities(&before).into_iter().zip(asperities(file));
        both.into_iter().all(|(then, now)| (then / now - 1.0).abs() < SAME)
    };
    if asperity_inputs::parse(&before, Path::new("")).is_ok_and(is_same) {
        return Ok(before);
    }
    let values = match way {
        // Ra of Gaussian heights.
        FINISH => vec![rounded((2.0 * moments.m0 / PI).sqrt()), "unknown".into()],
        "moments" => [moments.m0, moments.m2, moments.m4].map(rounded).into(),
        "iso" => [moments.m0.sqrt(), density, 1.0 / radius].map(rounded).into(),
        "index" => {
            [file.scene.plasticity_index()?, density * radius * std, std].map(rounded).into()
        }
        _ => [radius, density, std].map(rounded).into(),
    };
    with(keys.iter().zip(values).map(|(key, value)| surface_key(key, Some(value))).collect())
}

/// The text whose surface is a file. In place of another file it is levelled and filtered with the
/// same keys, and read without those that the other file needed.
pub(crate) fn with_scan(text: &str, name: &str) -> Result<String, Refusal> {
    if files(text).iter().any(|known| known == name) {
        return Ok(text.into());
    }
    let fields = fields(text);
    let old = fields.get("surface.file").map(String::as_str);
    let is_random = |name: &str| name.starts_with(RANDOM) && name.ends_with(".x3p");
    let mut changes = removals(|key| {
        let is_kept = key.subject == Subject::Surface || OF_TREATMENT.contains(&key.name);
        old.is_some() && (is_kept || key.name == "file")
    });
    // No scan has a second surface that is known within ranges.
    if OTHER.iter().any(|key| fields.contains_key(&format!("surface.counterface.{key}"))) {
        changes.push(surface_key("counterface", None));
    }
    // In quotes, so that no name of a file reads as anything else.
    changes.push(surface_key("file", Some(toml_edit::Value::from(name).to_string())));
    if is_random(name) {
        changes.push(surface_key("periodic", Some("true".into())));
    }
    edit(text, &changes)
}

fn surface_key(name: &str, value: Option<String>) -> Change {
    Change { path: format!("surface.{name}"), value }
}

/// The keys that describe a surface go, but for those that are kept.
fn removals(is_kept: impl Fn(&Key) -> bool) -> Vec<Change> {
    let removed = KEYS.iter().filter(|key| key.section == "surface" && !is_kept(key));
    let removed = removed.filter(|key| !OF_BOTH.contains(&key.name));
    removed.map(|key| surface_key(key.name, None)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_surface_is_the_same_in_every_way() {
        let text = include_str!("../../asperity-inputs/examples/ground-steel.toml");
        let folder = std::path::Path::new(".");
        let file = asperity_inputs::parse(text, folder).unwrap();
        assert_eq!(way(&fields(text)), "moments");
        for (name, _) in &WAYS[2..] {
            let edited = described(text, name, &BTreeMap::new(), &file).unwrap();
            assert_eq!(way(&fields(&edited)), *name);
            let found = asperity_inputs::parse(&edited, folder).unwrap().scene.surface;
            let wanted = file.scene.surface;
            let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 5e-5, "{name}: {a} {b}");
            near(found.asperity_radius, wanted.asperity_radius);
            near(found.asperity_density, wanted.asperity_density);
            near(found.asperity_height_std, wanted.asperity_height_std);
        }
        let found = fields(&with_scan(text, "a \"b\".x3p").unwrap());
        assert_eq!((way(&found), found["surface.file"].as_str()), ("scan", "a \"b\".x3p"));
        assert!(!found.contains_key("surface.m0") && !found.contains_key("surface.periodic"));
        for way in ["scan", "x"] {
            assert!(described(text, way, &BTreeMap::new(), &file).is_err());
        }
    }

    #[test]
    fn a_surface_given_by_its_slope_can_be_described_otherwise() {
        let folder = Path::new(".");
        let template = asperity_inputs::template();
        let (head, _) = template.split_once("\n[surface]").unwrap();
        for surface in [
            "sq = 1.1e-6\nspd = 2e8\nsdq = 0.058",
            "surface_height_std = 1.1e-6\nasperity_density = 2e8\nmean_slope = 0.03",
        ] {
            let text = format!("{head}\n[surface]\n{surface}\n");
            let file = asperity_inputs::parse(&text, folder).unwrap();
            for (name, _) in &WAYS[2..] {
                let edited = described(&text, name, &BTreeMap::new(), &file).unwrap();
                assert_eq!(way(&fields(&edited)), *name);
                let found = asperity_inputs::parse(&edited, folder).unwrap().scene.surface;
                let ratio = found.asperity_radius / file.scene.surface.asperity_radius;
                assert!((ratio - 1.0).abs() < 5e-5, "{surface}, {name}: {ratio}");
            }
            let scan = fields(&with_scan(&text, "a.x3p").unwrap());
            assert!(!scan.contains_key("surface.sdq") && !scan.contains_key("surface.mean_slope"));
        }
    }

    #[test]
    fn the_way_back_has_the_texts_that_were_typed_unless_the_surface_changed() {
        let template = asperity_inputs::template();
        let (head, _) = template.split_once("\n[surface]").unwrap();
        let text = format!(
            "{head}\n[surface]\nsq = \"95 nm\"\nspd = \"20000 1/mm2\"\nspc = \"50 1/mm\"\n"
        );
        let typed = fields(&text);
        let parse = |text: &str| asperity_inputs::parse(text, Path::new("")).unwrap();
        let moments = described(&text, "moments", &BTreeMap::new(), &parse(&text)).unwrap();
        let back = described(&moments, "iso", &typed, &parse(&moments)).unwrap();
        assert_eq!(fields(&back), fields(&text));
        let m0 = |value: &str| surface_key("m0", Some(value.into()));
        let changed = edit(&moments, &[m0("1e-14")]).unwrap();
        let back = described(&changed, "iso", &typed, &parse(&changed)).unwrap();
        assert!(fields(&back)["surface.sq"].starts_with("1e-7"), "{back}");
    }

    #[test]
    fn a_surface_becomes_one_of_unknown_finish_and_its_finish_comes_back() {
        let parse = |text: &str| asperity_inputs::parse(text, Path::new("")).unwrap();
        let template = asperity_inputs::template();
        let file = parse(template);
        let text = described(template, FINISH, &BTreeMap::new(), &file).unwrap();
        let typed = fields(&text);
        assert_eq!((way(&typed), typed["surface.finish"].as_str()), (FINISH, "unknown"));
        let ra: f64 = typed["surface.ra"].parse().unwrap();
        let wanted = (2.0 * file.scene.surface.moments().m0 / PI).sqrt();
        assert!((ra / wanted - 1.0).abs() < 1e-5, "{ra}");
        let set = |path: &str, value: &str| Change { path: path.into(), value: Some(value.into()) };
        let ground = [
            set("surface.ra", "0.8 um"),
            set("surface.finish", "ground"),
            set("surface.counterface.ra", "0.8 um"),
            set("surface.counterface.finish", "ground"),
        ];
        let text = edit(&text, &ground).unwrap();
        assert!(text.contains("counterface = { ra = \"0.8 um\", finish = \"ground\" }"), "{text}");
        // Numbers are those of both surfaces, and the way back is to what was typed.
        let typed = fields(&text);
        let moments = described(&text, "moments", &BTreeMap::new(), &parse(&text)).unwrap();
        let has_other = |text: &str| fields(text).keys().any(|path| path.contains("counterface"));
        assert!(!has_other(&moments));
        let back = described(&moments, FINISH, &typed, &parse(&moments)).unwrap();
        let each = |text: &BTreeMap<String, String>| {
            let mut text = text.clone();
            text.remove("surface.counterface");
            text
        };
        assert_eq!(each(&fields(&back)), each(&typed));
        assert!(!has_other(&with_scan(&text, "a.x3p").unwrap()));
        let none = |path: &str| Change { path: path.into(), value: None };
        let smooth = ["surface.counterface.ra", "surface.counterface.finish"].map(none);
        assert!(!has_other(&edit(&text, &smooth).unwrap()));
    }

    #[test]
    fn another_file_is_treated_as_the_one_before_and_read_without_its_keys() {
        let text = "[surface]\nfile = \"a.txt\"\nunit = \"um\"\npixel_size = 2\nmax_missing = 0.3\n\
                    filter = 8e-4\nlevel = \"mean\"\nperiodic = true\n";
        let of = |text: &str, name: &str| fields(&with_scan(text, name).unwrap());
        let found = of(text, "b.txt");
        let values: Vec<_> = found.values().map(String::as_str).collect();
        assert_eq!(values, ["b.txt", "8e-4", "mean"]);
        assert_eq!(with_scan(text, "a.txt").unwrap(), text);
        assert!(with_scan(text, "b.txt").unwrap().starts_with("[surface]\nfile = \"b.txt\"\n"));
        let random = with_scan(text, "random-1.x3p").unwrap();
        assert_eq!(fields(&random)["surface.periodic"], "true");
        assert!(!of(&random, "c.x3p").contains_key("surface.periodic"));
    }
}
