//! Adhesive contacts against `tests/reference/adhesion.csv` (mpmath, over contact radii), published
//! numbers, and the model that is left without adhesion.
#![allow(clippy::unwrap_used, reason = "a test binary: a panic is the failure")]

use std::f64::consts::PI;

use asperity_adhesion::{
    DerjaguinMullerToporov, JkrBranch, JohnsonKendallRoberts, PullOff, pull_off,
};
use asperity_core::{
    At, Case, Contact, ContactError, ContactModel, Diagnostic, Evaluation, HeightDistribution,
    Heights, Interface, Quantity, Request, Scene, Severity, StandardisedHeights, Surface, Sweep,
    Tolerance,
};
use asperity_gw::GreenwoodWilliamson;

const APPROACH: JohnsonKendallRoberts = JohnsonKendallRoberts { branch: JkrBranch::Approach };
const SEPARATION: JohnsonKendallRoberts = JohnsonKendallRoberts { branch: JkrBranch::Separation };

fn model(id: &str) -> &'static dyn ContactModel {
    let models: [&'static dyn ContactModel; 3] = [&DerjaguinMullerToporov, &APPROACH, &SEPARATION];
    models.into_iter().find(|model| model.id() == id).unwrap()
}

/// E = 1 GPa, R = 0.1 mm, σ_z = 0.1 µm, a thousand asperities.
fn scene(work: f64) -> Scene {
    let mut interface = Interface::elastic(1e9, 0.5);
    interface.work_of_adhesion = Some(work);
    Scene::new(interface, Surface::new(1e-4, 1e9, 1e-7), 1e-6)
}

/// w_a at which θ = E σ_z^1.5/(w_a √R) is this.
fn work_of(theta: f64) -> f64 {
    1e9 * 1e-7f64.powf(1.5) / (theta * 1e-2)
}

fn compiled(model: &dyn ContactModel, scene: &Scene, tolerance: f64) -> Box<dyn Contact> {
    let asked = [Quantity::Force, Quantity::Tangent];
    let request = Request::new(asked).within(Tolerance::new(tolerance).unwrap());
    model.compile(scene, &request).unwrap()
}

#[test]
fn every_row_of_the_reference_is_met_by_every_way_of_asking() {
    let rows = include_str!("../../../tests/reference/adhesion.csv").lines().skip(1);
    let (mut count, mut failures) = (0, vec![]);
    for line in rows {
        let fields: Vec<&str> = line.split(',').collect();
        let [id, work, heights, s, quantity, value] = fields[..] else { panic!("{line}") };
        let [work, s, value] = [work, s, value].map(|n| n.parse::<f64>().unwrap());
        let quantity: Quantity = quantity.parse().unwrap();
        let mut scene = scene(work);
        if heights == "exponential" {
            scene.heights = HeightDistribution::Exponential;
        }
        let tight = Tolerance::new(1e-13).unwrap();
        let request = Request::new([quantity]).within(tight);
        let model = model(id);
        let contact = model.compile(&scene, &request).unwrap();
        let alone = model.solve(&scene, &request.clone().at([s])).unwrap();
        let run = contact.respond(&request.at([s, s + 0.125]));
        let case = Case::new(scene, s);
        let sweep = Sweep::new(model, &[quantity], tight);
        let found = [
            contact.evaluate(quantity, s).unwrap(),
            alone.columns[0].rows[0].clone().unwrap(),
            run.columns[0].rows[0].clone().unwrap(),
            sweep.evaluate_all(&[case.clone(), case])[1].clone().unwrap()[0],
        ];
        for (way, found) in found.into_iter().enumerate() {
            let error = (found.value() / value - 1.0).abs();
            count += 1;
            // Forces cancel near their zero, which the bound includes.
            let bound = found.relative_error();
            if error.is_nan() || error > bound || error > 1e-12 && bound < 1e-11 || bound > 1e-8 {
                failures.push(format!("{line}: way {way}, {error:.1e}, bound {bound:.1e}"));
            }
        }
    }
    assert!(failures.is_empty(), "{} of {count}:\n{}", failures.len(), failures.join("\n"));
    assert_eq!(count, 4 * 423);
}

#[test]
fn the_pull_off_of_dmt_has_the_published_numbers() {
    for (theta, wanted) in [
        (0.1, -0.911731803),
        (1.0, -0.545762293),
        (2.0, -0.345248071),
        (5.0, -0.101489854),
        (10.0, -0.0145629907),
    ] {
        let work = work_of(theta);
        let contact = compiled(&DerjaguinMullerToporov, &scene(work), 1e-12);
        let found = pull_off(&*contact).unwrap().unwrap();
        let unit = 2.0 * PI * work * 1e-4 * 1e3;
        // Nine printed digits.
        assert!((found.force.value() / unit / wanted - 1.0).abs() < 6e-9, "{theta}: {found:?}");
    }
    // Exponential heights: none beyond θ = 2√π.
    for (theta, sticks) in [(3.5, true), (3.6, false)] {
        let mut scene = scene(work_of(theta));
        scene.heights = HeightDistribution::Exponential;
        let found = pull_off(&*compiled(&DerjaguinMullerToporov, &scene, 1e-12)).unwrap();
        assert_eq!(found.is_some(), sticks, "{theta}: {found:?}");
    }
}

#[test]
fn the_separation_of_jkr_has_the_published_numbers() {
    // s = σ_z/(π² w_a² R/K²)^(1/3), K = 4E/3.
    let work_at = |s: f64| (1e-7 / s).powf(1.5) * (4.0 / 3.0 * 1e9) / (PI * 1e-2);
    for (s, wanted) in
        [(0.1, -0.9925108), (0.5, -0.779769593), (1.0, -0.451899803), (2.0, -0.107585156)]
    {
        let work = work_at(s);
        let contact = compiled(&SEPARATION, &scene(work), 1e-12);
        let found = pull_off(&*contact).unwrap().unwrap();
        let unit = 1.5 * PI * work * 1e-4 * 1e3;
        let printed = if s < 0.2 { 6e-8 } else { 6e-9 };
        assert!((found.force.value() / unit / wanted - 1.0).abs() < printed, "{s}: {found:?}");
    }
    let work = work_at(1.0);
    let contact = compiled(&SEPARATION, &scene(work), 1e-12);
    for (t, wanted) in [(0.0, -0.617626136423), (1.0, -0.544636614248), (2.0, -0.179832175941)] {
        let found = contact.evaluate(Quantity::Force, t).unwrap().value();
        let found = found / (1e3 * PI * work * 1e-4);
        assert!((found / wanted - 1.0).abs() < 5e-12, "{t}: {found}");
    }
}

#[test]
fn without_adhesion_all_are_gw_and_with_little_nearly() {
    let asked = [Quantity::Force, Quantity::Area, Quantity::Contacts, Quantity::Tangent];
    let asked = Request::new(asked).within(Tolerance::new(1e-13).unwrap()).at([-3.0, 0.0, 2.0]);
    let gw = GreenwoodWilliamson.solve(&scene(0.0), &asked).unwrap();
    for id in ["dmt", "jkr", "jkr-separation"] {
        // JKR's w is off by √(2π w_a a/E): 1.4e-6 σ_z for the second.
        for (work, within) in [(0.0, 1e-15), (1e-30, 1e-13), (1e-12, 1e-5)] {
            let found = model(id).solve(&scene(work), &asked).unwrap();
            for (found, wanted) in found.columns.iter().zip(&gw.columns) {
                for (found, wanted) in found.rows.iter().zip(&wanted.rows) {
                    let ratio = found.as_ref().unwrap().value() / wanted.as_ref().unwrap().value();
                    assert!((ratio - 1.0).abs() < within, "{id} {work}: {ratio}");
                }
            }
        }
        let contact = compiled(model(id), &scene(0.0), 1e-10);
        assert_eq!(pull_off(&*contact).unwrap(), None, "{id}");
        let refused = contact.separation_at(-1e-3).unwrap_err().to_string();
        assert!(refused.contains("load is -0.001: a finite number above 0"), "{refused}");
    }
}

#[test]
fn loads_and_tensions_lead_back_to_all_their_separations() {
    for work in [0.3, 3.0, 1e4] {
        for id in ["dmt", "jkr", "jkr-separation"] {
            let contact = compiled(model(id), &scene(work), 1e-12);
            let force = |s: f64| contact.evaluate(Quantity::Force, s).unwrap().value();
            let PullOff { force: least, separation } = pull_off(&*contact).unwrap().unwrap();
            let least = least.value();
            let tension = 0.5 * least;
            let found = contact.separations_at(tension).unwrap();
            assert_eq!(found.len(), 2, "{id} {work}: {found:?}");
            assert!(found[0].value < separation.value && separation.value < found[1].value);
            // Pulled from contact, the stable one comes first.
            assert_eq!(contact.separation_at(tension).unwrap(), found[0]);
            let slopes = Request::new([Quantity::Tangent]);
            let slopes = model(id).compile(&scene(work), &slopes).unwrap();
            let [stable, unstable] =
                [0, 1].map(|k| slopes.evaluate(Quantity::Tangent, found[k]).unwrap().value());
            assert!(stable > 0.0 && unstable < 0.0, "{id} {work}: {stable} {unstable}");
            for s in &found {
                let error = (force(s.value) / tension - 1.0).abs();
                assert!(error < 1e-7, "{id} {work} {s:?}: {error:.1e}");
            }
            for load in [1e-9, 1e-3, 10.0] {
                let found = contact.separations_at(load).unwrap();
                assert_eq!(found.len(), 1, "{id} {work} {load}: {found:?}");
                let near = 1e-9 * (1.0 + separation.value.abs());
                let [closer, farther] = [-near, near].map(|by| force(found[0].value + by));
                assert!(closer > load && farther < load, "{id} {work} {load}: {closer} {farther}");
            }
            // As a row, and in a sweep of one.
            let request = Request::new([Quantity::Force]).at_loads([tension]);
            let row = model(id).solve(&scene(work), &request).unwrap();
            assert!((row.values(Quantity::Force).unwrap()[0] / tension - 1.0).abs() < 1e-6);
            let refused = contact.separations_at(1.01 * least).unwrap_err();
            let ContactError::OutOfReach { largest, .. } = refused else { panic!("{refused}") };
            assert!((largest / least - 1.0).abs() < 1e-9, "{id} {work}: {largest} {least}");
            assert!(refused.to_string().contains("the surfaces pull off at -"), "{refused}");
        }
    }
}

#[test]
fn approach_and_separation_differ_by_what_a_loop_loses() {
    // One is above the other wherever the last contacts hold, and both meet under pressure.
    let scene = scene(3.0);
    let [approach, separation] = [APPROACH, SEPARATION].map(|m| compiled(&m, &scene, 1e-12));
    let at = |contact: &dyn Contact, s: f64| contact.evaluate(Quantity::Force, s).unwrap().value();
    for s in [-1.0, 0.0, 1.0, 3.0] {
        assert!(at(&*approach, s) > at(&*separation, s), "{s}");
    }
    // Contacts that exist on both branches are the same: far below, all of them.
    let [a, b] = [&approach, &separation].map(|contact| at(&**contact, -14.0));
    assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
}

#[test]
fn tensions_are_told_and_what_is_missing_is_named() {
    let asked = Request::new([Quantity::Pressure, Quantity::Force]).at([-6.0, 1.0, 2.0]);
    for id in ["dmt", "jkr"] {
        let answer = model(id).solve(&scene(3.0), &asked).unwrap();
        let [warning] = &answer.warnings[..] else { panic!("{:?}", answer.warnings) };
        assert!(
            warning.code == "adhesion" && warning.count == 2 && warning.at == Some(At::from(1.0)),
            "{warning:?}"
        );
        assert!(warning.to_string().ends_with("the surfaces attract each other there"));
        let mut bare = scene(0.0);
        bare.interface.work_of_adhesion = None;
        let refused = model(id).solve(&bare, &asked).unwrap_err().to_string();
        assert!(refused.starts_with("work_of_adhesion is missing: "), "{refused}");
        for (load, wanted) in
            [(0.0, "load is 0.0: a finite number other than 0"), (f64::NAN, "load")]
        {
            let contact = compiled(model(id), &scene(0.03), 1e-10);
            let refused = contact.separations_at(load).unwrap_err().to_string();
            assert!(refused.starts_with(wanted), "{refused}");
        }
    }
}

#[test]
fn works_in_another_unit_are_asked_about_and_tabors_parameter_is_told() {
    let check = scene(50.0).check().unwrap();
    let found: Vec<&Diagnostic> =
        check.findings.iter().filter(|f| f.field == "work_of_adhesion").collect();
    let [finding] = found[..] else { panic!("{:?}", check.findings) };
    assert_eq!((finding.code, finding.severity), ("unusual-size", Severity::Warning));
    assert!(finding.message().ends_with("50 looks like mJ/m2; 50 mJ/m2 is 0.05 J/m2"), "{finding}");
    let check = scene(0.05).check().unwrap();
    assert!(!check.findings.iter().any(|f| f.field == "work_of_adhesion"), "{:?}", check.findings);
    // (1e-4 · 0.0025/(1e18 · 2.7e-29))^(1/3), and 1e9 · 1e-10.5/(0.05 · 0.01).
    let number = |name| check.number(name).unwrap();
    assert!((number("tabor_parameter") / 9_259.259_259_259_26f64.cbrt() - 1.0).abs() < 1e-12);
    assert!((number("adhesion_parameter") / 63.245_553_203_367_6 - 1.0).abs() < 1e-12);
    let none = scene(0.0).check().unwrap();
    assert_eq!(
        (none.number("tabor_parameter"), none.number("adhesion_parameter")),
        (Some(0.0), None)
    );
}

#[test]
fn far_from_the_mean_the_bound_knows_how_a_separation_rounds() {
    // w_p is 4e6 σ_z: one unit in the last place of s moves the count by 3e-10.
    let mut scene = scene(1e4);
    scene.surface.asperity_height_std = 1e-11;
    let asked = Request::new([Quantity::Contacts]).within(Tolerance::new(1e-13).unwrap());
    let contact = SEPARATION.compile(&scene, &asked).unwrap();
    let half = |s: f64| contact.evaluate(Quantity::Contacts, s).unwrap();
    let (mut low, mut high) = (0.0, 1e7);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if half(middle).value() > 500.0 { low = middle } else { high = middle }
    }
    assert!(low > 1e5, "{low}");
    let (one, next) = (half(low + 5.0), half((low + 5.0).next_up()));
    let moved = (one.value() / next.value() - 1.0).abs();
    let known = one.relative_error() + next.relative_error();
    assert!(moved > 1e-11 && moved < known && known < 100.0 * moved, "{moved:e} {known:e}");
}

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

impl Contact for Without<'_> {
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
            for k in 1..4000 {
                let s = high.value + (end - high.value) * f64::from(k) / 4000.0;
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

/// The triangle of statrs, whose last ten-thousandth is hardly integrated next to its end.
#[test]
fn loads_next_to_the_last_contact_are_met_on_steep_ends() {
    let mut scene = triangular(1e-6, 1.0, true);
    let steep = statrs::distribution::Triangular::new(-2.0, 2.0, 1.9999).unwrap();
    let steep = StandardisedHeights::new("steep", steep, 1e-6).unwrap();
    scene.heights = HeightDistribution::other(steep);
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
