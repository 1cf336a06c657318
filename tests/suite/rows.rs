//! Rows: the same result singly and in a list, within the bounds.

use asperity::{
    At, ContactModel, Interface, Model, Quantity, Request, Scene, Surface, Tolerance, linspace,
};

use crate::one_of;
use crate::scenes::model;

fn scene(plasticity: f64) -> Scene {
    let mut interface = Interface::new(1e11, 0.3, 1e9);
    interface.equivalent_shear_modulus = Some(3e10);
    let surface = Surface::from_plasticity_index(plasticity, 0.04, 1e-6, &interface).unwrap();
    Scene::new(interface, surface, 1e-4)
}

/// Tangents with their bounds at these separations.
fn tangents(model: &Model, scene: &Scene, separations: &[f64], tolerance: f64) -> Vec<[f64; 2]> {
    let request = Request::new([Quantity::Tangent]).within(Tolerance::new(tolerance).unwrap());
    let answer = model.solve(scene, &request.at(separations.iter().copied())).unwrap();
    let row = |row: &Result<asperity::Evaluation, _>| {
        let row = row.as_ref().unwrap();
        [row.value(), row.relative_error()]
    };
    answer.column(Quantity::Tangent).unwrap().rows.iter().map(row).collect()
}

#[test]
fn tangents_far_below_0_are_the_same_singly_and_in_a_list() {
    let deep = [-60.0, -20.0, -10.0, -8.5];
    let list: Vec<f64> = deep.into_iter().chain(linspace(-8.0, 8.0, 33)).collect();
    for id in one_of(2, ["at-additive", "gao", "ke", "at-overlap"]) {
        let (model, scene) = (model(id), scene(3.0));
        let listed = tangents(&model, &scene, &list, 1e-10);
        for (s, [value, bound]) in deep.iter().zip(&listed) {
            let [alone, own] = tangents(&model, &scene, &[*s], 1e-10)[0];
            // A table is known to 2e-13, and a slope at -60 to some sixty times as much.
            let [fine, least] = tangents(&model, &scene, &[*s], 3e-11)[0];
            assert!(*bound < 2e-10 && own < 2e-10 && least < 4e-11, "{id} {s}: {bound:e} {own:e}");
            assert!((value / alone - 1.0).abs() <= bound + own, "{id} {s}: {value} {alone}");
            assert!((value / fine - 1.0).abs() <= bound + least, "{id} {s}: {value} {fine}");
        }
    }
}

#[test]
fn logarithms_near_zero_have_the_rounding_of_their_scale() {
    let gw = model("gw");
    let lines = include_str!("../reference/ln_force.csv").lines().skip(1);
    for line in lines {
        let fields: Vec<f64> = line.split(',').map(|field| field.parse().unwrap()).collect();
        let [s, nominal_area, wanted] = fields[..] else { panic!("{line}") };
        let interface = Interface::new(1e11, 0.3, 1e9);
        let scene = Scene::new(interface, Surface::new(1e-4, 1e9, 1e-6), nominal_area);
        let request = Request::new([Quantity::LnForce]).within(Tolerance::new(1e-15).unwrap());
        let answer = gw.solve(&scene, &request.at([s])).unwrap();
        let column = answer.column(Quantity::LnForce).unwrap();
        let row = column.rows[0].as_ref().unwrap();
        let (found, bound) = (row.value(), row.bound(column.quantity));
        let off = (found - wanted).abs();
        // Two logarithms of up to 400 cancel: each is rounded to 6e-14.
        assert!(off <= bound && bound < 3e-13, "{s}: {off:e}, bound {bound:e}");
    }
}

#[test]
fn rows_have_the_separations_that_carry_their_loads() {
    let scene = scene(3.0);
    let quantities = [Quantity::Area, Quantity::Tangent];
    // Few and many rows of asperities; a theory of the whole surface.
    for (id, count) in [("ke", 2), ("ke", 40), ("gw-pairs", 2), ("gao", 12)] {
        let mut at: Vec<At> = linspace(1.0, 50.0, count).into_iter().map(At::Load).collect();
        at.extend([At::Pressure(1e5), 1.5.into(), At::Load(-1.0)]);
        let request = Request::new(quantities).at(at.iter().copied());
        let answer = model(id).solve(&scene, &request).unwrap();
        let contact = model(id).compile(&scene, &request).unwrap();
        assert_eq!(answer.separations.len(), at.len());
        for (found, at) in answer.separations.iter().zip(&at) {
            match (found, at) {
                (Err(error), At::Load(load)) => assert!(*load < 0.0, "{id}: {error}"),
                (found, at) => {
                    let (found, known) =
                        (found.as_ref().unwrap(), contact.separation(*at).unwrap());
                    assert!((found.value - known.value).abs() < 1e-9, "{id} {at}: {found} {known}");
                    assert_eq!((found.unit, found.from), (known.unit, known.from));
                }
            }
        }
    }
    let request = Request::new([Quantity::Area]).at_loads([1.0]);
    let persson = model("persson").solve(&scene, &request);
    assert!(persson.unwrap().separations[0].is_err());
}
