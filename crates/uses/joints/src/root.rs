//! Roots of falling functions that may fail.

use asperity_core::ContactError;
use asperity_quadrature::{bracketed_root, fallible};

/// Largest retreat searched \[σ_z\].
pub(crate) const MAX_DISTANCE: f64 = 1e4;

/// The root of a falling `f`, searched from `low` in steps that double up to `farthest`; `low`
/// where `f` is not positive there, `None` where `f` is still positive at the end.
pub(crate) fn falling_root(
    f: impl Fn(f64) -> Result<f64, ContactError>,
    (mut low, mut high): (f64, f64),
    farthest: f64,
) -> Result<Option<f64>, ContactError> {
    if f(low)? <= 0.0 {
        return Ok(Some(low));
    }
    while f(high)? > 0.0 {
        (low, high) = (high, 2.0 * high);
        if high > farthest {
            return Ok(None);
        }
    }
    // Minus infinity, the logarithm of 0, is replaced by a finite value.
    fallible(|x| Ok(f(x)?.max(-f64::MAX)), |f| bracketed_root(f, low, high))
}
