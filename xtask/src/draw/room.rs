//! Finding room for a box of text inside a frame full of curves.

use super::clip::Rect;
use super::series::Point;

/// What is already in the frame.
#[derive(Debug, Clone, Default)]
pub(crate) struct Taken {
    /// Points of curves and markers, which no box may cover.
    pub(crate) curves: Vec<Point>,
    /// Points of reference lines, which a box should not cover.
    pub(crate) lines: Vec<Point>,
    /// Boxes placed before.
    pub(crate) boxes: Vec<Rect>,
}

/// Air around a box, in pixels.
pub(crate) const AIR: f64 = 18.0;

impl Taken {
    /// How many points of curves a box would cover, with air around it.
    pub(crate) fn covered(&self, rect: &Rect) -> usize {
        let rect = rect.grown(AIR);
        self.curves.iter().filter(|point| rect.contains(**point)).count()
    }

    /// How bad a place for a box is: the less, the better.
    pub(crate) fn cost(&self, rect: &Rect) -> usize {
        let wide = rect.grown(AIR);
        let lines = self.lines.iter().filter(|point| wide.contains(**point)).count();
        let boxes = self.boxes.iter().filter(|other| wide.overlaps(other)).count();
        10 * self.covered(rect) + lines + 100_000 * boxes
    }

    /// The place in a region where a box of this size covers least; corners first.
    pub(crate) fn best(&self, region: &Rect, width: f64, height: f64) -> Rect {
        let across = (region.width() - width).max(0.0);
        let down = (region.height() - height).max(0.0);
        let at = |x: f64, y: f64| {
            Rect::sized(region.left + x * across, region.top + y * down, width, height)
        };
        let mut best = at(1.0, 0.0);
        let mut least = self.cost(&best);
        for (x, y) in places() {
            let rect = at(x, y);
            let cost = self.cost(&rect);
            if cost < least {
                (best, least) = (rect, cost);
            }
        }
        best
    }
}

/// Shares of the free width and height: the corners, then a grid from the rim inwards.
fn places() -> Vec<(f64, f64)> {
    const GRID: i32 = 16;
    let mut places = vec![(1.0, 0.0), (0.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    let mut grid: Vec<(i32, i32)> =
        (0..=GRID).flat_map(|x| (0..=GRID).map(move |y| (x, y))).collect();
    let rim = |v: i32| v.min(GRID - v);
    grid.sort_by_key(|(x, y)| (rim(*x).min(rim(*y)), rim(*x).max(rim(*y)), *y, *x));
    places.extend(
        grid.into_iter()
            .map(|(x, y)| (f64::from(x) / f64::from(GRID), f64::from(y) / f64::from(GRID))),
    );
    places
}

/// Moves labels in a row apart until none overlap, as little as it takes. All
/// are given by the middle wanted and the half width, from left to right.
pub(crate) fn spread(wanted: &[(f64, f64)], gap: f64, left: f64, right: f64) -> Vec<f64> {
    let apart = |i: usize| wanted[i].1 + wanted[i + 1].1 + gap;
    let mut rightward: Vec<f64> = wanted.iter().map(|(middle, _)| *middle).collect();
    let mut leftward = rightward.clone();
    for i in 1..wanted.len() {
        rightward[i] = rightward[i].max(rightward[i - 1] + apart(i - 1));
        let j = wanted.len() - 1 - i;
        leftward[j] = leftward[j].min(leftward[j + 1] - apart(j));
    }
    let mut middles: Vec<f64> =
        rightward.iter().zip(&leftward).map(|(a, b)| 0.5 * (a + b)).collect();
    for i in (0..wanted.len()).rev() {
        let most =
            if i + 1 < wanted.len() { middles[i + 1] - apart(i) } else { right - wanted[i].1 };
        middles[i] = middles[i].min(most);
    }
    for i in 0..wanted.len() {
        let least = if i > 0 { middles[i - 1] + apart(i - 1) } else { left + wanted[i].1 };
        middles[i] = middles[i].max(least);
    }
    middles
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_goes_to_the_free_corner() {
        let region = Rect::sized(0.0, 0.0, 1000.0, 1000.0);
        let curves = (0..100).map(|i| (f64::from(i) * 10.0, f64::from(i) * 10.0)).collect();
        let taken = Taken { curves, ..Taken::default() };
        let found = taken.best(&region, 300.0, 300.0);
        assert_eq!(taken.covered(&found), 0);
    }

    #[test]
    fn labels_move_apart_and_stay_between_the_ends() {
        let middles = spread(&[(100.0, 50.0), (110.0, 50.0), (990.0, 50.0)], 10.0, 0.0, 1000.0);
        assert!(middles[1] - middles[0] >= 110.0 - 1e-9);
        assert!(middles[0] >= 50.0 && middles[2] <= 950.0);
    }
}
