//! Only requested quantities are computed.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use asperity::{
    AngleDensity, Asperities, Asperity, AsperityModel, At, Case, Check, Contact, ContactError,
    ContactModel, Formula, HeightDistribution, Law, Model, ObliqueContact, Power, Quantity,
    Request, Scene, Sweep, Tolerance, angle_average,
};

use crate::scenes::{described, named, with_index};

described!(Spy, LateralSpy, SignedSpy);

/// A law with a power part to x = 1 and a counted function beyond, like a user's law.
#[derive(Debug, Clone, Default)]
struct Spy {
    /// The quantities of the requested laws.
    laws: Arc<Mutex<Vec<Quantity>>>,
    /// Number of samples of the function part.
    samples: Arc<AtomicUsize>,
    /// Whether the stiffness is a law of its own.
    own_stiffness: bool,
}

impl Spy {
    fn asked(&self) -> Vec<Quantity> {
        self.laws.lock().unwrap().clone()
    }

    fn samples(&self) -> usize {
        self.samples.load(Ordering::Relaxed)
    }

    fn compile(&self, scene: &Scene, quantities: &[Quantity]) -> Box<dyn Contact> {
        let request = Request::new(quantities.iter().copied());
        ContactModel::compile(self, scene, &request).unwrap()
    }
}

impl AsperityModel for Spy {
    fn force(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        self.law(asperity, Quantity::Force)
    }

    fn area(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        self.law(asperity, Quantity::Area)
    }

    fn stiffness(&self, asperity: &Asperity, _: Tolerance) -> Result<Option<Law>, ContactError> {
        self.own_stiffness.then(|| self.law(asperity, Quantity::Stiffness)).transpose()
    }
}

impl Spy {
    fn law(&self, asperity: &Asperity, quantity: Quantity) -> Result<Law, ContactError> {
        self.laws.lock().unwrap().push(quantity);
        let samples = self.samples.clone();
        let beyond = Formula::function(move |x| {
            samples.fetch_add(1, Ordering::Relaxed);
            x * x.ln_1p()
        });
        Ok(Law::in_units(asperity.critical_interference()?, 1.0)
            .elastic(0.0..1.0, [Power::new(1.0, 1.5)])
            .plastic(1.0..f64::INFINITY, beyond))
    }
}

#[test]
fn only_the_laws_of_requested_quantities_are_built() {
    let (f, a, k, t) = (Quantity::Force, Quantity::Area, Quantity::Stiffness, Quantity::Tangent);
    for (asked, own_stiffness, laws) in [
        (vec![a], false, vec![a]),
        (vec![f], false, vec![f]),
        (vec![t], false, vec![f]),
        (vec![k, t, f], false, vec![f]),
        (vec![t, a, k], false, vec![f, a]),
        (vec![a, k], true, vec![a, k]),
        (vec![k, t, f, k], true, vec![k, f]),
        (vec![], false, vec![]),
    ] {
        let spy = Spy { own_stiffness, ..Spy::default() };
        let compiled = spy.compile(&named("mild"), &asked);
        assert!(spy.asked() == laws, "{asked:?}: {:?}", spy.asked());
        // Values need no further law, and nothing was sampled before.
        assert!(spy.samples() == 0, "compiling samples nothing");
        for quantity in asked {
            compiled.evaluate(quantity, 1.0).unwrap();
        }
        assert!(spy.asked() == laws);
    }
}

#[test]
fn nothing_is_integrated_after_preparation() {
    let spy = Spy::default();
    let compiled = spy.compile(&with_index(2.0), &[Quantity::Force, Quantity::Tangent]);
    compiled.prepare(-5.0, 6.0).unwrap();
    let prepared = spy.samples();
    assert!(prepared > 0);
    for k in 0..=1100 {
        compiled.force_and_tangent(-5.0 + 0.01 * f64::from(k)).unwrap();
    }
    assert!(spy.samples() == prepared, "{} {prepared}", spy.samples());
    compiled.evaluate(Quantity::Force, -6.5).unwrap();
    assert!(spy.samples() > prepared);
    assert!(compiled.prepare(1.0, 0.0).is_err() && compiled.prepare(f64::NAN, 1.0).is_err());
}

#[test]
fn regimes_out_of_reach_are_not_sampled() {
    let spy = Spy::default();
    // ψ = 0.5: w_c is 4 σ_z, so that yielding begins at heights of d + 4.
    let compiled = spy.compile(&with_index(0.5), &[Quantity::Force]);
    for separation in [20.0, 60.0, 1e4] {
        // At d = 20 the density at d + 4 is exp(-88) of that at d, below the cut of exp(-46).
        assert!(compiled.evaluate(Quantity::Force, separation).unwrap().scaled > 0.0);
        assert!(spy.samples() == 0, "{} samples at {separation}", spy.samples());
    }
    compiled.evaluate(Quantity::Force, 2.0).unwrap();
    let near = spy.samples();
    assert!(near > 0);
    // A rule serves its neighbourhood: the same or a close separation needs no further sample.
    compiled.evaluate(Quantity::Force, 2.0).unwrap();
    compiled.evaluate(Quantity::Force, 2.001).unwrap();
    assert!(spy.samples() == near, "{} {near}", spy.samples());
}

#[test]
fn shares_are_computed_when_requested_and_once() {
    let spy = Spy::default();
    let request = Request::new([Quantity::Force]).at([0.5]);
    let compiled = ContactModel::compile(&spy, &with_index(2.0), &request).unwrap();
    assert!(compiled.respond(&request).columns[0].rows[0].is_ok());
    let value_only = spy.samples();
    assert!(value_only > 0);
    let shares = compiled.shares(Quantity::Force, 0.5).unwrap();
    let with_shares = spy.samples();
    assert!(with_shares > value_only);
    let total: f64 = shares.iter().map(|s| s.share).sum();
    // The request's tolerance of 1e-10, for each of three integrals.
    assert!(shares.len() == 2 && (total - 1.0).abs() < 3e-10, "{shares:?}");
    compiled.shares(Quantity::Force, 0.5).unwrap();
    assert!(spy.samples() == with_shares);
    assert!(spy.asked() == [Quantity::Force]);
}

/// What a program does for a load: judge the answer, show the separation, answer.
#[test]
fn a_load_is_compiled_and_inverted_once() {
    let (spy, scene) = (Spy::default(), with_index(2.0));
    let load = At::Load(100.0);
    let request = Request::new(Quantity::JUDGED).at([load]);
    let contact = spy.contact(&scene, &request).unwrap();
    let laws = spy.asked();
    assert!(laws == [Quantity::Force, Quantity::Area], "{laws:?}");
    contact.separation(load).unwrap();
    let inverted = spy.samples();
    contact.separation(load).unwrap();
    assert!(inverted > 0 && spy.samples() == inverted, "{inverted} {}", spy.samples());
    let _ = Check::answers(&spy, &scene, Some(&*contact), &[load]);
    let judged = spy.samples() - inverted;
    let _ = contact.respond(&request);
    let answered = spy.samples() - inverted - judged;
    assert!(spy.asked() == laws, "compiled again for {:?}", spy.asked());
    // Without inversion, an answer takes its two integrals, at one separation.
    let place = contact.separation(load).unwrap();
    let there = Spy::default();
    there.solve(&scene, &Request::new(Quantity::JUDGED).at([place])).unwrap();
    assert!(judged <= there.samples(), "{judged} {}", there.samples());
    assert!(answered <= there.samples(), "{answered} {}", there.samples());
}

#[test]
fn moving_a_compiled_scene_keeps_its_laws() {
    let spy = Spy::default();
    let rough = with_index(2.0);
    let compiled = spy.compile(&rough, &[Quantity::Force, Quantity::Area]);
    let mut other = with_index(3.0);
    other.surface.asperity_density *= 2.0;
    other.nominal_area *= 3.0;
    other.heights = HeightDistribution::Exponential;
    let moved = compiled.on(&other).unwrap();
    assert!(spy.asked() == [Quantity::Force, Quantity::Area], "{:?}", spy.asked());
    assert!(spy.samples() == 0, "moving samples nothing");
    let anew = Spy::default().compile(&other, &[Quantity::Force, Quantity::Area]);
    for quantity in [Quantity::Force, Quantity::Area] {
        let [a, b] = [&moved, &anew].map(|c| c.evaluate(quantity, 0.3).unwrap());
        assert!(a == b, "{quantity}: {a:?} {b:?}");
    }
    assert!(spy.asked().len() == 2);
}

/// An oblique contact that counts its averages, the costly part of a lateral model.
struct Counted(Arc<AtomicUsize>);

impl ObliqueContact for Counted {
    fn means(&self, y: f64, gaps: &[f64], _: f64, out: &mut [f64]) -> f64 {
        self.0.fetch_add(gaps.len(), Ordering::Relaxed);
        out.fill(y * y.sqrt());
        0.0
    }

    fn corners(&self, _: f64) -> [f64; 3] {
        [f64::INFINITY; 3]
    }
}

#[derive(Debug)]
struct LateralSpy(Arc<AtomicUsize>);

impl AsperityModel for LateralSpy {
    fn force(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        let contact = Arc::new(Counted(self.0.clone()));
        let all = 0.0..f64::INFINITY;
        let density = AngleDensity::default();
        let (form, _) = angle_average(contact, all.clone(), density, tolerance.relative());
        Ok(Law::in_units(asperity.critical_interference()?, 1.0).elastic(all, form))
    }

    fn area(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        self.force(asperity, tolerance)
    }
}

#[test]
fn tables_of_a_lateral_law_move_to_another_scene() {
    let averages = Arc::new(AtomicUsize::new(0));
    let request = Request::new([Quantity::Force]);
    let evaluate = |compiled: &dyn Contact| {
        compiled.evaluate(Quantity::Force, 0.0).unwrap();
        averages.load(Ordering::Relaxed)
    };
    let first = LateralSpy(averages.clone()).compile(&with_index(6.0), &request).unwrap();
    let building = evaluate(&*first);
    assert!(building > 1000, "{building}");
    // Half as rough: the same x, and a few new cells of smaller x.
    let moved = evaluate(&*first.on(&with_index(6.0 / 2f64.sqrt())).unwrap());
    assert!(moved - building < building / 5, "{moved} after {building}");
    // The same roughness with other numbers of asperities: no new average.
    let mut scene = with_index(6.0);
    scene.nominal_area *= 7.0;
    let again = evaluate(&*first.on(&scene).unwrap());
    assert!(again == moved, "{again} after {moved}");
    let anew = LateralSpy(averages.clone()).compile(&with_index(6.0), &request).unwrap();
    assert!(evaluate(&*anew) - again == building);
}

#[test]
fn a_lateral_law_that_is_integrated_once_is_not_tabulated() {
    let averages = Arc::new(AtomicUsize::new(0));
    let model = LateralSpy(averages.clone());
    let scene = with_index(6.0);
    let request = Request::new([Quantity::Force]);
    let compiled = model.compile(&scene, &request).unwrap().evaluate(Quantity::Force, 1.0).unwrap();
    let tabulating = averages.swap(0, Ordering::Relaxed);
    let sweep = Sweep::new(&model, &[Quantity::Force], Tolerance::default());
    let once = sweep.evaluate(&Case::new(scene.clone(), 1.0)).unwrap()[0];
    let single = averages.swap(0, Ordering::Relaxed);
    assert!(single < tabulating / 3, "{single} averages, {tabulating} for tables");
    let off = (once.value() / compiled.value() - 1.0).abs();
    assert!(off <= once.error + compiled.error, "{off:e}");
    // Nor for the few rows of a request.
    model.solve(&scene, &request.at([1.0, 2.0])).unwrap();
    assert!(averages.load(Ordering::Relaxed) < 3 * single);
}

/// A law like AT's as printed: elastic, less a part that begins at x = 1, and one from 6 on.
#[derive(Debug)]
struct SignedSpy(Arc<AtomicUsize>);

impl AsperityModel for SignedSpy {
    fn force(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        let mut law = Law::in_units(asperity.critical_interference()?, 1.0);
        for (range, sign) in [(0.0..1.0, 1.0), (1.0..6.0, -1.0), (6.0..f64::INFINITY, 1.0)] {
            let contact = Arc::new(Counted(self.0.clone()));
            let density = AngleDensity::default();
            let (form, kinks) = angle_average(contact, range, density, tolerance.relative());
            law = law.elastic(0.0..f64::INFINITY, form);
            if let Some(part) = law.parts.last_mut() {
                (part.sign, part.kinks) = (sign, kinks);
            }
        }
        Ok(law)
    }

    fn area(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        self.force(asperity, tolerance)
    }
}

/// A load takes the averages of a few integrals, also where parts are subtracted and another
/// separation may carry it: the steps to a root, its last place, and bounds above it.
#[test]
fn a_load_on_a_law_with_subtracted_parts_is_not_tabulated() {
    let averages = Arc::new(AtomicUsize::new(0));
    let model = SignedSpy(averages.clone());
    let count = |index: f64, at: At| {
        averages.store(0, Ordering::Relaxed);
        let request = Request::new([Quantity::Force]).at([at]);
        let contact = model.contact(&with_index(index), &request).unwrap();
        let force = contact.evaluate(Quantity::Force, at).unwrap().value();
        (averages.load(Ordering::Relaxed), force)
    };
    for (index, s) in [(0.8, 0.0), (0.8, 2.0), (4.0, -1.0), (4.0, 1.0), (4.0, 3.0)] {
        let (once, load) = count(index, s.into());
        let (inverted, force) = count(index, At::Load(load));
        assert!((force / load - 1.0).abs() < 1e-9, "{index} {s}: {force} {load}");
        // Tables of the law take 6 to 9 times as many as one separation.
        assert!(inverted <= 5 * once, "{index} {s}: {inverted} averages, {once} at a separation");
    }
}

#[test]
fn another_asperity_is_refused() {
    let scene = with_index(2.0);
    let compiled = Spy::default().compile(&scene, &[Quantity::Force]);
    let changes: [fn(&mut Scene); 5] = [
        |s| s.surface.asperity_radius *= 1.0 + 1e-15,
        |s| s.interface.equivalent_modulus *= 2.0,
        |s| s.interface.hardness = Some(1e9),
        |s| s.interface.equivalent_shear_modulus = None,
        |s| s.interface.pressure_factor = None,
    ];
    for change in changes {
        let mut other = scene.clone();
        change(&mut other);
        let error = compiled.on(&other).unwrap_err();
        assert!(error == ContactError::OtherAsperity, "{error}");
        assert!(error.to_string().contains("asperity_radius differs"));
    }
    let mut bad = scene.clone();
    bad.nominal_area = -1.0;
    assert!(compiled.on(&bad).unwrap_err().to_string().starts_with("nominal_area is -1"));
    assert!(compiled.on(&scene).is_ok());
}

/// A value between two rough surfaces samples a function of its law as often as one surface does,
/// once more for its integral.
#[test]
fn the_law_of_pairs_samples_a_function_about_as_often() {
    let counts = |scene: &Scene, alone: bool| {
        [false, true].map(|pairs| {
            let spy = Spy::default();
            let own = Model::new(spy.clone());
            let model = if pairs { own.on(Asperities::Pairs) } else { own };
            let request = Request::new([Quantity::Force]).at([1.0]);
            let contact =
                if alone { model.contact(scene, &request) } else { model.compile(scene, &request) };
            contact.unwrap().evaluate(Quantity::Force, 1.0).unwrap();
            spy.samples()
        })
    };
    let found = [(true, 0.5), (true, 2.0), (false, 0.5), (false, 2.0)]
        .map(|(alone, index)| counts(&with_index(index), alone));
    for [one, pairs] in found {
        assert!(pairs > 0 && pairs <= 2 * one, "{found:?}");
    }
}
