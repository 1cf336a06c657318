//! Values of models at loads, as `asperity curve` prints them.

use asperity::{
    At, Check, ContactError, Described, Evaluation, Findings, Quantity, Request, SeparationUnit,
    shortest_digits,
};
use asperity_answer::{Asked, Line};
use asperity_inputs::SceneFile;
use serde_json::{Value, json};

use crate::dialect::{PAGE, said};
use crate::refusal::Refusal;
use crate::shown::shown;
use crate::span::Span;

/// The separation beside the quantities of a view.
pub(crate) const SEPARATION: &str = "separation";

/// The quantities that every scene has.
const USUAL: [Quantity; 6] = [
    Quantity::AreaFraction,
    Quantity::Tangent,
    Quantity::UnloadingStiffness,
    Quantity::TangentialStiffness,
    Quantity::MeanPressure,
    Quantity::Contacts,
];

/// What the program adds where jkr pulls off.
const OPENING: &str = "; jkr-separation, which describes opening, may carry more";

/// The quantities of a scene: conductances where the bodies have the property.
pub(crate) fn quantities(file: &SceneFile) -> Vec<Quantity> {
    let interface = &file.scene.interface;
    let thermal = interface.thermal_conductivity.map(|_| Quantity::ThermalConductance);
    let electrical = interface.electrical_resistivity.map(|_| Quantity::ElectricalConductance);
    USUAL.into_iter().chain(thermal).chain(electrical).collect()
}

/// The columns of a scene with their units: the separation and the quantities.
pub(crate) fn columns(file: &SceneFile) -> impl Iterator<Item = (String, &'static str)> {
    let quantities = quantities(file).into_iter().map(|q| (q.to_string(), q.unit()));
    [(SEPARATION.to_string(), "m")].into_iter().chain(quantities)
}

/// The columns that can be drawn: the separation and the quantities; without a scene those that all
/// have.
pub(crate) fn views(file: Option<&SceneFile>) -> Vec<Value> {
    let from = file.map_or_else(Default::default, |file| file.separation_from);
    let separation = format!("Distance of the surfaces, from {from} to the other surface.");
    let view = |id: &str, label: &str, definition: &str| json!({ "id": id, "label": label, "definition": definition });
    let of = |q: Quantity| view(&q.to_string(), q.label(), q.definition());
    let quantities = file.map_or(USUAL.to_vec(), quantities).into_iter().map(of);
    [view(SEPARATION, SEPARATION, &separation)].into_iter().chain(quantities).collect()
}

/// The model of an id with all quantities of the scene that it has, ready for many loads.
pub(crate) fn compile(file: &SceneFile, id: &str) -> Result<Asked, Refusal> {
    let many = Span::of(&file.scene).pressures().into_iter().map(At::Pressure);
    let request = Request::new(quantities(file)).at(many);
    Ok(Asked::new(file, &file.model(id)?, &request, (false, true))?)
}

/// The values at one load, or the reason why there are none, with why no contact has them and
/// warnings about them.
pub(crate) fn row(
    file: &SceneFile,
    id: &str,
    asked: &Asked,
    at: At,
) -> Result<(Value, Findings), Refusal> {
    let (lines, warnings) = asked.lines(file, &[at]);
    let separation = || -> Result<f64, ContactError> {
        let found = asked.contact().separation(at)?;
        let scene = asked.contact().scene();
        Ok(found.measured_in(SeparationUnit::Metres, file.separation_from, scene)?.value)
    };
    let mut cells = vec![cell(SEPARATION, "m", separation().map_err(|e| e.marked()))];
    let values = lines.iter().flat_map(|line| &line.values);
    cells.extend(quantities(file).into_iter().zip(values).map(|(quantity, found)| {
        let value = found.as_ref().map(Evaluation::value).map_err(ContactError::marked);
        let mut cell = cell(&quantity.to_string(), quantity.unit(), value);
        if let Ok(value) = found {
            cell["bound"] = value.bound(quantity).into();
        }
        cell
    }));
    let (model, load) = (file.model(id)?, at.load(&file.scene).unwrap_or_default());
    let (is_tension, why) = (load < 0.0, cells[0]["shown"].as_str().unwrap_or_default());
    let is_empty = cells.iter().all(|cell| cell["digits"].is_null());
    let reason = is_empty.then(|| match id {
        _ if is_tension && !model.validity().adhesive => {
            let add = match file.scene.interface.work_of_adhesion {
                Some(_) => "",
                None => "add work_of_adhesion in the scene file and ",
            };
            let load = shown(load, "N");
            format!("load is {load}: models without adhesion carry no tension; {add}choose dmt, jkr or jkr-separation")
        }
        "jkr" if is_tension => format!("{why}{OPENING}"),
        _ => why.into(),
    });
    // Values may be impossible because of an implausible input.
    let valid = || !file.findings().are_implausible();
    let area = lines.first().and_then(|line| line.values.first()?.as_ref().ok());
    let mark = at.pressure(&file.scene).zip(area).and_then(|(pressure, area)| {
        Check::impossible(&model, &file.scene, pressure, area.value()).filter(|_| valid())
    });
    let mark = mark.map(|found| found.say(&PAGE));
    let row = json!({ "model": id, "cells": cells, "reason": reason, "mark": mark });
    Ok((row, warnings.into_iter().collect()))
}

/// The rows at pressures, as a csv without its head; blank where there is no value.
pub(crate) fn rows(file: &SceneFile, id: &str, asked: &Asked, pressures: &[f64]) -> String {
    let places: Vec<At> = pressures.iter().map(|pressure| At::Pressure(*pressure)).collect();
    let digits = |number: Option<f64>| {
        number.filter(|n| n.is_finite()).map_or(String::new(), shortest_digits)
    };
    let row = |line: &Line| {
        let (at, scene) = (line.given, &file.scene);
        let given = [at.load(scene), at.pressure(scene), line.separation[1]];
        let values = line.values.iter().map(|found| Some(found.as_ref().ok()?.value()));
        let cells: Vec<String> = given.into_iter().chain(values).map(digits).collect();
        format!("{id},{}\n", cells.join(","))
    };
    asked.lines(file, &places).0.iter().map(row).collect()
}

/// The head of [`rows`].
pub(crate) fn head(file: &SceneFile) -> String {
    let quantities = quantities(file).into_iter().map(Quantity::column).collect::<Vec<_>>();
    format!("model,load_N,pressure_Pa,separation_m,{}", quantities.join(","))
}

/// A value of a quantity as shown with all its digits in SI units, or the reason why there is none.
pub(crate) fn cell(quantity: &str, unit: &str, found: Result<f64, String>) -> Value {
    match found {
        Ok(value) => json!({
            "quantity": quantity, "digits": shortest_digits(value), "shown": shown(value, unit),
        }),
        Err(reason) => json!({ "quantity": quantity, "shown": said(&reason) }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file() -> SceneFile {
        asperity_inputs::parse(asperity_inputs::template(), std::path::Path::new(".")).unwrap()
    }

    fn of(file: &SceneFile, id: &str, asked: &Asked, at: At) -> Value {
        row(file, id, asked, at).unwrap().0
    }

    fn alone(file: &SceneFile, id: &str, at: At) -> Value {
        of(file, id, &compile(file, id).unwrap(), at)
    }

    #[test]
    fn a_load_that_a_model_refuses_has_its_reason() {
        let file = file();
        let ke = compile(&file, "ke").unwrap();
        let reason = |load: f64| {
            of(&file, "ke", &ke, At::Load(load))["reason"].as_str().unwrap().to_string()
        };
        let tension = reason(-5.0);
        let wanted = "load is -5 N: models without adhesion carry no tension; add work_of_adhesion in the scene file and choose dmt, jkr or jkr-separation";
        assert_eq!(tension, wanted);
        let heavy = reason(1e30);
        assert!(heavy.contains("largest force of the model"), "{heavy}");
        let significant_digits = |number: &str| {
            let mantissa = number.split('e').next().unwrap_or_default();
            mantissa.trim_matches('0').chars().filter(char::is_ascii_digit).count()
        };
        assert!(heavy.split(' ').all(|part| significant_digits(part) <= 5), "{heavy}");
        assert_eq!(of(&file, "ke", &ke, At::Load(100.0))["reason"], Value::Null);
    }

    #[test]
    fn models_with_adhesion_refuse_a_tension_where_the_surfaces_pull_off() {
        let text = include_str!("../../asperity-inputs/examples/elastomer-on-glass.toml");
        let text = text.replace("rigid_", "work_of_adhesion = 0.05\nrigid_");
        let file = asperity_inputs::parse(&text, std::path::Path::new(".")).unwrap();
        let gw = alone(&file, "gw", At::Load(-1.0));
        assert!(
            gw["reason"]
                .as_str()
                .unwrap()
                .ends_with("carry no tension; choose dmt, jkr or jkr-separation")
        );
        for id in ["dmt", "jkr"] {
            let row = alone(&file, id, At::Load(-1.0));
            let reason = row["reason"].as_str().unwrap().to_string();
            assert!(reason.starts_with("load is -1.0 N: the surfaces pull off at -0."), "{reason}");
            assert_eq!(reason.contains("; jkr-separation, which describes opening"), id == "jkr");
        }
    }

    #[test]
    fn rows_and_curves_are_the_answers_of_the_library() {
        let file = file();
        let ke = compile(&file, "ke").unwrap();
        let row = of(&file, "ke", &ke, At::Pressure(1e6));
        let request = Request::new(quantities(&file)).at([At::Pressure(1e6)]);
        let response = file.model("ke").unwrap().solve(&file.scene, &request).unwrap();
        for cell in &row["cells"].as_array().unwrap()[1..] {
            let quantity: Quantity = cell["quantity"].as_str().unwrap().parse().unwrap();
            let wanted = response.values(quantity).unwrap()[0];
            let found: f64 = cell["digits"].as_str().unwrap().parse().unwrap();
            assert!((found / wanted - 1.0).abs() < 1e-13, "{quantity}: {found} {wanted}");
            assert!(cell["bound"].as_f64().unwrap() < 1e-9);
        }
        let csv = rows(&file, "ke", &ke, &[1e6, 2e6]);
        let first: Vec<&str> = csv.lines().next().unwrap().split(',').collect();
        assert_eq!(first.len(), head(&file).split(',').count());
        let area = head(&file).split(',').position(|name| name == "area_fraction").unwrap();
        // Several loads are evaluated together.
        let [one, many] = [first[area], row["cells"][1]["digits"].as_str().unwrap()]
            .map(|digits| digits.parse::<f64>().unwrap());
        assert!((one / many - 1.0).abs() < 1e-13, "{one} {many}");
    }

    #[test]
    fn a_model_without_a_quantity_has_the_others_and_the_reason() {
        let file = file();
        let gao = compile(&file, "gao").unwrap();
        let row = of(&file, "gao", &gao, At::Load(100.0));
        let found = |name: &str| {
            row["cells"].as_array().unwrap().iter().find(|cell| cell["quantity"] == name).unwrap()
        };
        assert!(found("area-fraction")["digits"].is_string());
        let unloading = found("unloading-stiffness");
        assert!(unloading["digits"].is_null() && unloading["shown"].is_string());
        assert!(compile(&file, "dmt").is_err());
    }

    fn marks(text: &str, id: &str, at: At) -> Option<String> {
        let file = asperity_inputs::parse(text, std::path::Path::new(".")).unwrap();
        alone(&file, id, at)["mark"].as_str().map(String::from)
    }

    #[test]
    fn a_load_beyond_full_contact_has_a_mark_and_a_usual_one_none() {
        let text = asperity_inputs::template();
        let found = marks(text, "persson-fudge", At::Load(1e30)).unwrap();
        assert!(found.contains("nominal area is 1e34 Pa, above the hardness (2e9 Pa)"), "{found}");
        for id in ["gw", "ke", "persson-fudge"] {
            assert_eq!(marks(text, id, At::Load(100.0)), None);
        }
    }

    #[test]
    fn more_area_than_there_is_has_a_mark() {
        let text = include_str!("../../asperity-inputs/examples/elastomer-on-glass.toml");
        let found = marks(text, "gw", At::Pressure(1.5e6)).unwrap();
        assert!(found.contains("gw: the real area is 2.804 times the nominal area"), "{found}");
        let heavy = marks(text, "persson", At::Pressure(1e7)).unwrap();
        assert!(heavy.contains("above the equivalent modulus (2.667e6 Pa)"), "{heavy}");
        assert_eq!(marks(text, "gw", At::Pressure(1e4)), None);
    }

    #[test]
    fn a_load_is_not_blamed_for_a_wrong_unit_of_a_field() {
        let text = asperity_inputs::template().replacen("210e9", "210", 1);
        assert_eq!(marks(&text, "gw", At::Load(100.0)), None);
    }
}
