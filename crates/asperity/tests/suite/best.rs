//! The model `best`.

use std::collections::BTreeMap;

use asperity::{
    At, Best, BestContact, Code, Compared, Contact, ContactEngine, ContactError, ContactModel,
    Datum, Described, Evidence, HeightDistribution, Interface, Model, ProfileMoments, Quantity,
    Request, Scene, SeparationUnit, SolvedContact, Source, Surface, Tolerance,
};

const ASKED: [Quantity; 5] = [
    Quantity::Area,
    Quantity::MeanPressure,
    Quantity::Tangent,
    Quantity::UnloadingStiffness,
    Quantity::ContactRadiusSum,
];

fn scene(m4: f64) -> Scene {
    let surface = Surface::from_moments(&ProfileMoments { m0: 1.6e-13, m2: 2.5e-3, m4 }).unwrap();
    Scene::new(Interface::new(115e9, 0.3, 7e9), surface, 1e-4)
}

fn best(scene: &Scene) -> BestContact<Model> {
    Best::default().on(scene, Tolerance::default()).unwrap()
}

fn contact(scene: &Scene, asked: &[Quantity]) -> Box<dyn Contact> {
    Model::best().compile(scene, &Request::new(asked.iter().copied())).unwrap()
}

#[test]
fn the_answer_is_what_boundary_elements_are_expected_to_give() {
    let scene = scene(3e8);
    let (all, evidence) = (contact(&scene, &ASKED), Evidence::committed().unwrap());
    for load in [10.0, 1e3, 3e4] {
        let at = At::Load(load);
        let pressure = load / scene.nominal_area;
        let counted: Model = "ke".parse().unwrap();
        let counted = counted.solve(&scene, &Request::new([Quantity::Contacts]).at([at])).unwrap();
        let contacts = counted.values(Quantity::Contacts).unwrap()[0];
        let expected = evidence.expected(&scene, None, pressure, Some(contacts)).unwrap();
        for (quantity, of, unit) in [
            (Quantity::Area, Compared::Area, scene.nominal_area),
            (Quantity::Tangent, Compared::Stiffness, 1.0),
            (Quantity::UnloadingStiffness, Compared::UnloadingStiffness, 1.0),
        ] {
            let (value, wanted) =
                (all.evaluate(quantity, at).unwrap(), expected.estimate(of).unwrap());
            let interval = all.interval(quantity, at).unwrap();
            let found = [value.value(), interval.lower, interval.upper];
            let [low, high] = wanted.ends.unwrap();
            for (found, wanted) in found.into_iter().zip([wanted.value, low, high]) {
                assert!((found / wanted / unit - 1.0).abs() < 1e-9, "{quantity}: {found} {wanted}");
            }
            assert!(value.relative_error() < 1e-8 && interval.of.contains("1 cm2 with some"));
            // Whatever else is asked.
            let alone = contact(&scene, &[quantity]).evaluate(quantity, at).unwrap();
            assert_eq!(alone.value().to_bits(), value.value().to_bits());
        }
        let value = |quantity| all.evaluate(quantity, at).unwrap().value();
        assert!((value(Quantity::Area) * value(Quantity::MeanPressure) / load - 1.0).abs() < 1e-12);
        let radii = value(Quantity::ContactRadiusSum) * 2.0 * 115e9;
        assert!((radii / value(Quantity::UnloadingStiffness) - 1.0).abs() < 1e-12);
        let gap = all.separation_in(SeparationUnit::Metres, Datum::SurfaceMean, at).unwrap();
        let wanted = expected.estimate(Compared::MeanGap).unwrap().value;
        assert!((gap / wanted - 1.0).abs() < 1e-9, "{gap} {wanted}");
    }
}

#[test]
fn a_separation_has_the_load_that_has_this_separation() {
    let scene = scene(3e8);
    let contact = contact(&scene, &[Quantity::Force, Quantity::Area]);
    for load in [30.0, 1e3, 2e4] {
        let separation = contact.separation(At::Load(load)).unwrap();
        let value = |quantity, at: At| contact.evaluate(quantity, at).unwrap().value();
        let found = value(Quantity::Force, separation.into());
        assert!((found / load - 1.0).abs() < 1e-8, "{found} {load}");
        let areas = [separation.into(), At::Load(load)].map(|at| value(Quantity::Area, at));
        assert!((areas[0] / areas[1] - 1.0).abs() < 1e-8, "{areas:?}");
        let [area, gap] =
            [Some(Quantity::Area), None].map(|of| contact.interval_at(of, separation.into()));
        assert!(area.is_some() && gap.is_some());
    }
}

#[test]
fn ratios_to_the_nearest_model_are_kept_under_loads_lighter_than_solved_ones() {
    let scene = scene(3e8);
    let best = best(&scene);
    let [light, lighter] =
        [1.0, 0.5].map(|load| best.known(Compared::Area, At::Load(load)).unwrap());
    let [high, low] = [&light, &lighter].map(|known| known.ends.unwrap());
    // The area is nearly in proportion to the load, and its interval with it.
    assert!((light.value / lighter.value / 2.0 - 1.0).abs() < 0.03, "{light:?} {lighter:?}");
    assert!((high[1] / high[0]).ln() <= (low[1] / low[0]).ln() + 1e-9, "{high:?} {low:?}");
    let ke = best.by(Compared::Area, At::Load(1.0)).unwrap();
    assert_ne!(ke.id(), "gw");
    let far = best.known(Compared::Area, At::Load(1e-9)).unwrap();
    assert!(far.ends.is_none() && far.source == Source::Evidence, "{far:?}");
}

/// Boundary elements on a surface that had no part in the evidence (256 x 256 pixels, waves of 4.5
/// to 28 µm, a Hurst exponent of 0.75; ψ = 1.7 and 6): 4.22e8 N/m at 0.29 H, and a mean gap of
/// -8.98e-8 m at 0.7 H, both confirmed by differences and transforms of another program.
/// From a thirtieth of the lightest solved load to two thirds of the hardness, where evidence ends.
#[test]
fn areas_and_stiffnesses_rise_with_the_load_and_gaps_fall() {
    for (m4, hardness) in [(1.4e8, 3e9), (3e8, 7e9), (1e9, 2e9), (1.5e9, 12e9)] {
        let mut scene = scene(m4);
        scene.interface.hardness = Some(hardness);
        let contact = contact(&scene, &ASKED);
        let unit = 115e9 * 0.005f64.sqrt();
        let pressures = std::iter::successors(Some(4e-7 * unit), |p| Some(1.25 * p));
        let places = pressures.take_while(|p| *p < (0.65 * hardness).min(0.25 * unit));
        let mut before: Option<[f64; 4]> = None;
        for at in places.map(At::Pressure) {
            let value = |quantity| contact.evaluate(quantity, at).unwrap().value();
            let gap = contact.separation_in(SeparationUnit::Metres, Datum::SurfaceMean, at);
            let of = [Quantity::Area, Quantity::Tangent, Quantity::UnloadingStiffness].map(value);
            let now = [of[0], of[1], of[2], -gap.unwrap()];
            if let Some(before) = before {
                let rises = now.iter().zip(before).all(|(now, before)| *now > before);
                assert!(rises, "m4 {m4}, H {hardness}, {at}: {before:?} {now:?}");
            }
            before = Some(now);
        }
        assert!(before.is_some());
    }
}

#[test]
fn nothing_is_stated_that_new_surfaces_refute() {
    let surface = |hardness: f64| {
        let moments = ProfileMoments { m0: 2.84e-14, m2: 5e-3, m4: 3.35e9 };
        let interface = Interface::new(115e9, 0.3, hardness);
        Scene::new(interface, Surface::from_moments(&moments).unwrap(), 1.6384e-8)
    };
    let stated = |hardness: f64, share: f64, of| {
        // Above, the gap of the models is below 0, and there is none.
        let known = best(&surface(hardness)).known(of, At::Pressure(share * hardness));
        known.is_ok_and(|known| known.ends.is_some())
    };
    for (share, tangent) in [(0.31, false), (0.29, true)] {
        assert!(stated(8.4e9, share, Compared::Area));
        assert_eq!(stated(8.4e9, share, Compared::Stiffness), tangent);
    }
    assert!(stated(2.4e9, 0.5, Compared::MeanGap) && !stated(2.4e9, 0.7, Compared::MeanGap));
}

#[test]
fn areas_carry_the_load_and_contacts_unload_at_least_as_stiff() {
    // Where most of the contact flows the area is F/H.
    let mut soft = scene(1.2e8);
    let hardness = 7e9 * soft.plasticity_index().unwrap() / 8.0;
    soft.interface.hardness = Some(hardness);
    let best = best(&soft);
    for step in 1..=40 {
        let pressure = hardness * 0.015 * f64::from(step);
        let known = |of| best.known(of, At::Pressure(pressure)).unwrap();
        let area = known(Compared::Area);
        let least = area.ends.unwrap()[0].min(area.value);
        assert!(least >= pressure / hardness * (1.0 - 1e-15), "{area:?}");
        let [tangent, unloading] = [Compared::Stiffness, Compared::UnloadingStiffness].map(known);
        if let (Some(loading), Some(ends)) = (tangent.ends, unloading.ends) {
            assert!(
                tangent.value <= unloading.value && loading[0] <= ends[0] && loading[1] <= ends[1]
            );
        }
    }
}

#[test]
fn without_evidence_the_first_valid_model_answers_without_an_interval() {
    // The skewness of the surface is unknown.
    let mut skewed = scene(3e8);
    skewed.heights = HeightDistribution::Exponential;
    let asked = [Quantity::Area, Quantity::Tangent];
    let (contact, at) = (contact(&skewed, &asked), At::Load(1e3));
    let ke: Model = "ke".parse().unwrap();
    let ke = ke.compile(&skewed, &Request::new(asked)).unwrap();
    for quantity in asked {
        let [found, wanted] =
            [&contact, &ke].map(|one| one.evaluate(quantity, at).unwrap().value());
        assert!((found / wanted - 1.0).abs() < 1e-9 && contact.interval(quantity, at).is_none());
    }
    let notes = contact.notes(&[at]);
    assert_eq!((notes[0].code, &*notes[0].field), (Code::NoEvidence, "skewness"));
    // Adhesion that matters is answered by a model of its range.
    let mut sticky = Interface::elastic(1e7, 0.5);
    sticky.work_of_adhesion = Some(0.1);
    let sticky = Scene::new(sticky, scene(3e8).surface, 1e-4);
    assert_eq!(best(&sticky).by(Compared::Area, At::Load(1.0)).unwrap().id(), "jkr");
}

#[test]
fn under_tension_the_model_of_parting_answers_where_closing_surfaces_carry_none() {
    let mut interface = Interface::elastic(4e6 / 3.0, 0.5);
    interface.work_of_adhesion = Some(0.05);
    let rubber = Scene::new(interface, Surface::new(1e-4, 1e9, 1e-6), 1e-4);
    for (load, id) in [(1.0, "jkr"), (-0.2, "jkr"), (-0.5, "jkr-separation")] {
        let known = best(&rubber).known(Compared::Area, At::Load(load)).unwrap();
        assert!(matches!(&known.source, Source::Model(of, _) if of == id), "{load}: {known:?}");
    }
}

#[test]
fn outside_of_what_was_solved_the_nearest_end_answers_without_an_interval() {
    // No surface of this bandwidth was solved.
    let broad = scene(3e11);
    let (contact, at) = (contact(&broad, &[Quantity::Area]), At::Load(1e3));
    assert!(contact.interval(Quantity::Area, at).is_none());
    let notes = contact.notes(&[at]);
    assert_eq!(notes[0].code, Code::Extrapolated);
    assert!(notes[0].field.starts_with("alpha"), "{}", notes[0]);
    let noted = |scene: &Scene| best(scene).notes(&[at]).iter().any(|n| n.code == Code::NoHardness);
    let mut elastic = broad.clone();
    elastic.interface.hardness = None;
    assert!(noted(&elastic) && !noted(&broad));
    // Contacts that merge keep their ratio to a theory of the whole surface.
    let soft = Scene::new(Interface::elastic(1e6, 0.5), scene(3e8).surface, 1e-4);
    let soft = best(&soft);
    let merged = soft.known(Compared::Area, At::Pressure(9e5)).unwrap();
    assert!(merged.ends.is_none() && (0.9..=1.0).contains(&merged.value), "{merged:?}");
    assert_eq!(soft.by(Compared::Area, At::Pressure(9e5)).unwrap().id(), "persson-fudge");
    assert!(soft.known(Compared::Area, At::Pressure(1.1e6)).is_err());
}

/// Where evidence ends, in the load, in the bandwidth and in the hardness: of 400 steps none is
/// larger than what changes steeply.
#[test]
fn answers_do_not_jump_where_evidence_ends() {
    let of_steps = |from: f64, to: f64, most: f64, place: &dyn Fn(f64) -> (Scene, f64)| {
        let known = |step: u32| {
            let (scene, pressure) = place(from * (to / from).powf(f64::from(step) / 400.0));
            let best = best(&scene);
            Compared::ALL.map(|of| {
                let value = best.known(of, At::Pressure(pressure)).ok()?.value;
                let gap = value / scene.surface.moments().m0.sqrt();
                Some(if of == Compared::MeanGap { gap } else { value.ln() })
            })
        };
        let all: Vec<_> = (0..=400).map(known).collect();
        for (k, of) in Compared::ALL.into_iter().enumerate() {
            let known: Vec<f64> = all.iter().map_while(|values| values[k]).collect();
            // Where most is in contact there is no gap, and above the hardness nothing.
            let least = if from < 1e3 { 300 } else { 401 };
            assert!(known.len() >= least, "{of:?} {} from {from:e} to {to:e}", known.len());
            for pair in known.windows(2) {
                assert!((pair[1] - pair[0]).abs() < most, "{pair:?} from {from:e} to {to:e}");
            }
        }
    };
    let of = |m4: f64, hardness: Option<f64>| {
        let mut scene = scene(m4);
        scene.interface.hardness = hardness;
        scene
    };
    for hardness in [Some(7e9), Some(2e9), None] {
        of_steps(1e1, 6e9, 0.1, &|pressure| (of(3e8, hardness), pressure));
        of_steps(6e7, 3e10, 0.003, &|m4| (of(m4, hardness), 1e8));
    }
    of_steps(3e8, 1e11, 0.02, &|hardness| (of(3e8, Some(hardness)), 1e8));
}

#[test]
fn what_was_solved_on_the_scan_is_an_input_of_the_answer() {
    let (scene, pressure) = (scene(3e8), 1e7);
    let solved = |uncertain: Option<&str>| {
        let values = BTreeMap::from([(Compared::Area, 0.0123)]);
        let uncertain = uncertain.map(|why| (Code::FewPatches, String::from(why)));
        let solved = SolvedContact { pressure, values, uncertain };
        let best = Best::<Model>::default().with_solved(vec![solved]);
        best.on(&scene, Tolerance::default()).unwrap()
    };
    let certain = solved(None);
    let at = At::Pressure(pressure);
    let known = certain.known(Compared::Area, at).unwrap();
    assert_eq!((known.value, known.ends, known.source), (0.0123, None, Source::Solved));
    // What a solution lacks, and other loads, are expected.
    for (of, at) in [(Compared::Stiffness, at), (Compared::Area, At::Pressure(2e7))] {
        assert_eq!(certain.known(of, at).unwrap().source, Source::Evidence);
    }
    let few = solved(Some("too few patches"));
    assert_eq!(few.known(Compared::Area, at).unwrap().source, Source::Evidence);
    let noted = |best: &BestContact<Model>| {
        best.notes(&[at]).iter().any(|note| note.code == Code::SolutionNotUsed)
    };
    assert!(noted(&few) && !noted(&certain));
}

#[test]
fn what_has_no_counterpart_in_boundary_elements_is_refused() {
    for quantity in [Quantity::Stiffness, Quantity::ElasticShare] {
        let refused = Model::best().compile(&scene(3e8), &Request::new([quantity])).unwrap_err();
        assert!(matches!(refused, ContactError::Unsupported { .. }), "{refused}");
    }
}
