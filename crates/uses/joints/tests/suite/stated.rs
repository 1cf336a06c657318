//! Values that are stated for named scenes, and relations that hold for every law of circles.

use std::f64::consts::PI;

use asperity_core::{
    At, ContactModel, HeightDistribution, Interface, Quantity, Request, Scene, Surface,
    TabulatedHeights, Tolerance,
};
use asperity_gw::GreenwoodWilliamson;
use asperity_jg::JacksonGreen;
use asperity_joints::{PartialSlip, Unloading, UnloadingLaw};
use asperity_ke::KogutEtsion;

use crate::scenes::{SIGMA, named, tight, with_index};

/// Law, argument and value of the rows of a quantity in `tests/reference/joints_stated.csv`, whose
/// last column is their origin.
fn stated(quantity: &str) -> Vec<(&'static str, f64, f64)> {
    let rows = include_str!("../../../../../tests/reference/joints_stated.csv").lines().skip(1);
    let row = |line: &'static str| {
        let [name, law, argument, value] = line.splitn(5, ',').take(4).collect::<Vec<_>>()[..]
        else {
            panic!("{line}")
        };
        let argument = argument.parse().unwrap_or(f64::NAN);
        (name == quantity).then(|| (law, argument, value.parse().unwrap()))
    };
    let found: Vec<_> = rows.filter_map(row).collect();
    assert!(!found.is_empty(), "{quantity}");
    found
}

/// The one value of a quantity.
fn one(quantity: &str) -> f64 {
    stated(quantity)[0].2
}

fn value(model: &dyn ContactModel, scene: &Scene, quantity: Quantity, separation: f64) -> f64 {
    let request = Request::new([quantity]).within(tight());
    let contact = model.compile(scene, &request).unwrap();
    contact.evaluate(quantity, separation).unwrap().value()
}

#[test]
fn forces_of_kogut_and_etsion_on_the_way_back_equal_the_stated_shares() {
    // The shares depend on the plasticity index and, beyond 110 w_c, on K: here of nu = 0.3.
    let mut interface = Interface::new(116e9, 0.3, 1.12e9);
    interface.pressure_factor = Some(0.577);
    let surface = Surface::from_plasticity_index(6.0, 0.04, SIGMA, &interface).unwrap();
    let scene = Scene::new(interface, surface, 3e-5);
    for (law, retreat, share) in stated("ke-share-on-the-way-back") {
        let law: UnloadingLaw = law.parse().unwrap();
        let joint = Unloading::new(&KogutEtsion, &scene, At::from(0.0), law, tight()).unwrap();
        let largest = joint.force(0.0).unwrap().value();
        let found = joint.force(retreat * SIGMA).unwrap().value() / largest;
        // Eight printed digits.
        assert!((found - share).abs() < 6e-9, "{law} at {retreat}: {found}");
    }
}

#[test]
fn the_published_sphere_slips_as_stated() {
    // E of a body 192.85 GPa, nu 0.29, R 4.17 mm, mu 0.2, w 10 µm.
    let (modulus, nu, radius) = (192.85e9_f64, 0.29_f64, 4.174432305996625e-3_f64);
    let mut interface = Interface::new(0.5 * modulus / (1.0 - nu * nu), nu, 1e12);
    // 1/G = 2 (2 - nu)/G of a body.
    let shear = 0.5 * modulus / (1.0 + nu);
    interface.equivalent_shear_modulus = Some(0.5 * shear / (2.0 - nu));
    let (_, interference, force) = stated("sphere-force")[0];
    let (_, shift, friction) = stated("sphere-friction")[0];
    let width = 1e-10;
    let mut scene = Scene::new(interface, Surface::new(radius, 1e4, 1e-6), 1e-4);
    assert!((scene.asperities() - 1.0).abs() < 1e-15);
    // Heights that differ by 1e-5 of the interference: of the second order in the sum.
    let points = [(-width, 0.5 / width), (width, 0.5 / width)];
    scene.heights = HeightDistribution::other(TabulatedHeights::new("one", &points).unwrap());
    let (at, law) = (At::metres(-interference), UnloadingLaw::Hertz);
    let joint = Unloading::new(&GreenwoodWilliamson, &scene, at, law, tight()).unwrap();
    let slip = PartialSlip::new(&joint, 0.2).unwrap();
    let found = [
        (joint.force(0.0).unwrap().value(), force),
        (slip.force(shift).unwrap().value(), friction),
        // Q = mu F (1 - (1 - u/u_s)^1.5), at half of mu F.
        (
            slip.shift_at(0.5).unwrap() / (1.0 - 0.5f64.powf(2.0 / 3.0)),
            one("sphere-gross-slip-shift"),
        ),
    ];
    for (found, wanted) in found {
        assert!((found / wanted - 1.0).abs() < 1e-8, "{found} {wanted}");
    }
}

#[test]
fn one_sum_of_contact_radii_answers_four_questions() {
    let mut scene = named("at-paper");
    scene.interface.thermal_conductivity = Some(200.0 / 3.0);
    let Interface { equivalent_modulus, equivalent_shear_modulus, .. } = scene.interface;
    let shear = equivalent_shear_modulus.unwrap();
    let models: [&dyn ContactModel; 3] =
        [&GreenwoodWilliamson, &KogutEtsion, &JacksonGreen::default()];
    for model in models {
        let of = |quantity| value(model, &scene, quantity, 1.0);
        let (sum, unloading) = (of(Quantity::ContactRadiusSum), of(Quantity::UnloadingStiffness));
        for (found, wanted) in [
            (unloading, 2.0 * equivalent_modulus * sum),
            (of(Quantity::TangentialStiffness), 4.0 * shear / equivalent_modulus * unloading),
            // Barber: h A/K = k/E.
            (of(Quantity::ThermalConductance), 200.0 / 3.0 / equivalent_modulus * unloading),
        ] {
            assert!((found / wanted - 1.0).abs() < 1e-12, "{}: {found} {wanted}", model.id());
        }
    }
    // GW: eta A sqrt(R sigma) F_1/2(t), by Simpson's rule over v = sqrt(z - t).
    let surface = scene.surface;
    let (steps, span) = (4000, 12f64.sqrt());
    let term = |k: i32| {
        let weight = if k == 0 || k == steps { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
        let v = span * f64::from(k) / f64::from(steps);
        weight * 2.0 * v * v * (-0.5 * (1.0 + v * v).powi(2)).exp()
    };
    let integral = (0..=steps).map(term).sum::<f64>() * span / f64::from(3 * steps);
    let integral = integral / (2.0 * PI).sqrt();
    let radius = (surface.asperity_radius * surface.asperity_height_std).sqrt();
    let wanted = scene.asperities() * radius * integral;
    let gw = |quantity| value(&GreenwoodWilliamson, &scene, quantity, 1.0);
    assert!((gw(Quantity::ContactRadiusSum) / wanted - 1.0).abs() < 1e-12);
    let ratio = gw(Quantity::UnloadingStiffness) / gw(Quantity::Tangent);
    assert!((ratio - 1.0).abs() < 1e-11, "{ratio}");
}

#[test]
fn small_vibrations_are_stiffer_than_first_loading_by_the_stated_factors() {
    for (_, index, factor) in stated("ke-unloading-over-loading-stiffness") {
        // Half of the last digit.
        let printed = if factor < 2.0 { 5e-3 } else { 5e-2 };
        let scene = with_index(index);
        let of = |quantity| value(&KogutEtsion, &scene, quantity, 1.0);
        let found = of(Quantity::UnloadingStiffness) / of(Quantity::Tangent);
        assert!((found - factor).abs() <= printed, "{index}: {found}");
    }
}

#[test]
fn kogut_etsion_and_jackson_green_are_near_finite_elements() {
    // Small slopes, as in the elements: the strength is a small share of the modulus.
    let mut interface = Interface::new(116e9, 0.3, 1.12e6);
    interface.yield_strength = Some(0.4e6);
    let surface = Surface::from_plasticity_index(2.0, 0.04, SIGMA, &interface).unwrap();
    let asperity = Scene::new(interface, surface, 3e-5).asperity().unwrap();
    let deviation = |model: &dyn ContactModel, x: f64, element: f64| {
        let law = model.law(&asperity, Quantity::Force, Tolerance::default()).unwrap();
        law.value(x * law.interference_unit).unwrap() / law.value_unit / element - 1.0
    };
    let elements = stated("finite-element-force");
    for &(_, x, element) in &elements {
        // Below the kinks of KE at 6 and 110; above that at 6 it has 4.8 % too much.
        let ke = deviation(&KogutEtsion, x * (1.0 - 1e-9), element);
        assert!(ke.abs() < if x > 50.0 { 0.06 } else { 0.031 }, "ke at {x}: {ke}");
        let jg = deviation(&JacksonGreen::default(), x, element);
        // 4.6 % at 50, and 1 to 4 % elsewhere.
        assert!(jg.abs() < 0.047, "jg at {x}: {jg}");
    }
    let (_, kink, element) = elements[2];
    let above = deviation(&KogutEtsion, kink * (1.0 + 1e-9), element);
    assert!((above - 0.048).abs() < 5e-4, "{above}");
}
