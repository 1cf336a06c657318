//! The page of definitions has every quantity, with the unit and the models that the code has.

use asperity::{
    Asperities, At, ContactError, ContactModel, Described, Interface, Model, Quantity, Request,
    Scene, Surface,
};

const PAGE: &str = include_str!("../../DEFINITIONS.md");

/// The cells of the quantity's row: name, symbol, unit, definition, models, needs, errors.
fn row(quantity: Quantity) -> Vec<&'static str> {
    let start = format!("| `{quantity}` |");
    let mut rows = PAGE.lines().filter(|line| line.starts_with(&start));
    let row = rows.next().unwrap_or_else(|| panic!("DEFINITIONS.md has no row of {quantity}"));
    assert!(rows.next().is_none(), "DEFINITIONS.md has two rows of {quantity}");
    let cells = row.strip_prefix('|').and_then(|row| row.strip_suffix('|'));
    cells.unwrap_or_default().split('|').map(str::trim).collect()
}

#[test]
fn every_quantity_has_its_symbol_its_unit_and_its_kind_of_error() {
    for quantity in Quantity::ALL {
        let row = row(quantity);
        assert_eq!(row.len(), 7, "{row:?}");
        let unit = if quantity.unit().is_empty() { "1" } else { quantity.unit() };
        assert_eq!(row[2], unit, "{row:?}");
        assert_eq!(row[1].replace('Σ', "sum "), quantity.symbol(), "{row:?}");
        let errors = if quantity.is_absolute() { "absolute" } else { "relative" };
        assert_eq!(row[6], errors, "{row:?}");
    }
}

/// A scene with every input.
fn scene() -> Scene {
    let mut interface = Interface::new(116e9, 0.31, 1.12e9);
    interface.equivalent_shear_modulus = Some(41e9);
    interface.thermal_conductivity = Some(20.0);
    interface.electrical_resistivity = Some(1e-7);
    interface.work_of_adhesion = Some(0.05);
    let surface = Surface::from_plasticity_index(1.0, 0.04, 1e-6, &interface).unwrap();
    Scene::new(interface, surface, 3e-5)
}

/// The quantities that a model has, apart from inputs that are missing.
fn quantities_of(model: &Model, scene: &Scene) -> Vec<Quantity> {
    let is_there = |quantity: Quantity, found: Result<(), ContactError>| match found {
        Ok(()) | Err(ContactError::Missing { .. }) => true,
        Err(ContactError::Unsupported { .. }) => false,
        Err(other) => panic!("{model} {quantity}: {other}"),
    };
    let contact = |asked: &[Quantity]| model.contact(scene, &Request::new(asked.iter().copied()));
    let mut all = Quantity::ALL.to_vec();
    all.retain(|quantity| is_there(*quantity, contact(&[*quantity]).map(drop)));
    // One contact for all: random asperities take long to be averaged.
    let asked: Vec<_> = all.iter().copied().filter(|one| contact(&[*one]).is_ok()).collect();
    let contact = contact(&asked).unwrap();
    let found = |one: Quantity| contact.evaluate(one, At::Load(1.0)).map(drop);
    all.retain(|one| !asked.contains(one) || is_there(*one, found(*one)));
    all
}

#[test]
fn every_quantity_names_the_models_that_have_it() {
    let scene = scene();
    let (inclined, upright): (Vec<_>, Vec<_>) =
        Model::of_asperities().into_iter().partition(|model| model.validity().angles);
    let (yielding, elastic): (Vec<_>, Vec<_>) =
        Model::whole_surface().into_iter().partition(|model| model.validity().holds_to.is_none());
    let groups = [
        ([upright, Model::adhesive()].concat(), &["all", "asperities", "upright"][..]),
        (Model::all_on(Asperities::Random), &["all", "asperities"]),
        (Model::all_on(Asperities::Pairs), &["all", "asperities", "upright"]),
        (inclined, &["all", "asperities"]),
        (elastic, &["all", "persson"]),
        (yielding, &["all", "persson-plastic"]),
        (Model::correlations(), &["correlations"]),
    ];
    for (models, words) in &groups {
        for model in models {
            let found = quantities_of(model, &scene);
            for quantity in Quantity::ALL {
                let stated = row(quantity)[4].split(", ").any(|word| words.contains(&word));
                assert_eq!(found.contains(&quantity), stated, "{} {quantity}", model.id());
            }
        }
    }
}
