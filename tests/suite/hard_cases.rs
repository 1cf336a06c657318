//! Every row of `reference/hard_cases.csv`: where naive methods fail (its last two columns say
//! which, and how), computed another way by the script beside it: 45 digits with mpmath for
//! GW..AF, 13 digits by integrating over (contact normal, tangential push) for Gao and AT.

use std::collections::HashMap;

use asperity::{
    Compiled, HeightDistribution, Interface, Model, Quantity, Request, Scene, Surface, Tolerance,
};

struct Row<'a> {
    fields: Vec<&'a str>,
}

impl Row<'_> {
    fn number(&self, column: usize) -> f64 {
        self.fields[column].parse().unwrap()
    }

    fn scene(&self) -> Scene {
        let mut interface = Interface::new(self.number(2), self.number(4), self.number(5));
        interface.equivalent_shear_modulus = Some(self.number(3));
        interface.pressure_factor = Some(self.number(6));
        let surface = Surface::new(self.number(7), self.number(8), self.number(9));
        let mut scene = Scene::new(interface, surface, self.number(10));
        if self.fields[11] == "exponential" {
            scene.heights = HeightDistribution::Exponential;
        }
        scene
    }

    fn model(&self) -> Model {
        self.fields[12].parse().unwrap()
    }

    fn quantity(&self) -> Quantity {
        self.fields[13].parse().unwrap()
    }

    /// The value over its scale, exp(-s²/2) or exp(-s) for s > 0, from the logarithm's text: at
    /// s = 1e6 a double holds no digit of the value.
    fn scaled(&self) -> f64 {
        let s = self.number(14);
        let (high, low) = match (self.fields[11], s > 0.0) {
            (_, false) => (0.0, 0.0),
            ("exponential", true) => (s, 0.0),
            // s² in two doubles.
            _ => (0.5 * s * s, 0.5 * s.mul_add(s, -(s * s))),
        };
        let text = self.fields[16];
        let (sign, digits) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
        let (whole, fraction) = digits.split_once('.').unwrap();
        let whole = sign * whole.parse::<f64>().unwrap();
        let fraction = sign * format!("0.{fraction}").parse::<f64>().unwrap();
        let size = (whole + high + (fraction + low)).exp();
        if self.fields[15].starts_with('-') { -size } else { size }
    }
}

#[test]
fn every_hard_case_is_met_within_the_bound_that_is_claimed() {
    let table = include_str!("../reference/hard_cases.csv");
    let mut compiled: HashMap<String, Compiled> = HashMap::new();
    let mut failures = vec![];
    let mut rows = 0;
    for line in table.lines().skip(1) {
        let row = Row { fields: line.split(',').collect() };
        let (model, quantity) = (row.model(), row.quantity());
        let lateral = model.claims().angles;
        // The tightest tolerances that are promised. The lateral references themselves hold 13
        // digits of the sum of sizes.
        let (tolerance, reference) = if lateral { (1e-11, 1e-13) } else { (1e-13, 1e-15) };
        let key = row.fields[2..14].join(",");
        let scene = compiled.entry(key).or_insert_with(|| {
            let request = Request::new([quantity]).within(Tolerance::new(tolerance).unwrap());
            model.compile(&row.scene(), &request).unwrap()
        });
        let found = scene.evaluate(quantity, row.number(14)).unwrap();
        let error = (found.scaled - row.scaled()).abs() / found.size;
        rows += 1;
        let within = error <= tolerance && error <= found.error + reference;
        if !within {
            let place = row.fields[..2].join(" ");
            failures.push(format!(
                "{place} {model} {quantity} at {}: error {error:.1e}, bound {:.1e}",
                row.fields[14], found.error
            ));
        }
    }
    assert!(failures.is_empty(), "{} of {rows}:\n{}", failures.len(), failures.join("\n"));
    assert!(rows >= 600, "{rows} rows");
}
