//! Every row of `reference/hard_cases.csv`: cases in which naive methods fail (the last two columns
//! state which, and how), computed another way by the script beside it: 45 digits with mpmath for
//! GW..AF, 13 digits by integrating over (contact normal, tangential push) for Gao and AT.

use std::collections::{BTreeSet, HashMap};

use asperity::{
    Contact, HeightDistribution, Interface, Model, Quantity, Request, Scene, Surface, Tolerance,
};

use crate::one_of;

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

/// Asserts that every row of these models is met within the tolerance and within the bound.
fn are_met(models: &[&str], count: usize) {
    let table = include_str!("../reference/hard_cases.csv");
    let rows = table.lines().skip(1).map(|line| Row { fields: line.split(',').collect() });
    let rows: Vec<Row<'_>> = rows.filter(|row| models.contains(&row.fields[12])).collect();
    assert_eq!(rows.len(), count, "every row of {models:?}");
    let mut compiled: HashMap<String, Box<dyn Contact>> = HashMap::new();
    let mut failures = vec![];
    // Laws of lateral models are long to build: one of three scenes.
    let scene = |row: &Row<'_>| row.fields[2..14].join(",");
    let scenes: BTreeSet<String> = rows.iter().map(scene).collect();
    let of = if rows[0].model().validity().angles { 3 } else { 1 };
    let scenes: BTreeSet<String> = one_of(of, scenes).collect();
    for row in rows.iter().filter(|row| scenes.contains(&scene(row))) {
        let (model, quantity) = (row.model(), row.quantity());
        let lateral = model.validity().angles;
        // The tightest tolerances of the models. The lateral references have 13 digits of the sum
        // of sizes.
        let (tolerance, reference) = if lateral { (1e-11, 1e-13) } else { (1e-13, 1e-15) };
        let scene = compiled.entry(scene(row)).or_insert_with(|| {
            let request = Request::new([quantity]).within(Tolerance::new(tolerance).unwrap());
            model.compile(&row.scene(), &request).unwrap()
        });
        let found = scene.evaluate(quantity, row.number(14)).unwrap();
        let error = (found.scaled - row.scaled()).abs() / found.size;
        let within = error <= tolerance && error <= found.error + reference;
        if !within {
            let place = row.fields[..2].join(" ");
            failures.push(format!(
                "{place} {model} {quantity} at {}: error {error:.1e}, bound {:.1e}",
                row.fields[14], found.error
            ));
        }
    }
    assert!(failures.is_empty(), "{} of {count}:\n{}", failures.len(), failures.join("\n"));
}

/// One test for each model with laws that take long to build, so that they are built in parallel;
/// together they cover all 605 rows where long cases run.
macro_rules! hard_cases {
    ($($name:ident: $models:expr, $count:expr;)*) => {
        $(#[test]
        fn $name() {
            are_met(&$models, $count);
        })*

        #[test]
        fn no_row_is_left_out() {
            let rows = include_str!("../reference/hard_cases.csv").lines().count() - 1;
            assert_eq!([$($count),*].iter().sum::<usize>(), rows);
        }
    };
}

hard_cases! {
    hard_cases_of_upright_models_are_met:
        ["gw", "ceb", "zmc", "ke", "etsion", "jg", "jg-cosine", "af"], 313;
    hard_cases_of_gao_are_met: ["gao"], 55;
    hard_cases_of_at_are_met: ["at"], 103;
    hard_cases_of_at_additive_are_met: ["at-additive"], 67;
    hard_cases_of_at_overlap_are_met: ["at-overlap"], 67;
}

/// Below exponential heights, the tangent of a law given as a function is a small difference of
/// large numbers. The row at -30 is tested above; the reference of the others is the tightest
/// tolerance.
#[test]
fn tangents_far_below_exponential_heights_meet_any_tolerance() {
    let mut interface = Interface::new(2.5e9, 0.42, 4.5e8);
    interface.pressure_factor = Some(0.6262);
    let mut scene = Scene::new(interface, Surface::new(2e-5, 4e9, 5e-7), 1e-6);
    scene.heights = HeightDistribution::Exponential;
    for id in ["jg", "jg-cosine"] {
        let model: Model = id.parse().unwrap();
        let at = |tolerance: f64, s: f64| {
            let request =
                Request::new([Quantity::Tangent]).within(Tolerance::new(tolerance).unwrap());
            model.compile(&scene, &request).unwrap().evaluate(Quantity::Tangent, s).unwrap()
        };
        // The difference has an error of some 4e-14 of its terms.
        for (s, finest) in [(-9.0, 1e-12), (-30.0, 5e-12), (-100.0, 2e-11), (-400.0, 1e-10)] {
            let best = at(finest, s);
            for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
                let found = at(tolerance, s);
                let error = (found.value() / best.value() - 1.0).abs();
                let bound = found.bound(Quantity::Tangent) + best.bound(Quantity::Tangent);
                assert!(
                    error <= tolerance.min(bound),
                    "{id} {s} {tolerance:e}: {error:e} {bound:e}"
                );
            }
        }
    }
}

/// At the end of skewed heights, the rounding of the separation adds more than the tolerance to
/// every value: the stated bounds tell it alike for all quantities, alone or in a curve.
#[test]
fn what_rounding_adds_to_a_tolerance_is_stated_for_every_quantity() {
    let mut interface = Interface::new(200e9 / 1.82, 0.3, 2e9);
    interface.pressure_factor = None;
    let surface = Surface::from_plasticity_index(0.727_361_66, 0.042, 1.3e-7, &interface).unwrap();
    let mut scene = Scene::new(interface, surface, 1e-4);
    scene.heights = HeightDistribution::Weibull(asperity::WeibullHeights::new(-0.62).unwrap());
    let asked =
        [Quantity::Force, Quantity::Area, Quantity::Stiffness, Quantity::UnloadingStiffness];
    let etsion: Model = "etsion".parse().unwrap();
    let last = |count: u32, tolerance: f64| {
        let places = (1..=count).map(|k| 7.9899 * f64::from(k) / f64::from(count));
        let request = Request::new(asked).within(Tolerance::new(tolerance).unwrap()).at(places);
        let answer = etsion.solve(&scene, &request).unwrap();
        let last = |q: &Quantity| {
            let column = answer.columns.iter().find(|column| column.quantity == *q).unwrap();
            let value = column.rows.last().unwrap().as_ref().unwrap();
            (value.value(), value.bound(*q))
        };
        asked.iter().map(last).collect::<Vec<_>>()
    };
    let exact = last(1, 1e-13);
    for count in [1, 3, 255] {
        let found = last(count, 1.2e-13);
        let force = found[0].1;
        for ((value, bound), (other, error)) in found.into_iter().zip(&exact) {
            assert!(
                bound < 1e-10 && bound < 3.0 * force && force < 3.0 * bound,
                "{bound:e} {force:e}"
            );
            assert!((value / other - 1.0).abs() <= bound + error, "{count}: {value:e} {other:e}");
        }
    }
}
