//! Sealing pressures: a closed form, surfaces of another solver, and surfaces made like a map.

use std::f64::consts::{PI, TAU};
use std::ops::ControlFlow;

use asperity_bem::{
    BoundaryElements, Fluid, HeightMap, LoadCase, RandomSurface, Seal, Sealing, Solution,
};

use crate::{MODULUS, close, is_long};

/// The smallest gap that is open \[m\].
const MOLECULE: f64 = 3e-10;

fn sealed(elements: &BoundaryElements) -> ([Option<Sealing>; 2], Option<Solution>) {
    elements.sealing(MOLECULE, |_| ControlFlow::Continue(())).unwrap()
}

fn wave(shape: [usize; 2], height: impl Fn(f64, f64) -> f64) -> HeightMap {
    let [rows, columns] = shape;
    let at = |k: usize, n: usize| TAU * k as f64 / n as f64;
    let heights =
        (0..rows * columns).map(|k| height(at(k % columns, columns), at(k / columns, rows)));
    HeightMap::new(heights.collect(), shape, [1e-6; 2]).unwrap()
}

#[test]
fn ridges_seal_along_them_in_full_contact_and_across_them_at_once() {
    // Westergaard: full contact at π E a/λ, for waves of the amplitude a and the length λ. The last
    // pixel of 64 closes a part 6e-4 before.
    let map = wave([4, 64], |x, _| 1e-6 * x.cos());
    let elements = BoundaryElements::new(map, MODULUS).unwrap();
    let ([across, along], last) = sealed(&elements);
    assert!(across.is_none());
    let (along, last) = (along.unwrap(), last.unwrap());
    close(along.pressure, PI * MODULUS * 1e-6 / 64e-6, 0.012);
    assert!(last.mean_pressure <= along.pressure && along.area > 0.9 && along.area < 1.0);
    assert!(along.tightest_gap > MOLECULE);
    // With a hardness the imprint closes it before, below the hardness.
    let hardness = 0.1 * along.pressure;
    let ([across, soft], _) = sealed(&elements.hardness(hardness).unwrap());
    let soft = soft.unwrap();
    assert!(across.is_none() && soft.pressure > 0.5 * hardness && soft.pressure < hardness);
    // Shut from the beginning.
    let flat = BoundaryElements::new(wave([4, 4], |_, _| 0.0), MODULUS).unwrap();
    assert_eq!(sealed(&flat).0, [None, None]);
}

#[test]
fn elastic_surfaces_seal_where_another_solver_has_them() {
    // p/(E g) of 20 directions of surfaces with H = 0.8, by a solver in NumPy: 0.235 +- 0.036 with
    // waves up to half of the side, 0.212 +- 0.017 up to a quarter. Means of other surfaces differ
    // by three standard errors at most; the area in contact is that of percolation.
    let seeds = if is_long() { 20 } else { 4 };
    for (longest, mean, scatter) in [(2.0, 0.235, 0.036), (4.0, 0.212, 0.017)] {
        let mut all: Vec<Sealing> = vec![];
        for seed in 0..seeds {
            let surface = RandomSurface::new(longest, longest, 16.0).unwrap();
            let surface = surface.gradient(0.1).unwrap().side(1e-4).unwrap().seed(seed);
            let elements = BoundaryElements::new(surface.heights(64).unwrap(), MODULUS).unwrap();
            all.extend(sealed(&elements).0.into_iter().flatten());
        }
        let count = all.len() as f64;
        assert_eq!(all.len() as u64, 2 * seeds);
        let found = all.iter().map(|one| one.pressure).sum::<f64>() / count / (0.1 * MODULUS);
        let error = scatter * (1.0 / count + 1.0 / 20.0_f64).sqrt();
        assert!((found - mean).abs() < 3.0 * error, "{longest}: {found} +- {error}");
        let area = all.iter().map(|one| one.area).sum::<f64>() / count;
        assert!((0.36..0.48).contains(&area), "{longest}: {area}");
    }
}

#[test]
fn another_surface_has_the_spectrum_and_the_heights() {
    let surface = RandomSurface::new(2.0, 4.0, 16.0).unwrap().skewness(-1.0).unwrap();
    let map = surface.gradient(0.1).unwrap().side(1e-4).unwrap().seed(3).heights(128).unwrap();
    let (other, third) = (map.another(1), map.another(2));
    assert!(other == map.another(1) && other != third);
    let skewness = |map: &HeightMap| {
        let cube = map.heights().iter().map(|h| h.powi(3)).sum::<f64>();
        cube / map.heights().len() as f64 / map.rms_height().powi(3)
    };
    for other in [other, third] {
        close(other.rms_height(), map.rms_height(), 1e-12);
        close(skewness(&other), skewness(&map), 0.05);
        let is_far = |(a, b): &(&f64, &f64)| (*a - *b).abs() > map.rms_height();
        assert!(other.heights().iter().zip(map.heights()).filter(is_far).count() > 1000);
    }
    // An egg-crate has one shape: others are the same elsewhere, and seal at the same pressure,
    // below which a liquid passes.
    let eggs = wave([64, 64], |x, y| 1e-6 * ((2.0 * x).cos() + (2.0 * y).cos()));
    let [one, other] = [eggs.clone(), eggs.another(5)].map(|map| {
        let elements = BoundaryElements::new(map, MODULUS).unwrap();
        let [x, y] = sealed(&elements).0.map(|one| one.unwrap().pressure);
        close(x, y, 1e-12);
        let fluid = Fluid::Liquid(1e-3);
        let (width_over_length, molecule) = (1.0, MOLECULE);
        let seal = Seal { width_over_length, pressures: [1e6, 0.0], fluid, molecule };
        let flow = |share: f64| {
            let solution = elements.solve(LoadCase::MeanPressure(share * x)).unwrap();
            elements.seal_flows(&solution, &seal).unwrap()[0].flow
        };
        assert!(flow(0.985) > 0.0 && flow(1.015) == 0.0);
        x
    });
    close(one, other, 1e-9);
}
