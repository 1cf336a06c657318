//! Input that cannot be answered is refused by name; input that looks odd is answered.

use asperity_bem::{BemError, Boundary, BoundaryElements, HeightMap, LoadCase, RandomSurface};

use crate::{MODULUS, UNIT, close, rough};

#[track_caller]
fn refused<T: std::fmt::Debug>(found: Result<T, BemError>, message: &str) {
    let text = found.unwrap_err().to_string();
    assert!(text.contains(message), "{text}");
}

#[test]
fn maps() {
    let map = |heights: Vec<f64>, shape, pixel| HeightMap::new(heights, shape, pixel);
    refused(map(vec![0.0; 4], [1, 4], [1.0; 2]), "rows is 1");
    refused(map(vec![0.0; 4], [4, 1], [1.0; 2]), "columns is 1");
    refused(map(vec![0.0; 5], [2, 3], [1.0; 2]), "5 numbers");
    refused(map(vec![0.0; 5], [usize::MAX, 3], [1.0; 2]), "5 numbers");
    refused(map(vec![0.0; 6], [2, 3], [0.0, 1.0]), "rows is 0");
    refused(map(vec![0.0; 6], [2, 3], [1.0, f64::NAN]), "columns is NaN");
    let with = |value: f64| {
        let mut heights = vec![0.0; 6];
        heights[4] = value;
        map(heights, [2, 3], [1.0; 2])
    };
    refused(with(f64::NAN), "column 1 is NaN");
    refused(with(f64::NEG_INFINITY), "column 1 is -inf");
    refused(map(vec![f64::MAX, f64::MIN, 0.0, 0.0], [2, 2], [1.0; 2]), "height is");
}

#[test]
fn loads() {
    let solver = BoundaryElements::new(rough(32, 1), MODULUS).unwrap();
    for value in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        refused(solver.solve(LoadCase::MeanPressure(value)), "mean pressure is");
        refused(solver.solve(LoadCase::Load(value)), "load is");
        refused(solver.solve(LoadCase::MeanGap(value)), "mean gap is");
        refused(BoundaryElements::new(rough(32, 1), value), "equivalent modulus is");
        refused(solver.clone().hardness(value), "hardness is");
        refused(solver.clone().tolerance(value), "tolerance is");
    }
    let soft = solver.clone().hardness(UNIT).unwrap();
    for pressure in [UNIT, 2.0 * UNIT] {
        let refused = soft.solve(LoadCase::MeanPressure(pressure));
        assert!(matches!(refused, Err(BemError::CannotBeCarried { .. })));
    }
    let highest = solver.solve(LoadCase::MeanPressure(1e-3 * UNIT)).unwrap().mean_gap * 100.0;
    refused(solver.solve(LoadCase::MeanGap(highest)), "nothing touches");
    let hasty = solver.most_iterations(3);
    let error = hasty.solve(LoadCase::MeanPressure(0.1 * UNIT)).unwrap_err();
    assert!(
        matches!(error, BemError::NotConverged { iterations: 3, residual, .. } if residual > 1e-8)
    );
}

#[test]
fn surfaces() {
    refused(RandomSurface::new(0.0, 1.0, 2.0), "longest is 0");
    refused(RandomSurface::new(3.0, 2.0, 4.0), "roll-off is 2");
    refused(RandomSurface::new(3.0, 3.0, f64::NAN), "shortest is NaN");
    refused(RandomSurface::new(1.1, 1.2, 1.3), "one whole wave");
    let surface = RandomSurface::new(1.0, 2.0, 8.0).unwrap();
    refused(surface.hurst(1.5), "Hurst exponent is 1.5");
    refused(surface.side(0.0), "side is 0");
    refused(surface.gradient(-1.0), "gradient is -1");
    refused(surface.heights(16), "side is 16");
    let halves = (0..4).fold(rough(32, 1), |map, _| map.half_grid().unwrap());
    refused(halves.half_grid(), "rows is 2");
}

/// What is said about some of them, read as prose when it changes.
#[test]
fn wording() {
    let map = |shape, pixel| HeightMap::new(vec![0.0; 4], shape, pixel).map(drop);
    let solver = BoundaryElements::new(rough(32, 1), MODULUS).unwrap();
    let soft = solver.clone().hardness(UNIT).unwrap();
    let waves = || RandomSurface::of_wavelengths([50e-6, 50e-6, 5e-6], [100e-6; 2]).unwrap();
    let said = [
        map([1, 4], [1.0; 2]),
        map([2, 3], [1.0; 2]),
        map([2, 2], [0.0, 1.0]),
        HeightMap::new(vec![f64::NAN; 4], [2, 2], [1.0; 2]).map(drop),
        solver.solve(LoadCase::Load(-1.0)).map(drop),
        solver.solve(LoadCase::MeanPressure(1e100)).map(drop),
        soft.solve(LoadCase::MeanPressure(UNIT)).map(drop),
        RandomSurface::new(1.1, 1.2, 1.3).map(drop),
        RandomSurface::of_wavelengths([1e-5, 2e-5, 1e-6], [1e-4; 2]).map(drop),
        RandomSurface::of_wavelengths([1e-5, 1e-5, 1e-9], [1e-4; 2]).map(drop),
        waves().lay(0.5, 0.0).map(drop),
        waves().lay(100.0, 0.0).map(drop),
        waves().skewness(9.0).map(drop),
        waves().map([64, 40]).map(drop),
    ];
    insta::assert_snapshot!(said.map(|one| one.unwrap_err().to_string()).join("\n"));
}

/// A flat punch: everywhere in contact, evenly when it is periodic, under p = F/(2π a..) edges
/// when it is not.
#[test]
fn flat_maps() {
    let map = HeightMap::new(vec![0.1; 30 * 31], [30, 31], [1e-6; 2]).unwrap();
    let solver = BoundaryElements::new(map, MODULUS).unwrap();
    let solution = solver.solve(LoadCase::MeanPressure(UNIT)).unwrap();
    close(solution.area, 1.0, 0.0);
    assert!(solution.pressures.iter().all(|&pressure| (pressure / UNIT - 1.0).abs() < 1e-12));
    assert!(solution.mean_gap.abs() < 1e-20);
    let punch =
        solver.clone().boundary(Boundary::Free).solve(LoadCase::MeanPressure(UNIT)).unwrap();
    assert!(punch.pressures[0] > 3.0 * UNIT && punch.pressures[15 * 31 + 15] < 0.6 * UNIT);
    refused(solver.solve(LoadCase::MeanGap(1e-9)), "nothing touches");
}

/// Two by two pixels, and one row of waves.
#[test]
fn the_least_maps() {
    let map = HeightMap::new(vec![0.0, 0.0, 0.0, 1e-6], [2, 2], [1e-6; 2]).unwrap();
    for boundary in [Boundary::Periodic, Boundary::Free] {
        let solver = BoundaryElements::new(map.clone(), MODULUS).unwrap().boundary(boundary);
        let light = solver.solve(LoadCase::MeanPressure(1e-3 * MODULUS)).unwrap();
        assert_eq!(light.patches, [1]);
        let heavy = solver.solve(LoadCase::MeanPressure(10.0 * MODULUS)).unwrap();
        assert_eq!(heavy.patches, [4]);
    }
}
