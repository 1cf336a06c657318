//! Hills of a surface: Spd and Spc of ISO 25178-2.

use crate::topography::extremes;
use crate::{Topography, TopographyError};

/// Hills lower than this share of Sz above their highest saddle belong to a neighbour: the usual
/// Wolf pruning. \[recalled\]
const PRUNED: f64 = 0.05;
/// No point.
const NONE: u32 = u32::MAX;
/// The neighbours of a point.
const AROUND: [(isize, isize); 8] =
    [(-1, -1), (-1, 0), (-1, 1), (0, -1), (0, 1), (1, -1), (1, 0), (1, 1)];

/// The peaks of the significant hills of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Peaks {
    /// Spd \[1/m²\]: their number per measured area.
    pub spd: f64,
    /// Spc \[1/m\]: their mean curvature, of second differences along rows and columns; `None`
    /// where no peak has four measured neighbours.
    pub spc: Option<f64>,
}

impl Topography {
    /// Spd and Spc of ISO 25178-2: the surface is cut into the hills that drain from one peak
    /// each, every point from its highest of eight neighbours; hills that rise less than 5 % of Sz
    /// above their highest saddle are joined, over that saddle, to their neighbour, the lowest
    /// first (Wolf pruning). Hills at an edge are incomplete and left out.
    ///
    /// # Errors
    /// [`TopographyError::SummitsOfProfile`] for a profile; [`TopographyError::Flat`] when all
    /// heights are equal.
    pub fn peaks(&self) -> Result<Peaks, TopographyError> {
        if self.is_profile() {
            return Err(TopographyError::SummitsOfProfile);
        }
        // The comparisons leave missing points out.
        let [low, high] = extremes(self.heights());
        if low >= high {
            return Err(TopographyError::Flat { points: self.measured() });
        }
        let hills = self.hills(PRUNED * (high - low));
        let [dx, dy] = self.pixel_size();
        let spd = hills.len() as f64 / (self.measured() as f64 * dx * dy);
        let curvatures: Vec<f64> = hills.iter().filter_map(|at| self.mean_curvature(*at)).collect();
        let mean = curvatures.iter().sum::<f64>() / curvatures.len() as f64;
        Ok(Peaks { spd, spc: (!curvatures.is_empty()).then_some(mean) })
    }

    /// The point at a distance, around the edges of a periodic surface.
    pub(crate) fn beside(&self, at: usize, down: isize, along: isize) -> Option<usize> {
        let (rows, columns) = (self.rows(), self.columns());
        let move_by = |from: usize, by: isize, n: usize| match self.is_periodic() {
            true => Some((from as isize + by).rem_euclid(n as isize) as usize),
            false => from.checked_add_signed(by).filter(|to| *to < n),
        };
        let row = move_by(at / columns, down, rows)?;
        let to = row * columns + move_by(at % columns, along, columns)?;
        (to != at).then_some(to)
    }

    /// Likewise, if it has a height.
    fn neighbour(&self, at: usize, down: isize, along: isize) -> Option<usize> {
        self.beside(at, down, along).filter(|to| !self.heights()[*to].is_nan())
    }

    /// The peaks of the hills that are whole, after lower ones have joined their neighbours.
    ///
    /// From the highest point downwards, each joins the hill of its highest neighbour, and islands
    /// that meet there become one. If the lower of two rises less than `least` above that saddle,
    /// all of that island is one hill, which joins the hill on the other side.
    fn hills(&self, least: f64) -> Vec<usize> {
        let (heights, columns) = (self.heights(), self.columns());
        // Of equal points the later is above.
        let level = |at: &u32| (heights[*at as usize], *at);
        let mut downwards: Vec<u32> = (0..heights.len() as u32).collect();
        downwards.retain(|at| !heights[*at as usize].is_nan());
        downwards.sort_unstable_by(|a, b| {
            heights[*b as usize].total_cmp(&heights[*a as usize]).then(b.cmp(a))
        });
        let mut islands: Vec<u32> = (0..heights.len() as u32).collect();
        let (mut hills, mut peaks) = (islands.clone(), vec![]);
        for &at in &downwards {
            let beside = |(down, along)| self.neighbour(at as usize, down, along);
            let beside = AROUND.into_iter().filter_map(beside).map(|to| to as u32);
            let higher: Vec<u32> = beside.filter(|to| level(to) > level(&at)).collect();
            let highest =
                higher.iter().copied().reduce(|a, b| if level(&b) > level(&a) { b } else { a });
            let Some(highest) = highest else {
                peaks.push(at);
                continue;
            };
            (islands[at as usize], hills[at as usize]) = (highest, highest);
            for other in higher {
                let [a, b] = [at, other].map(|at| root(&mut islands, at));
                if a == b {
                    continue;
                }
                let (low, high, beyond) =
                    if level(&b) > level(&a) { (a, b, other) } else { (b, a, at) };
                islands[low as usize] = high;
                if heights[low as usize] - heights[at as usize] < least {
                    let [from, to] = [low, beyond].map(|at| root(&mut hills, at));
                    hills[from as usize] = to;
                }
            }
        }
        // The highest peak of each hill is the first.
        let mut found = vec![NONE; heights.len()];
        for peak in peaks {
            let first = &mut found[root(&mut hills, peak) as usize];
            if *first == NONE {
                *first = peak;
            }
        }
        let last = [self.rows() - 1, columns - 1];
        for at in downwards.into_iter().filter(|_| !self.is_periodic()) {
            let (row, column) = (at as usize / columns, at as usize % columns);
            if row == 0 || column == 0 || row == last[0] || column == last[1] {
                found[root(&mut hills, at) as usize] = NONE;
            }
        }
        found.into_iter().filter(|peak| *peak != NONE).map(|peak| peak as usize).collect()
    }

    /// Mean curvature \[1/m\], positive on a peak.
    fn mean_curvature(&self, at: usize) -> Option<f64> {
        let [dx, dy] = self.pixel_size();
        let bend = |down: isize, along: isize, step: f64| {
            let [one, two] = [-1, 1].map(|k| self.neighbour(at, k * down, k * along));
            let sum = self.heights()[one?] + self.heights()[two?];
            Some((sum - 2.0 * self.heights()[at]) / (step * step))
        };
        Some(-0.5 * (bend(0, 1, dx)? + bend(1, 0, dy)?))
    }
}

/// The end of a chain of points, which is shortened on the way.
fn root(next: &mut [u32], mut at: u32) -> u32 {
    let mut end = at;
    while next[end as usize] != end {
        end = next[end as usize];
    }
    while next[at as usize] != end {
        at = std::mem::replace(&mut next[at as usize], end);
    }
    end
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    fn egg_box(n: usize, waves: f64, ripple: f64) -> Topography {
        let height = |k: usize| {
            let [x, y] = [k % n, k / n].map(|at| TAU * at as f64 / n as f64);
            let coarse = (waves * x).cos() + (waves * y).cos();
            1e-6 * (coarse + ripple * (8.0 * waves * x).cos())
        };
        Topography::new((0..n * n).map(height).collect(), n, [1e-6; 2]).unwrap()
    }

    #[test]
    fn an_egg_box_has_a_hill_a_period_and_small_ripples_are_pruned() {
        // Ripples of 0.3 rise by 0.6 less at most π/8 of slope 1 over their saddles: more than 5 %
        // of Sz = 4.6, each of eight on a period.
        for (ripple, hills) in [(0.0, 36.0), (0.03, 36.0), (0.3, 36.0 * 8.0)] {
            let surface = egg_box(240, 6.0, ripple).with_periodic(true);
            let found = surface.peaks().unwrap();
            assert!((found.spd * 240e-6 * 240e-6 - hills).abs() < 1.0, "{ripple} {found:?}");
        }
        let spc = egg_box(240, 6.0, 0.0).with_periodic(true).peaks().unwrap().spc.unwrap();
        let bend = 2.0 * (1.0 - (TAU / 40.0).cos()) * 1e-6 / 1e-12;
        assert!((spc / bend - 1.0).abs() < 1e-9, "{spc} {bend}");
    }

    #[test]
    fn hills_at_the_edge_are_left_out() {
        // Peaks at multiples of 40 points: those in row or column 0, and the hills cut by the last
        // row or column, are incomplete.
        let found = egg_box(240, 6.0, 0.0).peaks().unwrap();
        assert!((found.spd * 240e-6 * 240e-6 - 25.0).abs() < 1e-6, "{found:?}");
    }

    #[test]
    fn profiles_and_flat_surfaces_are_refused() {
        let made =
            |heights: Vec<f64>, columns| Topography::new(heights, columns, [1.0; 2]).unwrap();
        assert!(made(vec![0.0, 1.0, 0.0], 3).peaks().is_err());
        assert!(made(vec![1.0; 9], 3).peaks().is_err());
    }
}
