//! Point masses of a density times a smooth weight, on panels refined until resolved.

pub(crate) mod panel;

use std::cmp::Ordering;

use crate::{Density, Piece, PointMasses, QuadratureError, WeightFunction};
use panel::{POINTS, Panel};

/// Without a known origin, each panel ends at most at this multiple of its beginning.
const RATIO: f64 = 4.0;
/// Depth of bisection; a thinner panel carries less than any tolerance.
const DEEPEST: u32 = 50;
/// Bisection of a panel also stops after this number of halvings in a row that did not help.
const STALLED: u32 = 4;

/// All bisection stops at this number of samples: dozens of undeclared kinks need a tenth of them,
/// and noise has no end.
const MOST: usize = 200_000;

/// Wanted and accepted error, relative to the integral of the absolute value.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Goal {
    /// Panels are bisected to this error,
    pub(crate) aim: f64,
    /// and a larger one than this is refused: an aim near rounding may be missed by a little.
    pub(crate) refuse: f64,
}

/// The point masses that replace `density(x) · weight(x)` on `[low, high]`.
///
/// `edges` are extra panel ends that suit the weight; the density's own breaks are added. Panels
/// are bisected until the sum of their estimated errors is below the goal's aim times the integral
/// of the absolute value, or until they are too thin to matter.
///
/// # Errors
/// A refusal of a sampler, a sample that is not finite, and [`QuadratureError::NotConverged`] when
/// the error estimate stays above the accepted one.
pub(crate) fn discretise(
    density: &Density,
    (low, high): (f64, f64),
    edges: &[f64],
    weight: &dyn Fn(f64) -> f64,
    goal: Goal,
) -> Result<PointMasses, QuadratureError> {
    let Goal { aim, refuse } = goal;
    let (mut result, sampled) = own_masses(density, (low, high), edges, weight, aim)?;
    let density = sampled.as_ref().unwrap_or(density);
    let mut panels = first_panels(density, low, high, edges);
    let mut evaluations = result.evaluations;
    for panel in &mut panels {
        evaluations += panel.sample(density, weight)?;
    }
    // Each panel is allowed its share of the error of the sum, which is known after the first pass;
    // a panel below the rounding of the sum is not bisected.
    let count = panels.len().max(1) as f64;
    let mut stuck = result.error;
    let mut done = Vec::with_capacity(panels.len());
    let own: f64 = result.masses.iter().map(|m| m.abs()).sum();
    let mut total = own + panels.iter().map(Panel::size).sum::<f64>();
    while let Some(panel) = panels.pop() {
        let allowed = (aim / count).max(1e-17) * total;
        let given_up = panel.depth >= DEEPEST || panel.stalled >= STALLED || evaluations >= MOST;
        if panel.error <= allowed || given_up {
            stuck += panel.error;
            done.push(panel);
            continue;
        }
        total -= panel.size();
        let mut halves = panel.halves();
        for half in &mut halves {
            evaluations += half.sample(density, weight)?;
            total += half.size();
        }
        // A kink or a jump remains in one half, noise in both, where halving does not help.
        let noisy = halves[0].error + halves[1].error > 0.75 * panel.error;
        for mut half in halves {
            half.stalled = if noisy { panel.stalled + 1 } else { 0 };
            panels.push(half);
        }
    }
    let floor = total * 1e-19 / (done.len() * POINTS).max(1) as f64;
    (result.error, result.evaluations) = (stuck, evaluations);
    for panel in done.iter().rev() {
        for (&x, &mass) in panel.points.iter().zip(&panel.masses) {
            if mass.abs() > floor {
                result.points.push(x);
                result.masses.push(mass);
            }
        }
    }
    if stuck > refuse * total {
        return Err(QuadratureError::missed(stuck / total, aim, evaluations));
    }
    Ok(result)
}

/// The masses of pieces that provide them, and the density without those pieces, if there are any.
fn own_masses(
    density: &Density,
    range: (f64, f64),
    edges: &[f64],
    weight: &dyn Fn(f64) -> f64,
    aim: f64,
) -> Result<(PointMasses, Option<Density>), QuadratureError> {
    let (mut all, mut own) = (PointMasses::default(), vec![]);
    let mut against = WeightFunction { range, edges, weight, aim, beside: 0.0 };
    // A piece that is small beside others needs fewer digits, so the largest comes first: likely
    // the one that begins just before the weight is largest.
    let likely = 0.6 * against.likely();
    let beyond = |piece: &Piece| (piece.from > likely, (piece.from - likely).abs());
    let mut pieces: Vec<(usize, &Piece)> = density.pieces.iter().enumerate().collect();
    pieces.sort_by(|(_, a), (_, b)| beyond(a).partial_cmp(&beyond(b)).unwrap_or(Ordering::Equal));
    for (k, piece) in pieces {
        let Some(found) = piece.sampler.masses(&against) else { continue };
        if let Some(k) = found.masses.iter().position(|mass| !mass.is_finite()) {
            let (at, value) = (found.points[k], found.masses[k]);
            return Err(QuadratureError::NotFinite { at, value });
        }
        own.push(k);
        against.beside += found.masses.iter().map(|m| m.abs()).sum::<f64>();
        all.points.extend(found.points);
        all.masses.extend(found.masses.iter().map(|m| piece.sign * m));
        all.error += found.error;
        all.evaluations += found.evaluations;
    }
    let sampled = || density.pieces.iter().enumerate().filter(|(k, _)| !own.contains(k));
    let sampled = (!own.is_empty())
        .then(|| Density { pieces: sampled().map(|(_, piece)| piece.clone()).collect() });
    Ok((all, sampled))
}

fn first_panels(density: &Density, low: f64, high: f64, edges: &[f64]) -> Vec<Panel> {
    let kinks = density.breaks(low, high);
    let mut panels = Vec::new();
    let mut left = low;
    for right in kinks.iter().copied().chain([high]) {
        if density.active(left, right).next().is_some() {
            panels_between_kinks(density, left, right, edges, &mut panels);
        }
        left = right;
    }
    panels
}

fn panels_between_kinks(
    density: &Density,
    left: f64,
    right: f64,
    edges: &[f64],
    panels: &mut Vec<Panel>,
) {
    let mut origins = density.active(left, right).map(|piece| piece.origin);
    let first = origins.next().flatten();
    let common = first.filter(|_| origins.all(|o| o == first)).or((left <= 0.0).then_some(0.0));
    let mut ends: Vec<f64> = edges.iter().copied().filter(|e| *e > left && *e < right).collect();
    if common.is_none() {
        // Unknown origin: panels grow geometrically away from the kink on the left.
        let mut x = left * RATIO;
        while x < right {
            ends.push(x);
            x *= RATIO;
        }
        ends.sort_by(f64::total_cmp);
    }
    ends.push(right);
    let mut from = left;
    for to in ends {
        // The first panel after a kink may start with a fractional power of the distance to it.
        let origin = common.unwrap_or(if from <= left { left } else { 0.0 });
        panels.push(Panel::new(origin, from, to, (left, right)));
        from = to;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Piece;
    use std::sync::Arc;

    impl From<f64> for Goal {
        fn from(aim: f64) -> Self {
            Self { aim, refuse: 4.0 * aim.max(1e-16) }
        }
    }

    fn piece(from: f64, to: f64, origin: Option<f64>, f: fn(f64) -> f64) -> Piece {
        let sampler = move |x: &[f64], out: &mut [f64]| {
            for (out, x) in out.iter_mut().zip(x) {
                *out = f(*x);
            }
            Ok(())
        };
        Piece { from, to, sign: 1.0, kinks: vec![], origin, sampler: Arc::new(sampler) }
    }

    fn sum(density: &Density, high: f64, tolerance: f64) -> (f64, PointMasses) {
        let masses = discretise(density, (0.0, high), &[], &|_| 1.0, tolerance.into()).unwrap();
        (masses.masses.iter().sum(), masses)
    }

    #[test]
    fn fractional_powers_at_a_kink_are_integrated_to_rounding() {
        let density = Density {
            pieces: vec![
                piece(0.0, 1.0, Some(0.0), |x| x.powf(1.5)),
                piece(1.0, 170.0, Some(1.0), |x| 1.0 + 1.32 * (x - 1.0).powf(1.27)),
            ],
        };
        let (value, masses) = sum(&density, 40.0, 1e-15);
        let exact = 0.4 + 39.0 + 1.32 * 39f64.powf(2.27) / 2.27;
        assert!((value / exact - 1.0).abs() < 1e-14, "{value} {exact}");
        assert_eq!(masses.evaluations, 40, "one panel a regime");
    }

    #[test]
    fn undeclared_kinks_and_jumps_cost_time_not_accuracy() {
        let declared = |x: f64| if x < 0.7 { x } else { 2.0 * x + 1.0 };
        let density = Density { pieces: vec![piece(0.0, 2.0, None, declared)] };
        let (value, masses) = sum(&density, 2.0, 1e-12);
        let exact = 0.245 + (4.0 - 0.49) + 1.3;
        assert!((value / exact - 1.0).abs() < 1e-12, "{value} {exact}");
        assert!(masses.evaluations > 400);
    }

    #[test]
    fn no_jump_hides_next_to_the_end_of_a_panel() {
        for k in 0..2000 {
            // Everywhere, also next to the ends of halved panels.
            let at = 2.0 * (0.5 + f64::from(k) / 4000.0).powi(5);
            let sampler = move |x: &[f64], out: &mut [f64]| {
                out.iter_mut().zip(x).for_each(|(out, x)| *out = if *x < at { 1.0 } else { 1.03 });
                Ok(())
            };
            let sampler = Arc::new(sampler);
            let piece =
                Piece { from: 0.0, to: 2.0, sign: 1.0, kinks: vec![], origin: None, sampler };
            let (value, _) = sum(&Density { pieces: vec![piece] }, 2.0, 1e-12);
            let exact = at + 1.03 * (2.0 - at);
            assert!((value / exact - 1.0).abs() < 1e-12, "{at}: {value} {exact}");
        }
    }

    #[test]
    fn halving_of_noise_ends_with_an_error() {
        let noise = |x: f64| 1.5 + (1e15 * x).sin();
        let density = Density { pieces: vec![piece(0.0, 2.0, None, noise)] };
        let error = discretise(&density, (0.0, 2.0), &[], &|_| 1.0, 1e-12.into()).unwrap_err();
        let QuadratureError::NotConverged { reached, evaluations, .. } = error else {
            panic!("{error}")
        };
        assert!(reached > 1e-12 && evaluations < 2 * MOST, "{reached} {evaluations}");
    }

    #[test]
    fn samples_that_are_not_finite_are_refused_with_their_place() {
        let density = Density { pieces: vec![piece(0.0, 2.0, None, |x| (x - 1.0).sqrt())] };
        let error = discretise(&density, (0.0, 2.0), &[], &|_| 1.0, 1e-12.into()).unwrap_err();
        assert!(matches!(error, QuadratureError::NotFinite { at, .. } if at < 1.0));
    }
}
