//! Every separation that carries a load, against a scan of the force in steps far narrower than its
//! features.

use asperity::{
    Contact, ContactError, ContactModel, HeightDistribution, Interface, Quantity, Request, Scene,
    Surface, TabulatedHeights, Tolerance, WeibullHeights,
};

use crate::scenes::model;
use crate::{is_long, one_of};

/// Evenly distributed numbers from 0 to 1.
struct Spread(f64);

impl Spread {
    fn next(&mut self) -> f64 {
        self.0 = (self.0 * 1.000_1 + 0.618_033_988_749_894_9).fract();
        (self.0 * 7_919.0).fract()
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[(self.next() * all.len() as f64) as usize]
    }
}

/// Heights with about this standard deviation.
fn heights(name: &str, unit: f64, spread: &mut Spread) -> HeightDistribution {
    let table = |name: &str, points: &[(f64, f64)]| {
        let points: Vec<(f64, f64)> = points.iter().map(|(z, p)| (z * unit, *p)).collect();
        HeightDistribution::other(TabulatedHeights::new(name, &points).unwrap())
    };
    match name {
        "gaussian" => HeightDistribution::Gaussian,
        "exponential" => HeightDistribution::Exponential,
        "weibull" => {
            let skewness = spread.between(-0.9, 0.9);
            HeightDistribution::Weibull(WeibullHeights::new(skewness).unwrap())
        }
        "uniform" => table(name, &[(-3f64.sqrt(), 1.0), (3f64.sqrt(), 1.0)]),
        "triangular" => {
            let mode = spread.between(-2.0, 2.0);
            table(name, &[(-2.4, 0.0), (mode, 1.0), (2.4, 0.0)])
        }
        _ => {
            let (a, b) = (spread.between(-1.5, 0.0), spread.between(0.2, 1.5));
            let width = 10f64.powf(spread.between(-2.0, -0.5));
            let peak = |at: f64| [(at - width, 0.0), (at, 1.0), (at + width, 0.0)];
            table(name, &[peak(a), peak(b)].concat())
        }
    }
}

const HEIGHTS: [&str; 6] =
    ["gaussian", "exponential", "weibull", "uniform", "triangular", "narrow peaks"];

/// The cells of a scan between -80 and `top` in which the force crosses the load.
fn scan(contact: &dyn Contact, load: f64, top: f64) -> Vec<(f64, f64)> {
    const COUNT: usize = 6_000;
    // Narrow cells above -8, wider and wider ones below.
    let place = |k: usize| {
        let u = k as f64 / COUNT as f64;
        if u < 0.8 { -8.0 + (top + 8.0) * (u / 0.8) } else { -8.0 - 72.0 * ((u - 0.8) / 0.2) }
    };
    let mut s: Vec<f64> = (0..=COUNT).map(place).collect();
    s.sort_by(f64::total_cmp);
    let mut force = vec![0.0; s.len()];
    contact.fill(&[Quantity::Force], &s, &mut [&mut force[..]]).unwrap();
    let crosses = |k: &usize| (force[*k] >= load) != (force[k + 1] >= load);
    (0..COUNT).filter(crosses).map(|k| (s[k], s[k + 1])).collect()
}

/// The fault of the separations of a load, if any.
pub(crate) fn wrong(contact: &dyn Contact, load: f64) -> Option<String> {
    let top = 16.0;
    let wanted = scan(contact, load, top);
    let one = contact.separation_at(load);
    let all = match (contact.separations_at(load), &one) {
        (Ok(all), Ok(one)) if all.last() == Some(one) && load > 0.0 => all,
        // Of a tension, the stable one.
        (Ok(all), Ok(one)) if all.first() == Some(one) && load < 0.0 => all,
        (Err(_), Err(_)) if wanted.is_empty() => return None,
        (all, one) => return Some(format!("{one:?} but {all:?}; scan {wanted:?}")),
    };
    let s: Vec<f64> = all.iter().map(|s| s.value).collect();
    let hair = |s: f64| 1e-7 * (1.0 + s.abs());
    let near = |(a, b): &(f64, f64)| s.iter().any(|s| *s >= a - hair(*a) && *s <= b + hair(*b));
    if !wanted.iter().all(near) {
        return Some(format!("found {s:?}; scan {wanted:?}"));
    }
    let force = |s: f64| contact.evaluate(Quantity::Force, s).unwrap();
    for s in s {
        let at = force(s);
        // At a jump, neither floating-point neighbour meets the load.
        let (lower, upper) = (force(s - hair(s)).value(), force(s + hair(s)).value());
        let met = (at.value() / load - 1.0).abs() <= at.relative_error() + 1e-9;
        if !met && (lower >= load) == (upper >= load) {
            return Some(format!("at {s} the force is {:e}", at.value()));
        }
    }
    None
}

#[test]
fn no_crossing_is_missed_on_any_heights() {
    let count = if is_long() { 48 } else { 6 };
    let mut spread = Spread(0.123);
    let mut failures = vec![];
    let mut several = 0;
    for k in 0..count {
        let ids =
            ["at", "at", "at", "at", "jg", "zmc", "ke", "etsion", "dmt", "jkr", "jkr-separation"];
        let id = spread.of(&ids);
        let name = HEIGHTS[k % HEIGHTS.len()];
        let index = spread.between(0.8, 6.5);
        let Scene { mut interface, mut surface, .. } =
            printed(1.12e9, spread.between(1e10, 6e10), index);
        let adhesive = matches!(id, "dmt" | "jkr" | "jkr-separation");
        if adhesive {
            interface = Interface::elastic(1e9, 0.5);
            interface.work_of_adhesion = Some(10f64.powf(spread.between(-1.0, 1.6)));
            surface = Surface::new(1e-4, 1e9, 1e-6);
        }
        let mut scene = Scene::new(interface, surface, 3e-5);
        scene.heights = heights(name, surface.asperity_height_std, &mut spread);
        let request = Request::new([Quantity::Force]).within(Tolerance::new(1e-9).unwrap());
        let contact = model(id).compile(&scene, &request).unwrap();
        // A light load, or a force of the scene, which may be tensile.
        let mut load = 10f64.powf(spread.between(-8.0, 3.0));
        if adhesive {
            let from = spread.between(-1.0, 2.5);
            let force = contact.evaluate(Quantity::Force, from).unwrap().value();
            load = if force == 0.0 { load } else { force * spread.of(&[1.0, 0.3, 0.01]) };
        }
        several += usize::from(contact.separations_at(load).is_ok_and(|all| all.len() > 1));
        let found = wrong(&*contact, load).map(|w| format!("{k} {id} {name} {load:e}: {w}"));
        failures.extend(found);
    }
    assert!(failures.is_empty(), "{} of {count}\n{}", failures.len(), failures.join("\n"));
    assert!(6 * several >= count, "{several}");
}

/// The AT paper's materials with this hardness, and the roughness of this plasticity index.
fn printed(hardness: f64, shear: f64, index: f64) -> Scene {
    let mut interface = Interface::new(116e9, 0.31, hardness);
    interface.equivalent_shear_modulus = Some(shear);
    interface.pressure_factor = Some(0.58);
    let surface = Surface::from_plasticity_index(index, 0.04, 1e-6, &interface).unwrap();
    Scene::new(interface, surface, 3e-5)
}

fn compiled(id: &str, scene: &Scene) -> Box<dyn Contact> {
    model(id).compile(scene, &Request::new([Quantity::Force, Quantity::Area])).unwrap()
}

#[test]
fn the_first_contact_of_at_on_uniform_heights_is_found() {
    let mut scene = printed(1.12e9, 41e9, 6.0);
    let width = 3f64.sqrt() * 1e-6;
    let points = [(-width, 1.0), (width, 1.0)];
    scene.heights = HeightDistribution::other(TabulatedHeights::new("flat", &points).unwrap());
    let contact = compiled("at", &scene);
    // The force crosses the load at 1.7156 and again at 1.6635, less than a tenth farther down.
    let all = contact.separations_at(0.03).unwrap();
    assert_eq!(wrong(&*contact, 0.03), None);
    assert!(all.len() >= 3 && (all[all.len() - 1].value - 1.715_617_5).abs() < 1e-4, "{all:?}");
    // Both by a single row and by the compiled scene.
    let request = Request::new([Quantity::Area]).at_loads([0.03]);
    let row = model("at").solve(&scene, &request).unwrap().values(Quantity::Area).unwrap()[0];
    let area = contact.evaluate(Quantity::Area, *all.last().unwrap()).unwrap().value();
    assert!((row / area - 1.0).abs() < 1e-6, "{row} {area}");
}

#[test]
fn searches_for_one_and_for_all_separations_agree() {
    let mut exponential =
        printed(3_503_986_977.996_206_3, 10_564_220_552.024_988, 2.348_382_271_637_265);
    exponential.heights = HeightDistribution::Exponential;
    let mut weibull = printed(54_795_688.220_055_17, 43_460_555_176.572_68, 0.655_933_822_3);
    weibull.heights =
        HeightDistribution::Weibull(WeibullHeights::new(-0.002_243_123_609_956_265_7).unwrap());
    let [of_exponential, of_weibull] =
        [[2.136_927e-5, 1.29, 318.0, 5e4], [1.54e-8, 1e-3, 1.0, 56.3587]];
    for (scene, loads) in [(exponential, of_exponential), (weibull, of_weibull)] {
        let contact = compiled("at", &scene);
        for load in one_of(2, loads) {
            let found = wrong(&*contact, load);
            assert_eq!(found, None, "{load}");
            // A single row is refused if the compiled scene refuses.
            let row = model("at").solve(&scene, &Request::new([Quantity::Area]).at_loads([load]));
            let row = row.unwrap().values(Quantity::Area);
            assert_eq!(
                row.is_ok_and(|v| v[0].is_finite()),
                contact.separation_at(load).is_ok(),
                "{load}"
            );
        }
    }
}

/// The largest force of a scan from -1e6 to 20, and its separation.
fn largest(contact: &dyn Contact) -> (f64, f64) {
    let deep = (0..4000).map(|k| -10f64.powf(f64::from(k) * 6.0 / 3999.0));
    let s: Vec<f64> = deep.chain((0..4000).map(|k| -1.0 + 21.0 * f64::from(k) / 4000.0)).collect();
    let force = s.iter().map(|s| contact.evaluate(Quantity::Force, *s).unwrap().value());
    force.zip(s.iter().copied()).fold((0.0, 0.0), |a, b| if b.0 > a.0 { b } else { a })
}

#[test]
fn a_refusal_names_the_largest_force() {
    // S_y/E = 0.17: the force of JG rises by far below -64 sigma, and falls again.
    let (e, nu) = (1e11, 0.377_946_684_464_134);
    let yields = 0.167_563_888_010_807_54 * e;
    let mut interface = Interface::new(e, nu, 2.8 * yields);
    interface.yield_strength = Some(yields);
    let c: f64 = 1.295 * (0.736 * nu).exp();
    let critical = (std::f64::consts::PI * c * yields / (2.0 * e)).powi(2) * 1e-4;
    let std = 0.972_476_620_558_971_4 * critical;
    let jg = Scene::new(interface, Surface::new(1e-4, 1e9, std), 1e-4);
    let mut at = printed(3_503_986_977.996_206_3, 10_564_220_552.024_988, 2.348_382_271_637_265);
    at.heights = HeightDistribution::Exponential;
    for (id, scene) in [("jg", jg), ("at", at)] {
        let contact = compiled(id, &scene);
        let (peak, at) = largest(&*contact);
        assert!(peak > 1e4, "{id}: {peak:e}");
        for share in one_of(2, [1e-6, 1e-3, 0.9, 0.99, 0.999]) {
            assert_eq!(
                wrong_deep(&*contact, share * peak),
                None,
                "{id} {share} of {peak:e} at {at}"
            );
        }
        match contact.separation_at(1e3 * peak) {
            Err(ContactError::OutOfReach { largest, .. }) => {
                assert!(largest >= peak && largest < 1.001 * peak, "{id}: {largest:e} {peak:e}");
            }
            other => panic!("{id}: {other:?}"),
        }
    }
}

/// The fault of the separation of a load far below 0, if any.
fn wrong_deep(contact: &dyn Contact, load: f64) -> Option<String> {
    let one = match contact.separation_at(load) {
        Ok(one) => one,
        Err(error) => return Some(error.to_string()),
    };
    let all = contact.separations_at(load).unwrap();
    let force = contact.evaluate(Quantity::Force, one).unwrap().value();
    let right = all.last() == Some(&one) && (force / load - 1.0).abs() < 1e-6;
    (!right).then(|| format!("{one:?} {all:?} {force}"))
}

/// A search that starts far from the root meets separations above nearly all heights.
#[test]
fn loads_on_heights_with_a_light_tail_are_met() {
    let mut scene =
        Scene::new(Interface::new(116e9, 0.31, 1.12e9), Surface::new(3.59e-4, 1.11e8, 1e-6), 3e-5);
    scene.heights = HeightDistribution::Weibull(WeibullHeights::new(-1.0).unwrap());
    let contact = model("gw").compile(&scene, &Request::new([Quantity::Force])).unwrap();
    for s in [-300.0, -100.8, -60.0, -5.0, 0.0, 1.5] {
        let load = contact.evaluate(Quantity::Force, s).unwrap().value();
        let found = contact.separation_at(load).unwrap().value;
        assert!((found - s).abs() <= 1e-8 * (1.0 + s.abs()), "{s}: {found}");
        assert_eq!(contact.separations_at(load).unwrap().len(), 1, "{s}");
    }
}
