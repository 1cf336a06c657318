//! From a density times a smooth weight to point masses, on panels refined until resolved.

pub(crate) mod panel;

use std::cmp::Ordering;

use crate::{Density, Piece, PointMasses, QuadratureError, WeightFunction};
use panel::{POINTS, Panel};

/// Without a known origin, panels grow by no more than this ratio.
const RATIO: f64 = 4.0;
/// Bisection stops here; a panel that thin carries less than any tolerance.
const DEEPEST: u32 = 50;
/// So does it after this many halvings in a row that did not help.
const STALLED: u32 = 4;

/// And so does all bisection once the density was sampled this often: dozens of undeclared kinks
/// take a tenth of it, and halving noise would never end.
const MOST: usize = 200_000;

/// How well masses are wanted, relative to the integral of the absolute value.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Goal {
    /// What panels are bisected for,
    pub(crate) aim: f64,
    /// and what is refused: an aim near rounding may be missed by a little.
    pub(crate) refuse: f64,
}

impl From<f64> for Goal {
    fn from(aim: f64) -> Self {
        Self { aim, refuse: 4.0 * aim.max(1e-16) }
    }
}

/// Replaces `density(x) · weight(x)` on `[low, high]` by point masses.
///
/// `edges` are extra panel ends that suit the weight; the density's own breaks are added. Panels
/// are bisected until their estimated errors sum to less than the goal's aim times the integral of
/// the absolute value, or until they are too thin to matter.
///
/// # Errors
/// What the density's samplers refuse, non-finite samples, and [`QuadratureError::NotConverged`]
/// when the error estimate stays above what the goal refuses.
pub(crate) fn discretise(
    density: &Density,
    (low, high): (f64, f64),
    edges: &[f64],
    weight: &dyn Fn(f64) -> f64,
    goal: impl Into<Goal>,
) -> Result<PointMasses, QuadratureError> {
    let Goal { aim, refuse } = goal.into();
    let (mut result, sampled) = own_masses(density, (low, high), edges, weight, aim)?;
    let density = sampled.as_ref().unwrap_or(density);
    let mut panels = first_panels(density, low, high, edges);
    let mut evaluations = result.evaluations;
    for panel in &mut panels {
        evaluations += panel.sample(density, weight)?;
    }
    // Each panel may err by its share of the whole; the whole is known after the first pass, and
    // a panel already below rounding of the whole is left alone.
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
        // A kink or jump is left in one half; noise stays in both, and halving does not help.
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
        return Err(QuadratureError::NotConverged {
            reached: stuck / total,
            asked: aim,
            evaluations,
        });
    }
    Ok(result)
}

/// The masses of pieces that have their own, and the density without those pieces, if any has.
fn own_masses(
    density: &Density,
    range: (f64, f64),
    edges: &[f64],
    weight: &dyn Fn(f64) -> f64,
    aim: f64,
) -> Result<(PointMasses, Option<Density>), QuadratureError> {
    let (mut all, mut own) = (PointMasses::default(), vec![]);
    let mut against = WeightFunction { range, edges, weight, aim, beside: 0.0 };
    // What is small beside other pieces need be no better: the one that begins just before the
    // weight is largest is likely to be large.
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
        let masses = discretise(density, (0.0, high), &[], &|_| 1.0, tolerance).unwrap();
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
        assert_eq!(masses.evaluations, 40, "one panel a regime is enough");
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
            // Everywhere, also next to where halving ends panels.
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
    fn noise_is_given_up_in_the_end() {
        let noise = |x: f64| 1.5 + (1e15 * x).sin();
        let density = Density { pieces: vec![piece(0.0, 2.0, None, noise)] };
        let error = discretise(&density, (0.0, 2.0), &[], &|_| 1.0, 1e-12).unwrap_err();
        let QuadratureError::NotConverged { reached, evaluations, .. } = error else {
            panic!("{error}")
        };
        assert!(reached > 1e-12 && evaluations < 2 * MOST, "{reached} {evaluations}");
    }

    #[test]
    fn not_a_number_is_an_error_that_says_where() {
        let density = Density { pieces: vec![piece(0.0, 2.0, None, |x| (x - 1.0).sqrt())] };
        let error = discretise(&density, (0.0, 2.0), &[], &|_| 1.0, 1e-12).unwrap_err();
        assert!(matches!(error, QuadratureError::NotFinite { at, .. } if at < 1.0));
    }
}
