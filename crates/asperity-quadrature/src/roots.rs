//! A root of a continuous function between two points where its sign differs.

/// Finds x in [low, high] with f(x) = 0 to the last bits, by bisection sped up with the secant
/// (the "Illinois" rule); `None` when the signs at both ends agree or a value is not finite.
#[must_use]
pub fn bracketed_root(mut f: impl FnMut(f64) -> f64, mut low: f64, mut high: f64) -> Option<f64> {
    let (mut f_low, mut f_high) = (f(low), f(high));
    if f_low == 0.0 {
        return Some(low);
    }
    if f_high == 0.0 {
        return Some(high);
    }
    if !f_low.is_finite() || !f_high.is_finite() || f_low.signum() * f_high.signum() > 0.0 {
        return None;
    }
    let mut side = 0;
    for step in 0..200 {
        let width = high - low;
        if width.abs() <= 2.0 * f64::EPSILON * high.abs().max(low.abs()) {
            break;
        }
        // Every third step halves the bracket, so that a bad secant cannot stall.
        let x =
            if step % 3 == 2 { 0.5 * (low + high) } else { low - f_low * width / (f_high - f_low) };
        let x = if x > low.min(high) && x < low.max(high) { x } else { 0.5 * (low + high) };
        let value = f(x);
        if value == 0.0 {
            return Some(x);
        }
        if value.signum() * f_low.signum() > 0.0 {
            (low, f_low) = (x, value);
            if side == 1 {
                f_high *= 0.5;
            }
            side = 1;
        } else {
            (high, f_high) = (x, value);
            if side == -1 {
                f_low *= 0.5;
            }
            side = -1;
        }
    }
    Some(0.5 * (low + high))
}

#[cfg(test)]
mod tests {
    use super::bracketed_root;

    #[test]
    fn finds_roots_and_refuses_where_there_is_none() {
        let root = bracketed_root(|x| x * x - 2.0, 0.0, 2.0).unwrap();
        assert!((root - 2f64.sqrt()).abs() < 4e-16);
        let steep = bracketed_root(|x| (x - 1e-9).cbrt(), -1.0, 1.0).unwrap();
        assert!((steep - 1e-9).abs() < 1e-15);
        assert!(bracketed_root(|x| x * x + 1.0, -1.0, 1.0).is_none());
        assert!(bracketed_root(|_| f64::NAN, -1.0, 1.0).is_none());
    }
}
