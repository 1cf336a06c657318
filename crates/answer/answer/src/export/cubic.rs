//! Cubics between two nodes, through values and slopes (Hermite).

/// The cubic from 0 at t = 0 to 1 at t = 1 with slopes a and b there.
pub(crate) fn value(a: f64, b: f64, t: f64) -> f64 {
    t * (a + t * ((3.0 - 2.0 * a - b) + t * (a + b - 2.0)))
}

/// Its slope.
pub(crate) fn slope(a: f64, b: f64, t: f64) -> f64 {
    a + t * (2.0 * (3.0 - 2.0 * a - b) + 3.0 * t * (a + b - 2.0))
}

/// Whether it rises all the way: the exact condition of Fritsch & Carlson (1980). \[recalled, and
/// checked against the slopes of cubics below\]
pub(crate) fn is_monotone(a: f64, b: f64) -> bool {
    let (excess, lean) = (a + b - 2.0, 2.0 * a + b - 3.0);
    a >= 0.0
        && b >= 0.0
        && (excess <= 0.0 || lean <= 0.0 || a + 2.0 * b <= 3.0 || 3.0 * a * excess >= lean * lean)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_condition_for_cubics_is_that_their_slope_has_no_root_inside() {
        for i in 0..80 {
            for k in 0..80 {
                let (a, b) = (0.06 * f64::from(i), 0.06 * f64::from(k));
                let least = (0..=1000)
                    .map(|t| slope(a, b, f64::from(t) / 1000.0))
                    .fold(f64::INFINITY, f64::min);
                // Within the resolution of 1001 points on a parabola.
                if least.abs() > 1e-4 {
                    assert_eq!(is_monotone(a, b), least > 0.0, "{a} {b} {least}");
                }
            }
        }
    }
}
