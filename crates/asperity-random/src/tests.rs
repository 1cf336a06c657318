//! Every row of `reference/population.csv`, from another program, and what a random surface
//! refuses.

use std::collections::BTreeMap;
use std::f64::consts::{PI, SQRT_2};

use asperity_af::AbdoFarhang;
use asperity_at::AminiTehrani;
use asperity_ceb::ChangEtsionBogy;
use asperity_core::{
    AsperityModel, At, Contact, ContactModel, HeightDistribution, Interface, ProfileMoments,
    Quantity, Request, Scene, Separation, Surface, Tolerance,
};
use asperity_etsion::EtsionKligermanKadin;
use asperity_gw::GreenwoodWilliamson;
use asperity_jg::JacksonGreen;
use asperity_ke::KogutEtsion;
use asperity_quadrature::gauss_kronrod;
use asperity_zmc::ZhaoMaiettaChang;

use crate::population::Population;
use crate::{FARTHEST, RandomAsperities};

/// The model of asperities, and the same on a random surface.
fn models(id: &str) -> (Box<dyn AsperityModel>, Box<dyn ContactModel>) {
    fn both(
        model: impl AsperityModel + Copy + 'static,
    ) -> (Box<dyn AsperityModel>, Box<dyn ContactModel>) {
        (Box::new(model), Box::new(RandomAsperities::new(model)))
    }
    match id {
        "gw" => both(GreenwoodWilliamson),
        "ceb" => both(ChangEtsionBogy),
        "zmc" => both(ZhaoMaiettaChang),
        "ke" => both(KogutEtsion),
        "etsion" => both(EtsionKligermanKadin),
        "jg" => both(JacksonGreen::default()),
        "af" => both(AbdoFarhang::default()),
        other => panic!("{other}"),
    }
}

/// What summits sharper than 9.5 √(m₄/3), which the program behind the file leaves out, add: the
/// integral over k and w of the density itself, with that over k_m in closed form. \[derived\]
fn sharp(model: &dyn AsperityModel, scene: &Scene, quantity: Quantity, height: f64) -> f64 {
    let own = Population::new(scene).unwrap();
    let population = own.scene(scene);
    let asperity = population.asperity().unwrap();
    let tolerance = Tolerance::new(1e-11).unwrap();
    let law = model.law(&asperity, quantity, tolerance).unwrap().unwrap();
    let b = own.unit / (SQRT_2 * own.height_std);
    let a_k = 1.5 + b * b;
    let over_curvatures = |k: f64| {
        let over_interferences = |w: f64| {
            let a = (height + w) / own.height_std;
            let beyond = (0.5 * a_k).sqrt() * (k - a * b / a_k);
            let gauss = (0.5 * k * k - 0.5 * a * a * (1.0 - b * b / a_k)).exp();
            law.value(w * k).unwrap() * k * gauss * libm::erfc(beyond)
        };
        let mut breaks: Vec<f64> =
            law.kinks().iter().map(|x| x * law.interference_unit / k).collect();
        let last = (9.0 * own.height_std + 12.0 * own.unit - height).max(own.unit);
        breaks.retain(|w| *w < last);
        breaks.extend((0..=12).map(|j| last * (f64::from(j) / 12.0).powi(2)));
        breaks.sort_by(f64::total_cmp);
        gauss_kronrod(over_interferences, &breaks, 1e-9, 100_000).unwrap().value
    };
    let breaks = [9.5, 10.0, 11.0, 13.0, 16.0];
    let all = gauss_kronrod(over_curvatures, &breaks, 1e-8, 10_000).unwrap().value;
    let norm = (0.75 / PI).sqrt() * (0.5 * PI / a_k).sqrt() / (2.0 * PI).sqrt() / own.height_std;
    scene.asperities() * norm * all
}

/// Scene and √m₀ by name.
fn scenes() -> BTreeMap<&'static str, (Scene, f64)> {
    let lines = include_str!("../../../tests/reference/population_scenes.csv").lines().skip(1);
    let scene = |line: &'static str| {
        let fields: Vec<&str> = line.split(',').collect();
        let number = |k: usize| fields[k].parse::<f64>().unwrap();
        let mut interface = Interface::new(number(1), number(2), number(3));
        interface.pressure_factor = Some(number(4));
        let moments = ProfileMoments { m0: number(5), m2: number(6), m4: number(7) };
        let surface = Surface::from_moments(&moments).unwrap();
        (fields[0], (Scene::new(interface, surface, 1.0), moments.m0.sqrt()))
    };
    lines.map(scene).collect()
}

fn above(height: f64) -> At {
    Separation::metres(height).from_surface_mean().into()
}

#[test]
fn every_reference_value_is_met_within_the_bound() {
    let scenes = scenes();
    let mut contacts = BTreeMap::<(&str, &str), Box<dyn Contact>>::new();
    let mut worst = BTreeMap::<&str, f64>::new();
    let (mut failures, mut count) = (vec![], 0);
    for line in include_str!("../../../tests/reference/population.csv").lines().skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let [case, id, height, quantity, value] = fields[..] else { panic!("{line}") };
        let (scene, rms) = &scenes[case];
        let (law, random) = models(id);
        let contact = contacts.entry((case, id)).or_insert_with(|| {
            let request = Request::new([Quantity::Force, Quantity::Area, Quantity::Tangent]);
            random.compile(scene, &request.within(Tolerance::new(1e-11).unwrap())).unwrap()
        });
        let height = height.parse::<f64>().unwrap() * rms;
        let quantity: Quantity = quantity.parse().unwrap();
        let beyond = match quantity {
            Quantity::Tangent => {
                let step = 0.01 * rms;
                let of = |j: f64| sharp(&*law, scene, Quantity::Force, height + j * step);
                (8.0 * (of(-1.0) - of(1.0)) - (of(-2.0) - of(2.0))) / (12.0 * step)
            }
            quantity => sharp(&*law, scene, quantity, height),
        };
        let wanted = value.parse::<f64>().unwrap() + beyond;
        let found = contact.evaluate(quantity, above(height)).unwrap();
        let (error, bound) = ((found.value() / wanted - 1.0).abs(), found.relative_error());
        // The file holds about 1e-12; differences find tangents of what it lacks to 1e-5.
        let own = 2e-12 + 1e-5 * beyond / wanted;
        if error.is_nan() || error > bound + own || bound > 1e-10 {
            failures.push(format!("{line}: {error:.1e}, bound {bound:.1e}, own {own:.1e}"));
        }
        let most = worst.entry(id).or_default();
        *most = most.max(error);
        count += 1;
    }
    println!("{worst:?}");
    assert!(failures.is_empty(), "{} of {count}:\n{}", failures.len(), failures.join("\n"));
    assert_eq!(count, 315);
}

#[test]
fn limits_of_the_bandwidth_and_what_is_refused() {
    let gw = RandomAsperities::new(GreenwoodWilliamson);
    let asked = Request::new([Quantity::Force, Quantity::Contacts]);
    let interface = Interface::elastic(116e9, 0.31);
    let scene = |bandwidth: f64| {
        let m4 = bandwidth * 1e-8 / 1e-12;
        let surface = Surface::from_moments(&ProfileMoments { m0: 1e-12, m2: 1e-4, m4 }).unwrap();
        Scene::new(interface, surface, 3e-5)
    };
    let at = |scene: &Scene, quantity: Quantity, height: f64| {
        gw.compile(scene, &asked).unwrap().evaluate(quantity, above(height)).unwrap().value()
    };
    // Curvature tells nothing of the height in the limit: Gaussian summits with spread radii.
    // ⟨κ^(-1/2)⟩ √R₀ against √R: force per asperity, at any separation.
    let ratio = |bandwidth: f64, height: f64| {
        let scene = scene(bandwidth);
        let one = GreenwoodWilliamson.compile(&scene, &asked).unwrap();
        let one = one.evaluate(Quantity::Force, above(height)).unwrap().value();
        at(&scene, Quantity::Force, height) / one
    };
    let far = [0.0, 2e-6].map(|height| ratio(1e8, height));
    assert!((far[0] / far[1] - 1.0).abs() < 1e-3, "{far:?}");
    let near = [0.0, 2e-6].map(|height| ratio(1e4, height));
    assert!((near[0] / near[1] - 1.0).abs() > 10.0 * (far[0] / far[1] - 1.0).abs(), "{near:?}");
    // The other limit is continuous, and every summit is met from far below.
    let narrow = [1.5 + 1e-6, 1.5 + 1e-5].map(|alpha| at(&scene(alpha), Quantity::Force, 1e-6));
    assert!((narrow[0] / narrow[1] - 1.0).abs() < 1e-4, "{narrow:?}");
    for alpha in [1.6, 3.0, 100.0] {
        let scene = scene(alpha);
        let all = at(&scene, Quantity::Contacts, -12e-6) / scene.asperities();
        assert!((all - 1.0).abs() < 1e-10, "{alpha}: {all}");
    }

    let usual = scene(5.0);
    let contact = gw.compile(&usual, &asked.clone().at([At::Load(1.0)])).unwrap();
    let refused = contact.evaluate(Quantity::Force, above((FARTHEST + 0.1) * 1e-6)).unwrap_err();
    assert!(refused.to_string().contains("over sqrt(m0)"), "{refused}");
    assert!(contact.evaluate(Quantity::Force, At::Load(1e-12)).is_err());
    let there = contact.separation(At::Load(1.0)).unwrap();
    let force = contact.evaluate(Quantity::Force, there).unwrap().value();
    assert!((force - 1.0).abs() < 1e-9, "{force}");
    let refused =
        RandomAsperities::new(AminiTehrani::default()).compile(&usual, &asked).unwrap_err();
    assert!(refused.to_string().contains("spread over angles"), "{refused}");
    let mut exponential = usual;
    exponential.heights = HeightDistribution::Exponential;
    let refused = gw.compile(&exponential, &asked).unwrap_err().to_string();
    assert!(refused.contains("heights must be Gaussian"), "{refused}");
}

/// Where height and curvature know nothing of each other, Hertz' laws are averaged over k alone: the
/// density of k with that over k_m in closed form, k³ exp(k²/2) erfc(k √3/2). \[derived\]
#[test]
fn in_the_limit_of_broad_surfaces_radii_stay_spread() {
    let moment = |power: i32| {
        // k = t² makes half powers smooth.
        let density = |t: f64| {
            let k = t * t;
            let tail = (0.5 * k * k).exp() * libm::erfc(0.75f64.sqrt() * k);
            2.0 * t * k.powi(3) * tail * t.powi(power)
        };
        gauss_kronrod(density, &[0.0, 1.0, 2.0, 4.5], 1e-12, 10_000).unwrap().value
    };
    // In units of √(m₄/3); GW has R = (3/8) √(π/m₄).
    let radius = 0.375 * (PI / 3.0).sqrt();
    let [all, half, whole] = [0, -1, -2].map(moment);
    let wanted = [half / all / radius.sqrt(), whole / all / radius];
    assert!((wanted[0] - 1.130).abs() < 5e-4 && (wanted[1] - 1.355).abs() < 5e-4, "{wanted:?}");
    let quantities = [Quantity::Force, Quantity::Area];
    let asked = Request::new(quantities);
    let random = RandomAsperities::new(GreenwoodWilliamson);
    let contacts = |bandwidth: f64| {
        let moments = ProfileMoments { m0: 1e-12, m2: 1e-4, m4: bandwidth * 1e4 };
        let surface = Surface::from_moments(&moments).unwrap();
        let scene = Scene::new(Interface::elastic(116e9, 0.31), surface, 3e-5);
        let one = GreenwoodWilliamson.compile(&scene, &asked).unwrap();
        [random.compile(&scene, &asked).unwrap(), one]
    };
    let [spread, one] = contacts(1e8);
    for height in [-1e-6, 0.0, 2e-6, 4e-6] {
        for (quantity, wanted) in quantities.into_iter().zip(wanted) {
            let [a, b] = [&spread, &one].map(|c| c.evaluate(quantity, above(height)).unwrap());
            let found = a.value() / b.value();
            // A summit's height and curvature are correlated by √(3/(2α)) = 1.2e-4.
            assert!((found / wanted - 1.0).abs() < 2e-3, "{quantity} {height}: {found} {wanted}");
        }
    }
    let [area, of_one] = contacts(1e6).map(|contact| {
        let load = 1e-6 * one.evaluate(Quantity::Force, above(0.0)).unwrap().value();
        contact.evaluate(Quantity::Area, At::Load(load)).unwrap().value()
    });
    assert!((area / of_one - wanted[1] / wanted[0]).abs() < 0.02, "{}", area / of_one);
}

#[test]
fn every_law_is_averaged_however_deep_its_parts_begin() {
    let moments = ProfileMoments { m0: 1e-12, m2: 1e-4, m4: 7.5e4 };
    let mut scene =
        Scene::new(Interface::new(1e11, 0.3, 1e9), Surface::from_moments(&moments).unwrap(), 1e-8);
    let usual = scene.plasticity_index().unwrap();
    let at = above(1e-6);
    let asked = Request::new([Quantity::Force]);
    let elastic = RandomAsperities::new(GreenwoodWilliamson).compile(&scene, &asked).unwrap();
    let elastic = elastic.evaluate(Quantity::Force, at).unwrap().value();
    for index in [0.05, 0.4, 1.0, 1.05, 30.0] {
        scene.interface.hardness = Some(1e9 * usual / index);
        for id in ["ceb", "zmc", "ke", "etsion", "jg", "af"] {
            let contact = models(id).1.compile(&scene, &asked).unwrap();
            let found = contact.evaluate(Quantity::Force, at);
            let ratio = found.unwrap_or_else(|e| panic!("{id} {index}: {e}")).value() / elastic;
            // What never yields is elastic, what always does is softer.
            let wanted = if index < 0.1 { 1.0 - 1e-4..1.0 + 1e-4 } else { 0.0..1.5 };
            assert!(wanted.contains(&ratio), "{id} {index}: {ratio}");
        }
    }
}

/// The hard cases: spectra as narrow as can be, and very broad ones.
#[test]
fn the_narrowest_and_the_broadest_surfaces_are_met() {
    let mut count = 0;
    for line in include_str!("../../../tests/reference/random_limits.csv").lines().skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let [alpha, height, wanted] = [0, 1, 3].map(|k| fields[k].parse::<f64>().unwrap());
        let moments = ProfileMoments { m0: 1e-12, m2: 1e-4, m4: alpha * 1e4 };
        let surface = Surface::from_moments(&moments).unwrap();
        let scene = Scene::new(Interface::elastic(1e11, 0.3), surface, 1.0);
        let quantity: Quantity = fields[2].parse().unwrap();
        let asked = Request::new([quantity]);
        let contact = RandomAsperities::new(GreenwoodWilliamson).compile(&scene, &asked).unwrap();
        let found = contact.evaluate(quantity, above(height * 1e-6)).unwrap();
        let error = (found.value() / wanted - 1.0).abs();
        assert!(error < 1e-10 && error <= found.relative_error() + 1e-15, "{line}: {found:?}");
        count += 1;
    }
    assert_eq!(count, 40);
}

#[test]
fn plasticity_indices_of_hundreds_are_answered() {
    for (hardness, m2, x) in [(1e8, 0.04, 0.0), (5.2918e7, 0.064_852_774, -4.19)] {
        let interface = Interface::new(1e11, 0.3, hardness);
        let moments = ProfileMoments { m0: 1e-12, m2, m4: 6.0 * m2 * m2 / 1e-12 };
        let surface = Surface::from_moments(&moments).unwrap();
        let scene = Scene::new(interface, surface, 1e-4);
        assert!(scene.plasticity_index().unwrap() > 400.0);
        for id in ["ke", "ceb", "jg", "zmc"] {
            let request = Request::new([Quantity::Force, Quantity::Area]).at([above(x * 1e-6)]);
            let found = models(id).1.solve(&scene, &request).unwrap();
            let [force, area] =
                [Quantity::Force, Quantity::Area].map(|q| found.values(q).unwrap()[0]);
            assert!(force > 0.0 && area > 0.0, "{id} {hardness}: {force} {area}");
            // Nearly all asperities are plastic: under these laws their mean pressure is H.
            if ["ke", "zmc"].contains(&id) {
                assert!((force / (hardness * area) - 1.0).abs() < 1e-5, "{id}: {force} {area}");
            }
        }
    }
}
