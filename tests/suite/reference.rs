//! Every row of `reference/models.csv`: 40-digit values for GW..AF, three independent
//! implementations that agree to 5e-13 for Gao and AT.

use asperity::{Model, Quantity, Request, Tolerance};

use crate::scenes;

#[test]
fn every_reference_value_is_met() {
    let table = include_str!("../reference/models.csv");
    let mut rows = 0;
    let mut failures = vec![];
    for row in table.lines().skip(1) {
        let fields: Vec<&str> = row.split(',').collect();
        let [case, model, separation, quantity, value] = fields[..] else { panic!("{row}") };
        let Ok(model) = model.parse::<Model>() else { continue };
        let Ok(quantity) = quantity.parse::<Quantity>() else { continue };
        let value: f64 = value.parse().unwrap();
        let request = Request::new([quantity])
            .at([separation.parse().unwrap()])
            .within(Tolerance::new(1e-12).unwrap());
        let answer = model.solve(&scenes::named(case), &request).unwrap();
        let error = (answer.values(quantity).unwrap()[0] / value - 1.0).abs();
        let allowed = if model.claims().angles { 1e-9 } else { 1e-11 };
        rows += 1;
        if error > allowed {
            failures.push(format!("{row}: error {error:.1e}"));
        }
    }
    assert!(failures.is_empty(), "{} of {rows}:\n{}", failures.len(), failures.join("\n"));
    assert!(rows >= 432, "only {rows} rows");
}
