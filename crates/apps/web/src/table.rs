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
    let format = form.parse();
    let format = format.map_err(|_| Refusal::new(format!("{form:?} is no form of a table")))?;
    let units: UnitSystem = units.parse().map_err(Refusal::new)?;
    let (model, span) = (file.model(id)?, Span::of(file));
    let ends = [0.2, 1.0].map(|position| At::Pressure(span.pressure(position)));
    let subject = Subject { file, name: "", model: &model, tolerance: Tolerance::default() };
    let nodes = Nodes::Range { ends, count: 2, log: false, max_error: Some(ERROR) };
    let export = Export { subject, nodes, format, units, conductance: false };
    let text = export.answer(&mut Sheet::default(), &Silent).map_err(Refusal::new)?.text;
    let extension = if format == TableFormat::Csv { "csv" } else { "inp" };
    // Of ranges, tables are in the middle.
    let place = if file.unknowns().is_empty() { "" } else { "-middle" };
    Ok(json!({ "name": format!("{id}-{form}{place}.{extension}"), "text": text }))
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
    fn a_table_of_ranges_is_named_after_their_middle() {
        let text = "nominal_area = 1e-4\n[interface]\nequivalent_modulus = 115e9\n\
            poissons_ratio = 0.3\nhardness = 2e9\n[surface]\nra = 8e-7\nfinish = \"ground\"\n";
        let file = asperity_scene::parse(text, std::path::Path::new(".")).unwrap();
        assert_eq!(table(&file, "ke", "csv", "SI").unwrap()["name"], "ke-csv-middle.csv");
        assert!(table(&file, "persson-fudge", "calculix", "SI").is_err());
    }
}
