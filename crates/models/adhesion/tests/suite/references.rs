//! Adhesive contacts against `tests/reference/adhesion.csv` (mpmath, over contact radii), published
//! numbers, and the model that is left without adhesion.

use std::f64::consts::PI;

use crate::{APPROACH, SEPARATION, compiled, model, scene, work_of};

use asperity_adhesion::{DerjaguinMullerToporov, PullOff, pull_off};
use asperity_core::{
    At, Case, Contact, ContactError, ContactModel, HeightDistribution, Quantity, Request, Sweep,
    Tolerance,
};
use asperity_gw::GreenwoodWilliamson;

#[test]
fn every_row_of_the_reference_is_met_by_every_way_of_asking() {
    let rows = include_str!("../../../../../tests/reference/adhesion.csv").lines().skip(1);
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
        assert!(refused.contains("load is -0.001"), "{refused}");
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
            // At -223 σ_z under strong adhesion, a slope is a difference of larger terms: 1.2e-10.
            let slopes = Request::new([Quantity::Tangent]).within(Tolerance::new(1e-9).unwrap());
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
            warning.code.name() == "adhesion"
                && warning.count == 2
                && warning.at == Some(At::from(1.0)),
            "{warning:?}"
        );
        let mut bare = scene(0.0);
        bare.interface.work_of_adhesion = None;
        let refused = model(id).solve(&bare, &asked).unwrap_err().to_string();
        assert!(refused.starts_with("work_of_adhesion is missing: "), "{refused}");
        for (load, wanted) in [(0.0, "load is 0"), (f64::NAN, "load")] {
            let contact = compiled(model(id), &scene(0.03), 1e-10);
            let refused = contact.separations_at(load).unwrap_err().to_string();
            assert!(refused.starts_with(wanted), "{refused}");
        }
    }
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
