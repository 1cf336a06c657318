//! Roots, changes of a condition, and maxima of a function between two places.

/// The result of `search` for a function `f` that may fail: `search` sees NaN in place of an error,
/// and its result is dropped if there was one.
///
/// # Errors
/// The first error of `f`.
pub fn fallible<T, E>(
    mut f: impl FnMut(f64) -> Result<f64, E>,
    search: impl FnOnce(&mut dyn FnMut(f64) -> f64) -> T,
) -> Result<T, E> {
    let mut first = None;
    let found = search(&mut |x| {
        f(x).unwrap_or_else(|error| {
            first.get_or_insert(error);
            f64::NAN
        })
    });
    first.map_or(Ok(found), Err)
}

/// The x in [low, high] with f(x) = 0 to the last bits, by bisection and the secant (the
/// "Illinois" rule); `None` when the signs at both ends agree or a value is not finite.
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
        if !value.is_finite() {
            return None;
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

/// The last number on the way from `holding` to `lost` at which a condition holds, by bisection: at
/// the next number it does not.
pub fn last_place(mut holds: impl FnMut(f64) -> bool, mut holding: f64, mut lost: f64) -> f64 {
    loop {
        let middle = lost + 0.5 * (holding - lost);
        if [holding, lost].iter().any(|end| end.to_bits() == middle.to_bits()) {
            return holding;
        }
        *(if holds(middle) { &mut holding } else { &mut lost }) = middle;
    }
}

/// The place of the only maximum of a function between `low` and `high`, by golden sections, to
/// 4e-9 of their distance: values do not determine it much better.
pub fn highest(mut f: impl FnMut(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    const SECTION: f64 = 0.618_033_988_749_894_9;
    let inside =
        |low: f64, high: f64| (high - SECTION * (high - low), low + SECTION * (high - low));
    let (mut a, mut b) = inside(low, high);
    let (mut at_a, mut at_b) = (f(a), f(b));
    let narrow = 4e-9 * (high - low);
    while high - low > narrow {
        if at_a > at_b {
            (high, b, at_b) = (b, a, at_a);
            a = inside(low, high).0;
            at_a = f(a);
        } else {
            (low, a, at_a) = (a, b, at_b);
            b = inside(low, high).1;
            at_b = f(b);
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_found_where_the_sign_changes() {
        let root = bracketed_root(|x| x * x - 2.0, 0.0, 2.0).unwrap();
        assert!((root - 2f64.sqrt()).abs() < 4e-16);
        let steep = bracketed_root(|x| (x - 1e-9).cbrt(), -1.0, 1.0).unwrap();
        assert!((steep - 1e-9).abs() < 1e-15);
        assert!(bracketed_root(|x| x * x + 1.0, -1.0, 1.0).is_none());
        assert!(bracketed_root(|_| f64::NAN, -1.0, 1.0).is_none());
        let broken = |x: f64| if x.abs() < 0.5 { f64::NAN } else { x };
        assert!(bracketed_root(broken, -1.0, 1.0).is_none());
    }

    #[test]
    fn the_first_failure_is_returned() {
        let f = |x: f64| if (0.5..0.9).contains(&x) { Err(x) } else { Ok(x - 0.7) };
        let failed = fallible(f, |f| bracketed_root(f, 0.0, 1.0)).unwrap_err();
        assert!((0.5..0.9).contains(&failed));
        let root = fallible(|x| Ok::<_, f64>(x - 0.7), |f| bracketed_root(f, 0.0, 1.0));
        assert_eq!(root, Ok(Some(0.7)));
    }

    #[test]
    fn changes_of_a_condition_and_maxima_are_found() {
        for (from, to) in [(0.0, 3.0), (-1.0, 7.0)] {
            let last = last_place(|x| x * x < 2.0, from, to);
            assert!(last * last < 2.0 && last.next_up() * last.next_up() >= 2.0, "{last}");
        }
        let first = last_place(|x| x * x > 2.0, 3.0, 0.0);
        assert!(first * first > 2.0 && first.next_down() * first.next_down() <= 2.0, "{first}");
        let top = highest(|x| x * (2.0 - x), -1.0, 5.0);
        assert!((top - 1.0).abs() < 3e-8, "{top}");
    }
}
