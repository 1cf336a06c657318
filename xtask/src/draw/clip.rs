//! Curves cut at the frame before they are drawn: a drawing library that clamps
//! points outside would draw them as false lines along the frame.

use super::ruler::Ruler;
use super::series::Point;

/// A rectangle in pixels; `top` is less than `bottom`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rect {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
}

impl Rect {
    /// The rectangle of this size with its top left corner here.
    pub(crate) fn sized(left: f64, top: f64, width: f64, height: f64) -> Self {
        Self { left, top, right: left + width, bottom: top + height }
    }

    pub(crate) fn width(&self) -> f64 {
        self.right - self.left
    }

    pub(crate) fn height(&self) -> f64 {
        self.bottom - self.top
    }

    /// The rectangle with its sides moved out, or in if negative.
    pub(crate) fn grown(&self, by: f64) -> Self {
        Self {
            left: self.left - by,
            top: self.top - by,
            right: self.right + by,
            bottom: self.bottom + by,
        }
    }

    pub(crate) fn contains(&self, point: Point) -> bool {
        (self.left..=self.right).contains(&point.0) && (self.top..=self.bottom).contains(&point.1)
    }

    pub(crate) fn overlaps(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }
}

/// The frame of a panel with its two axes.
#[derive(Clone, Copy)]
pub(crate) struct Frame<'a> {
    pub(crate) rect: Rect,
    pub(crate) x: &'a Ruler,
    pub(crate) y: &'a Ruler,
}

impl Frame<'_> {
    /// The pixel of a point of the CSV.
    pub(crate) fn pixel(&self, point: Point) -> Point {
        (self.across(self.x.share(point.0)), self.up(self.y.share(point.1)))
    }

    /// The pixel of a share of the width.
    pub(crate) fn across(&self, share: f64) -> f64 {
        self.rect.left + share * self.rect.width()
    }

    /// The pixel of a share of the height, counted from the foot.
    pub(crate) fn up(&self, share: f64) -> f64 {
        self.rect.bottom - share * self.rect.height()
    }

    /// The parts of a piece of curve that are inside the frame, in pixels.
    pub(crate) fn clip(&self, piece: &[Point]) -> Vec<Vec<Point>> {
        let mut parts: Vec<Vec<Point>> = Vec::new();
        if let [single] = piece {
            if self.x.holds(single.0) && self.y.holds(single.1) {
                parts.push(vec![self.pixel(*single)]);
            }
            return parts;
        }
        let mut open = false;
        for pair in piece.windows(2) {
            let Some((start, end, whole)) = self.clip_segment(pair[0], pair[1]) else {
                open = false;
                continue;
            };
            match parts.last_mut() {
                Some(part) if open => part.push(end),
                _ => parts.push(vec![start, end]),
            }
            open = whole;
        }
        parts
    }

    /// The part of a segment inside the frame, and whether it reaches its own end.
    fn clip_segment(&self, from: Point, to: Point) -> Option<(Point, Point, bool)> {
        let (mut from, mut to) = (from, to);
        let mut whole = true;
        if let Some(floor) = self.y.floor() {
            (from, to, whole) = lift(from, to, floor)?;
        }
        if let Some(floor) = self.x.floor() {
            let turned = lift((from.1, from.0), (to.1, to.0), floor)?;
            from = (turned.0.1, turned.0.0);
            to = (turned.1.1, turned.1.0);
            whole &= turned.2;
        }
        let (from, to) = (self.pixel(from), self.pixel(to));
        let (enter, leave) = inside_shares(&self.rect, from, to)?;
        let at = |share: f64| (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1));
        Some((at(enter), at(leave), whole && leave >= 1.0))
    }
}

/// Moves an end that has no logarithm along the segment up to the floor of the
/// axis; none is left of a segment that never rises above the floor.
fn lift(from: Point, to: Point, floor: f64) -> Option<(Point, Point, bool)> {
    let meet = |high: Point, low: Point| {
        let share = (high.1 - floor) / (high.1 - low.1);
        (high.0 + share * (low.0 - high.0), floor)
    };
    match (from.1 > 0.0, to.1 > 0.0) {
        (true, true) => Some((from, to, true)),
        (true, false) if from.1 > floor => Some((from, meet(from, to), false)),
        (false, true) if to.1 > floor => Some((meet(to, from), to, true)),
        _ => None,
    }
}

/// The shares of a segment at which it enters and leaves a rectangle (Liang and Barsky).
fn inside_shares(rect: &Rect, from: Point, to: Point) -> Option<(f64, f64)> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let sides = [
        (-dx, from.0 - rect.left),
        (dx, rect.right - from.0),
        (-dy, from.1 - rect.top),
        (dy, rect.bottom - from.1),
    ];
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (slope, room) in sides {
        if slope < 0.0 {
            enter = enter.max(room / slope);
        } else if slope > 0.0 {
            leave = leave.min(room / slope);
        } else if room < -1e-6 {
            return None;
        }
    }
    (enter <= leave).then_some((enter, leave))
}

/// A polygon cut at a rectangle, side by side (Sutherland and Hodgman).
pub(crate) fn clip_polygon(rect: &Rect, polygon: &[Point]) -> Vec<Point> {
    let inside: [&dyn Fn(Point) -> f64; 4] =
        [&|p| p.0 - rect.left, &|p| rect.right - p.0, &|p| p.1 - rect.top, &|p| rect.bottom - p.1];
    let mut points = polygon.to_vec();
    for room in inside {
        let mut kept = Vec::with_capacity(points.len());
        for (index, point) in points.iter().enumerate() {
            let before = points[(index + points.len() - 1) % points.len()];
            let (was, is) = (room(before), room(*point));
            if (was < 0.0) != (is < 0.0) {
                let share = was / (was - is);
                kept.push((
                    before.0 + share * (point.0 - before.0),
                    before.1 + share * (point.1 - before.1),
                ));
            }
            if is >= 0.0 {
                kept.push(*point);
            }
        }
        points = kept;
    }
    points
}

#[cfg(test)]
mod tests {
    use super::super::figure::Axis;
    use super::*;

    fn ruler(axis: Axis) -> anyhow::Result<Ruler> {
        Ruler::new(&axis, &[], false, 5.0)
    }

    const RECT: Rect = Rect { left: 0.0, top: 0.0, right: 100.0, bottom: 100.0 };

    #[test]
    fn a_curve_that_leaves_and_returns_is_cut_at_the_frame() -> anyhow::Result<()> {
        let (x, y) = (
            ruler(Axis::new("x", "x").range(0.0, 4.0))?,
            ruler(Axis::new("y", "y").range(0.0, 1.0))?,
        );
        let frame = Frame { rect: RECT, x: &x, y: &y };
        let parts = frame.clip(&[(0.0, 0.5), (1.0, 0.5), (2.0, 2.5), (3.0, 0.5), (4.0, 0.5)]);
        assert_eq!(parts.len(), 2);
        assert_eq!(parts[0], [(0.0, 50.0), (25.0, 50.0), (31.25, 0.0)]);
        assert_eq!(parts[1], [(68.75, 0.0), (75.0, 50.0), (100.0, 50.0)]);
        Ok(())
    }

    #[test]
    fn a_point_not_above_zero_ends_a_log_curve_at_the_foot() -> anyhow::Result<()> {
        let (x, y) = (
            ruler(Axis::new("x", "x").range(0.0, 4.0))?,
            ruler(Axis::new("y", "y").log().range(0.01, 1.0))?,
        );
        let frame = Frame { rect: RECT, x: &x, y: &y };
        let parts = frame.clip(&[(0.0, 1.0), (1.0, 0.1), (2.0, -0.1), (3.0, 0.0), (4.0, 0.1)]);
        assert_eq!(parts.len(), 2);
        let foot = parts[0][2];
        assert!((foot.1 - 100.0).abs() < 1e-9 && (foot.0 - 36.25).abs() < 1e-9, "{foot:?}");
        assert!((parts[1][0].1 - 100.0).abs() < 1e-9);
        Ok(())
    }

    #[test]
    fn a_polygon_is_cut_at_the_frame() {
        let cut =
            clip_polygon(&RECT, &[(-50.0, 50.0), (50.0, 50.0), (50.0, 150.0), (-50.0, 150.0)]);
        assert_eq!(cut.len(), 4);
        assert!(cut.iter().all(|point| RECT.contains(*point)));
    }
}
