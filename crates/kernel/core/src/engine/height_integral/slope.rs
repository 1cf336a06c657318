//! Slopes far below the heights.

use std::sync::{Arc, LazyLock};

use asperity_quadrature::{Density, Moments, Nearby, Overlap, QuadratureError, Weight};

/// Below this s a slope is a small difference of large integrals: with a finer law and a finer
/// integral by [`FINER_BELOW`], enough digits are left down to about s = -64.
pub(crate) const SLOPES_CANCEL: f64 = -8.0;
pub(super) const FINER_BELOW: f64 = 0.01;
/// No law that is sampled is better than this.
const FINEST_LAW: f64 = 1e-13;

/// `found`, an integral at s with its slope, or a finer integral if its slope misses the tolerance
/// and the finer one meets it.
/// `finer` returns the density to a smaller tolerance.
#[inline(always)]
pub(crate) fn with_slope_within(
    found: Moments,
    finer: impl Fn(f64) -> Density,
    (scale, s): (f64, f64),
    tolerance: f64,
) -> Moments {
    if s >= SLOPES_CANCEL || found.slope_within(s, tolerance).is_ok() {
        return found;
    }
    let better = integral_within(&finer, (scale, s), tolerance);
    better.map_or(found, |better| found.with_slope(&better, s))
}

#[cold]
fn integral_within(
    density: &dyn Fn(f64) -> Density,
    (scale, s): (f64, f64),
    tolerance: f64,
) -> Option<Moments> {
    let finer = FINER_BELOW * tolerance;
    let made = Nearby::new(&density(finer), scale, s, finer).map(|made| made.at(s));
    // Farther down, derivatives of the law are averaged instead: those of samples err by as much
    // more than the samples as s is deep.
    let derived = || {
        let weight = GAUSSIAN.as_ref().map_err(Clone::clone)?;
        let finer = (0.1 * tolerance / (1.0 - s)).max(FINEST_LAW);
        let density = density(finer);
        let own = if density.knows_slope() { 0.0 } else { finer * (1.0 - s) };
        let made = Overlap::new(density, scale, tolerance).at(weight, s, true)?;
        Ok::<_, QuadratureError>(Moments { error: made.error + own, ..made })
    };
    let within = |made: &Moments| made.slope_within(s, tolerance).is_ok();
    made.ok().filter(within).or_else(|| derived().ok().filter(within))
}

/// exp(-z²/2)/√(2π).
static GAUSSIAN: LazyLock<Result<Arc<Weight>, QuadratureError>> = LazyLock::new(|| {
    let ln = |z: f64| -0.5 * z * z - 0.5 * (2.0 * std::f64::consts::PI).ln();
    let everywhere = (f64::NEG_INFINITY, f64::INFINITY);
    Weight::new("the Gaussian density", ln, everywhere, &[], 0.0).map(Arc::new)
});
