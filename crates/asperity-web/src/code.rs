//! The calculation of the page as lines for a shell, Python and Rust, and as tables.

use asperity::{At, Quantity, Tolerance};
use asperity_answer::{Export, Sheet, Silent, Subject, TableFormat, UnitSystem};
use asperity_inputs::SceneFile;
use serde_json::{Value, json};

use crate::answer::quantities;
use crate::refusal::Refusal;
use crate::span::{Load, Span};

/// Largest error of interpolation in a table.
const TABLE_ERROR: f64 = 0.01;

/// Lines that give the digits of the page: the same models at the same load.
pub(crate) fn code(file: &SceneFile, ids: &[String], load: &Load) -> Value {
    let quantities = quantities(file);
    let names: Vec<String> = quantities.iter().map(Quantity::to_string).collect();
    let variants: Vec<String> = quantities.iter().map(|q| format!("Quantity::{q:?}")).collect();
    let (place, at, number) = match load.at {
        At::Pressure(_) => ("pressure", "Pressure", load.pascals),
        _ => ("load", "Load", load.newtons),
    };
    // The capitals of the templates.
    let words = [
        ("IDS", ids.join(",")),
        ("LIST", format!("{ids:?}")),
        ("NAMES", names.join(",")),
        ("QUANTITIES", format!("{names:?}")),
        ("VARIANTS", variants.join(",\n        ")),
        ("PLACE", place.into()),
        ("AT", at.into()),
        ("NUMBER", format!("{number:?}")),
    ];
    let lines = |template: &str| {
        let put = |text: String, (word, given): &(&str, String)| text.replace(word, given);
        words.iter().fold(template.to_string(), put)
    };
    json!({
        "shell": lines(include_str!("code/shell.txt")),
        "python": lines(include_str!("code/python.txt")),
        "rust": lines(include_str!("code/rust.txt")),
    })
}

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
    let mut found = within(TABLE_ERROR);
    // COMBIN39 takes few nodes.
    for error in [0.03, 0.1, 0.3] {
        if form == "ansys" && found.is_err() {
            found = within(error);
        }
    }
    let text = found.map_err(Refusal::new)?.text;
    Ok(json!({ "name": format!("{id}-{form}.{extension}"), "text": text }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::LoadKeys;

    #[test]
    fn tables_and_lines_name_model_and_load() {
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
        let keys = LoadKeys { text: "1.5 kN".into(), ..Default::default() };
        let load = Load::of(&keys, &file.scene).unwrap();
        let code = code(&file, &["ke".into(), "jg".into()], &load);
        let text = |language: &str| code[language].as_str().unwrap().to_string();
        assert!(text("shell").contains("--model ke,jg --load 1500.0"), "{code}");
        assert!(text("python").contains("load=1500.0"), "{code}");
        assert!(text("python").contains("for name in [\"ke\", \"jg\"]:"), "{code}");
        assert!(text("python").contains("for quantity in [\"area-fraction\", "), "{code}");
    }
}
