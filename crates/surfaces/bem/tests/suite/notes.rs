//! Findings of unresolved maps and contacts.

use asperity_bem::{Boundary, BoundaryElements, HeightMap, LoadCase, RandomSurface};

use crate::{MODULUS, UNIT, rough};

#[test]
fn short_waves_are_seen_in_both_boundaries() {
    for boundary in [Boundary::Periodic, Boundary::Free] {
        for (n, short) in [(64, true), (128, true), (256, false), (512, false)] {
            let surface = RandomSurface::new(2.0, 4.0, 24.0).unwrap().gradient(0.1).unwrap();
            let map = surface.side(1e-4).unwrap().heights(n).unwrap();
            let solver = BoundaryElements::new(map, MODULUS).unwrap().boundary(boundary);
            let solution =
                solver.tolerance(0.1).unwrap().solve(LoadCase::MeanPressure(UNIT)).unwrap();
            let found = solution.notes.iter().find(|note| note.code.name() == "short-waves");
            let found = found.map(|note| note.value);
            assert_eq!(found.is_some(), short, "{n} {found:?}");
            if let Some(pixels) = found {
                // The shortest wave is n/24 pixels long; the note counts 1 % of the slope out.
                let exact = n as f64 / 24.0;
                assert!((0.97 * exact..1.06 * exact).contains(&pixels), "{n} {pixels}");
            }
        }
    }
}

#[test]
fn few_pixels_and_few_patches_are_counted() {
    let solver = BoundaryElements::new(rough(128, 2), MODULUS).unwrap();
    let notes = |share: f64| solver.solve(LoadCase::MeanPressure(share * UNIT)).unwrap().notes;
    let light = notes(1e-4);
    let codes: Vec<_> = light.iter().map(|note| note.code.name()).collect();
    assert_eq!(codes, ["few-pixels", "few-patches"]);
    assert!(light[0].value < 100.0 && light[1].value < 30.0, "{light:?}");
    assert!(light.iter().all(|note| note.to_string().contains("at least")));
    let middle = notes(0.03);
    assert!(!middle.iter().any(|note| note.code.name() == "few-pixels"), "{middle:?}");
}

#[test]
fn a_larger_load_is_advised_only_where_it_makes_more_patches() {
    let solver = BoundaryElements::new(rough(128, 2), MODULUS).unwrap();
    let solve = |share: f64| solver.solve(LoadCase::MeanPressure(share * UNIT)).unwrap();
    for (share, merged) in [(1e-3, false), (0.5, true), (1.0, true)] {
        let solution = solve(share);
        assert_eq!(solution.area > 0.3, merged, "{}", solution.area);
        let few = solution.notes.iter().find(|note| note.code.name() == "few-patches").unwrap();
        let text = few.to_string();
        assert_eq!(text.ends_with("raise the load"), !merged, "{text}");
        assert_eq!(text.ends_with("a larger one"), merged, "{text}");
    }
}

#[test]
fn half_the_grid_tells_how_far_the_answer_depends_on_it() {
    let map =
        RandomSurface::new(2.0, 4.0, 8.0).unwrap().gradient(0.1).unwrap().heights(256).unwrap();
    let area = |map| {
        let solver = BoundaryElements::new(map, 1.0).unwrap();
        let solution = solver.solve(LoadCase::MeanPressure(5e-3)).unwrap();
        [solution.area, solution.pixel_area]
    };
    let [half, fine] = [area(map.half_grid().unwrap()), area(map)];
    // Corrected areas agree where counted ones do not.
    assert!((half[0] / fine[0] - 1.0).abs() < 0.02, "{half:?} {fine:?}");
    assert!(half[1] / fine[1] > 1.02, "{half:?} {fine:?}");
}

#[test]
fn edges_that_do_not_match_are_reported_where_nothing_is_declared() {
    let whole = rough(128, 4);
    let cut = whole.heights().chunks(128).take(90).flat_map(|row| row[..100].to_vec()).collect();
    let cut = HeightMap::new(cut, [90, 100], whole.pixel()).unwrap();
    let noted = |map: HeightMap, boundary| {
        let solver = BoundaryElements::new(map, MODULUS).unwrap();
        let solver = match boundary {
            Some(boundary) => solver.boundary(boundary),
            None => solver,
        };
        let solution = solver.tolerance(0.1).unwrap().solve(LoadCase::MeanPressure(UNIT)).unwrap();
        solution.notes.iter().any(|note| note.code.name() == "open-seam" && note.value > 3.0)
    };
    assert!(noted(cut.clone(), None));
    assert!(!noted(cut.periodic_part(), None) && !noted(whole, None));
    // A declared boundary is not questioned.
    assert!(!noted(cut.clone(), Some(Boundary::Periodic)) && !noted(cut, Some(Boundary::Free)));
}
