//! `bem` as a model: the solver's answers under the names that all models share.

use asperity_bem::{Bem, Continuation, LoadCase};
use asperity_core::{
    At, ContactError, ContactModel, Interface, Quantity, Request, Scene, Separation, Surface,
};

use crate::{MODULUS, UNIT, close, options, paraboloid, rough};

const NOMINAL: f64 = 3e-6;

fn scene() -> Scene {
    let interface = Interface::new(MODULUS, 0.3, 0.3 * UNIT);
    Scene::new(interface, Surface::new(1e-5, 1e10, 1e-6), NOMINAL)
}

#[test]
fn answers_are_those_of_the_solver() {
    for elastic in [true, false] {
        let bem = Bem::new(rough(64, 1), options(None, elastic));
        let elements = bem.elements(&scene().interface).unwrap();
        let direct = elements.solve(LoadCase::MeanPressure(0.05 * UNIT)).unwrap();
        assert_eq!(direct.plastic_area > 0.0, !elastic);
        let quantities =
            [Quantity::Force, Quantity::AreaFraction, Quantity::Area, Quantity::MeanPressure];
        let places = [
            At::Pressure(0.05 * UNIT),
            At::Load(0.05 * UNIT * NOMINAL),
            Separation::metres(direct.mean_gap).from_surface_mean().into(),
        ];
        let request = Request::new(quantities).at(places);
        let contact = bem.compile(&scene(), &request).unwrap();
        let answer = contact.respond(&request);
        for (row, place) in places.into_iter().enumerate() {
            let found = quantities.map(|q| answer.values(q).unwrap()[row]);
            close(found[0], 0.05 * UNIT * NOMINAL, 1e-5);
            close(found[1], direct.area, 1e-5);
            close(found[2], direct.area * NOMINAL, 1e-5);
            close(found[3], 0.05 * UNIT / direct.area, 1e-5);
            let gap = contact.separation(place).unwrap();
            let gap = gap.measured_in(
                asperity_core::SeparationUnit::Metres,
                asperity_core::Datum::SurfaceMean,
                &scene(),
            );
            close(gap.unwrap().value, direct.mean_gap, 1e-6);
        }
    }
}

#[test]
fn nothing_touches_far_away_and_what_it_cannot_give_is_named() {
    let bem = Bem::new(rough(64, 1), options(Some(Continuation::Free), false));
    let request = Request::new([Quantity::Area, Quantity::MeanPressure]);
    let contact = bem.compile(&scene(), &request).unwrap();
    let far: At = Separation::metres(1.0).from_surface_mean().into();
    assert!(contact.evaluate(Quantity::Area, far).unwrap().value() <= 0.0);
    let none = contact.evaluate(Quantity::MeanPressure, far);
    assert!(matches!(none, Err(ContactError::NoValue { .. })), "{none:?}");
    let not_asked = contact.evaluate(Quantity::Force, far);
    assert!(matches!(not_asked, Err(ContactError::NotRequested { quantity: Quantity::Force })));
    let heavy = contact.evaluate(Quantity::Area, At::Pressure(UNIT)).unwrap_err().to_string();
    assert!(heavy.contains("hardness"), "{heavy}");
    let contacts = bem.compile(&scene(), &Request::new([Quantity::Contacts])).unwrap_err();
    assert!(contacts.to_string().starts_with("bem cannot give contacts (available: force,"));
    let mut soft = scene();
    soft.interface.equivalent_modulus = -1.0;
    let refused = bem.compile(&soft, &request).unwrap_err().to_string();
    assert!(refused.starts_with("equivalent_modulus is -1"), "{refused}");
}

#[test]
fn steps_at_the_edges_stay_where_the_map_is_declared_periodic() {
    let cut = rough(64, 1).heights()[..64 * 40].to_vec();
    let cut = asperity_bem::HeightMap::new(cut, [40, 64], rough(64, 1).pixel()).unwrap();
    let usual = Bem::new(cut.clone(), options(None, true));
    assert!(usual.note().is_some_and(|note| note.value > 3.0) && usual.map().edges_meet());
    assert_eq!(usual.continuation(), Continuation::PeriodicPart);
    assert_eq!(usual.half_grid().unwrap().map().shape(), [20, 32]);
    let requested = Bem::new(cut.clone(), options(Some(Continuation::PeriodicPart), true));
    assert!(requested.note().is_none() && requested.map() == usual.map());
    for continuation in [Continuation::Periodic, Continuation::Free] {
        let bem = Bem::new(cut.clone(), options(Some(continuation), true));
        assert!(bem.note().is_none() && *bem.map() == cut);
        assert_eq!(bem.continuation(), continuation);
        // What is declared has no second warning.
        let solved = bem.elements(&scene().interface).unwrap().tolerance(0.1).unwrap();
        let solved = solved.solve(LoadCase::MeanPressure(UNIT)).unwrap();
        assert!(
            solved.notes.iter().all(|note| note.code.name() != "open-seam"),
            "{:?}",
            solved.notes
        );
    }
    let whole = Bem::new(rough(64, 1), options(None, true));
    assert_eq!((whole.continuation(), whole.note()), (Continuation::Periodic, None));
    for one in Continuation::ALL {
        assert_eq!(Continuation::from_name(&one.to_string()), Some(one));
    }
    assert_eq!(Continuation::from_name("open"), None);
}

/// Stiffness and tangent are the slope of first loading, at pressures and at gaps.
#[test]
fn the_tangent_is_the_slope_of_loading() {
    let bem = Bem::new(rough(64, 1), options(None, false));
    let elements = bem.elements(&scene().interface).unwrap();
    let solution = elements.solve(LoadCase::MeanPressure(0.02 * UNIT)).unwrap();
    let slope = elements.loading_stiffness(&solution).unwrap() * NOMINAL;
    let gap: At = Separation::metres(solution.mean_gap).from_surface_mean().into();
    let far: At = Separation::metres(1.0).from_surface_mean().into();
    for quantity in [Quantity::Tangent, Quantity::Stiffness] {
        let request = Request::new([quantity]).at([At::Pressure(0.02 * UNIT)]);
        let contact = bem.compile(&scene(), &request).unwrap();
        let value = |at| contact.evaluate(quantity, at).unwrap().value();
        close(value(At::Pressure(0.02 * UNIT)), slope, 1e-9);
        close(value(gap), slope, 1e-3);
        assert!(value(far) <= 0.0);
    }
}

/// A ball or a cylinder that fills the map is one body unless a boundary is declared, with a note.
#[test]
fn a_body_that_fills_the_map_is_free_by_default() {
    let map = paraboloid(65, 1e-6, 1e-3);
    let usual = Bem::new(map.clone(), options(None, true));
    assert_eq!(usual.continuation(), Continuation::Free);
    assert_eq!(usual.map(), &map);
    let note = usual.note().unwrap();
    assert!(note.code.name() == "single-body" && note.value > 30.0, "{note}");
    let cylinder = (0..65 * 65).map(|k| -((k % 65) as f64 - 32.0).powi(2)).collect();
    let cylinder = asperity_bem::HeightMap::new(cylinder, [65, 65], [1e-6; 2]).unwrap();
    assert_eq!(Bem::new(cylinder, options(None, true)).continuation(), Continuation::Free);
    for declared in Continuation::ALL {
        assert_eq!(Bem::new(map.clone(), options(Some(declared), true)).note(), None);
    }
}

/// Stiffnesses and conductances of joints are multiples of the stiffness at fixed contact.
#[test]
fn joints_have_the_stiffness_at_fixed_contact() {
    let bem = Bem::new(rough(64, 1), options(None, false));
    let mut scene = scene();
    let at = At::Pressure(0.02 * UNIT);
    let elements = bem.elements(&scene.interface).unwrap();
    let solution = elements.solve(LoadCase::MeanPressure(0.02 * UNIT)).unwrap();
    let stiffness = elements.fixed_contact(&solution).unwrap().stiffness * NOMINAL;
    let compile = |scene: &Scene, quantity| bem.compile(scene, &Request::new([quantity]).at([at]));
    let lacks = compile(&scene, Quantity::ThermalConductancePerArea).unwrap_err().to_string();
    assert!(lacks.starts_with("thermal_conductivity is missing"), "{lacks}");
    let interface = &mut scene.interface;
    interface.equivalent_shear_modulus = Some(0.2 * MODULUS);
    (interface.thermal_conductivity, interface.electrical_resistivity) = (Some(50.0), Some(1e-7));
    let sum = stiffness / (2.0 * MODULUS);
    for (quantity, required) in [
        (Quantity::UnloadingStiffness, stiffness),
        (Quantity::TangentialStiffness, 0.8 * stiffness),
        (Quantity::ThermalConductance, 100.0 * sum),
        (Quantity::ThermalConductancePerArea, 100.0 * sum / NOMINAL),
        (Quantity::ElectricalConductance, 2e7 * sum),
        (Quantity::ElectricalConductancePerArea, 2e7 * sum / NOMINAL),
    ] {
        let contact = compile(&scene, quantity).unwrap();
        close(contact.evaluate(quantity, at).unwrap().value(), required, 1e-9);
        let far: At = Separation::metres(1.0).from_surface_mean().into();
        assert!(contact.evaluate(quantity, far).unwrap().value() <= 0.0);
    }
}
