//! Every row of `reference/models.csv`: 40-digit values for GW..AF, three independent
//! implementations that agree to 5e-13 for Gao and AT.

use asperity::{
    AminiTehrani, ContactModel, Displacement, ForceComponent, Gao, LateralOptions, Model, Quantity,
    Reading, Request, Tolerance,
};

use crate::scenes;

/// A model of this id with these options of the lateral models.
pub fn lateral(id: &str, options: LateralOptions) -> Model {
    let at = |reading| Model::new(AminiTehrani { reading, options });
    match id {
        "gao" => Model::new(Gao { options }),
        "at" => at(Reading::Printed),
        "at-additive" => at(Reading::Additive),
        "at-overlap" => at(Reading::Overlap),
        _ => panic!("{id} has no lateral options"),
    }
}

/// The model and quantity that a row's words stand for.
fn row(model: &str, quantity: &str) -> (Model, Quantity) {
    let mut options = LateralOptions::default();
    let quantity = match quantity {
        "vertical-force" => {
            options.force = ForceComponent::Vertical;
            Quantity::Force
        }
        "force-no-tangential" | "stiffness-no-tangential" => {
            options.displacement = Displacement::None;
            quantity.trim_end_matches("-no-tangential").parse().unwrap()
        }
        plain => return (model.parse().unwrap(), plain.parse().unwrap()),
    };
    (lateral(model, options), quantity)
}

#[test]
fn every_reference_value_is_met() {
    let table = include_str!("../reference/models.csv");
    let mut rows = 0;
    let mut failures = vec![];
    let tolerance = Tolerance::new(1e-12).unwrap();
    for line in table.lines().skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let [case, model, separation, quantity, value] = fields[..] else { panic!("{line}") };
        let (model, quantity) = row(model, quantity);
        let value: f64 = value.parse().unwrap();
        let request = Request::new([quantity]).at([separation.parse().unwrap()]).within(tolerance);
        let answer = model.solve(&scenes::named(case), &request).unwrap();
        let error = (answer.values(quantity).unwrap()[0] / value - 1.0).abs();
        let allowed = if model.claims().angles { 1e-9 } else { 1e-11 };
        rows += 1;
        if error.is_nan() || error > allowed {
            failures.push(format!("{line}: error {error:.1e}"));
        }
    }
    assert!(failures.is_empty(), "{} of {rows}:\n{}", failures.len(), failures.join("\n"));
    assert!(rows == 864, "{rows} rows");
}
