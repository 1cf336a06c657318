//! The stiffness at fixed contact and the path of unloading, against closed forms and differences
//! of solutions.

use std::f64::consts::PI;

use asperity_bem::{BemError, Boundary, BoundaryElements, HeightMap, LoadCase, Solution};

use crate::{MODULUS, UNIT, close, is_long, paraboloid, rough};

/// Flat punches of the radius 1 at these places [x, y], in a square of the side `side` of n x n
/// pixels, pressed by a load that holds all of them down.
fn punches(n: usize, side: f64, places: &[[f64; 2]]) -> (BoundaryElements, Solution) {
    let step = side / n as f64;
    let at = |k: usize| (k as f64 + 0.5) * step - 0.5 * side;
    let inside =
        |i: usize, j: usize| places.iter().any(|[x, y]| (at(j) - x).hypot(at(i) - y) < 1.0);
    let heights = (0..n * n).map(|k| if inside(k / n, k % n) { 1.0 } else { 0.0 }).collect();
    let map = HeightMap::new(heights, [n, n], [step; 2]).unwrap();
    let solver = BoundaryElements::new(map, MODULUS).unwrap().boundary(Boundary::Free);
    let solution = solver.solve(LoadCase::Load(1e-3 * MODULUS)).unwrap();
    (solver, solution)
}

/// Stiffness of the whole map [N/m].
fn total(solver: &BoundaryElements, solution: &Solution, area: f64) -> f64 {
    solver.fixed_contact(solution).unwrap().stiffness * area
}

/// Errors on three grids: each less than the one before, the last below 1 %.
#[track_caller]
fn fall(errors: [f64; 3]) {
    let [coarse, middle, fine] = errors.map(f64::abs);
    assert!(coarse > middle && middle > fine && fine < 0.01, "{errors:?}");
}

/// Boussinesq: K = 2 E a, with the radius of a circle of as many pixels.
#[test]
fn a_flat_circular_punch() {
    fall([32, 64, 128].map(|n| {
        let (solver, solution) = punches(n, 2.5, &[[0.0; 2]]);
        let radius = 2.5 * (solution.pixel_area / PI).sqrt();
        total(&solver, &solution, 2.5 * 2.5) / (2.0 * MODULUS * radius) - 1.0
    }));
}

/// Each feels the other's force at the distance d: 1/K = 1/(2 E a) + 1/(π E d), to (a/d)³.
#[test]
fn two_distant_circles() {
    let distance = 8.0;
    let alone = 1.0 / (2.0 * MODULUS) + 1.0 / (PI * MODULUS * distance);
    fall([80, 160, 320].map(|n| {
        let (solver, solution) = punches(n, 12.0, &[[-4.0, 0.0], [4.0, 0.0]]);
        total(&solver, &solution, 144.0) * alone / 2.0 - 1.0
    }));
}

/// Hertz: dF/dw = 2 E a.
#[test]
fn a_sphere() {
    let (radius, load) = (1e-3, 2.0);
    let contact = (3.0 * load * radius / (4.0 * MODULUS)).cbrt();
    let side = 3.0 * contact;
    fall([41, 81, 161].map(|n| {
        let step = side / n as f64;
        let map = paraboloid(n, step, radius);
        let solver = BoundaryElements::new(map, MODULUS).unwrap().boundary(Boundary::Free);
        let solution = solver.solve(LoadCase::Load(load)).unwrap();
        total(&solver, &solution, side * side) / (2.0 * MODULUS * contact) - 1.0
    }));
}

/// With free edges the approach is that to distant points, and the half-space under the map gives
/// way by a part of it: under a circle by (2/π) asin(a/r) outside. The rest closes the mean gap.
#[test]
fn approaches_to_distant_points_close_the_gap_in_part() {
    let (radius, load) = (1e-3, 2.0);
    let contact = (3.0 * load * radius / (4.0 * MODULUS)).cbrt();
    let n = 129;
    for sides in [4.0, 8.0] {
        let step = sides * contact / n as f64;
        let from_axis = |k: usize| {
            let at = |i: usize| (i as f64 - (n / 2) as f64) * step;
            at(k / n).hypot(at(k % n))
        };
        let heights = (0..n * n).map(|k| -from_axis(k).powi(2) / (2.0 * radius));
        let map = HeightMap::new(heights.collect(), [n, n], [step; 2]).unwrap();
        let area = map.area();
        let solver = BoundaryElements::new(map, MODULUS).unwrap().boundary(Boundary::Free);
        let solution = solver.solve(LoadCase::Load(load)).unwrap();
        let fixed = solver.fixed_contact(&solution).unwrap();
        let deflection = |k: usize| match contact / from_axis(k) {
            inside if inside >= 1.0 => 1.0,
            outside => 2.0 / PI * outside.asin(),
        };
        let mean = (0..n * n).map(deflection).sum::<f64>() / (n * n) as f64;
        close(fixed.mean_deflection, mean, 0.01);
        // Of four radii the slope over the mean gap is more than twice that over the approach.
        let exact = 2.0 * MODULUS * contact / (1.0 - mean);
        close(fixed.stiffness * area / (1.0 - fixed.mean_deflection), exact, 0.03);
        close(solver.loading_stiffness(&solution).unwrap() * area, exact, 0.03);
    }
    let rough = BoundaryElements::new(rough(128, 2), MODULUS).unwrap().boundary(Boundary::Free);
    for share in [0.01, 0.1] {
        let solution = rough.solve(LoadCase::MeanPressure(share * UNIT)).unwrap();
        let fixed = rough.fixed_contact(&solution).unwrap();
        let over_gap = fixed.stiffness / (1.0 - fixed.mean_deflection);
        assert!(over_gap > 1.1 * fixed.stiffness);
        let found = rough.loading_stiffness(&solution).unwrap();
        close(found, over_gap, 1e-12);
        let gap = |k: f64| {
            rough.solve(LoadCase::MeanPressure(k * solution.mean_pressure)).unwrap().mean_gap
        };
        close(found, 0.04 * solution.mean_pressure / (gap(0.98) - gap(1.02)), 0.02);
    }
}

/// The slope of first loading is that between other solutions; yielded contacts unload stiffer.
#[test]
fn slopes_of_loading_are_differences_of_solutions() {
    let given = LoadCase::MeanPressure(0.05 * UNIT);
    for hardness in [None, Some(0.2 * UNIT), Some(0.0501 * UNIT)] {
        let solver = BoundaryElements::new(rough(128, 3), MODULUS).unwrap();
        let solver = match hardness {
            Some(hardness) => solver.hardness(hardness).unwrap(),
            None => solver,
        };
        let solution = solver.solve(given).unwrap();
        let found = solver.loading_stiffness(&solution).unwrap();
        let fixed = solver.fixed_contact(&solution).unwrap().stiffness;
        let gap = |share: f64| {
            solver.solve(LoadCase::MeanPressure(share * 0.05 * UNIT)).unwrap().mean_gap
        };
        // Almost at the hardness little more is carried.
        let (heavier, lighter, within) = match hardness {
            Some(hardness) if hardness < 0.051 * UNIT => (1.001, 0.999, 1e-3),
            _ => (1.01, 0.99, 0.02),
        };
        let slope = (heavier - lighter) * 0.05 * UNIT / (gap(lighter) - gap(heavier));
        close(found, slope, within);
        match hardness {
            None => close(found, fixed, 0.02),
            Some(_) => assert!(found < 0.9 * fixed, "{found:e} {fixed:e}"),
        }
    }
    let solver = BoundaryElements::new(rough(64, 1), MODULUS).unwrap();
    let full = solver.solve(LoadCase::MeanPressure(3.0 * UNIT)).unwrap();
    assert_eq!(solver.loading_stiffness(&full), Err(BemError::FullContact));
    // Almost at the hardness a neighbouring load closes the last gap.
    let hardness = 0.5 * UNIT;
    let solver = solver.clone().hardness(hardness).unwrap();
    let closes = (1..40).map(|k| 1.0 - 0.5f64.powi(k)).find_map(|share| {
        let solution = solver.solve(LoadCase::MeanPressure(share * hardness)).unwrap();
        solver.loading_stiffness(&solution).err().map(|error| (solution, error))
    });
    let (solution, error) = closes.unwrap();
    assert!(solution.pixel_area < 1.0, "{}", solution.pixel_area);
    let BemError::FullContactBeside { pressure, neighbour } = error else { panic!("{error}") };
    close(pressure, solution.mean_pressure, 1e-12);
    assert!(neighbour > pressure && neighbour < hardness, "{neighbour:e} {pressure:e}");
    // Under the lightest loads one pixel touches: as stiff as under any other.
    let single = [1e-300, 1e-9].map(|p| {
        let solution = solver.solve(LoadCase::MeanPressure(p)).unwrap();
        assert_eq!(solution.patches, [1]);
        solver.loading_stiffness(&solution).unwrap()
    });
    close(single[0], single[1], 1e-12);
}

/// A plateau of a soft material: the deflections of all loads vanish in the rounding of its height.
#[test]
fn a_slope_that_is_lost_in_rounding_is_refused() {
    let inside = |k: usize| (4..10).contains(&(k / 64)) && (4..10).contains(&(k % 64));
    let heights = (0..64 * 64).map(|k| if inside(k) { 1.0 } else { 0.0 }).collect();
    let map = HeightMap::new(heights, [64, 64], [1e-3; 2]).unwrap();
    let hardness = 1e-15 * MODULUS;
    let solver = BoundaryElements::new(map, MODULUS).unwrap().hardness(hardness).unwrap();
    let pressure = 0.9 * hardness * 36.0 / (64.0 * 64.0);
    let solution = solver.solve(LoadCase::MeanPressure(pressure)).unwrap();
    assert!(solution.plastic_area > 0.0 && solution.pixel_area < 0.01, "{}", solution.pixel_area);
    let refused = solver.loading_stiffness(&solution).unwrap_err();
    assert!(matches!(refused, BemError::Slope { .. }), "{refused}");
}

/// An elastic contact unloads as it loads: the slope of pressure over mean gap.
#[test]
fn an_elastic_contact_has_its_loading_slope() {
    for seed in if is_long() { 1..=3 } else { 1..=1 } {
        let solver = BoundaryElements::new(rough(256, seed), MODULUS).unwrap();
        let solver = solver.tolerance(1e-11).unwrap();
        let shares = [1e-3, 0.1, 3e-3, 1e-2];
        for share in &shares[..if is_long() { 4 } else { 2 }] {
            let pressure = share * UNIT;
            let at = |factor: f64| solver.solve(LoadCase::MeanPressure(factor * pressure)).unwrap();
            let (less, here, more) = (at(0.99), at(1.0), at(1.01));
            let slope = 0.02 * pressure / (less.mean_gap - more.mean_gap);
            let found = solver.fixed_contact(&here).unwrap().stiffness;
            let within = if here.patches.len() < 30 { 0.02 } else { 0.005 };
            close(found, slope, within);
        }
    }
}

/// Yielding makes unloading stiffer than loading.
#[test]
fn a_yielded_contact_is_stiffer_than_its_loading_slope() {
    let elastic = BoundaryElements::new(rough(128, 4), MODULUS).unwrap();
    let solver = elastic.clone().hardness(0.2 * UNIT).unwrap();
    let at = |pressure: f64| solver.solve(LoadCase::MeanPressure(pressure * UNIT)).unwrap();
    let (less, here, more) = (at(0.0198), at(0.02), at(0.0202));
    assert!(here.plastic_area > 0.3 * here.pixel_area);
    let slope = 0.0004 * UNIT / (less.mean_gap - more.mean_gap);
    let found = solver.fixed_contact(&here).unwrap();
    assert!(found.stiffness > 1.1 * slope, "{} {slope}", found.stiffness);
    assert!(found.iterations < 60 && found.residual <= 1e-11, "{}", found.iterations);
}

#[test]
fn full_contact_and_foreign_solutions_are_refused() {
    let solver = BoundaryElements::new(rough(32, 1), MODULUS).unwrap();
    let solution = solver.solve(LoadCase::MeanPressure(10.0 * UNIT)).unwrap();
    assert_eq!(solver.fixed_contact(&solution), Err(BemError::FullContact));
    let other = BoundaryElements::new(rough(64, 1), MODULUS).unwrap();
    let refused = other.fixed_contact(&solution).unwrap_err();
    assert!(matches!(refused, BemError::Count { found: 1024, .. }), "{refused}");
}

/// The flattened surface carries the load as before, and leaves along the slope at fixed contact.
#[test]
fn a_yielded_contact_unloads_along_its_own_path() {
    let solver = BoundaryElements::new(rough(128, 4), MODULUS).unwrap();
    let solver = solver.hardness(0.2 * UNIT).unwrap().tolerance(1e-11).unwrap();
    let pressed = solver.solve(LoadCase::MeanPressure(0.02 * UNIT)).unwrap();
    let flat = solver.flattened_by(&pressed).unwrap();
    let again = flat.solve(LoadCase::MeanPressure(0.02 * UNIT)).unwrap();
    close(again.mean_gap, pressed.gap_volume, 1e-8);
    close(again.pixel_area, pressed.pixel_area, 2e-3);
    // Shorter steps come nearer to the stiffness.
    let stiffness = solver.fixed_contact(&pressed).unwrap().stiffness;
    let slope = |share: f64| {
        let less = flat.solve(LoadCase::MeanPressure(0.02 * UNIT * (1.0 - share))).unwrap();
        share * 0.02 * UNIT / (less.mean_gap - again.mean_gap)
    };
    let errors = [0.08, 0.02, 0.005].map(|share| (slope(share) / stiffness - 1.0).abs());
    assert!(errors[0] > errors[1] && errors[1] > errors[2] && errors[2] < 0.02, "{errors:?}");
    // On the way back the gap is smaller than in loading: energy is lost.
    let at =
        |solver: &BoundaryElements| solver.solve(LoadCase::MeanPressure(0.005 * UNIT)).unwrap();
    let (loading, unloading) = (at(&solver).gap_volume, at(&flat));
    let retreat = unloading.mean_gap - again.mean_gap;
    assert!(retreat > 0.0 && retreat < loading - pressed.mean_gap, "{retreat:e}");
    assert!(unloading.plastic_area <= pressed.plastic_area);
}

#[test]
fn an_elastic_contact_leaves_its_surface_as_it_was() {
    let map = rough(64, 1);
    let solver = BoundaryElements::new(map.clone(), MODULUS).unwrap();
    let solution = solver.solve(LoadCase::MeanPressure(0.05 * UNIT)).unwrap();
    let after = solver.flattened_by(&solution).unwrap();
    let again = after.solve(LoadCase::MeanPressure(0.02 * UNIT)).unwrap();
    let before = solver.solve(LoadCase::MeanPressure(0.02 * UNIT)).unwrap();
    close(again.mean_gap, before.mean_gap, 1e-9);
}

/// Retreats give the contacts of the flattened surface; force, area and stiffness fall to 0.
#[test]
fn retreats_follow_the_path_of_unloading() {
    let solver = BoundaryElements::new(rough(64, 4), MODULUS).unwrap();
    let solver = solver.hardness(0.2 * UNIT).unwrap();
    let greatest = LoadCase::MeanPressure(0.02 * UNIT);
    let path = solver.unloading_from(greatest).unwrap();
    let pressed = solver.solve(greatest).unwrap();
    let flat = solver.flattened_by(&pressed).unwrap();
    let end = path.last_contact();
    let retreats = [0.5 * end, 0.0, 0.1 * end, 1.5 * end, -1.0];
    let found = path.at_retreats(&retreats, |_| std::ops::ControlFlow::Continue(()));
    assert!(matches!(found[4], Err(BemError::OutOfRange { field: "retreat", .. })));
    let all: Vec<_> = found.into_iter().take(4).map(Result::unwrap).collect();
    close(all[1].mean_pressure, 0.02 * UNIT, 1e-12);
    for (at, contact) in [(0, &all[0]), (2, &all[2])] {
        let gap = pressed.gap_volume + retreats[at];
        let direct = flat.solve(LoadCase::MeanGap(gap)).unwrap();
        close(contact.mean_pressure, direct.mean_pressure, 1e-5);
        close(contact.mean_gap, pressed.mean_gap + retreats[at], 1e-12);
        let fixed = flat.fixed_contact(&direct).unwrap().stiffness;
        close(contact.stiffness.clone().unwrap().unwrap(), fixed, 1e-3);
    }
    for less in [[0, 2], [2, 1], [3, 0]].map(|pair| pair.map(|k: usize| &all[k])) {
        let [less, more] = less;
        assert!(less.mean_pressure < more.mean_pressure && less.area < more.area);
    }
    assert!(all[3].mean_pressure <= 0.0);
}

/// Hertz: a sphere pressed in by d parts after the retreat d, with F (1 - r/d)^1.5 and 2 E a at r.
/// Retreats of distant points, not of the mean gap.
#[test]
fn a_sphere_opens_as_it_was_pressed() {
    let (radius, load) = (1e-3, 2.0);
    let contact = (3.0 * load * radius / (4.0 * MODULUS)).cbrt();
    let map = paraboloid(61, 3.0 * contact / 61.0, radius);
    let area = map.area();
    let solver = BoundaryElements::new(map, MODULUS).unwrap().boundary(Boundary::Free);
    let path = solver.unloading_from(LoadCase::Load(load)).unwrap();
    let depth = contact * contact / radius;
    close(path.last_contact(), depth, 2e-3);
    let shares = [0.0, 0.04, 0.3, 0.7, 1.1];
    let retreats = shares.map(|share| share * depth);
    let found = path.at_retreats(&retreats, |_| std::ops::ControlFlow::Continue(()));
    let found: Vec<_> = found.into_iter().map(Result::unwrap).collect();
    for (contact_at, (share, retreat)) in found.iter().zip(shares.into_iter().zip(retreats)) {
        let left = (1.0 - share).max(0.0);
        close(contact_at.mean_pressure * area, load * left.powf(1.5), 5e-3);
        let stiffness = contact_at.stiffness.clone().unwrap().unwrap() * area;
        close(stiffness, 2.0 * MODULUS * contact * left.sqrt(), 0.02);
        close(contact_at.separation - path.closest().separation, retreat, 1e-9);
        let opened = contact_at.mean_gap - path.closest().mean_gap;
        assert!(retreat <= 0.0 || opened < 0.8 * retreat, "{opened:e} {retreat:e}");
        let solved = solver.solve(LoadCase::Separation(contact_at.separation));
        assert_eq!(solved.is_err(), left <= 0.0);
    }
}

/// Where a free contact has yielded, its first retreats still follow its stiffness.
#[test]
fn a_yielded_free_contact_opens_with_its_stiffness() {
    let solver = BoundaryElements::new(rough(64, 4), MODULUS).unwrap().boundary(Boundary::Free);
    let solver = solver.hardness(0.2 * UNIT).unwrap().tolerance(1e-11).unwrap();
    let path = solver.unloading_from(LoadCase::MeanPressure(0.05 * UNIT)).unwrap();
    let stiffness = path.closest().stiffness.clone().unwrap().unwrap();
    let retreat = 0.01 * 0.05 * UNIT / stiffness;
    let found = path.at_retreats(&[retreat], |_| std::ops::ControlFlow::Continue(()));
    let left = found[0].as_ref().unwrap().mean_pressure;
    close((0.05 * UNIT - left) / retreat, stiffness, 0.02);
}
