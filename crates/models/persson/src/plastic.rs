//! The area of a yielding surface: pressures diffuse between two ends that absorb, 0 and the
//! hardness H.
//!
//! x = p/H and s = √(2 V)/H. Two forms of one sum: waves, which decay fast where s is large, and
//! mirror images, which decay fast where it is small.

use std::f64::consts::{FRAC_2_SQRT_PI, PI};

use libm::{erf, erfc};

use crate::area::GAMMA;

/// Images are summed up to this s, waves beyond: two images at most, and ten waves.
const IMAGES: f64 = 0.4;
/// A decay below which a wave does not change the sum.
const LEAST_WAVE: f64 = 1e-18;
/// Images that are closer over s are subtracted by a series.
const NEAR: f64 = 1e-4;
/// A relative step of Newton's method after which the next one is below rounding.
const SHORT: f64 = 1e-9;
const STEPS: usize = 40;

/// The areas at an s, over the nominal one.
#[derive(Debug, Clone, Copy)]
struct Areas {
    /// Elastic and plastic together.
    total: f64,
    /// Slope of the total with s.
    slope: f64,
    plastic: f64,
}

/// A/A_n and its plastic part at x < 1; s = `full` √(γ + (1-γ) A/A_n).
pub(crate) fn areas(x: f64, full: f64) -> [f64; 2] {
    let at = |s: f64| if s > IMAGES { by_waves(x, s) } else { by_images(x, s) };
    let area = root(at, full);
    [area, at(spread(full, area)).plastic]
}

/// s at an area fraction.
fn spread(full: f64, area: f64) -> f64 {
    full * (GAMMA + (1.0 - GAMMA) * area).sqrt()
}

/// The total area, which falls with s, at its own s.
fn root(mut at: impl FnMut(f64) -> Areas, full: f64) -> f64 {
    let (mut low, mut high) = (at(full).total, at(spread(full, 0.0)).total);
    let mut area = high;
    for _ in 0..STEPS {
        let s = spread(full, area);
        let Areas { total, slope, .. } = at(s);
        *if area > total { &mut high } else { &mut low } = area;
        let rise = 1.0 - slope * full * (full / s) * 0.5 * (1.0 - GAMMA);
        let next = area - (area - total) / rise;
        if (next - area).abs() <= SHORT * area {
            return next;
        }
        area = if (low..=high).contains(&next) { next } else { 0.5 * (low + high) };
    }
    area
}

/// The sums of 2/(n π) sin(n π x) exp(-(n π s/2)²), for n = 1, 2, ..., with their signs.
fn by_waves(x: f64, s: f64) -> Areas {
    let mut areas = Areas { total: x, slope: 0.0, plastic: x };
    for n in 1.. {
        let phase = f64::from(n) * PI;
        let decay = (-(0.5 * phase * s).powi(2)).exp();
        if decay < LEAST_WAVE {
            break;
        }
        let wave = 2.0 / phase * (phase * x).sin() * decay;
        areas.total += wave;
        areas.slope -= 0.5 * phase * phase * s * wave;
        areas.plastic += if n % 2 == 1 { -wave } else { wave };
    }
    // Rounding can leave less than nothing.
    Areas { plastic: areas.plastic.max(0.0), ..areas }
}

fn by_images(x: f64, s: f64) -> Areas {
    let moved = |c: f64| FRAC_2_SQRT_PI * c / s / s * (-(c / s).powi(2)).exp();
    Areas {
        total: erf(x / s) + image(2.0, x, s),
        slope: moved(2.0 - x) - moved(2.0 + x) - moved(x),
        plastic: image(1.0, x, s) + image(3.0, x, s),
    }
}

/// erfc((c-x)/s) - erfc((c+x)/s).
fn image(c: f64, x: f64, s: f64) -> f64 {
    let (u, d) = (c / s, x / s);
    if d > NEAR {
        return erfc((c - x) / s) - erfc((c + x) / s);
    }
    2.0 * FRAC_2_SQRT_PI * d * (-u * u).exp() * (1.0 + (2.0 * u * u - 1.0) * d * d / 3.0)
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

    use super::*;
    use crate::PerssonVariance;

    /// s at full contact over E g/H.
    const FULL: f64 = FRAC_1_SQRT_2;

    /// x, E g/H, A and A_pl with 60 digits: see the script.
    fn reference() -> Vec<[f64; 4]> {
        let text = include_str!("../../../../tests/reference/persson_plastic.csv");
        let row =
            |line: &str| -> Vec<f64> { line.split(',').map(|x| x.parse().unwrap()).collect() };
        text.lines().skip(1).map(|line| row(line).try_into().unwrap()).collect()
    }

    #[test]
    fn areas_are_those_of_sixty_digits() {
        let rows = reference();
        let mut worst: f64 = 0.0;
        for [x, strain, area, plastic] in &rows {
            let found = areas(*x, FULL * strain);
            for (found, wanted) in found.into_iter().zip([area, plastic]) {
                worst = worst.max((found - wanted).abs() / area);
            }
        }
        assert!(rows.len() > 150 && worst < 2e-15, "{worst:e}");
    }

    #[test]
    fn an_area_takes_at_most_six_sums() {
        let sums = |x: f64, full: f64| {
            let sums = Cell::new(0);
            let counting = |s| {
                sums.set(sums.get() + 1);
                if s > IMAGES { by_waves(x, s) } else { by_images(x, s) }
            };
            root(counting, full);
            sums.get()
        };
        let most = reference().iter().map(|[x, strain, ..]| sums(*x, FULL * strain)).max();
        assert_eq!(most, Some(6));
    }

    #[test]
    fn waves_and_images_are_one_sum() {
        for s in [0.35, IMAGES, 0.41] {
            for x in [1e-9, 1e-3, 0.3, 0.7, 0.999] {
                let [waves, images] = [by_waves(x, s), by_images(x, s)];
                assert!((waves.total / images.total - 1.0).abs() < 3e-15, "{s} {x}");
                assert!((waves.slope / images.slope - 1.0).abs() < 1e-12, "{s} {x}");
                let off = (waves.plastic - images.plastic).abs() / images.total;
                assert!(off < 3e-15, "{s} {x}: {off}");
            }
        }
    }

    #[test]
    fn a_hard_surface_is_elastic_and_a_soft_one_plastic() {
        for x in [1e-9, 1e-6, 1e-3] {
            let [area, plastic] = areas(x, 1e-2);
            let elastic = PerssonVariance::Fudge.area_fraction(x * SQRT_2 / 1e-2);
            assert!((area / elastic - 1.0).abs() < 1e-14 && plastic < 1e-100, "{x}");
            assert!(areas(x, 1e3).iter().all(|area| area.total_cmp(&x).is_eq()), "{x}");
        }
    }

    #[test]
    fn areas_grow_with_the_pressure_and_carry_it() {
        for strain in [1e-3, 0.1, 0.5, 0.6, 0.8, 1.0, 3.0, 1e4] {
            let mut before = [0.0; 2];
            for k in 1..1000 {
                let x = f64::from(k) / 1000.0;
                let found = areas(x, FULL * strain);
                assert!(found[0] >= before[0] && found[1] >= before[1], "{x} {strain}");
                assert!(
                    found[0] >= x && found[1] <= x && found[0] <= 1.0,
                    "{x} {strain} {found:?}"
                );
                before = found;
            }
        }
    }
}
