//! Where something that falls reaches 0, by functions that may fail.

use asperity_core::ContactError;
use asperity_quadrature::{bracketed_root, fallible};

/// Nothing is looked for beyond this \[σ_z\].
pub(crate) const MAX_DISTANCE: f64 = 1e4;

/// Where `f` falls to 0, from between two places on, and twice as far each time up to the farthest;
/// the first place where it is no more than that already, and `None` where it is not yet.
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
    // An infinite fall (the logarithm of nothing) is as good as any.
    fallible(|x| Ok(f(x)?.max(-f64::MAX)), |f| bracketed_root(f, low, high))
}
