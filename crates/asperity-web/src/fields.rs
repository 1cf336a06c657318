//! Values of a scene's text by their path, and texts with other values. Order stays, and so do
//! comments but those about a value or a body that became another.

use std::collections::BTreeMap;

use asperity::Body;
use asperity_inputs::{BODY, Field, materials};
use toml_edit::{ArrayOfTables, DocumentMut, Formatted, Item, Table, TableLike, Value};

use crate::message::Change;
use crate::refusal::Refusal;

/// How the description of a changed example begins.
const CHANGED: &str = "Changed from:";

/// The values of all keys as typed: texts without their quotes.
pub(crate) fn fields(text: &str) -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    if let Ok(document) = text.parse::<DocumentMut>() {
        of_table(document.as_table(), "", &mut found);
    }
    found
}

fn of_table(table: &dyn TableLike, path: &str, found: &mut BTreeMap<String, String>) {
    for (key, item) in table.iter() {
        let path = if path.is_empty() { key.to_string() } else { format!("{path}.{key}") };
        match item {
            Item::Value(Value::String(text)) => _ = found.insert(path, text.value().clone()),
            Item::Value(value) => {
                let value = value.clone().decorated("", "");
                found.insert(path, value.to_string());
            }
            Item::Table(table) => of_table(table, &path, found),
            Item::ArrayOfTables(tables) => {
                for (k, table) in tables.iter().enumerate() {
                    of_table(table, &format!("{path}[{}]", k + 1), found);
                }
            }
            Item::None => {}
        }
    }
}

/// The names of all files of a text, each once.
pub(crate) fn files(text: &str) -> Vec<String> {
    fn walk(table: &dyn TableLike, found: &mut Vec<String>) {
        for (key, item) in table.iter() {
            if let Some(tables) = item.as_array_of_tables() {
                tables.iter().for_each(|table| walk(table, found));
            } else if let Some(table) = item.as_table_like() {
                walk(table, found);
            }
            let one = item.as_str().filter(|_| key == "file");
            let several = item.as_array().filter(|_| key == "files");
            let several = several.into_iter().flatten().filter_map(Value::as_str);
            for name in one.into_iter().chain(several) {
                if !found.iter().any(|known| known == name) {
                    found.push(name.into());
                }
            }
        }
    }
    let mut found = vec![];
    if let Ok(document) = text.parse::<DocumentMut>() {
        walk(document.as_table(), &mut found);
    }
    found
}

/// The text with other values. A value that reads as TOML is written as it is, any other as text.
pub(crate) fn edit(text: &str, changes: &[Change]) -> Result<String, Refusal> {
    let mut document = parsed(text)?;
    for Change { path, value } in changes {
        let (section, key) = path.rsplit_once('.').unwrap_or(("", path));
        let Some(table) = section_of(&mut document, section, value.is_some())? else { continue };
        match value.as_deref().map(str::trim).filter(|value| !value.is_empty()) {
            None => _ = table.remove(key),
            Some(value) => {
                let mut value = as_value(value);
                // Comments above the key stay; the one behind it describes the old value.
                match table.get_mut(key) {
                    Some(item) => {
                        if let Some(old) = item.as_value() {
                            let plain = |value: &Value| value.clone().decorated("", "").to_string();
                            let same = plain(old) == plain(&value);
                            *value.decor_mut() = old.decor().clone();
                            if !same {
                                value.decor_mut().set_suffix("");
                            }
                        }
                        *item = Item::Value(value);
                    }
                    None => _ = table.insert(key, Item::Value(value)),
                }
            }
        }
        without_remark(&mut document, section);
    }
    Ok(document.to_string())
}

/// Removes the comment behind the head of a body, which describes it as it was.
fn without_remark(document: &mut DocumentMut, section: &str) {
    let number = section.strip_prefix("body[").and_then(|rest| rest.strip_suffix(']'));
    let index = number.and_then(|number| number.parse::<usize>().ok()?.checked_sub(1));
    let bodies = document.get_mut("body").and_then(Item::as_array_of_tables_mut);
    if let Some(body) = index.zip(bodies).and_then(|(index, bodies)| bodies.get_mut(index)) {
        body.decor_mut().set_suffix("");
    }
}

/// The text of an example that was changed: the comment that begins it, which describes the
/// example, becomes its first sentence and says so.
pub(crate) fn changed(text: &str) -> String {
    let lines = text.lines().take_while(|line| line.starts_with('#'));
    let words: Vec<&str> = lines.clone().map(|line| line.trim_start_matches('#').trim()).collect();
    let words = words.join(" ");
    if words.is_empty() || words.starts_with(CHANGED) {
        return text.into();
    }
    let first = words.split_once(". ").map_or(words.trim_end_matches('.'), |(first, _)| first);
    let rest: String = text.split_inclusive('\n').skip(lines.count()).collect();
    format!("# {CHANGED} {first}.\n{rest}")
}

/// The changes that give a body a material or, without an id, the numbers of its material.
pub(crate) fn material(text: &str, body: usize, id: &str) -> Vec<Change> {
    let path = |name: &str| format!("body[{body}].{name}");
    let old = fields(text).remove(&path("material"));
    let old = materials().iter().find(|known| Some(&known.id) == old.as_ref());
    let old = old.filter(|_| id.is_empty()).map(|material| &material.body);
    if id.is_empty() && old.is_none() {
        return vec![];
    }
    let number = |field: &Field<Body>| {
        let value = old.and_then(field.get).map(|value| format!("{value:e}"));
        Change { path: path(field.name), value }
    };
    let id = (!id.is_empty()).then(|| id.to_string());
    // Of another material nothing stays.
    let named = Change { path: path("material"), value: id };
    [named].into_iter().chain(BODY.iter().map(number)).collect()
}

/// The text without the second body, or with it again, alike the first.
pub(crate) fn with_rigid(text: &str, rigid: bool) -> Result<String, Refusal> {
    let mut document = parsed(text)?;
    let bodies = document.get_mut("body").and_then(Item::as_array_of_tables_mut);
    let bodies = bodies.ok_or_else(|| Refusal::new("the scene has no [[body]]"))?;
    if rigid {
        if bodies.len() > 1 {
            bodies.remove(1);
        }
        document.insert("rigid_counterface", toml_edit::value(true));
    } else {
        if let (1, Some(first)) = (bodies.len(), bodies.get(0).cloned()) {
            bodies.push(first);
        }
        document.remove("rigid_counterface");
    }
    Ok(document.to_string())
}

fn parsed(text: &str) -> Result<DocumentMut, Refusal> {
    text.parse().map_err(|_| {
        let reason = "the scene file has a syntax error; correct the text first";
        Refusal::at("TOML", reason)
    })
}

fn as_value(text: &str) -> Value {
    text.parse().unwrap_or_else(|_| Value::String(Formatted::new(text.to_string())))
}

/// The table of a section, such as `body[2]`; made if asked for.
fn section_of<'d>(
    document: &'d mut DocumentMut,
    section: &str,
    make: bool,
) -> Result<Option<&'d mut dyn TableLike>, Refusal> {
    let wrong = || Refusal::at(section, format!("{section} is not a section of a scene"));
    if section.is_empty() {
        return Ok(Some(document.as_table_mut()));
    }
    if let Some((name, rest)) = section.split_once('[') {
        let number: usize = rest.trim_end_matches(']').parse().map_err(|_| wrong())?;
        if !document.contains_key(name) && make {
            document.insert(name, Item::ArrayOfTables(ArrayOfTables::new()));
        }
        let Some(tables) = document.get_mut(name).and_then(Item::as_array_of_tables_mut) else {
            return if make { Err(wrong()) } else { Ok(None) };
        };
        if number == tables.len() + 1 && make {
            tables.push(Table::new());
        }
        let table = number.checked_sub(1).and_then(|k| tables.get_mut(k));
        return match table {
            Some(table) => Ok(Some(table)),
            None if make => Err(wrong()),
            None => Ok(None),
        };
    }
    if !document.contains_key(section) && make {
        document.insert(section, Item::Table(Table::new()));
    }
    match document.get_mut(section) {
        None => Ok(None),
        Some(item) => item.as_table_like_mut().map(Some).ok_or_else(wrong),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn change(path: &str, value: Option<&str>) -> Change {
        Change { path: path.into(), value: value.map(str::to_string) }
    }

    const TEXT: &str = "nominal_area = 1e-4 # m^2\n\n[[body]] # steel\nhardness = \"7 GPa\" # hard\n\
                        \n[[body]]\nhardness = 2e9\n\n[surface]\nm0 = 1e-13\n";

    #[test]
    fn a_rigid_counterface_takes_the_second_body_if_there_is_one() {
        let rigid = with_rigid(TEXT, true).unwrap();
        assert_eq!(rigid.matches("[[body]]").count(), 1);
        assert_eq!(with_rigid(&rigid, true).unwrap(), rigid);
        assert_eq!(with_rigid(&rigid, false).unwrap().matches("[[body]]").count(), 2);
    }

    #[test]
    fn values_are_found_by_path_and_changed_in_place() {
        let found = fields(TEXT);
        assert_eq!(found["body[1].hardness"], "7 GPa");
        assert_eq!((found["body[2].hardness"].as_str(), found.len()), ("2e9", 4));
        let changes = [
            change("body[1].hardness", Some("6 GPa")),
            change("surface.m0", Some("2e-13")),
            change("options.jg_hardness", Some("cosine")),
            change("body[2].hardness", None),
            change("body[3].hardness", None),
        ];
        let edited = edit(TEXT, &changes).unwrap();
        let wanted = TEXT.replace("7 GPa", "6 GPa").replace("1e-13", "2e-13");
        let wanted = wanted.replace("hardness = 2e9\n", "").replace(" # hard", "");
        let wanted = wanted.replace(" # steel", "");
        assert_eq!(edited, format!("{wanted}\n[options]\njg_hardness = \"cosine\"\n"));
    }

    #[test]
    fn comments_above_a_value_stay_and_one_behind_goes_with_its_value() {
        let text = "# as measured\nnominal_area = 1e-4 # m2\n";
        let edited = |value| edit(text, &[change("nominal_area", Some(value))]).unwrap();
        assert_eq!(edited("3 cm2"), "# as measured\nnominal_area = \"3 cm2\"\n");
        assert_eq!(edited("1e-4"), text);
    }

    #[test]
    fn a_changed_example_says_so_once_and_is_not_described_any_more() {
        let text = include_str!("../../asperity-inputs/examples/wheel-rail.toml");
        let found = changed(text);
        let wanted = "# Changed from: A steel wheel on a steel rail, both run in.\n\n";
        assert!(found.starts_with(wanted) && !found.contains("asperity curve"), "{found}");
        assert_eq!(fields(&found), fields(text));
        assert_eq!(changed(&found), found);
        assert_eq!(changed(TEXT), TEXT);
    }

    #[test]
    fn a_material_becomes_own_values_with_all_its_numbers_and_back() {
        let text = edit(TEXT, &material(TEXT, 1, "copper-cold-worked")).unwrap();
        assert_eq!(fields(&text)["body[1].material"], "copper-cold-worked");
        let own = edit(&text, &material(&text, 1, "")).unwrap();
        let known = materials().iter().find(|known| known.id == "copper-cold-worked").unwrap();
        for (key, wanted) in [
            ("youngs_modulus", Some(known.body.youngs_modulus)),
            ("thermal_conductivity", known.body.thermal_conductivity),
            ("electrical_resistivity", known.body.electrical_resistivity),
        ] {
            let found = &fields(&own)[&format!("body[1].{key}")];
            assert_eq!(found.parse::<f64>().ok(), wanted, "{key}");
        }
        // Another material takes all of them away.
        let again = edit(&own, &material(&own, 1, "copper-cold-worked")).unwrap();
        assert_eq!(fields(&again), fields(&text));
        assert!(material(TEXT, 1, "").is_empty());
    }

    #[test]
    fn the_files_of_a_text_are_found_wherever_they_are_named() {
        let text = "[surface]\nfiles = [\"a.x3p\", \"b.x3p\"]\n\
                    counterface = { file = \"c.sur\" }\nheights = { file = \"d.csv\" }\n";
        assert_eq!(files(text), ["a.x3p", "b.x3p", "c.sur", "d.csv"]);
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

    #[test]
    fn the_counterface_is_rigid_and_back() {
        let rigid = with_rigid(TEXT, true).unwrap();
        assert!(rigid.contains("rigid_counterface = true") && !rigid.contains("2e9"), "{rigid}");
        let back = fields(&with_rigid(&rigid, false).unwrap());
        assert_eq!(back["body[2].hardness"], "7 GPa");
        assert!(!back.contains_key("rigid_counterface"));
    }
}
