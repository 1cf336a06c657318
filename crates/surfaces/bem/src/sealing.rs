//! Sealing: the mean pressure at which contacts close the last open path.

use std::ops::ControlFlow;

use crate::network::Direction;
use crate::solver::{BoundaryElements, Run};
use crate::{BemError, LoadCase, Progress, Solution};

/// The first pressure over modulus times Sq over the side: surfaces of few waves seal near it.
const START: f64 = 10.0;
/// The step to another pressure until one is open and one closed.
const STEP: f64 = 4.0;
/// Steps down, after which a path is taken as never open.
const MOST_STEPS: i32 = 8;
/// The heaviest open and the lightest closed pressure are as near.
const WITHIN: f64 = 1.02;

/// Where the last path in one direction closes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sealing {
    /// The mean pressure \[Pa\], within 1 %.
    pub pressure: f64,
    /// The share of the area in contact at the heaviest open pressure.
    pub area: f64,
    /// The tightest gap \[m\] on the last path, at that pressure.
    pub tightest_gap: f64,
}

/// A pressure with what is open there along x and along y.
type Tried = (f64, [Option<Sealing>; 2]);

impl BoundaryElements {
    /// Where the last paths along x and along y close, by bisection of the logarithm of the
    /// pressure; `None` where contacts and gaps smaller than `molecule` \[m\] close every path
    /// down to the lightest contact. Beside them the heaviest contact with an open path, if there
    /// is one.
    ///
    /// # Errors
    /// The errors of [`solve`](Self::solve); [`BemError::Cancelled`] where `progress` stops.
    pub fn sealing(
        &self,
        molecule: f64,
        mut progress: impl FnMut(&Progress) -> ControlFlow<()>,
    ) -> Result<([Option<Sealing>; 2], Option<Solution>), BemError> {
        let slope = self.map.rms_height() / self.map.area().sqrt();
        // A flat map is closed at any pressure.
        let slope = if slope > 0.0 { slope } else { 1.0 };
        let start = (START * self.modulus * slope).min(0.5 * self.cap());
        let mut run = Run::new(self);
        let mut known: Vec<Tried> = vec![];
        let mut heaviest: Option<Solution> = None;
        let next = |known: &[Tried]| {
            (0..2).find_map(|k| match ends(known, k) {
                (None, None) => Some(start),
                (None, Some(closed)) => {
                    (closed > start * STEP.powi(-MOST_STEPS)).then(|| closed / STEP)
                }
                (Some(Sealing { pressure: open, .. }), None) => {
                    // Up to the hardness, which no path may close.
                    let heavier = (STEP * open).min((open * self.cap()).sqrt());
                    (heavier > WITHIN * open).then_some(heavier)
                }
                (Some(Sealing { pressure: open, .. }), Some(closed)) => {
                    (closed > WITHIN * open).then(|| (open * closed).sqrt())
                }
            })
        };
        while let Some(pressure) = next(&known) {
            let (index, done) = (known.len(), known.len());
            let watch = &mut |iterations, residual| {
                progress(&Progress { index, done, iterations, residual })
            };
            let solution = run.solve(LoadCase::MeanPressure(pressure), watch)?;
            let [x, y] = Direction::ALL.map(|along| self.tightest_gap(&solution, along));
            let area = solution.area;
            let open = [x?, y?].map(|gap| {
                let (tightest_gap, _) = gap.filter(|(gap, _)| *gap >= molecule)?;
                Some(Sealing { pressure, area, tightest_gap })
            });
            known.push((pressure, open));
            let before = heaviest.as_ref().map_or(0.0, |before| before.mean_pressure);
            if open.iter().any(Option::is_some) && pressure > before {
                heaviest = Some(solution);
            }
        }
        let sealed = [0, 1].map(|k| {
            let (Some(last), closed) = ends(&known, k) else { return None };
            // A heavier contact may be open again; without a closed one the hardness is the end.
            let closed = closed.unwrap_or(self.cap());
            let pressure = (last.pressure * closed.max(last.pressure)).sqrt();
            Some(Sealing { pressure, ..last })
        });
        Ok((sealed, heaviest))
    }
}

/// The heaviest contact with an open path in a direction, and the lightest pressure without one.
fn ends(known: &[Tried], k: usize) -> (Option<Sealing>, Option<f64>) {
    let open = known.iter().filter_map(|(_, open)| open[k]);
    let closed = known.iter().filter(|(_, open)| open[k].is_none()).map(|(pressure, _)| *pressure);
    (open.max_by(|a, b| a.pressure.total_cmp(&b.pressure)), closed.min_by(f64::total_cmp))
}
