//! Ranges of interference in which asperities still touch after a retreat u: δ(w) > u.
//!
//! δ grows with w in most laws; where it decreases, deeper contacts are lost earlier.

use asperity_core::QuadratureError;
use asperity_quadrature::{fallible, highest, last_place};

/// Samples of δ in the search for its extrema in one range.
const SAMPLES: i32 = 128;
/// Decades searched where the range is unbounded.
const DECADES: f64 = 6.0;
/// Relative changes of δ below this are rounding errors.
const ROUNDING: f64 = 1e-12;

/// δ \[m\] of w \[m\].
type Way<'d> = &'d dyn Fn(f64) -> Result<f64, QuadratureError>;

/// Interferences of the extrema of δ between two neighbouring breaks, ascending.
pub(crate) fn recovery_extrema(
    delta: Way<'_>,
    range: [f64; 2],
) -> Result<Vec<f64>, QuadratureError> {
    let [low, high] = finite(range, 0.0);
    // The ends are excluded, as δ may jump there.
    let place = |k: i32| low * (high / low).powf((f64::from(k) + 0.5) / f64::from(SAMPLES));
    let mut turns = vec![];
    // Start and direction of the last step up or down.
    let (mut step, mut before) = (None, (place(0), delta(place(0))?));
    for k in 1..SAMPLES {
        let here = (place(k), delta(place(k))?);
        if (here.1 - before.1).abs() <= ROUNDING * before.1 {
            continue;
        }
        let up = here.1 > before.1;
        if let Some((from, was_up)) = step.filter(|(_, was_up)| *was_up != up) {
            let sign = if was_up { 1.0 } else { -1.0 };
            turns.push(fallible(delta, |delta| highest(|w| sign * delta(w), from, here.0))?);
        }
        step = Some((before.0, up));
        before = here;
    }
    Ok(turns)
}

/// The part of a range with δ > u; δ must be monotonic on the range.
pub(crate) fn contact_range(
    delta: Way<'_>,
    range: [f64; 2],
    u: f64,
) -> Result<Option<[f64; 2]>, QuadratureError> {
    if u == 0.0 {
        return Ok(Some(range));
    }
    // δ is about w; its formula underflows far below.
    let begin = range[0].max(1e-3 * u);
    if begin >= range[1] {
        return Ok(None);
    }
    let lasts = |w: f64| Ok::<_, QuadratureError>(delta(w)? > u);
    let mut end = finite([begin, range[1]], u)[1].next_down();
    let first = lasts(begin)?;
    let mut last = lasts(end)?;
    if range[1] == f64::INFINITY && !first {
        // A growing δ grows at least as √w, so that this limit is beyond any real interference.
        let mut doublings = 0;
        while !last && doublings < 200 {
            (end, doublings) = (2.0 * end, doublings + 1);
            last = lasts(end)?;
        }
    }
    let change = |[lasting, lost]: [f64; 2]| {
        fallible(delta, |delta| last_place(|w| delta(w) > u, lasting, lost))
    };
    Ok(match (first, last) {
        (true, true) => Some([begin, range[1]]),
        (false, true) => Some([change([end, begin])?, range[1]]),
        (true, false) => Some([begin, change([begin, end])?]),
        (false, false) => None,
    })
}

/// Finite, positive ends that replace a range's.
fn finite([low, high]: [f64; 2], u: f64) -> [f64; 2] {
    let ratio = 10f64.powf(DECADES);
    match (low > 0.0, high.is_finite()) {
        (true, true) => [low, high],
        (false, true) => [high / ratio, high],
        (true, false) => [low, ratio * low.max(u)],
        (false, false) => [1.0 / ratio, ratio],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contact_ranges_are_found_on_both_sides_of_an_extremum() {
        // δ = 4 w/(1 + w)²: up to 1 at w = 1, and down again.
        let delta = |w: f64| Ok(4.0 * w / (1.0 + w) / (1.0 + w));
        let turns = recovery_extrema(&delta, [1e-3, f64::INFINITY]).unwrap();
        assert!(turns.len() == 1 && (turns[0] - 1.0).abs() < 1e-7, "{turns:?}");
        // δ = 8/9 at w = 1/2 and 2.
        let u = 8.0 / 9.0;
        let up = contact_range(&delta, [1e-3, 1.0], u).unwrap().unwrap();
        assert!((up[0] - 0.5).abs() < 1e-14 && up[1].total_cmp(&1.0).is_eq(), "{up:?}");
        let down = contact_range(&delta, [1.0, f64::INFINITY], u).unwrap().unwrap();
        assert!(down[0].total_cmp(&1.0).is_eq() && (down[1] - 2.0).abs() < 1e-14, "{down:?}");
        assert!(contact_range(&delta, [1e-3, 0.4], u).unwrap().is_none());
        assert!(contact_range(&delta, [2.5, f64::INFINITY], u).unwrap().is_none());
        // A large retreat with a growing δ.
        let root = |w: f64| Ok(1e-3 * w.sqrt());
        let far = contact_range(&root, [1.0, f64::INFINITY], 10.0).unwrap().unwrap();
        assert!((far[0] / 1e8 - 1.0).abs() < 1e-14, "{far:?}");
    }
}
