//! Far below s = 0: the weight is a narrow bump at t = -s, and slopes are small differences.

use std::sync::Arc;

use asperity_quadrature::{AnyScale, Density, Moments, Piece, QuadratureError, ShiftedGaussian};

fn piece(from: f64, to: f64, f: fn(f64) -> f64) -> Piece {
    let sampler = move |x: &[f64], out: &mut [f64]| {
        out.iter_mut().zip(x).for_each(|(out, x)| *out = f(*x));
        Ok::<(), QuadratureError>(())
    };
    Piece { from, to, sign: 1.0, kinks: vec![], origin: None, sampler: Arc::new(sampler) }
}

/// A jump and two regimes, as in the force of Jackson and Green.
fn jump() -> Density {
    let above = |x: f64| {
        let elastic = (-0.25 * x.powf(5.0 / 12.0)).exp() * x.powf(1.5);
        elastic + 7.03 * (1.0 - (-x.powf(5.0 / 9.0) / 25.0).exp()) * x
    };
    Density { pieces: vec![piece(0.0, 1.9, |x| x.powf(1.5)), piece(1.9, f64::INFINITY, above)] }
}

/// Jumps at 1, 6 and 110, as in the force of Kogut and Etsion.
fn jumps() -> Density {
    Density {
        pieces: vec![
            piece(0.0, 1.0, |x| x.powf(1.5)),
            piece(1.0, 6.0, |x| 1.03 * x.powf(1.425)),
            piece(6.0, 110.0, |x| 1.4 * x.powf(1.263)),
            piece(110.0, f64::INFINITY, |x| 3.0 / 0.58 * x),
        ],
    }
}

/// Numbers in [0, 1) without a pattern.
fn share(k: u32, irrational: f64) -> f64 {
    (f64::from(k) * irrational).fract()
}

/// Below -9, where all but 1e-20 of the weight is at t > 0: the moments of a Gaussian about -s.
#[test]
fn powers_are_met_within_bounds_near_rounding_at_every_scale() {
    type Power = (fn(f64) -> f64, i32, fn(f64) -> [f64; 2]);
    let powers: [Power; 3] = [
        (|x| x, 1, |d| [d, 1.0]),
        (|x| x * x, 2, |d| [d * d + 1.0, 2.0 * d]),
        (|x| x * x * x, 3, |d| [d * d * d + 3.0 * d, 3.0 * d * d + 3.0]),
    ];
    for (f, p, exact) in powers {
        let density = Density { pieces: vec![piece(0.0, f64::INFINITY, f)] };
        let any = AnyScale::new(density.clone(), 1e-14);
        for k in 0..4000 {
            let scale = 1e-3 * 1e5f64.powf(share(k, 0.645_751));
            let s = -9.0 - 54.9 * share(k, 0.236_068);
            let check = |found: Moments, way: &str| {
                let [value, slope] = exact(-s).map(|m| m / scale.powi(p));
                let error = (found.value / value - 1.0).abs();
                // The reference itself is rounded.
                assert!(error <= found.error + 1e-15, "{way} {p} {s} {scale}: {error:e} {found:?}");
                let error = (found.slope - slope).abs() / found.sizes[1];
                assert!(error <= found.error, "{way} {p} {s} {scale}: slope {error:e} {found:?}");
                assert!(found.error < 3e-14, "{way} {p} {s} {scale}: {found:?}");
            };
            check(any.at(s, scale).unwrap(), "any scale");
            if k % 100 == 0 {
                check(
                    ShiftedGaussian::new(density.clone(), scale, 1e-14).at(s).unwrap(),
                    "one scale",
                );
            }
        }
    }
}

#[test]
fn slopes_meet_the_tolerance_relative_to_themselves() {
    for (density, name) in [(jump(), "one jump"), (jumps(), "three jumps")] {
        for k in 0..300 {
            let tolerance = 10f64.powf(-1.0 - 10.5 * share(k, 0.605_551));
            let scale = 1e-3 * 1e6f64.powf(share(k, 0.645_751));
            let tight = ShiftedGaussian::new(density.clone(), scale, 1e-14);
            let loose = ShiftedGaussian::new(density.clone(), scale, tolerance);
            let any = AnyScale::new(density.clone(), tolerance);
            for j in 0..5 {
                let s = -63.0 * share(5 * k + j, 0.236_068);
                let exact = tight.at(s);
                let exact = exact.unwrap();
                for found in [loose.at(s).unwrap(), any.at(s, scale).unwrap()] {
                    let error = (found.slope / exact.slope - 1.0).abs();
                    assert!(error < tolerance, "{name} {scale} {s} {tolerance:e}: {error:e}");
                    let error = (found.slope - exact.slope).abs() / exact.sizes[1];
                    assert!(error <= found.error + exact.error, "{name} {scale} {s}: {error:e}");
                }
            }
        }
    }
}

#[test]
fn any_scale_agrees_with_one_scale() {
    for (density, name) in [(jump(), "one jump"), (jumps(), "three jumps")] {
        let tight = AnyScale::new(density.clone(), 1e-14);
        for k in 0..6000 {
            let scale = 1e-2 * 1e3f64.powf(share(k, 0.645_751));
            let s = -8.0 - 56.0 * share(k, 0.236_068);
            let found = tight.value(s, scale);
            assert!(found.is_ok(), "{name} {scale} {s}: {found:?}");
            if k % 40 == 0 {
                let one = ShiftedGaussian::new(density.clone(), scale, 1e-14).value(s).unwrap();
                let (found, error) = (found.unwrap(), one.error);
                let off = (found.value / one.value - 1.0).abs();
                assert!(off <= found.error + error, "{name} {scale} {s}: {off:e}");
                assert!(found.error < 1e-13, "{name} {scale} {s}: {found:?}");
            }
        }
    }
}
