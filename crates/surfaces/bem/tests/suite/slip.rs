//! Partial slip of a scan against Cattaneo and Mindlin, and against itself.

use asperity_bem::{BemError, Boundary, BoundaryElements, ContactSlip, LoadCase};

use crate::{MODULUS, UNIT, close, is_long, paraboloid, rough};

const FRICTION: f64 = 0.3;
/// 4 G/E of like bodies with ν = 0.3.
const RATIO: f64 = 1.4 / 1.7;

/// With s = u/u_s: Q = μ P (1 - (1-s)^1.5), and the loss of a cycle by its integral.
#[test]
fn a_sphere_slips_as_cattaneo_and_mindlin_found() {
    let (radius, load, n) = (1e-3, 2.0, 121);
    let contact = (3.0 * load * radius / (4.0 * MODULUS)).cbrt();
    let step = 3.0 * contact / n as f64;
    let map = paraboloid(n, step, radius);
    let area = map.area();
    let solver = BoundaryElements::new(map, MODULUS).unwrap().boundary(Boundary::Free);
    let solution = solver.solve(LoadCase::Load(load)).unwrap();
    let slip = ContactSlip::new(solver, &solution, FRICTION, RATIO).unwrap();
    let whole = FRICTION * contact * contact / radius / RATIO;
    close(slip.limit() * area, FRICTION * load, 1e-6);
    for s in if is_long() { &[0.1, 0.3, 0.6, 0.9, 1.2][..] } else { &[0.3, 1.2] } {
        let s = *s;
        let left = 1.0 - f64::min(s, 1.0);
        let [force, under] = [1.0 - left.powf(1.5), s - 0.4 * (1.0 - left.powf(2.5))];
        close(slip.traction(s * whole).unwrap() * area, FRICTION * load * force, 3e-3);
        let loss = FRICTION * load * whole * (8.0 * under - 4.0 * force * s);
        // A small difference of large terms at small shifts.
        close(slip.loss(s * whole).unwrap() * area, loss, if s < 0.5 { 0.02 } else { 3e-3 });
        if s < 1.0 {
            let back = slip.shift_at(FRICTION * load * force / area).unwrap();
            close(back, s * whole, 3e-3);
        }
    }
    // The stick zone has the radius a (1-s)^(1/2).
    let (_, sticks) = slip.tractions(0.6 * whole).unwrap();
    let touching = solution.pressures.iter().filter(|p| **p > 0.0).count();
    let sticking = sticks.iter().filter(|sticks| **sticks).count();
    close(sticking as f64 / touching as f64, 0.4, 0.02);
}

#[test]
fn a_rough_contact_slips_more_and_more() {
    let solver = BoundaryElements::new(rough(64, 3), MODULUS).unwrap();
    let solution = solver.solve(LoadCase::MeanPressure(0.02 * UNIT)).unwrap();
    let stiffness = solver.fixed_contact(&solution).unwrap().stiffness;
    let slip = ContactSlip::new(solver.clone(), &solution, FRICTION, RATIO).unwrap();
    let sliding = slip.shift_at(0.99 * slip.limit()).unwrap();
    // At first all contacts are held.
    let start = 1e-4 * sliding;
    close(slip.traction(start).unwrap() / start, RATIO * stiffness, 0.01);
    let (mut force, mut loss) = (0.0, 0.0);
    for k in 1..=12 {
        let shift = 0.1 * f64::from(k) * sliding;
        let found = [slip.traction(shift).unwrap(), slip.loss(shift).unwrap()];
        assert!(found[0] > force && found[0] <= slip.limit() && found[1] > loss, "{k}: {found:?}");
        [force, loss] = found;
        let (tractions, sticks) = slip.tractions(shift).unwrap();
        let most = tractions.iter().zip(&solution.pressures).zip(&sticks);
        for ((traction, pressure), sticks) in most {
            let limit = FRICTION * pressure;
            assert!((-1e-9 * UNIT..=limit).contains(traction), "{traction} of {limit}");
            assert!(*sticks || (traction - limit).abs() <= 1e-12 * limit, "{traction} of {limit}");
        }
        let total = tractions.iter().sum::<f64>() / tractions.len() as f64;
        close(total, force, 1e-6);
    }
    // The area of the loop by its corners, against that by the energies.
    let (n, amplitude) = (40, 0.5 * sliding);
    let at = |k: usize| slip.traction(amplitude * k as f64 / n as f64).unwrap();
    let simpson: f64 = (0..n).step_by(2).map(|k| at(k) + 4.0 * at(k + 1) + at(k + 2)).sum();
    let under = simpson * amplitude / (3 * n) as f64;
    close(slip.loss(amplitude).unwrap(), 8.0 * under - 4.0 * at(n) * amplitude, 3e-3);
}

#[test]
fn yielding_and_wrong_numbers_are_refused() {
    let elastic = BoundaryElements::new(rough(32, 1), MODULUS).unwrap();
    let soft = elastic.clone().hardness(0.1 * UNIT).unwrap();
    let given = LoadCase::MeanPressure(0.02 * UNIT);
    let yielded = soft.solve(given).unwrap();
    let text = ContactSlip::new(soft, &yielded, FRICTION, RATIO).unwrap_err().to_string();
    assert!(text.contains("hardness is 0."), "{text}");
    let solution = elastic.solve(given).unwrap();
    let slip = |friction, ratio| ContactSlip::new(elastic.clone(), &solution, friction, ratio);
    assert!(matches!(slip(0.0, RATIO), Err(BemError::OutOfRange { field: "friction", .. })));
    let slip = slip(FRICTION, RATIO).unwrap();
    for shift in [-1e-9, f64::NAN] {
        assert!(matches!(slip.traction(shift), Err(BemError::OutOfRange { field: "shift", .. })));
    }
    assert!(slip.shift_at(slip.limit()).is_err());
}
