//! Values of a scene's text by their path, and texts with other values. Order stays, and so do
//! comments but those about a value or a body that became another.

use std::collections::BTreeMap;

use asperity_scene::{BODY, materials};
use toml_edit::{ArrayOfTables, DocumentMut, Item, Table, TableLike, Value};

use crate::message::Change;
use crate::refusal::Refusal;

const SYNTAX: &str = "the scene file has a syntax error; correct the text first";

/// The values of all keys as typed: texts without their quotes.
pub(crate) fn fields(text: &str) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    each_value(text, |path, value| _ = found.insert(path.into(), plain(value)));
    found
}

/// A value as typed.
fn plain(value: &Value) -> String {
    match value.as_str() {
        Some(text) => text.into(),
        None => value.clone().decorated("", "").to_string(),
    }
}

/// Passes on the values of a text with their paths, also in inline tables.
fn each_value(text: &str, mut each: impl FnMut(&str, &Value)) {
    fn walk(table: &dyn TableLike, path: &str, each: &mut dyn FnMut(&str, &Value)) {
        for (key, item) in table.iter() {
            let path = if path.is_empty() { key.into() } else { format!("{path}.{key}") };
            if let Some(value) = item.as_value() {
                each(&path, value);
            }
            if let Some(table) = item.as_table_like() {
                walk(table, &path, each);
            }
            for (table, k) in item.as_array_of_tables().into_iter().flatten().zip(1..) {
                walk(table, &format!("{path}[{k}]"), each);
            }
        }
    }
    if let Ok(document) = text.parse::<DocumentMut>() {
        walk(document.as_table(), "", &mut each);
    }
}

/// Whether a text is TOML with any section of a scene.
pub(crate) fn is_scene(text: &str) -> bool {
    let document = text.parse::<DocumentMut>();
    document
        .is_ok_and(|all| ["body", "interface", "surface"].iter().any(|name| all.contains_key(name)))
}

/// The names of all files of a text, each once.
pub(crate) fn files(text: &str) -> Vec<String> {
    let mut found = vec![];
    each_value(text, |path, value| {
        found.extend(value.as_str().filter(|_| path.ends_with(".file")).map(String::from));
    });
    asperity_answer::once(&found)
}

/// The text with other values. A value that reads as TOML is written as it is, any other as text.
/// Another material replaces the numbers of its body, and a rigid counterface the second body.
pub(crate) fn edit(text: &str, changes: &[Change]) -> Result<String, Refusal> {
    let mut document: DocumentMut = text.parse().map_err(|_| Refusal::at("TOML", SYNTAX))?;
    let known = fields(text);
    for change in changes {
        if change.path == "rigid_counterface" {
            set_rigid(&mut document, change.value.is_some())?;
            continue;
        }
        let below = format!("{}.", change.path);
        let is_here = |path: &String| *path == change.path || path.starts_with(&below);
        if change.value.is_none() && !known.keys().any(is_here) {
            continue;
        }
        set(&mut document, change)?;
        bend(&mut document, &change.path);
        for number in numbers_of_material(change, &known) {
            set(&mut document, &number)?;
        }
    }
    Ok(document.to_string())
}

/// The text with the `[surface]` of another, as it is written there.
pub(crate) fn with_surface_of(text: &str, other: &str) -> Result<String, Refusal> {
    let parsed = |text: &str| text.parse::<DocumentMut>().map_err(|_| Refusal::new(SYNTAX));
    let (mut document, other) = (parsed(text)?, parsed(other)?);
    if let Some(surface) = other.get("surface") {
        document.insert("surface", surface.clone());
    }
    Ok(document.to_string())
}

fn set(document: &mut DocumentMut, Change { path, value }: &Change) -> Result<(), Refusal> {
    let (section, key) = path.rsplit_once('.').unwrap_or(("", path));
    let value = value.as_deref().map(str::trim).filter(|value| !value.is_empty());
    let wrong = || Refusal::at(section, format!("{section} is not a section of a scene"));
    let table = section_of(document, section).ok_or_else(wrong)?;
    let Some(value) = value else {
        table.remove(key);
        // A second surface without keys is none.
        if let Some((outer, inner)) = section.split_once('.').filter(|_| table.is_empty()) {
            section_of(document, outer).map(|table| table.remove(inner));
        }
        return Ok(());
    };
    let mut value = value.parse().unwrap_or_else(|_| Value::from(value));
    match table.get_mut(key) {
        Some(item) => {
            // Comments above the key stay; the one behind it describes the old value.
            if let Some(old) = item.as_value() {
                *value.decor_mut() = old.decor().clone();
                let suffix = old.decor().suffix().and_then(toml_edit::RawString::as_str);
                let has_comment = suffix.is_some_and(|suffix| suffix.contains('#'));
                if has_comment && plain(old) != plain(&value) {
                    value.decor_mut().set_suffix("");
                }
            }
            *item = Item::Value(value);
        }
        None => _ = table.insert(key, Item::Value(value)),
    }
    Ok(())
}

/// The table of a section such as `body[2]`; made, where it can be the next one. The comment behind
/// the head of a body describes it as it was, and goes.
fn section_of<'d>(document: &'d mut DocumentMut, section: &str) -> Option<&'d mut dyn TableLike> {
    let Some((name, number)) = section.split_once('[') else {
        return match section {
            "" => Some(document.as_table_mut()),
            name if name.contains('.') => {
                let (outer, inner) = name.split_once('.')?;
                let table = document.entry(outer).or_insert_with(toml_edit::table);
                let table = table.as_table_like_mut()?.entry(inner);
                let none = || Item::Value(toml_edit::InlineTable::new().into());
                table.or_insert_with(none).as_table_like_mut()
            }
            name => document.entry(name).or_insert_with(toml_edit::table).as_table_like_mut(),
        };
    };
    let none = || Item::ArrayOfTables(ArrayOfTables::new());
    let tables = document.entry(name).or_insert_with(none).as_array_of_tables_mut()?;
    let k = number.trim_end_matches(']').parse::<usize>().ok()?.checked_sub(1)?;
    if k == tables.len() {
        tables.push(Table::new());
    }
    let table = tables.get_mut(k)?;
    table.decor_mut().set_suffix("");
    Some(table)
}

/// The numbers that a body with another material has: none or, without a material, the numbers of
/// the old one.
fn numbers_of_material(change: &Change, known: &BTreeMap<String, String>) -> Vec<Change> {
    let Some(body) = change.path.strip_suffix(".material") else { return vec![] };
    let is_own = change.value.as_ref().is_none_or(String::is_empty);
    let old = materials().iter().find(|old| Some(&old.id) == known.get(&change.path));
    let number = |field: &asperity_scene::Field<asperity::Body>| {
        let value = old.filter(|_| is_own).and_then(|old| (field.get)(&old.body));
        let (path, value) = (format!("{body}.{}", field.name), value.map(|x| format!("{x:e}")));
        Change { path, value }
    };
    BODY.iter().map(number).collect()
}

/// Of curved bodies, or of flat ones again, after a change of this path: bodies have a curvature or
/// a nominal area.
fn bend(document: &mut DocumentMut, path: &str) {
    if !path.starts_with("curvature.") {
        return;
    }
    let radii = document.get("curvature").and_then(Item::as_table_like);
    if radii.is_some_and(|radii| !radii.is_empty()) {
        document.remove("nominal_area");
    } else {
        document.remove("curvature");
        document.insert("nominal_area", toml_edit::value("1 cm2"));
    }
}

/// Takes the second body away, or brings it back, alike the first.
fn set_rigid(document: &mut DocumentMut, rigid: bool) -> Result<(), Refusal> {
    let bodies = document.get_mut("body").and_then(Item::as_array_of_tables_mut);
    let bodies = bodies.ok_or_else(|| Refusal::new("the scene has no [[body]]"))?;
    if rigid {
        if bodies.len() > 1 {
            bodies.remove(1);
        }
        document["rigid_counterface"] = toml_edit::value(true);
    } else {
        if let (1, Some(first)) = (bodies.len(), bodies.get(0).cloned()) {
            bodies.push(first);
        }
        document.remove("rigid_counterface");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn change(path: &str, value: Option<&str>) -> Change {
        Change { path: path.into(), value: value.map(str::to_string) }
    }

    fn with_rigid(text: &str, rigid: bool) -> Result<String, Refusal> {
        edit(text, &[change("rigid_counterface", rigid.then_some("true"))])
    }

    fn with_material(text: &str, id: &str) -> String {
        edit(text, &[change("body[1].material", Some(id))]).unwrap()
    }

    const TEXT: &str = "nominal_area = 1e-4 # m^2\n\n[[body]] # steel\nhardness = \"7 GPa\" # hard\n\
                        \n[[body]]\nhardness = 2e9\n\n[surface]\nm0 = 1e-13\n";

    #[test]
    fn a_rigid_counterface_takes_the_second_body_if_there_is_one() {
        let rigid = with_rigid(TEXT, true).unwrap();
        assert_eq!(rigid.matches("[[body]]").count(), 1);
        assert_eq!(with_rigid(&rigid, true).unwrap(), rigid);
        assert_eq!(with_rigid(&rigid, false).unwrap().matches("[[body]]").count(), 2);
        assert!(rigid.contains("rigid_counterface = true") && !rigid.contains("2e9"), "{rigid}");
        let back = fields(&with_rigid(&rigid, false).unwrap());
        assert_eq!(back["body[2].hardness"], "7 GPa");
        assert!(!back.contains_key("rigid_counterface"));
    }

    #[test]
    fn values_are_found_by_path_and_changed_in_place() {
        let found = fields(TEXT);
        assert_eq!(found["body[1].hardness"], "7 GPa");
        assert_eq!((found["body[2].hardness"].as_str(), found.len()), ("2e9", 4));
        let changes = [
            change("body[1].hardness", Some("6 GPa")),
            change("surface.m0", Some("2e-13")),
            change("options.force", Some("vertical")),
            change("body[2].hardness", None),
            change("body[3].hardness", None),
        ];
        let edited = edit(TEXT, &changes).unwrap();
        let wanted = TEXT.replace("7 GPa", "6 GPa").replace("1e-13", "2e-13");
        let wanted = wanted.replace("hardness = 2e9\n", "").replace(" # hard", "");
        let wanted = wanted.replace(" # steel", "");
        assert_eq!(edited, format!("{wanted}\n[options]\nforce = \"vertical\"\n"));
    }

    #[test]
    fn bodies_are_curved_by_a_radius_and_flat_without_one() {
        let curved = edit(TEXT, &[change("curvature.radius", Some("10 mm"))]).unwrap();
        assert_eq!(fields(&curved)["curvature.radius"], "10 mm");
        assert!(!fields(&curved).contains_key("nominal_area"));
        let flat = fields(&edit(&curved, &[change("curvature.radius", None)]).unwrap());
        assert_eq!(flat["nominal_area"], "1 cm2");
        assert!(!flat.keys().any(|path| path.starts_with("curvature")));
    }

    #[test]
    fn comments_above_a_value_stay_and_one_behind_goes_with_its_value() {
        let text = "# as measured\nnominal_area = 1e-4 # m2\n";
        let edited = |value| edit(text, &[change("nominal_area", Some(value))]).unwrap();
        assert_eq!(edited("3 cm2"), "# as measured\nnominal_area = \"3 cm2\"\n");
        assert_eq!(edited("1e-4"), text);
    }

    #[test]
    fn a_material_becomes_own_values_with_all_its_numbers_and_back() {
        let text = with_material(TEXT, "copper-cold-worked");
        assert_eq!(fields(&text)["body[1].material"], "copper-cold-worked");
        let own = with_material(&text, "");
        let known = materials().iter().find(|known| known.id == "copper-cold-worked").unwrap();
        for number in asperity::Body::NUMBERS {
            let found = fields(&own).get(&format!("body[1].{}", number.name)).cloned();
            let found = found.and_then(|text| text.parse::<f64>().ok());
            assert_eq!(found, (number.get)(&known.body), "{}", number.name);
        }
        // Another material takes all of them away.
        let again = with_material(&own, "copper-cold-worked");
        assert_eq!(fields(&again), fields(&text));
    }

    #[test]
    fn the_files_of_a_text_are_found_wherever_they_are_named() {
        let text = "[surface]\nfile = \"a.x3p\"\n\
                    counterface = { file = \"c.sur\" }\nheights = { file = \"d.csv\" }\n";
        assert_eq!(files(text), ["a.x3p", "c.sur", "d.csv"]);
        assert!(files(TEXT).is_empty() && files("file = ").is_empty());
    }

    #[test]
    fn a_text_of_a_value_is_never_markup_of_the_file() {
        let sly = "1\nm2 = 7";
        let edited = edit(TEXT, &[change("surface.m0", Some(sly))]).unwrap();
        assert_eq!(fields(&edited)["surface.m0"], sly);
        assert!(edit("a = = 2", &[change("a", Some("1"))]).is_err());
        assert!(edit(TEXT, &[change("body[9].hardness", Some("1"))]).is_err());
        assert!(edit(TEXT, &[change("nominal_area.b", Some("1"))]).is_err());
    }
}
