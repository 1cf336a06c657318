//! How to add a model: its source, and the laws of force and area of one asperity, in 30 lines.
//! Averages over heights, tangents, shares, bounds on errors and inversion follow from the laws.
//!
//! This model is elastic up to the critical interference w_c, plastic beyond 10 w_c, and follows a
//! power law between.

use std::f64::consts::PI;

use asperity::{
    Asperity, AsperityModel, Citation, ContactError, ContactModel, Described, Interface, Law,
    Power, Provenance, Quantity, Request, Scene, Surface, Tolerance, testkit,
};

#[derive(Debug)]
struct ThreeRanges;

const SOURCE: Citation = Citation {
    id: "three-ranges", // in tables and scene files
    name: "Three ranges",
    authors: "A. Newcomer",
    year: 2026,
    title: "An example",
    provenance: Provenance::Derived,
    published: &[],
};

impl Described for ThreeRanges {
    fn citation(&self) -> &Citation {
        &SOURCE
    }
}

impl AsperityModel for ThreeRanges {
    // The tolerance is for laws that are tabulated.
    fn force(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        let unit = asperity.critical_force()?;
        // With x = w/w_c: F/F_c = x^1.5 up to 1 and (3/S) x from 10 on.
        three_ranges(asperity, unit, 1.5, 3.0 / asperity.pressure_factor)
    }

    fn area(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        let unit = PI * asperity.radius * asperity.critical_interference()?;
        // A/A_c = x and 2x.
        three_ranges(asperity, unit, 1.0, 2.0)
    }
}

fn three_ranges(
    asperity: &Asperity,
    unit: f64,
    elastic_exponent: f64,
    plastic_factor: f64,
) -> Result<Law, ContactError> {
    // Continuous at 10: 10^exponent = factor · 10.
    let between = (10.0 * plastic_factor).log10();
    Ok(Law::in_units(asperity.critical_interference()?, unit)
        .elastic(0.0..1.0, [Power::new(1.0, elastic_exponent)])
        .elastic_plastic(1.0..10.0, [Power::new(1.0, between)])
        .plastic(10.0..f64::INFINITY, [Power::new(plastic_factor, 1.0)]))
}

fn main() -> Result<(), ContactError> {
    let interface = Interface::new(116e9, 0.31, 1.12e9); // E [Pa], ν, H [Pa]
    let surface = Surface::new(3.59e-4, 1.11e8, 1e-6); // R [m], η [1/m²], σ_z [m]
    let scene = Scene::new(interface, surface, 3e-5); // A_n [m²]

    // The test kit checks the laws: ranges without gaps, values, jumps, the Hertzian limit.
    for finding in testkit::check(&ThreeRanges, &scene.asperity()?)? {
        println!("wrong: {finding}");
    }

    let quantities = [Quantity::Force, Quantity::Area, Quantity::Tangent];
    let request = Request::new(quantities).at([0.0, 1.0, 2.0]); // d/σ_z
    let answer = ThreeRanges.solve(&scene, &request)?;
    for quantity in quantities {
        let value = answer.values(quantity)?[1];
        println!("{quantity:9} {value:.4e} {}", quantity.unit());
    }
    Ok(())
}
