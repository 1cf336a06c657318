//! The lay of a surface: waves are longer along one direction.

use super::{RandomSurface, Wave};
use crate::BemError;

/// Accepted deviation of the ratio of slopes, and of the direction \[rad\].
const TOLERANCE: f64 = 1e-3;
/// What waves that are few still reach.
const WORST: f64 = 1e-2;

/// A stretch of the waves along a direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lay {
    /// The ratio of slopes and the direction that were asked for.
    pub(super) asked: [f64; 2],
    stretch: f64,
    direction: f64,
}

impl Lay {
    /// The lay whose waves on this surface have a ratio of slopes and a direction; none for a
    /// ratio of 1.
    pub(super) fn new(
        surface: &RandomSurface,
        ratio: f64,
        direction: f64,
    ) -> Result<Option<Self>, BemError> {
        let refused = |field, found, required| Err(BemError::OutOfRange { field, found, required });
        if !(1.0..=100.0).contains(&ratio) {
            return refused("ratio of slopes", ratio, "a number from 1 to 100");
        }
        if !(-10.0..=10.0).contains(&direction) {
            return refused("direction of the lay", direction.to_degrees(), "an angle in degrees");
        }
        if ratio <= 1.0 {
            return Ok(None);
        }
        // A ring of stretched waves has the ratio of its stretch; the lattice of those that fit on
        // the size has another one, and another direction.
        let mut lay = Self { asked: [ratio, direction], stretch: ratio, direction };
        let mut best = (f64::INFINITY, lay);
        for _ in 0..40 {
            let made = RandomSurface { lay: Some(lay), ..*surface };
            let Some((found, towards)) = slopes(&made) else { break };
            // Directions are equal modulo half a turn.
            let turn = 0.5 * (2.0 * (direction - towards)).sin();
            let off = (found / ratio - 1.0).abs().max(turn.abs());
            if off < best.0 {
                best = (off, lay);
            }
            if off < TOLERANCE {
                break;
            }
            lay.stretch = (lay.stretch * (ratio / found).powf(0.7)).clamp(1.0, 1e4);
            lay.direction += 0.7 * turn;
        }
        if best.0 > WORST {
            let required =
                "a ratio that the waves on this size can have (a larger size or shorter waves)";
            return refused("ratio of slopes", ratio, required);
        }
        Ok(Some(best.1))
    }

    /// The wave number at which the spectrum is taken: of the wave across the lay.
    pub(super) fn across(&self, [x, y]: [f64; 2]) -> f64 {
        let (sin, cos) = self.direction.sin_cos();
        (self.stretch * (x * cos + y * sin)).hypot(y * cos - x * sin)
    }
}

/// The ratio of the principal rms slopes, and the direction of the lesser one \[rad\].
fn slopes(surface: &RandomSurface) -> Option<(f64, f64)> {
    let [mut xx, mut xy, mut yy] = [0.0; 3];
    for Wave { i, j, weight, .. } in surface.waves() {
        let [x, y] = [j as f64, i as f64 * surface.aspect];
        xx += weight * x * x;
        xy += weight * x * y;
        yy += weight * y * y;
    }
    let (mean, half) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
    let across = 0.5 * xy.atan2(0.5 * (xx - yy));
    let least = (xx * yy - xy * xy) / (mean + half);
    (least > 0.0).then(|| (((mean + half) / least).sqrt(), across + std::f64::consts::FRAC_PI_2))
}
