//! The ways to describe a surface, and a scene's surface in another of them.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use asperity_answer::rounded;
use asperity_scene::{KEYS, Key, SceneFile, Subject};
use serde_json::{Value, json};

use crate::fields::{edit, fields, files};
use crate::labels::raised;
use crate::message::Change;
use crate::random::RANDOM;
use crate::refusal::Refusal;

/// Ways with their keys. The first two of each tell it from the others, of a finish any.
const WAYS: [(&str, &[&str]); 6] = [
    (FINISH, &["ra", "finish", "rdq", "rq", "rz", "rsm", "bandwidth"]),
    ("scan", &["file"]),
    ("moments", &["m0", "m2", "m4"]),
    ("iso", &["sq", "spd", "spc"]),
    ("index", &["plasticity_index", "roughness_parameter", "asperity_height_std"]),
    ("asperities", &["asperity_radius", "asperity_density", "asperity_height_std"]),
];
const FINISH: &str = "finish";
/// Lengths of a drawing, where a number without a unit is in µm: in the form, not in a file.
const OF_DRAWING: [&str; 4] = ["ra", "rq", "rz", "rsm"];
/// The keys of the other surface that the form has beside a finish, with what the form says of it.
const OTHER: [&str; 2] = ["ra", "finish"];
/// The path under which the form says what the other surface is, as [`other_surface`] does.
const OTHER_SURFACE: &str = "surface.other";
const COUNTERFACE: &str = "surface.counterface";
/// Keys that say how a scan is treated, whatever its file.
const OF_TREATMENT: [&str; 5] = ["estimator", "level", "filter", "smooth", "despike"];
/// Keys of a scan that the form always shows.
const OF_SCANS: [&str; 4] = ["file", "unit", "pixel_size", "periodic"];
/// Keys that another description of the surface leaves: the second surface, and what models make of
/// both.
const OF_BOTH: [&str; 2] = ["counterface", "separation_from"];

/// The fields of the form, of the two bodies, their contact and every surface, of each way to
/// describe a surface, and those that are rarely set for a scan. Each is a key with its label, a
/// value as it may be typed, or the values to choose from, separated by `|`, and the unit of a
/// number without one.
pub(crate) fn form() -> Value {
    let unit = |key: &Key| match OF_DRAWING.contains(&key.name) {
        true => "µm".into(),
        false => raised(key.unit).replace("ohm", "Ω"),
    };
    let field = |key: &Key| [key.name.into(), key.form[0].into(), key.form[1].into(), unit(key)];
    let of = |is_of: &dyn Fn(&Key) -> bool| -> Vec<_> {
        KEYS.iter().filter(|key| !key.form[0].is_empty() && is_of(key)).map(field).collect()
    };
    let is_more = |key: &Key| key.subject == Subject::Scan && !OF_SCANS.contains(&key.name);
    let named = |name: &&str| Key::find("surface", name);
    let ways = WAYS.map(|(way, keys)| {
        let keys = if way == "scan" { &OF_SCANS[..] } else { keys };
        (way, keys.iter().filter_map(named).map(field).collect::<Vec<_>>())
    });
    let other = OTHER.iter().filter_map(named).map(|key| {
        let [name, label, typed, unit] = field(key);
        [format!("counterface.{name}"), format!("{label}, other surface"), typed, unit]
    });
    let other: Vec<_> = other.collect();
    json!({
        "area": Key::find("", "nominal_area").map(field),
        "curvature": of(&|key| key.subject == Subject::Curvature),
        "body": of(&|key| key.subject == Subject::Body),
        "interface": of(&|key| key.subject == Subject::Interface),
        "ways": BTreeMap::from(ways),
        "other": other,
        "more": of(&is_more),
        "every": of(&|key| key.subject == Subject::Surface),
        "seal": of(&|key| key.subject == Subject::Seal),
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

/// What the other surface of a finish is: `same` as the first, `smooth` or `another`.
pub(crate) fn other_surface(fields: &BTreeMap<String, String>) -> Option<&'static str> {
    let is_same = |key: &Key| {
        fields.get(&format!("surface.{}", key.name))
            == fields.get(&format!("{COUNTERFACE}.{}", key.name))
    };
    let word = fields.get(COUNTERFACE).map(|word| word.trim_matches('"'));
    match fields.keys().any(|path| path.starts_with(COUNTERFACE)) {
        _ if way(fields) != FINISH => None,
        _ if word == Some("same") => Some("same"),
        false => Some("smooth"),
        true if word == Some("smooth") => Some("smooth"),
        true if of_roughness().all(is_same) => Some("same"),
        true => Some("another"),
    }
}

fn of_roughness() -> impl Iterator<Item = &'static Key> {
    KEYS.iter().filter(|key| key.subject == Subject::Roughness)
}

/// The text after changes in the form: lengths of a drawing have their unit, and the other surface
/// is changed as the first where they are the same, unless it is to be `another`.
pub(crate) fn edited(text: &str, changes: &[Change], another: bool) -> Result<String, Refusal> {
    let known = fields(text);
    let is_same = other_surface(&known) == Some("same") && !another;
    let mut all = vec![];
    for change in changes {
        if change.path == OTHER_SURFACE {
            let is_smooth = change.value.as_deref() == Some("smooth");
            all.push(surface_key("counterface", is_smooth.then(|| "smooth".into())));
            if !is_smooth {
                all.extend(copies(&known));
            }
            continue;
        }
        let key = change.path.strip_prefix("surface.").unwrap_or_default();
        let name = key.trim_start_matches("counterface.");
        let mut change = change.clone();
        let typed = change.value.as_deref().map(str::trim);
        let plain = typed.filter(|typed| typed.parse::<f64>().is_ok());
        if let Some(plain) = plain.filter(|_| !key.is_empty() && OF_DRAWING.contains(&name)) {
            change.value = Some(format!("{plain} um"));
        }
        if is_same && of_roughness().any(|of| of.name == key) {
            all.push(Change { path: format!("{COUNTERFACE}.{key}"), ..change.clone() });
        }
        all.push(change);
    }
    edit(text, &all)
}

/// The numbers of the first surface for the other.
fn copies(known: &BTreeMap<String, String>) -> Vec<Change> {
    let copy = |key: &Key| {
        let value = known.get(&format!("surface.{}", key.name))?;
        Some(Change { path: format!("{COUNTERFACE}.{}", key.name), value: Some(value.clone()) })
    };
    of_roughness().filter_map(copy).collect()
}

/// The text with the surface of its scene described in another way, to six digits.
pub(crate) fn described(text: &str, way: &str, file: &SceneFile) -> Result<String, Refusal> {
    let surface = file.scene.surface;
    let [radius, density] = [surface.asperity_radius, surface.asperity_density];
    let (std, moments) = (surface.asperity_height_std, surface.moments());
    let known = WAYS.iter().find(|(name, _)| *name == way && way != "scan");
    let (_, keys) = known.ok_or_else(|| Refusal::new("drop or choose a scan file instead"))?;
    let values = match way {
        // Ra of Gaussian heights; of two like bodies each has a like surface.
        FINISH => {
            let surfaces = if is_of_like_bodies(file) { 2.0 } else { 1.0 };
            let ra = (2.0 * moments.m0 / (PI * surfaces)).sqrt();
            vec![format!("{} um", rounded(1e6 * ra)), "unknown".into()]
        }
        "moments" => [moments.m0, moments.m2, moments.m4].map(rounded).into(),
        "iso" => [moments.m0.sqrt(), density, 1.0 / radius].map(rounded).into(),
        "index" => {
            [file.scene.plasticity_index()?, density * radius * std, std].map(rounded).into()
        }
        _ => [radius, density, std].map(rounded).into(),
    };
    // What is not of a scan, or of one of two surfaces, stays.
    let (written, is_pair) = (fields(text), file.scene.pair.is_some());
    let stays = |name: &str| match name {
        "heights" => written.get("surface.heights").is_none_or(|given| given != "measured"),
        "mean_plane_offset" | "peklenik_number" | "separation_from" => !is_pair,
        _ => true,
    };
    let mut changes = removals(|key| {
        keys.contains(&key.name) || key.subject == Subject::Surface && stays(key.name)
    });
    // The numbers are of both surfaces together.
    changes.push(surface_key("counterface", None));
    let set = keys.iter().zip(values).map(|(key, value)| surface_key(key, Some(value)));
    let made = edit(text, &changes.into_iter().chain(set).collect::<Vec<_>>())?;
    match way == FINISH && is_of_like_bodies(file) {
        true => edit(&made, &copies(&fields(&made))),
        false => Ok(made),
    }
}

fn is_of_like_bodies(file: &SceneFile) -> bool {
    matches!(file.bodies(), [first, second] if first == second)
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
    if OTHER.iter().any(|key| fields.contains_key(&format!("{COUNTERFACE}.{key}"))) {
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
    use std::path::Path;

    use super::*;

    #[test]
    fn what_no_way_says_stays_in_every_way() {
        let kept = "heights = { skewness = -0.5 }\npeklenik_number = 2.0\nmean_plane_offset = 1e-6";
        let text = asperity_scene::template().replace("heights = \"gaussian\"", kept);
        let file = asperity_scene::parse(&text, Path::new(".")).unwrap();
        for way in ["index", "moments", "iso", "asperities"] {
            let edited = described(&text, way, &file).unwrap();
            assert!(kept.lines().all(|line| edited.contains(line)), "{way}: {edited}");
        }
    }

    #[test]
    fn a_surface_is_the_same_in_every_way() {
        let ground = include_str!("../../../answer/scene/examples/ground-steel.toml");
        let (head, _) = asperity_scene::template().split_once("\n[surface]").unwrap();
        let by_slope = "surface_height_std = 1.1e-6\nasperity_density = 2e8\nmean_slope = 0.03";
        let by_slope = format!("{head}\n[surface]\n{by_slope}\n");
        for text in [ground, &by_slope] {
            let file = parse(text);
            for (name, _) in &WAYS[2..] {
                let edited = described(text, name, &file).unwrap();
                assert_eq!(way(&fields(&edited)), *name);
                let [found, wanted] = [parse(&edited), file.clone()].map(|f| f.scene.surface);
                let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 5e-5, "{name}: {a} {b}");
                near(found.asperity_radius, wanted.asperity_radius);
                near(found.asperity_density, wanted.asperity_density);
                near(found.asperity_height_std, wanted.asperity_height_std);
            }
            let scan = fields(&with_scan(text, "a \"b\".x3p").unwrap());
            assert_eq!((way(&scan), scan["surface.file"].as_str()), ("scan", "a \"b\".x3p"));
            let of_others = ["m0", "periodic", "mean_slope"];
            assert!(of_others.iter().all(|key| !scan.contains_key(&format!("surface.{key}"))));
            assert!(["scan", "x"].iter().all(|way| described(text, way, &file).is_err()));
        }
    }

    fn parse(text: &str) -> SceneFile {
        asperity_scene::parse(text, Path::new("")).unwrap()
    }

    fn set(path: &str, value: &str) -> Change {
        Change { path: path.into(), value: Some(value.into()) }
    }

    /// Bodies, of which the second may be harder, with Ra 0.8 um typed for a ground surface.
    fn ground(template: &str) -> String {
        let text = described(template, FINISH, &parse(template)).unwrap();
        edited(&text, &[set("surface.ra", "0.8"), set("surface.finish", "ground")], false).unwrap()
    }

    #[test]
    fn roughness_without_a_unit_is_in_um_and_other_numbers_as_typed() {
        let text = ground(asperity_scene::template());
        assert_eq!(fields(&text)["surface.ra"], "0.8 um");
        let changes = [
            set("surface.rz", "5 "),
            set("surface.rsm", "0.12 mm"),
            set("surface.rdq", "0.1"),
            set("surface.counterface.ra", "1.6"),
            set("body[1].hardness", "3e9"),
        ];
        let found = fields(&edited(&text, &changes, true).unwrap());
        for (path, wanted) in [
            ("surface.rz", "5 um"),
            ("surface.rsm", "0.12 mm"),
            ("surface.rdq", "0.1"),
            ("surface.counterface.ra", "1.6 um"),
            ("body[1].hardness", "3e9"),
        ] {
            assert_eq!(found[path], wanted);
        }
        // As the program reads the file.
        let rq = parse(&edited(&text, &[set("surface.rq", "1")], false).unwrap());
        let height = rq.scene.surface.moments().m0.sqrt();
        assert!((height / (2f64.sqrt() * 1e-6) - 1.0).abs() < 1e-9, "{height}");
    }

    #[test]
    fn every_number_of_the_form_has_its_unit() {
        let form = form();
        let lists = ["body", "interface", "more", "every", "other", "seal"].map(|list| &form[list]);
        let ways = form["ways"].as_object().unwrap().values();
        let all = lists.into_iter().chain(ways).flat_map(|list| list.as_array().unwrap());
        let mut count = 0;
        for field in all.chain([&form["area"]]) {
            let [name, _, typed, unit] = [0, 1, 2, 3].map(|k| field[k].as_str().unwrap());
            let name = name.rsplit('.').next().unwrap();
            let needs = Key::find("", name).is_some_and(|key| !key.unit.is_empty());
            assert_eq!(!unit.is_empty(), needs && !typed.contains('|'), "{field}");
            count += usize::from(needs);
        }
        assert!(count > 20, "{count}");
    }

    #[test]
    fn the_other_surface_of_two_like_bodies_is_the_same_until_another_is_chosen() {
        let other = |text: &str| other_surface(&fields(text)).unwrap();
        let has_other = |text: &str| fields(text).keys().any(|path| path.contains("counterface"));
        let template = asperity_scene::template();
        let text = ground(template);
        assert_eq!(other(&text), "same");
        assert!(text.contains("counterface = { ra = \"0.8 um\", finish = \"ground\" }"), "{text}");
        // Both together are as rough as the surface was; Rq of the middle of its range is 7 % above
        // the Rq of Gaussian heights.
        let as_it_was = described(template, FINISH, &parse(template)).unwrap();
        let m0 = |text: &str| parse(text).scene.surface.moments().m0;
        assert!((m0(&as_it_was) / m0(template) - 1.0).abs() < 0.2, "{}", m0(&as_it_was));
        let choose = |text: &str, value| edited(text, &[set(OTHER_SURFACE, value)], false).unwrap();
        let smooth = choose(&text, "smooth");
        assert_eq!((other(&smooth), &*fields(&smooth)[COUNTERFACE]), ("smooth", "smooth"));
        assert_eq!(choose(&smooth, "same"), text);
        assert!((m0(&text) / m0(&smooth) - 2.0).abs() < 1e-9);
        let another = choose(&smooth, "another");
        let another = edited(&another, &[set("surface.ra", "1.6")], true).unwrap();
        assert_eq!((other(&another), &*fields(&another)["surface.ra"]), ("another", "1.6 um"));
        assert_eq!(fields(&another)["surface.counterface.ra"], "0.8 um");
        // As a section of its own as well.
        let alone = edit(&text, &[surface_key("counterface", None)]).unwrap();
        let section = alone + "[surface.counterface]\nra = \"0.8 um\"\nfinish = \"ground\"\n";
        assert_eq!((other(&section), other(&choose(&section, "smooth"))), ("same", "smooth"));
        let unlike = template.replacen("hardness = 2e9", "hardness = 3e9", 1);
        assert_eq!(other(&ground(&unlike)), "smooth");
        assert_eq!(other_surface(&fields(template)), None);
        // Another description and a scan have none.
        let moments = described(&text, "moments", &parse(&text)).unwrap();
        assert!(!has_other(&moments) && !has_other(&with_scan(&text, "a.x3p").unwrap()));
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
