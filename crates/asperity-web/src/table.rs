//! Tables of the page for finite-element programs.

use asperity::{At, Tolerance};
use asperity_answer::{Export, Sheet, Silent, Subject, TableFormat, UnitSystem};
use asperity_inputs::SceneFile;
use serde_json::{Value, json};

use crate::refusal::Refusal;
use crate::span::Span;

/// Largest error of interpolation in a table, and larger ones for programs that take few nodes.
const ERROR: f64 = 0.01;
const LARGER: [f64; 3] = [0.03, 0.1, 0.3];

/// The table of a model over the range of the slider for a finite-element program, as a file.
pub(crate) fn table(file: &SceneFile, id: &str, form: &str, units: &str) -> Result<Value, Refusal> {
    let refused = |_| Refusal::new(format!("{form:?} is no form of a table"));
    let format: TableFormat = form.parse().map_err(refused)?;
    let extension = match format {
        TableFormat::Csv => "csv",
        TableFormat::Ansys => "mac",
        _ => "inp",
    };
    let units: UnitSystem = units.parse().map_err(Refusal::new)?;
    let (model, span) = (file.model(id)?, Span::of(&file.scene));
    let ends = [0.2, 1.0].map(|position| At::Pressure(span.pressure(position)));
    let subject =
        Subject { file, name: "", id: "", model: &model, tolerance: Tolerance::default() };
    let within = |error| {
        let (nodes, max_error, conductance, friction) = (2, Some(error), None, None);
        Export { subject, ends, nodes, log: false, max_error, format, units, conductance, friction }
            .answer(&mut Sheet::default(), &Silent)
    };
    let found =
        LARGER.into_iter().fold(within(ERROR), |found, larger| found.or_else(|_| within(larger)));
    let text = found.map_err(Refusal::new)?.text;
    Ok(json!({ "name": format!("{id}-{form}.{extension}"), "text": text }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_name_their_model() {
        let text = asperity_inputs::template();
        let file = asperity_inputs::parse(text, std::path::Path::new(".")).unwrap();
        for (form, word) in
            [("csv", "pressure"), ("abaqus", "*"), ("calculix", "*"), ("ansys", "R")]
        {
            let found = table(&file, "ke", form, "mm-N-MPa").unwrap();
            assert!(found["text"].as_str().unwrap().contains(word), "{found}");
            assert!(found["name"].as_str().unwrap().starts_with("ke-"), "{found}");
        }
        assert!(table(&file, "ke", "nastran", "SI").is_err());
        assert!(table(&file, "ke", "csv", "furlong").is_err());
    }
}
