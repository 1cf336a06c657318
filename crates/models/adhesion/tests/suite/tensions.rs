//! Tensions, the pull-off and their loads, on smooth and rough surfaces and on steep heights.

use std::f64::consts::PI;

use crate::{SEPARATION, compiled, model, scene, work_of};
use asperity_adhesion::{PullOff, pull_off};
use asperity_core::{
    At, Contact, ContactEngine, ContactError, ContactModel, Evaluation, HeightDistribution,
    Heights, Interface, Quantity, Request, Scene, Surface,
};

#[test]
fn of_surfaces_next_to_smooth_all_asperities_pull_as_one() {
    // The higher the adhesion and the smoother the surface, the further out in σ_z the largest
    // tension is held: up to 4e6 σ_z here.
    for (work, height_std) in [(1.0, 1e-9), (1e2, 1e-10), (1e4, 1e-11)] {
        let mut scene = scene(work);
        scene.surface.asperity_height_std = height_std;
        let asked = Request::new([Quantity::Force, Quantity::Tangent]);
        let contact = SEPARATION.compile(&scene, &asked).unwrap();
        let held = pull_off(&*contact).unwrap().unwrap();
        // 3/2 π w_a R per asperity (JKR), less the effect of the spread of heights.
        let each = 1.5 * PI * work * scene.surface.asperity_radius;
        let share = -held.force.value() / (each * scene.asperities());
        assert!((0.9..1.0 + 1e-9).contains(&share), "{work}: {share} {held:?}");
        // In steps of a ten-thousandth around it no tension is larger.
        for k in -50..=50 {
            let s = held.separation.value * (1.0 + 1e-4 * f64::from(k));
            let there = contact.evaluate(Quantity::Force, s).unwrap();
            // That far out, the place of a zero slope is accurate to a few ten-thousandths, and the
            // force of the minimum to the square of that.
            let known = held.force.relative_error() + there.relative_error() + 1e-7;
            let least = held.force.value() * (1.0 + known);
            assert!(there.value() >= least, "{work} {k}: {there:?} {held:?}");
        }
    }
}

/// A contact that knows no pull-off.
#[derive(Debug)]
struct Without<'c>(&'c dyn Contact);

impl ContactEngine for Without<'_> {
    fn model(&self) -> &str {
        self.0.model()
    }

    fn scene(&self) -> &Scene {
        self.0.scene()
    }

    fn quantities(&self) -> &[Quantity] {
        self.0.quantities()
    }

    fn evaluate_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        self.0.evaluate_at(quantity, at)
    }
}

#[test]
fn a_pull_off_that_cannot_be_found_is_an_error_and_not_none() {
    let contact = compiled(&SEPARATION, &scene(work_of(1.0)), 1e-9);
    let error = pull_off(&Without(&*contact)).unwrap_err().to_string();
    assert!(error.contains("pull-off"), "{error}");
    let asked = Request::new([Quantity::Area]);
    let contact = SEPARATION.compile(&scene(work_of(1.0)), &asked).unwrap();
    assert!(matches!(pull_off(&*contact), Err(ContactError::NotRequested { .. })));
}

#[test]
fn tensions_between_nearly_smooth_surfaces_are_held_at_two_separations() {
    // w_p is 25 to 1600 asperity_height_std: the force turns that far out.
    for height_std in [3.3e-8, 2e-9, 8.3e-10, 5e-10] {
        let mut interface = Interface::elastic(1e6, 0.5);
        interface.work_of_adhesion = Some(0.05);
        let scene = Scene::new(interface, Surface::new(1e-4, 1e9, height_std), 1e-4);
        let contact = compiled(&SEPARATION, &scene, 1e-10);
        let force = |s: f64| contact.evaluate(Quantity::Force, s).unwrap().value();
        let held = pull_off(&*contact).unwrap().unwrap();
        let turn = held.separation.value;
        for share in [0.1, 0.5, 0.9, 0.99, 0.9999, 1.0 - 1e-8] {
            let tension = share * held.force.value();
            let found = contact.separations_at(tension).unwrap();
            let [low, high] = found[..] else { panic!("{height_std} {share}: {found:?}") };
            assert!(low.value < turn && turn < high.value, "{height_std} {share}: {found:?}");
            assert_eq!(contact.separation_at(tension).unwrap(), low);
            for s in [low, high] {
                let error = (force(s.value) / tension - 1.0).abs();
                assert!(error < 1e-9, "{height_std} {share} {s:?}: {error:.1e}");
            }
            // Farther out, no separation holds as much.
            let end = 2.2 * turn + 9.0;
            for k in 1..500 {
                let s = high.value + (end - high.value) * f64::from(k) / 500.0;
                assert!(force(s) > tension, "{height_std} {share}: {s}");
            }
        }
        assert!(contact.separations_at(1.001 * held.force.value()).is_err());
    }
}

/// 2(z - low) and 2(high - z) about a mode, which is declared or not.
#[derive(Debug)]
struct Triangular {
    mode: f64,
    end: f64,
    declared: Vec<f64>,
}

impl Heights for Triangular {
    fn name(&self) -> &str {
        "triangular"
    }

    fn ln_density(&self, z: f64) -> f64 {
        let Self { mode, end, .. } = *self;
        match z {
            z if z.abs() > end => f64::NEG_INFINITY,
            z if z < mode => ((z + end) / (end * (mode + end))).ln(),
            z => ((end - z) / (end * (end - mode))).ln(),
        }
    }

    fn support(&self) -> (f64, f64) {
        (-self.end, self.end)
    }

    fn breaks(&self) -> &[f64] {
        &self.declared
    }
}

fn triangular(std: f64, mode: f64, declared: bool) -> Scene {
    let mut interface = Interface::elastic(1e9, 0.5);
    interface.work_of_adhesion = Some(1.0);
    let mut scene = Scene::new(interface, Surface::new(1e-4, 1e9, std), 3e-5);
    let (mode, end) = (mode * std, 2.4 * std);
    let declared = if declared { vec![mode] } else { vec![] };
    scene.heights = HeightDistribution::other(Triangular { mode, end, declared });
    scene
}

#[test]
fn the_pull_off_needs_no_declared_kinks_of_the_heights() {
    for (std, mode) in [(1e-6, 0.3), (1e-6, -0.5), (1e-7, 1.0)] {
        let [declared, found] = [true, false].map(|declared| {
            let contact = compiled(&SEPARATION, &triangular(std, mode, declared), 1e-10);
            pull_off(&*contact).unwrap().unwrap()
        });
        let [a, b] = [declared, found].map(|p: PullOff| p.force.value());
        assert!((a / b - 1.0).abs() < 1e-9, "{std} {mode}: {declared:?} {found:?}");
    }
}

/// A triangle from -2 to 2 with this mode, scaled to a standard deviation of 1 um about its mean.
#[derive(Debug)]
struct Steep(f64);

impl Steep {
    fn scale(&self) -> f64 {
        ((12.0 + self.0 * self.0) / 18.0).sqrt() / 1e-6
    }
}

impl Heights for Steep {
    fn name(&self) -> &str {
        "steep"
    }

    fn ln_density(&self, z: f64) -> f64 {
        let (scale, mode) = (self.scale(), self.0);
        let density = match mode / 3.0 + scale * z {
            x if x.abs() > 2.0 => 0.0,
            x if x <= mode => 0.5 * (x + 2.0) / (mode + 2.0),
            x => 0.5 * (2.0 - x) / (2.0 - mode),
        };
        density.ln() + scale.ln()
    }

    fn support(&self) -> (f64, f64) {
        let at = |x: f64| (x - self.0 / 3.0) / self.scale();
        (at(-2.0), at(2.0))
    }
}

/// Its last ten-thousandth is hardly integrated next to its end.
#[test]
fn loads_next_to_the_last_contact_are_met_on_steep_ends() {
    let mut scene = triangular(1e-6, 1.0, true);
    scene.heights = HeightDistribution::other(Steep(1.9999));
    let contact = compiled(&SEPARATION, &scene, 1e-10);
    let last = 1.488_771_670_037_970_5;
    for below in [1e-6, 1e-4, 1e-3, 1e-2, 0.1, 0.3] {
        let s = last - below;
        let force = contact.evaluate(Quantity::Force, s).unwrap().value();
        let all = contact.separations_at(force).unwrap();
        assert!(all.iter().any(|found| (found.value - s).abs() < 1e-8), "{s}: {all:?}");
        let alone = if force < 0.0 { all.first() } else { all.last() };
        assert_eq!(alone, Some(&contact.separation_at(force).unwrap()), "{s}");
    }
    let found = pull_off(&*contact).unwrap().unwrap();
    let near = |step: f64| {
        contact.evaluate(Quantity::Force, found.separation.value + step).unwrap().value()
    };
    assert!(near(1e-3) > found.force.value() && near(-1e-3) > found.force.value(), "{found:?}");
}

/// On a rough surface with little adhesion the force is negative only far out in the tail of the
/// heights, by less than the range of f64.
#[test]
fn rough_surfaces_with_little_adhesion_have_no_pull_off() {
    let mut interface = Interface::elastic(115e9, 0.3);
    interface.work_of_adhesion = Some(0.05);
    let scene = Scene::new(interface, Surface::new(2e-4, 2e8, 1e-6), 1e-4);
    assert!(scene.adhesion_parameter().unwrap() > 1e4);
    for id in ["dmt", "jkr", "jkr-separation"] {
        let contact = model(id).compile(&scene, &Request::new([Quantity::Force])).unwrap();
        assert_eq!(pull_off(&*contact).unwrap(), None, "{id}");
    }
}
