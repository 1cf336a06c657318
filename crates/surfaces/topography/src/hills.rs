//! Hills of a surface: Spd and Spc of ISO 25178-2.

use crate::topography::extremes;
use crate::{Topography, TopographyError};

/// Hills lower than this share of Sz above their highest saddle belong to a neighbour: the usual
/// Wolf pruning. \[recalled\]
const PRUNED: f64 = 0.05;
/// No point.
const NONE: u32 = u32::MAX;

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
        let peak_of = self.peak_of_points();
        let hills = self.joined(&peak_of, PRUNED * (high - low));
        let [dx, dy] = self.pixel_size();
        let spd = hills.len() as f64 / (self.measured() as f64 * dx * dy);
        let curvatures: Vec<f64> = hills.iter().filter_map(|at| self.mean_curvature(*at)).collect();
        let mean = curvatures.iter().sum::<f64>() / curvatures.len() as f64;
        Ok(Peaks { spd, spc: (!curvatures.is_empty()).then_some(mean) })
    }
}

/// Neighbours of a point before it and after it in reading order.
const BEFORE: [(isize, isize); 4] = [(-1, -1), (-1, 0), (-1, 1), (0, -1)];

impl Topography {
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

    /// Whether one point is above another; of equal ones, the later is.
    fn above(&self, one: usize, other: usize) -> bool {
        (self.heights()[one], one) > (self.heights()[other], other)
    }

    /// The peak of the hill of every point.
    fn peak_of_points(&self) -> Vec<u32> {
        let n = self.heights().len();
        let mut up: Vec<u32> = (0..n as u32).collect();
        for at in (0..n).filter(|at| !self.heights()[*at].is_nan()) {
            for (down, along) in BEFORE {
                let Some(other) = self.neighbour(at, down, along) else { continue };
                for (one, other) in [(at, other), (other, at)] {
                    if self.above(other, up[one] as usize) {
                        up[one] = other as u32;
                    }
                }
            }
        }
        for at in 0..n {
            root(&mut up, at as u32);
        }
        up
    }

    /// The peaks of the hills that are whole, after lower ones have joined their neighbours.
    fn joined(&self, peak_of: &[u32], least: f64) -> Vec<usize> {
        let n = peak_of.len();
        let mut saddles: Vec<(f64, u32, u32)> = vec![];
        let mut at_edge = vec![];
        let columns = self.columns();
        for at in (0..n).filter(|at| !self.heights()[*at].is_nan()) {
            for (down, along) in BEFORE {
                let Some(other) = self.neighbour(at, down, along) else { continue };
                if peak_of[other] != peak_of[at] {
                    let saddle = self.heights()[at].min(self.heights()[other]);
                    saddles.push((saddle, at as u32, other as u32));
                }
            }
            let (row, column) = (at / columns, at % columns);
            let last = [self.rows() - 1, columns - 1];
            let edge = row == 0 || column == 0 || row == last[0] || column == last[1];
            if edge && !self.is_periodic() {
                at_edge.push(peak_of[at]);
            }
        }
        saddles.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
        // Downwards, a saddle joins two islands. If the lower one rises less than `least` above
        // it, all of that island is one hill, which joins the hill on the other side.
        let mut islands: Vec<u32> = peak_of.to_vec();
        let mut hills: Vec<u32> = peak_of.to_vec();
        for (saddle, one, other) in saddles {
            let [a, b] = [one, other].map(|at| root(&mut islands, at));
            if a == b {
                continue;
            }
            let (low, high, beyond) = match self.above(b as usize, a as usize) {
                true => (a, b, other),
                false => (b, a, one),
            };
            islands[low as usize] = high;
            if self.heights()[low as usize] - saddle < least {
                let [from, to] = [low, beyond].map(|at| root(&mut hills, at));
                hills[from as usize] = to;
            }
        }
        // The peak of a hill is the highest of those that have joined.
        let mut highest = vec![NONE; n];
        for peak in
            (0..n).filter(|at| peak_of[*at] as usize == *at && !self.heights()[*at].is_nan())
        {
            let hill = root(&mut hills, peak as u32) as usize;
            if highest[hill] == NONE || self.above(peak, highest[hill] as usize) {
                highest[hill] = peak as u32;
            }
        }
        for peak in at_edge {
            let hill = root(&mut hills, peak) as usize;
            highest[hill] = NONE;
        }
        highest.into_iter().filter(|peak| *peak != NONE).map(|peak| peak as usize).collect()
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
