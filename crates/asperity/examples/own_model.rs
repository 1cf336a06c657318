//! A model of your own: the laws, and where they are from. Everything else comes with the trait.
//! This one is Hertz up to w_c and fully plastic at once beyond 10 w_c, with a power law between.

use asperity::{
    Asperity, AsperityModel, Citation, ContactError, ContactModel, Described, Interface, Law,
    Power, Provenance, Quantity, Request, Scene, Surface, Tolerance, testkit,
};

#[derive(Debug)]
struct ThreeRanges;

const SOURCE: Citation = Citation {
    id: "three-ranges",
    name: "Three ranges",
    authors: "me",
    year: 2026,
    title: "An example",
    provenance: Provenance::Derived,
};

impl Described for ThreeRanges {
    fn citation(&self) -> &Citation {
        &SOURCE
    }
}

impl AsperityModel for ThreeRanges {
    fn law(
        &self,
        asperity: &Asperity,
        quantity: Quantity,
        _: Tolerance,
    ) -> Result<Option<Law>, ContactError> {
        let (w, f) = (asperity.critical_interference()?, asperity.critical_force()?);
        let (unit, elastic, at_ten) = match quantity {
            Quantity::Force => (f, 1.5, 30.0 / asperity.pressure_factor),
            Quantity::Area => (std::f64::consts::PI * asperity.radius * w, 1.0, 20.0),
            _ => return Ok(None),
        };
        let law = Law::in_units(w, unit)
            .elastic(0.0..1.0, [Power::new(1.0, elastic)])
            .elastic_plastic(1.0..10.0, [Power::new(1.0, at_ten.log10())])
            .plastic(10.0..f64::INFINITY, [Power::new(at_ten / 10.0, 1.0)]);
        Ok(Some(law))
    }
}

fn main() -> Result<(), ContactError> {
    let scene =
        Scene::new(Interface::new(116e9, 0.31, 1.12e9), Surface::new(3.59e-4, 1.11e8, 1e-6), 3e-5);
    for finding in testkit::check(&ThreeRanges, &scene.asperity()?)? {
        println!("wrong: {finding}");
    }
    let request =
        Request::new([Quantity::Force, Quantity::Area, Quantity::Tangent]).at([0.0, 1.0, 2.0]);
    let answer = ThreeRanges.solve(&scene, &request)?;
    for column in &answer.columns {
        println!(
            "{:9} {:.4e} {}",
            column.quantity.to_string(),
            column.values()?[1],
            column.quantity.unit()
        );
    }
    Ok(())
}
