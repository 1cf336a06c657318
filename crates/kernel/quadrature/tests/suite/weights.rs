//! Weights with undeclared kinks, and with poles that hold much of the mass, against closed forms.

use std::sync::Arc;

use asperity_quadrature::{
    Density, Moments, Overlap, OverlapSeries, Piece, QuadratureError, Weight, gauss_kronrod,
};

/// x^p from 0 on.
fn power(p: f64) -> Density {
    let sampler = move |x: &[f64], out: &mut [f64]| {
        out.iter_mut().zip(x).for_each(|(out, x)| *out = x.powf(p));
        Ok::<(), QuadratureError>(())
    };
    let (from, to, kinks) = (0.0, f64::INFINITY, vec![]);
    let piece = Piece { from, to, sign: 1.0, kinks, origin: Some(0.0), sampler: Arc::new(sampler) };
    Density { pieces: vec![piece] }
}

/// Asserts that value and slope are exact within the bound, apart from `rounded`, the rounding of
/// the reference, and that the bound is within the tolerance.
fn check(name: &str, d: f64, found: &Moments, exact: [f64; 2], rounded: f64) {
    let scale = found.ln_scale.exp();
    for (n, found_one) in [found.value, found.slope].into_iter().enumerate() {
        let off = (found_one * scale - exact[n]).abs() / (found.sizes[n] * scale);
        assert!(off <= found.error + rounded, "{name} d {d} [{n}]: {off:e} {found:?} {exact:?}");
    }
    assert!(found.error < 1e-10, "{name} {d}: {:e}", found.error);
}

/// A triangle on [0, 1], whose mode is an undeclared kink.
#[test]
fn undeclared_kinks_are_found_next_to_the_ends_too() {
    let mut modes = vec![0.5, 0.91, 0.93, 0.96, 0.98, 0.04, 0.07];
    for near in (1..=11).map(|k| 10f64.powi(-k)) {
        modes.extend([near, 1.0 - near, 0.3 * near, 1.0 - 0.3 * near]);
    }
    for m in modes {
        let far = 1.0 - m;
        let ln = move |z: f64| {
            let g = if z < m { 2.0 * z / m } else { 2.0 * (1.0 - z) / far };
            if (0.0..=1.0).contains(&z) { g.ln() } else { f64::NEG_INFINITY }
        };
        let weight = Arc::new(Weight::new("triangle", ln, (0.0, 1.0), &[], 0.0).unwrap());
        let overlap = Arc::new(Overlap::new(power(1.0), 1.0, 1e-10));
        let cells = OverlapSeries::new(overlap.clone(), weight.clone());
        for d in [-3.0, -0.7, 0.0, 0.31, 0.93, 0.995] {
            let (below, above): (f64, f64) = (m - d, 1.0 - d);
            let exact = if d <= 0.0 {
                [(1.0 + m) / 3.0 - d, 1.0]
            } else if d < m {
                let value = below.powi(2) * (d + below / 1.5) / m + below * far + far * far / 3.0;
                [value, far + below * (d + m) / m]
            } else {
                [above.powi(3) / (3.0 * far), above * above / far]
            };
            let name = format!("mode {m}");
            check(&name, d, &overlap.at(&weight, d, true).unwrap(), exact, 0.0);
            check(&name, d, &cells.at(d, true).unwrap(), exact, 0.0);
        }
    }
}

/// An undeclared jump next to the end of the support: 3z² below, 0 above.
#[test]
fn a_curved_density_that_ends_before_its_support_does_is_found() {
    for near in (2..=12).map(|k| 10f64.powi(-k)) {
        let end = 1.0 - near;
        let ln = move |z: f64| {
            if (0.0..=end).contains(&z) {
                (3.0 * z * z).ln() - 3.0 * end.ln()
            } else {
                f64::NEG_INFINITY
            }
        };
        let weight = Weight::new("square", ln, (0.0, 1.0), &[], 0.0).unwrap();
        let overlap = Overlap::new(power(1.0), 1.0, 1e-10);
        for d in [-3.0, -0.2] {
            let found = overlap.at(&weight, d, true).unwrap();
            check(&format!("end {end}"), d, &found, [0.75 * end - d, 1.0], 0.0);
        }
    }
}

/// ln B(a, a), by mpmath.
const LN_BETA: [(f64, f64); 7] = [
    (0.051, 3.665_093_610_507_007),
    (0.055, 3.588_961_534_847_205_3),
    (0.06, 3.501_110_722_467_552),
    (0.08, 3.209_441_956_095_204),
    (0.1, 2.981_361_481_037_627),
    (0.2, 2.251_449_827_159_785),
    (0.5, 1.144_729_885_849_400_2),
];

/// Much of Beta(a, a) is next to its ends, at distances below the rounding of places.
#[test]
fn poles_at_both_ends_are_integrated_within_bounds() {
    for (a, ln_beta) in LN_BETA {
        let ln = move |z: f64| (a - 1.0) * (z * (1.0 - z)).ln() - ln_beta;
        let weight = Weight::new("beta", ln, (0.0, 1.0), &[], 0.0).unwrap();
        let overlap = Overlap::new(power(1.0), 1.0, 1e-10);
        for d in [-3.0, -0.7, -0.01] {
            let found = overlap.at(&weight, d, true).unwrap();
            check(&format!("Beta({a}, {a})"), d, &found, [0.5 - d, 1.0], 0.0);
        }
    }
}

/// The last asperities of a table, whose density falls to 0 in its last cell.
#[test]
fn the_upper_end_of_a_table_is_reached_with_few_samples() {
    let end = 1e-6;
    for cell in [1e-6, 2e-9] {
        // Constant but for the first and the last cell, which rise from 0 and fall to 0.
        let height = 1.0 / (2.0 * end - cell);
        let ln = move |z: f64| {
            let share = (end - z.abs()) / cell;
            if share >= 0.0 { (height * share.min(1.0)).ln() } else { f64::NEG_INFINITY }
        };
        let breaks = [cell - end, end - cell];
        let weight = Arc::new(Weight::new("table", ln, (-end, end), &breaks, 0.0).unwrap());
        for unit in [1.3e-8, 1e-5] {
            let overlap = Arc::new(Overlap::new(power(1.5), unit, 1e-10));
            let cells = OverlapSeries::new(overlap.clone(), weight.clone());
            for share in [1e-3, 1e-6, 1e-9, 1e-12, 1e-14, 1e-16] {
                let d = if share > 1e-16 { end * (1.0 - share) } else { end.next_down() };
                let left = end - d;
                let slope = height / cell * left * (left / unit).powf(1.5);
                let exact = [slope * left * (0.4 - 1.0 / 3.5), slope * (1.0 - 0.6)];
                for found in [overlap.at(&weight, d, true), cells.at(d, true)] {
                    let found = found.unwrap();
                    for (n, value) in [found.value, found.slope].into_iter().enumerate() {
                        let off = (value * found.ln_scale.exp() / exact[n] - 1.0).abs();
                        // The height left above d has the rounding of d.
                        let allowed = 1e-10 + 4.0 * f64::EPSILON * end / left;
                        assert!(off <= allowed, "{cell} {unit} {share} [{n}]: {off:e} {found:?}");
                    }
                }
            }
            let after = overlap.at(&weight, end, true).unwrap();
            assert!(after.value == 0.0 && after.slope == 0.0);
        }
    }
}

/// A blend between 1 and 54, as in the law of Zhao, Maietta and Chang, and its derivative.
fn blend(x: f64) -> [f64; 2] {
    let share = (x - 1.0) / 53.0;
    let pressure = (1.0 - 0.6 * (54.0 / x).ln() / 54f64.ln()) / 0.4;
    let area = x * (1.0 + share * share * (3.0 - 2.0 * share));
    let by_x = 1.0 + share * share * (3.0 - 2.0 * share) + x * 6.0 * share * (1.0 - share) / 53.0;
    [pressure * area, pressure * by_x + 1.5 / (54f64.ln() * x) * area]
}

/// The law and its derivative.
fn blended(x: f64) -> [f64; 2] {
    match x {
        x if x <= 0.0 => [0.0; 2],
        x if x < 1.0 => [x.powf(1.5), 1.5 * x.sqrt()],
        x if x < 54.0 => blend(x),
        x => [5.0 * x, 5.0],
    }
}

/// Two trapezia 3 µm apart, 40 nm wide each.
#[test]
fn narrow_peaks_that_hold_a_kink_of_the_law_are_integrated_at_every_separation() {
    let (half, apart, unit) = (2e-8, 1.5e-6, 5.338e-8);
    let density = move |z: f64| {
        let off = (z.abs() - apart).abs();
        ((half - off) / (0.5 * half)).clamp(0.0, 1.0) / (3.0 * half)
    };
    let corners = |c: f64| [-half, -0.5 * half, 0.5 * half, half].map(|off| c + off);
    let breaks = [corners(-apart), corners(apart)].concat();
    let support = (breaks[0], breaks[7]);
    let ln = move |z: f64| density(z).ln();
    let weight = Weight::new("peaks", ln, support, &breaks[1..7], 0.0).unwrap();
    let piece = |from: f64, to: f64, origin| {
        let sampler = |x: &[f64], out: &mut [f64]| {
            out.iter_mut().zip(x).for_each(|(out, x)| *out = blended(*x)[0]);
            Ok::<(), QuadratureError>(())
        };
        Piece { from, to, sign: 1.0, kinks: vec![], origin, sampler: Arc::new(sampler) }
    };
    let pieces = vec![
        piece(0.0, 1.0, Some(0.0)),
        piece(1.0, 54.0, None),
        piece(54.0, f64::INFINITY, Some(0.0)),
    ];
    let overlap = Overlap::new(Density { pieces }, unit, 1e-10);
    for k in 0..2000 {
        let d = -1.55e-6 + 1e-10 * f64::from(k);
        overlap.at(&weight, d, false).unwrap();
        let found = overlap.at(&weight, d, true).unwrap();
        if k % 10 == 0 {
            let mut ends = breaks.clone();
            ends.extend([0.0, 1.0, 54.0].map(|x| d + x * unit));
            ends.sort_by(f64::total_cmp);
            let integral = |n: usize| {
                let f = |z: f64| blended((z - d) / unit)[n] * density(z);
                gauss_kronrod(f, &ends, 1e-13, 100_000).unwrap().value
            };
            // Distances of 1e-8 between places of 1e-6 are rounded by 1e-14 and more.
            check("peaks", d, &found, [integral(0), integral(1) / unit], 1e-13);
        }
    }
}
