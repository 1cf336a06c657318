//! Clipping of curves at the frame; plotters would draw points outside as false lines along it. All
//! positions are fractions of the frame, from 0 to 1.

use crate::ruler::Ruler;
use crate::series::Point;

/// The parts of a piece of curve, in the units of the csv, that are inside the frame of two axes,
/// in fractions of it.
pub(crate) fn curve(piece: &[Point], x: &Ruler, y: &Ruler) -> Vec<Vec<Point>> {
    let share = |point: Point| (x.share(point.0), y.share(point.1));
    if let [single] = piece {
        let inside = x.holds(single.0) && y.holds(single.1);
        return if inside { vec![vec![share(*single)]] } else { vec![] };
    }
    let (mut parts, mut open): (Vec<Vec<Point>>, bool) = (vec![], false);
    for pair in piece.windows(2) {
        let lifted = lift(pair[0], pair[1], y.floor());
        let cut = lifted.and_then(|(from, to, whole)| {
            let (start, end, to_the_end) = segment(share(from), share(to))?;
            Some((start, end, whole && to_the_end))
        });
        let Some((start, end, whole)) = cut else {
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

/// Moves an end that has no logarithm along the segment up to the floor of the axis; returns
/// also whether the segment still reaches its own end.
fn lift(from: Point, to: Point, floor: Option<f64>) -> Option<(Point, Point, bool)> {
    let Some(floor) = floor else { return Some((from, to, true)) };
    let meet = |high: Point, low: Point| {
        (high.0 + (high.1 - floor) / (high.1 - low.1) * (low.0 - high.0), floor)
    };
    match (from.1 > 0.0, to.1 > 0.0) {
        (true, true) => Some((from, to, true)),
        (true, false) if from.1 > floor => Some((from, meet(from, to), false)),
        (false, true) if to.1 > floor => Some((meet(to, from), to, true)),
        _ => None,
    }
}

/// The point at a share of a segment.
pub(crate) fn between(from: Point, to: Point, share: f64) -> Point {
    (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1))
}

/// The part of a segment inside the frame, and whether it reaches its own end (Liang and Barsky).
fn segment(from: Point, to: Point) -> Option<(Point, Point, bool)> {
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (from, to) in [(from.0, to.0), (from.1, to.1)] {
        for (slope, room) in [(from - to, from), (to - from, 1.0 - from)] {
            if slope < 0.0 {
                enter = enter.max(room / slope);
            } else if slope > 0.0 {
                leave = leave.min(room / slope);
            } else if room < -1e-9 {
                return None;
            }
        }
    }
    (enter <= leave).then(|| (between(from, to, enter), between(from, to, leave), leave >= 1.0))
}

/// A polygon cut at the frame, side by side (Sutherland and Hodgman).
pub(crate) fn polygon(polygon: &[Point]) -> Vec<Point> {
    let rooms: [fn(Point) -> f64; 4] = [|p| p.0, |p| 1.0 - p.0, |p| p.1, |p| 1.0 - p.1];
    let mut points = polygon.to_vec();
    for room in rooms {
        let before = points.iter().cycle().skip(points.len().saturating_sub(1));
        let mut kept = vec![];
        for (before, point) in before.zip(&points) {
            let (was, is) = (room(*before), room(*point));
            if (was < 0.0) != (is < 0.0) {
                kept.push(between(*before, *point, was / (was - is)));
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
    use super::*;
    use crate::figure::Axis;

    fn ruler(axis: Axis) -> Ruler {
        Ruler::new(&axis, std::iter::empty(), false, 5).unwrap()
    }

    #[test]
    fn a_curve_that_leaves_and_returns_is_cut_at_the_frame() {
        let x = ruler(Axis::new("x", "x").range(0.0, 4.0));
        let y = ruler(Axis::new("y", "y").range(0.0, 1.0));
        let parts = curve(&[(0.0, 0.5), (1.0, 0.5), (2.0, 2.5), (3.0, 0.5), (4.0, 0.5)], &x, &y);
        assert_eq!(parts.len(), 2);
        assert_eq!(parts[0], [(0.0, 0.5), (0.25, 0.5), (0.3125, 1.0)]);
        assert_eq!(parts[1], [(0.6875, 1.0), (0.75, 0.5), (1.0, 0.5)]);
    }

    #[test]
    fn a_point_not_above_zero_ends_a_log_curve_at_the_foot() {
        let x = ruler(Axis::new("x", "x").range(0.0, 4.0));
        let y = ruler(Axis::new("y", "y").log().range(0.01, 1.0));
        let parts = curve(&[(0.0, 1.0), (1.0, 0.1), (2.0, -0.1), (3.0, 0.0), (4.0, 0.1)], &x, &y);
        assert_eq!(parts.len(), 2);
        let foot = parts[0][2];
        assert!(foot.1.abs() < 1e-9 && (foot.0 - 0.3625).abs() < 1e-9, "{foot:?}");
        assert!(parts[1][0].1.abs() < 1e-9);
    }

    #[test]
    fn a_polygon_is_cut_at_the_frame() {
        let cut = polygon(&[(-0.5, 0.5), (0.5, 0.5), (0.5, 1.5), (-0.5, 1.5)]);
        assert_eq!(cut.len(), 4);
        assert!(cut.iter().all(|p| (0.0..=0.5).contains(&p.0) && (0.5..=1.0).contains(&p.1)));
        assert!(polygon(&[]).is_empty());
    }
}
