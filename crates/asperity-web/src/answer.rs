//! Values of models at loads, as `asperity curve` prints them.

use std::collections::BTreeMap;

use asperity::{
    At, Contact, ContactError, ContactModel, Described, Evaluation, Finding, Model, Quantity,
    Request, Response, SeparationUnit, shortest_digits,
};
use asperity_inputs::SceneFile;

use crate::dialect::said;
use crate::message::{AnswerCell, AnswerRow, SEPARATION, View};
use crate::possible::impossible;
use crate::refusal::Refusal;
use crate::shown::shown;

/// The quantities that every scene has.
const USUAL: [Quantity; 6] = [
    Quantity::AreaFraction,
    Quantity::Tangent,
    Quantity::UnloadingStiffness,
    Quantity::TangentialStiffness,
    Quantity::MeanPressure,
    Quantity::Contacts,
];

/// The quantities of a scene: conductances where the bodies have the property.
pub(crate) fn quantities(file: &SceneFile) -> Vec<Quantity> {
    let interface = &file.scene.interface;
    let thermal = interface.thermal_conductivity.map(|_| Quantity::ThermalConductance);
    let electrical = interface.electrical_resistivity.map(|_| Quantity::ElectricalConductance);
    USUAL.into_iter().chain(thermal).chain(electrical).collect()
}

/// The separation and the quantities, as columns and views.
pub(crate) fn views(file: &SceneFile) -> Vec<View> {
    let quantities = quantities(file).into_iter().map(View::of);
    [View::separation(file.separation_from)].into_iter().chain(quantities).collect()
}

/// The columns of every scene.
pub(crate) fn usual_views() -> Vec<View> {
    let separation = View::separation(asperity::Datum::default());
    [separation].into_iter().chain(USUAL.map(View::of)).collect()
}

/// Why a model without adhesion refuses a tension.
fn no_tension(file: &SceneFile) -> String {
    let add = match file.scene.interface.work_of_adhesion {
        Some(_) => "",
        None => "add work_of_adhesion in the scene file and ",
    };
    format!("models without adhesion carry no tension; {add}choose dmt, jkr or jkr-separation")
}

/// What the program adds where jkr pulls off.
const OPENING: &str = "; jkr-separation, which describes opening, may carry more";

/// A model on a scene, ready for many loads.
pub(crate) struct Compiled {
    model: Model,
    contact: Box<dyn Contact>,
    /// Whether it describes adhesion, which carries tension.
    adhesive: bool,
    had: Vec<Quantity>,
    /// Why the model has no value of a quantity.
    refused: BTreeMap<Quantity, String>,
}

impl Compiled {
    /// The model of an id with all quantities of the scene that it has.
    pub(crate) fn new(file: &SceneFile, id: &str) -> Result<Self, Refusal> {
        let (model, scene) = (file.model(id)?, &file.scene);
        let compile = |quantities: &[Quantity]| {
            model.compile(scene, &Request::new(quantities.iter().copied()))
        };
        let all = quantities(file);
        let adhesive = model.validity().adhesive;
        let (mut had, mut refused) = (all.clone(), BTreeMap::new());
        let whole = match compile(&all) {
            Ok(contact) => return Ok(Self { model, contact, adhesive, had, refused }),
            Err(whole) => whole,
        };
        had.retain(|quantity| match compile(&[*quantity]) {
            Ok(_) => true,
            Err(reason) => {
                refused.insert(*quantity, reason.marked());
                false
            }
        });
        let contact = compile(if had.is_empty() { &[Quantity::Force] } else { &had });
        let contact = contact.map_err(|_: ContactError| whole)?;
        Ok(Self { model, contact, adhesive, had, refused })
    }

    fn respond(&self, at: &[At]) -> Response {
        let request = Request::new(self.had.iter().copied()).at(at.iter().copied());
        self.contact.respond(&request)
    }

    /// The separation in metres from the plane of the scene.
    fn separation(&self, file: &SceneFile, at: At) -> Result<f64, ContactError> {
        let separation = self.contact.separation(at)?;
        let metres = SeparationUnit::Metres;
        Ok(separation.measured_in(metres, file.separation_from, &file.scene)?.value)
    }

    /// The values at one load, with warnings about them.
    pub(crate) fn row(&self, file: &SceneFile, id: &str, at: At) -> (AnswerRow, Vec<Finding>) {
        let response = self.respond(&[at]);
        let separation = self.separation(file, at);
        let separation = cell(SEPARATION, "m", separation.map_err(|e| e.marked()), None);
        let value = |quantity: &Quantity| -> Result<Evaluation, String> {
            if let Some(reason) = self.refused.get(quantity) {
                return Err(reason.clone());
            }
            let column = response.column(*quantity).map_err(|error| error.marked())?;
            match column.rows.first() {
                Some(Ok(value)) => Ok(*value),
                Some(Err(reason)) => Err(reason.marked()),
                None => Err("no value".into()),
            }
        };
        let of = |quantity: Quantity| {
            let found = value(&quantity);
            let bound = found.as_ref().ok().map(|value| value.bound(quantity));
            cell(&quantity.to_string(), quantity.unit(), found.map(|value| value.value()), bound)
        };
        let cells: Vec<AnswerCell> =
            [separation].into_iter().chain(quantities(file).into_iter().map(of)).collect();
        let empty = cells.iter().all(|cell| cell.digits.is_none());
        let load = at.load(&file.scene).unwrap_or_default();
        let reason = empty.then(|| match load < 0.0 && !self.adhesive {
            true => format!("load is {}: {}", shown(load, "N"), no_tension(file)),
            false if load < 0.0 && id == "jkr" => format!("{}{OPENING}", cells[0].shown),
            false => cells[0].shown.clone(),
        });
        let area = value(&Quantity::AreaFraction).ok().map(|found| found.value());
        let mark = impossible(file, &self.model, at, area).filter(|_| !empty);
        let row = AnswerRow { model: id.into(), cells, reason, mark };
        (row, response.warnings)
    }

    /// The rows at pressures, as a csv without its head; blank where there is no value.
    pub(crate) fn rows(&self, file: &SceneFile, id: &str, pressures: &[f64]) -> String {
        let at: Vec<At> = pressures.iter().map(|pressure| At::Pressure(*pressure)).collect();
        let response = self.respond(&at);
        let all = quantities(file);
        let mut text = String::new();
        for (k, pressure) in pressures.iter().enumerate() {
            let load = pressure * file.scene.nominal_area;
            let given = [Some(load), Some(*pressure), self.separation(file, at[k]).ok()];
            let value = |quantity: &Quantity| {
                let column = response.column(*quantity).ok()?;
                column.rows.get(k)?.as_ref().ok().map(Evaluation::value)
            };
            let digits = |number: Option<f64>| {
                number.filter(|n| n.is_finite()).map_or(String::new(), shortest_digits)
            };
            let cells: Vec<String> =
                given.into_iter().chain(all.iter().map(value)).map(digits).collect();
            text += &format!("{id},{}\n", cells.join(","));
        }
        text
    }
}

/// The head of [`Compiled::rows`].
pub(crate) fn head(file: &SceneFile) -> Vec<String> {
    let given = ["model", "load_N", "pressure_Pa", "separation_m"].map(String::from);
    given.into_iter().chain(quantities(file).into_iter().map(Quantity::column)).collect()
}

/// A value of a quantity as shown, or the reason why there is none.
pub(crate) fn cell(
    quantity: &str,
    unit: &str,
    found: Result<f64, String>,
    bound: Option<f64>,
) -> AnswerCell {
    let quantity = quantity.to_string();
    match found {
        Ok(value) => {
            let digits = Some(shortest_digits(value));
            AnswerCell { quantity, digits, bound, shown: shown(value, unit) }
        }
        Err(reason) => AnswerCell { quantity, digits: None, bound: None, shown: said(&reason) },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file() -> SceneFile {
        asperity_inputs::parse(asperity_inputs::template(), std::path::Path::new(".")).unwrap()
    }

    #[test]
    fn a_load_that_a_model_refuses_has_its_reason() {
        let file = file();
        let ke = Compiled::new(&file, "ke").unwrap();
        let reason = |load: f64| ke.row(&file, "ke", At::Load(load)).0.reason.unwrap();
        let tension = reason(-5.0);
        let wanted = "load is -5 N: models without adhesion carry no tension; add work_of_adhesion in the scene file and choose dmt, jkr or jkr-separation";
        assert_eq!(tension, wanted);
        let heavy = reason(1e30);
        assert!(heavy.contains("largest force found"), "{heavy}");
        let significant_digits = |number: &str| {
            let mantissa = number.split('e').next().unwrap_or_default();
            mantissa.trim_matches('0').chars().filter(char::is_ascii_digit).count()
        };
        assert!(heavy.split(' ').all(|part| significant_digits(part) <= 5), "{heavy}");
        assert_eq!(ke.row(&file, "ke", At::Load(100.0)).0.reason, None);
    }

    #[test]
    fn models_with_adhesion_refuse_a_tension_where_the_surfaces_pull_off() {
        let text = include_str!("../../asperity-inputs/examples/elastomer-on-glass.toml");
        let text = text.replace("rigid_", "work_of_adhesion = 0.05\nrigid_");
        let file = asperity_inputs::parse(&text, std::path::Path::new(".")).unwrap();
        let gw = Compiled::new(&file, "gw").unwrap().row(&file, "gw", At::Load(-1.0)).0;
        assert!(
            gw.reason.unwrap().ends_with("carry no tension; choose dmt, jkr or jkr-separation")
        );
        for id in ["dmt", "jkr"] {
            let row = Compiled::new(&file, id).unwrap().row(&file, id, At::Load(-1.0)).0;
            let reason = row.reason.unwrap();
            assert!(reason.starts_with("load is -1.0 N: the surfaces pull off at -0."), "{reason}");
            assert_eq!(reason.contains("; jkr-separation, which describes opening"), id == "jkr");
        }
    }

    #[test]
    fn rows_and_curves_are_the_answers_of_the_library() {
        let file = file();
        let ke = Compiled::new(&file, "ke").unwrap();
        let (row, _) = ke.row(&file, "ke", At::Pressure(1e6));
        let request = Request::new(quantities(&file)).at([At::Pressure(1e6)]);
        let response = file.model("ke").unwrap().solve(&file.scene, &request).unwrap();
        for cell in &row.cells[1..] {
            let quantity: Quantity = cell.quantity.parse().unwrap();
            let wanted = response.values(quantity).unwrap()[0];
            let found: f64 = cell.digits.as_deref().unwrap().parse().unwrap();
            assert!((found / wanted - 1.0).abs() < 1e-13, "{quantity}: {found} {wanted}");
            assert!(cell.bound.unwrap() < 1e-9);
        }
        let rows = ke.rows(&file, "ke", &[1e6, 2e6]);
        let first: Vec<&str> = rows.lines().next().unwrap().split(',').collect();
        assert_eq!(first.len(), head(&file).len());
        let area = head(&file).iter().position(|name| name == "area_fraction").unwrap();
        // Several loads are evaluated together.
        let [one, many] = [first[area], row.cells[1].digits.as_deref().unwrap()]
            .map(|digits| digits.parse::<f64>().unwrap());
        assert!((one / many - 1.0).abs() < 1e-13, "{one} {many}");
    }

    #[test]
    fn a_model_without_a_quantity_has_the_others_and_the_reason() {
        let file = file();
        let gao = Compiled::new(&file, "gao").unwrap();
        let (row, _) = gao.row(&file, "gao", At::Load(100.0));
        let of = |name: &str| row.cells.iter().find(|cell| cell.quantity == name).unwrap();
        assert!(of("area-fraction").digits.is_some());
        let unloading = of("unloading-stiffness");
        assert!(unloading.digits.is_none() && !unloading.shown.is_empty());
        assert!(Compiled::new(&file, "dmt").is_err());
    }
}
