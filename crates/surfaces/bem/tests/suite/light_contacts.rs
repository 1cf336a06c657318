//! Contacts of few pixels against the same contacts on the whole map.

use asperity_bem::{BemError, Boundary, BoundaryElements, LoadCase};

use crate::{MODULUS, UNIT, close, is_long, rough};

#[test]
fn contacts_of_few_pixels_are_those_of_the_whole_map() {
    let cases = [(1, None), (3, Some(0.3)), (2, None), (4, Some(0.1))];
    for (seed, hardness) in cases.into_iter().take(if is_long() { 4 } else { 2 }) {
        let solver = BoundaryElements::new(rough(256, seed), MODULUS).unwrap();
        let solver = solver.tolerance(1e-11).unwrap();
        let solver = match hardness {
            Some(hardness) => solver.hardness(hardness * UNIT).unwrap(),
            None => solver,
        };
        // Not in order; the lightest holds a few pixels.
        let pressures = [1e-3, 3e-3, 1e-5, 1e-4].map(|share| share * UNIT);
        let found = solver.solve_light(&pressures).unwrap();
        for (pressure, light) in pressures.into_iter().zip(&found) {
            let whole = solver.solve(LoadCase::MeanPressure(pressure)).unwrap();
            close(light.mean_pressure, pressure, 1e-12);
            assert_eq!(light.pixel_area.to_bits(), whole.pixel_area.to_bits(), "{seed} {pressure}");
            assert_eq!(light.plastic_area.to_bits(), whole.plastic_area.to_bits());
            assert_eq!(light.patches, whole.patches);
            close(light.area, whole.area, 1e-12);
            close(light.mean_gap, whole.mean_gap, 1e-9);
            close(light.gap_volume, whole.gap_volume, 1e-9);
            let fixed = solver.fixed_contact(&whole).unwrap();
            close(light.unloading_stiffness, fixed.stiffness, 1e-8);
            for (at, pressure) in &light.pressures {
                close(*pressure, whole.pressures[*at], 1e-4);
            }
            assert!(light.residual <= 1e-11);
        }
    }
}

#[test]
fn heavy_loads_and_free_boundaries_are_refused() {
    let solver = BoundaryElements::new(rough(256, 1), MODULUS).unwrap();
    let heavy = solver.solve_light(&[0.1 * UNIT]).unwrap_err();
    assert!(matches!(heavy, BemError::NotLight { most: 5000, .. }), "{heavy}");
    let free = solver.clone().boundary(Boundary::Free).solve_light(&[1e-4 * UNIT]).unwrap_err();
    assert!(matches!(free, BemError::NotLight { most: 0, .. }), "{free}");
    let none = solver.solve_light(&[f64::NAN]).unwrap_err().to_string();
    assert!(none.contains("pressure is NaN"), "{none}");
    let soft = solver.hardness(1e-4 * UNIT).unwrap().solve_light(&[2e-4 * UNIT]).unwrap_err();
    assert!(matches!(soft, BemError::CannotBeCarried { .. }), "{soft}");
}
