//! Laws between two rough surfaces against references computed another way.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use asperity_af::AbdoFarhang;
use asperity_at::AminiTehrani;
use asperity_ceb::ChangEtsionBogy;
use asperity_core::{
    Asperity, AsperityModel, At, Case, ContactError, ContactModel, Formula, HeightDistribution,
    Interface, Law, Pair, Power, Quantity, Request, Scene, Separation, Surface, Sweep, Tolerance,
    testkit,
};
use asperity_etsion::EtsionKligermanKadin;
use asperity_gw::{GreenwoodWilliamson, greenwood_integral};
use asperity_jg::JacksonGreen;
use asperity_joints::{Joint, UnloadingLaw};
use asperity_ke::KogutEtsion;
use asperity_quadrature::gauss_kronrod;
use asperity_zmc::ZhaoMaiettaChang;

use crate::AsperityPairs;
use crate::integral::integral;

fn model(id: &str) -> AsperityPairs {
    match id {
        "gw" => AsperityPairs::new(GreenwoodWilliamson),
        "ceb" => AsperityPairs::new(ChangEtsionBogy),
        "zmc" => AsperityPairs::new(ZhaoMaiettaChang),
        "ke" => AsperityPairs::new(KogutEtsion),
        "etsion" => AsperityPairs::new(EtsionKligermanKadin),
        "jg" => AsperityPairs::new(JacksonGreen::default()),
        "af" => AsperityPairs::new(AbdoFarhang::default()),
        other => panic!("{other}"),
    }
}

/// A scene of the table of scenes, with the heights of both surfaces together.
fn scene(name: &str) -> Scene {
    let rows = include_str!("../../../../tests/reference/models_scenes.csv");
    let row = rows.lines().find(|row| row.starts_with(&format!("{name},"))).unwrap();
    let numbers: Vec<f64> = row.split(',').skip(1).map(|n| n.parse().unwrap()).collect();
    let [e, g, nu, hardness, factor, radius, density, std, area] = numbers[..] else { panic!() };
    let mut interface = Interface::new(e, nu, hardness);
    (interface.equivalent_shear_modulus, interface.pressure_factor) = (Some(g), Some(factor));
    Scene::new(interface, Surface::new(radius, density, FRAC_1_SQRT_2 * std), area)
}

/// Values at separations over σ_a from the mean of the asperities, each one alone and prepared.
fn check_against(rows: &str, scene: impl Fn(&str) -> Scene) -> usize {
    let (mut count, mut failures) = (0, vec![]);
    for row in rows.lines().skip(1) {
        let fields: Vec<&str> = row.split(',').collect();
        let quantity: Quantity = fields[3].parse().unwrap();
        let [at, wanted] = [fields[2], fields[4]].map(|n| n.parse::<f64>().unwrap());
        let (scene, model) = (scene(fields[0]), model(fields[1]));
        let tolerance = Tolerance::new(1e-13).unwrap();
        let request = Request::new([quantity]).within(tolerance).at([Separation::sigmas(at)]);
        for contact in [model.contact(&scene, &request), model.compile(&scene, &request)] {
            let found = contact.unwrap().evaluate(quantity, at).unwrap();
            let (off, bound) = ((found.value() / wanted - 1.0).abs(), found.relative_error());
            // Tangents of the reference have fewer digits than the bound.
            if off > 1e-12 || quantity != Quantity::Tangent && off > bound + 1e-15 {
                failures.push(format!("{row}: {off:e}, bound {bound:e}"));
            }
            count += 1;
        }
    }
    assert!(failures.is_empty(), "{} of {count}:\n{}", failures.len(), failures.join("\n"));
    count
}

#[test]
fn two_like_surfaces_have_the_values_of_the_reference() {
    assert_eq!(check_against(include_str!("../../../../tests/reference/pairs.csv"), scene), 748);
}

/// A second surface as in `pairs_unlike.py`, where the table has the heights of the first.
fn unlike(name: &str) -> Scene {
    let mut scene = scene(name);
    scene.surface.asperity_height_std *= 2f64.sqrt();
    let Surface { asperity_radius: r, asperity_density: eta, asperity_height_std: std, .. } =
        scene.surface;
    let second = Surface::new(0.4 * r, 1.7 * eta, 0.8 * std);
    scene.pair = Some(Pair::new(scene.surface, second));
    scene
}

#[test]
fn two_unlike_surfaces_have_those_of_the_double_integral() {
    let rows = include_str!("../../../../tests/reference/pairs_unlike.csv");
    assert_eq!(check_against(rows, unlike), 504);
}

#[test]
fn greenwood_and_tripp_have_a_closed_form() {
    let scene = scene("mild");
    let Surface { asperity_radius: beta, asperity_density: eta, asperity_height_std: std, .. } =
        scene.surface;
    let sigma = 2f64.sqrt() * std;
    let (e, area) = (scene.interface.equivalent_modulus, scene.nominal_area);
    let rough = (eta * beta * sigma).powi(2);
    let quantities = [Quantity::Pressure, Quantity::AreaFraction, Quantity::Contacts];
    let contact = model("gw").compile(&scene, &Request::new(quantities)).unwrap();
    for s in [-3.0, 0.0, 1.0, 3.0, 6.0] {
        let f = |order: f64| greenwood_integral(order, s).unwrap().value();
        let hertz = 16.0 * 2f64.sqrt() * PI / 15.0 * rough * (sigma / beta).sqrt() * e;
        let contacts = 4.0 * PI * eta * eta * beta * sigma * area;
        let wanted = [hertz * f(2.5), PI * PI * rough * f(2.0), contacts * f(1.0)];
        for (quantity, wanted) in quantities.into_iter().zip(wanted) {
            let found = contact.evaluate(quantity, s).unwrap().value();
            assert!((found / wanted - 1.0).abs() < 1e-13, "{quantity} {s}: {found} {wanted}");
        }
    }
}

fn force(scene: &Scene, at: impl Into<At>) -> f64 {
    let contact = model("ke").compile(scene, &Request::new([Quantity::Force])).unwrap();
    contact.evaluate(Quantity::Force, at).unwrap().value()
}

#[test]
fn both_surfaces_may_be_exchanged_and_like_ones_need_not_be_named() {
    let (unlike, mut exchanged) = (unlike("severe"), unlike("severe"));
    if let Some(pair) = &mut exchanged.pair {
        pair.surfaces.reverse();
    }
    let same = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-14, "{a} {b}");
    same(force(&unlike, 1.5), force(&exchanged, 1.5));
    let (alone, mut named) = (scene("severe"), scene("severe"));
    named.pair = Some(Pair::new(named.surface, named.surface));
    same(force(&named, 1.5), force(&alone, 1.5));
    // The scene of the contacts stands for itself, as where a contact is judged.
    let request = Request::new([Quantity::Force]);
    for scene in [&unlike, &alone] {
        let own = model("ke").compile(scene, &request).unwrap().scene().clone();
        for at in [At::sigmas(1.5), Separation::metres(3e-6).from_surface_mean().into()] {
            same(force(&own, at), force(scene, at));
        }
    }
}

#[test]
fn separations_of_the_mean_planes_count_the_asperities_of_both() {
    let h = Separation::metres(4e-6).from_surface_mean();
    let like = scene("at-paper");
    let d = 4e-6 - 2.0 * like.surface.mean_plane_offset();
    let same = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-13, "{a} {b}");
    same(force(&like, h), force(&like, At::metres(d)));
    let unlike = unlike("at-paper");
    let [first, second] = unlike.pair.unwrap().surfaces.map(|one| one.asperities);
    let d = 4e-6 - first.mean_plane_offset() - second.mean_plane_offset();
    same(force(&unlike, h), force(&unlike, At::metres(d)));
    // Measured: of each of two like surfaces, or of one of two, whose other has its own.
    let mut measured = like.clone();
    measured.mean_plane_offset = Some(5e-7);
    same(force(&measured, h), force(&like, At::metres(3e-6)));
    let mut one = unlike.clone();
    if let Some(pair) = &mut one.pair {
        pair.surfaces[0].mean_plane_offset = Some(5e-7);
    }
    let d = 4e-6 - 5e-7 - second.mean_plane_offset();
    same(force(&one, h), force(&unlike, At::metres(d)));
}

/// σ² and m₂ of two surfaces are the sums, and h/σ = 2 is a film of 2 √(σ₁² + σ₂²).
#[test]
fn both_surfaces_have_the_sums_of_their_numbers() {
    let unlike = unlike("mild");
    let pair = unlike.both_surfaces();
    let same = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-13, "{a} {b}");
    let [first, second] = pair.surfaces.map(|one| one.asperities.moments());
    same(pair.moments().m0, first.m0 + second.m0);
    same(pair.moments().m2, first.m2 + second.m2);
    same(pair.share_of_second(), second.m0 / (first.m0 + second.m0));
    let film = Separation::metres(2.0 * (first.m0 + second.m0).sqrt()).from_surface_mean();
    same(force(&unlike, Separation::film_ratio(2.0)), force(&unlike, film));
    // The surface that is equivalent to both plays no part.
    let mut other = unlike.clone();
    (other.surface_height_std, other.mean_plane_offset) = (Some(1e-3), Some(1e-3));
    same(force(&other, film), force(&unlike, film));
}

/// The force by contacts of one regime: the law of a contact times the pairs nearer than v.
#[test]
fn shares_are_those_of_the_contacts_and_loads_are_inverted() {
    let scene = scene("at-paper");
    let ke = model("ke").compile(&scene, &Request::new([Quantity::Force]).at([At::Load(1.0)]));
    let ke = ke.unwrap();
    let (asperity, d) = (ke.scene().asperity().unwrap(), 1.2);
    let law = KogutEtsion.force(&asperity, Tolerance::default()).unwrap();
    let by = |from: f64, to: f64| {
        let nearer = |x: f64| {
            let s = d + x * law.interference_unit / ke.scene().surface.asperity_height_std;
            0.5 * libm::erfc(s / 2f64.sqrt())
        };
        let force = |x: f64| law.value(x * law.interference_unit).unwrap() * nearer(x);
        let middle = 0.5 * (from + to);
        gauss_kronrod(force, &[from, middle, to], 1e-12, 50_000).unwrap().value
    };
    let wanted = [by(0.0, 1.0), by(1.0, 6.0), by(6.0, 110.0), by(110.0, 700.0)];
    let all: f64 = wanted.iter().sum();
    let found = ke.shares(Quantity::Force, d).unwrap();
    assert_eq!(found.len(), 4);
    for (share, wanted) in found.iter().zip(wanted) {
        assert!((share.share / wanted * all - 1.0).abs() < 1e-9, "{share:?} {}", wanted / all);
    }
    let load = ke.evaluate(Quantity::Force, d).unwrap().value();
    let there = ke.separation(At::Load(load)).unwrap();
    assert!((there.value - d).abs() < 1e-12, "{there}");
}

/// After a retreat u, each contact has F (1 - u/δ)^(3/2) of its force, δ = 3F/(4 E a).
#[test]
fn contacts_unload_one_by_one() {
    let scene = scene("at-paper");
    let (ke, d, u) = (model("ke"), 1.0, 2e-7);
    let joint = Joint::new(&ke, &scene, UnloadingLaw::Hertz, Tolerance::default()).unwrap();
    let opening = joint.unloading(At::sigmas(d)).unwrap();
    let request = Request::new([Quantity::Force, Quantity::Contacts]);
    let closed = ke.compile(&scene, &request).unwrap();
    let at = |quantity| closed.evaluate(quantity, d).unwrap().value();
    let same = |a: f64, b: f64, within: f64| assert!((a / b - 1.0).abs() < within, "{a} {b}");
    same(opening.force(0.0).unwrap().value(), at(Quantity::Force), 1e-9);
    same(opening.contacts(0.0).unwrap().value(), at(Quantity::Contacts), 1e-9);
    let asperity = closed.scene().asperity().unwrap();
    let tolerance = Tolerance::default();
    let force = KogutEtsion.force(&asperity, tolerance).unwrap();
    let area = KogutEtsion.area(&asperity, tolerance).unwrap();
    let critical = asperity.critical_interference().unwrap();
    let sum = |remaining: &dyn Fn(f64) -> f64| {
        let nearer = |w: f64| {
            let s = d + w / closed.scene().surface.asperity_height_std;
            remaining(w) * 0.5 * libm::erfc(s / 2f64.sqrt())
        };
        // The first contact that is left has w near u.
        let ends = [0.0, u, 1.1 * u, 1.5 * u, 110.0 * critical, 7e-6];
        gauss_kronrod(nearer, &ends, 1e-9, 200_000).unwrap().value
    };
    let loaded = |w: f64| force.value(w).unwrap();
    let left = |w: f64| {
        let radius = (area.value(w).unwrap() / PI).sqrt();
        let recovered = 0.75 * loaded(w) / (asperity.equivalent_modulus * radius);
        loaded(w) * (1.0 - u / recovered).max(0.0).powf(1.5)
    };
    let wanted = at(Quantity::Force) * sum(&left) / sum(&loaded);
    same(opening.force(u).unwrap().value(), wanted, 1e-6);
    assert!(wanted < 0.5 * at(Quantity::Force));
}

#[test]
fn a_sweep_and_other_densities_have_the_same_values() {
    let scenes = [scene("at-paper"), scene("mild"), unlike("mild")];
    for id in ["gw", "ke", "jg"] {
        let model = model(id);
        let sweep = Sweep::new(&model, &[Quantity::Force], Tolerance::default());
        let cases: Vec<Case> = scenes.iter().map(|s| Case::new(s.clone(), 1.0)).collect();
        for (scene, found) in scenes.iter().zip(sweep.evaluate_all(&cases)) {
            let contact = model.compile(scene, &Request::new([Quantity::Force])).unwrap();
            let wanted = contact.evaluate(Quantity::Force, 1.0).unwrap().value();
            let found = found.unwrap()[0].value();
            assert!((found / wanted - 1.0).abs() < 1e-11, "{id}: {found} {wanted}");
            // The law depends on the density.
            let mut denser = contact.scene().clone();
            denser.surface.asperity_density *= 2.0;
            assert!(matches!(contact.on(&denser), Err(ContactError::OtherAsperity)));
        }
    }
}

#[test]
fn one_function_on_two_ranges_has_two_integrals() {
    for (end, wanted) in [(1.0, 1.0), (2.0, 1.125)] {
        let line = Formula::function(|x| x).known_as("line", vec![]);
        let law = Law::in_units(1.0, 1.0).elastic(0.0..end, line);
        let law = integral(law.plastic(end..f64::INFINITY, [Power::new(end, 0.0)]));
        let found = law.value(1.5).unwrap();
        assert!((found - wanted).abs() < 1e-14, "{end}: {found}");
    }
}

#[test]
fn what_is_refused_has_its_reason() {
    let (mut scene, request) = (scene("mild"), Request::new([Quantity::Force]));
    let refused = |model: &AsperityPairs, scene: &Scene| {
        model.compile(scene, &request).unwrap_err().to_string()
    };
    let inclined = refused(&AsperityPairs::new(AminiTehrani::default()), &scene);
    assert!(inclined.contains("contacts are inclined"), "{inclined}");
    scene.heights = HeightDistribution::Exponential;
    assert!(refused(&model("gw"), &scene).contains("heights must be Gaussian"));
    let alone = Asperity::new(&scene.interface, 1e-4).unwrap();
    let message = model("gw").law(&alone, Quantity::Force, Tolerance::default());
    let message = message.unwrap_err().to_string();
    assert!(message.starts_with("asperity_density is missing"), "{message}");
    // No such law has a negative value, a kink that is not declared, or a jump.
    let asperity = unlike("mild").asperity().unwrap();
    for id in ["gw", "ceb", "zmc", "ke", "etsion", "jg", "af"] {
        assert!(testkit::check(&model(id), &asperity).unwrap().is_empty(), "{id}");
    }
}
