//! Tables of the page for finite-element programs.

use asperity::{At, Tolerance};
use asperity_answer::{Export, Nodes, Sheet, Silent, Subject, TableFormat, UnitSystem};
use asperity_scene::SceneFile;
use serde_json::{Value, json};

use crate::refusal::Refusal;
use crate::span::Span;

/// Largest relative error of interpolation in a table.
const ERROR: f64 = 0.01;

/// The table of a model over the range of the slider for a finite-element program, as a file.
pub(crate) fn table(file: &SceneFile, id: &str, form: &str, units: &str) -> Result<Value, Refusal> {
    let (format, units) = (format(form)?, units.parse().map_err(Refusal::new)?);
    let extension = match format {
        TableFormat::Csv => "csv",
        _ => "inp",
    };
    // Of ranges, tables are in the middle.
    let place = if file.unknowns().is_empty() { "" } else { "-middle" };
    let name = format!("{id}-{form}{place}.{extension}");
    Ok(json!({ "name": name, "text": text(file, id, format, units)? }))
}

/// Why models have no table in a form, by id; nothing for those that have one.
pub(crate) fn refusals(file: &SceneFile, ids: &[String], form: &str) -> Result<Value, Refusal> {
    let format = format(form)?;
    let why = |id: &String| {
        let refused = text(file, id, format, UnitSystem::default()).err();
        (id.clone(), json!(refused.map(|refused| refused.message)))
    };
    Ok(ids.iter().map(why).collect())
}

fn format(form: &str) -> Result<TableFormat, Refusal> {
    form.parse().map_err(|_| Refusal::new(format!("{form:?} is no form of a table")))
}

fn text(
    file: &SceneFile,
    id: &str,
    format: TableFormat,
    units: UnitSystem,
) -> Result<String, Refusal> {
    let (model, span) = (file.model(id)?, Span::of(file));
    let ends = [0.2, 1.0].map(|position| At::Pressure(span.pressure(position)));
    let subject =
        Subject { file, name: "", id: "", model: &model, tolerance: Tolerance::default() };
    let (max_error, conductance, friction) = (Some(ERROR), None, None);
    let nodes = Nodes::Range { ends, count: 2, log: false, max_error };
    let export = Export { subject, nodes, format, units, conductance, friction };
    Ok(export.answer(&mut Sheet::default(), &Silent).map_err(Refusal::new)?.text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_name_their_model() {
        let text = asperity_scene::template();
        let file = asperity_scene::parse(text, std::path::Path::new(".")).unwrap();
        for (form, word) in [("csv", "pressure"), ("abaqus", "*"), ("calculix", "*")] {
            let found = table(&file, "ke", form, "mm-N-MPa").unwrap();
            assert!(found["text"].as_str().unwrap().contains(word), "{found}");
            assert!(found["name"].as_str().unwrap().starts_with("ke-"), "{found}");
        }
        assert!(table(&file, "ke", "nastran", "SI").is_err());
        assert!(table(&file, "ke", "csv", "furlong").is_err());
    }

    #[test]
    fn models_without_a_table_are_known_before_one_is_asked_for() {
        let file = |text: &str| asperity_scene::parse(text, std::path::Path::new(".")).unwrap();
        let ranges = "nominal_area = 1e-4\n[interface]\nequivalent_modulus = 115e9\n\
            poissons_ratio = 0.3\nhardness = 2e9\n[surface]\nra = 8e-7\nfinish = \"ground\"\n";
        let ids = ["ke", "gw", "persson-fudge", "af", "dmt"].map(String::from);
        for text in [asperity_scene::template(), ranges] {
            let file = file(text);
            for form in ["csv", "calculix"] {
                let found = refusals(&file, &ids, form).unwrap();
                for id in &ids {
                    let made = table(&file, id, form, "SI");
                    assert_eq!(found[id].is_null(), made.is_ok(), "{id} {form}: {found}");
                }
                assert!(found["ke"].is_null(), "{form}: {found}");
                let name = table(&file, "ke", form, "SI").unwrap()["name"].to_string();
                assert_eq!(name.contains("-middle"), text == ranges, "{name}");
            }
        }
    }
}
