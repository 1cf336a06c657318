//! A curve in pixels: fewer points, samples, and places for markers.

use crate::canvas::{Canvas, MARKER, Rect};
use crate::clip::between;
use crate::series::Point;
use crate::style::Curve;

fn distance(a: Point, b: Point) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

/// The polyline without the points that change it invisibly (Douglas and Peucker).
pub(crate) fn simplified(points: &[Point]) -> Vec<Point> {
    const UNSEEN: f64 = 0.03;
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return vec![] };
    let away = |point: &Point| {
        let ((dx, dy), length) = ((last.0 - first.0, last.1 - first.1), distance(*first, *last));
        let cross = dx * (point.1 - first.1) - dy * (point.0 - first.0);
        if length > 0.0 { cross.abs() / length } else { distance(*point, *first) }
    };
    let inner = points.iter().enumerate().skip(1).take(points.len().saturating_sub(2));
    match inner.max_by(|a, b| away(a.1).total_cmp(&away(b.1))) {
        Some((place, point)) if away(point) > UNSEEN => {
            let mut kept = simplified(&points[..=place]);
            kept.pop();
            kept.extend(simplified(&points[place..]));
            kept
        }
        _ if points.len() > 1 => vec![*first, *last],
        _ => vec![*first],
    }
}

/// Points along polylines, at most this many pixels apart.
pub(crate) fn sampled(parts: &[Vec<Point>], every: f64) -> Vec<Point> {
    let mut samples = vec![];
    for part in parts {
        samples.extend(part.first());
        for pair in part.windows(2) {
            let count = (distance(pair[0], pair[1]) / every).ceil().max(1.0) as usize;
            samples.extend((1..=count).map(|i| between(pair[0], pair[1], i as f64 / count as f64)));
        }
    }
    samples
}

/// Every point at which polylines cross a vertical.
fn crossings(parts: &[Vec<Point>], x: f64) -> Vec<Point> {
    let pairs = parts.iter().flat_map(|part| part.windows(2));
    let crossing = pairs.filter(|pair| (pair[0].0 < x) != (pair[1].0 < x));
    crossing.map(|p| between(p[0], p[1], (x - p[0].0) / (p[1].0 - p[0].0))).collect()
}

/// Places for the sparse markers of several curves: each curve has its own verticals, and no two
/// markers touch each other or a measured point.
pub(crate) fn marker_places(
    curves: &[Vec<Vec<Point>>],
    frame: &Rect,
    mut taken: Vec<Point>,
) -> Vec<Vec<Point>> {
    let frame = frame.grown(-1.7 * MARKER);
    let across = (frame.width() / 127.0).floor().clamp(3.0, 5.0) as usize;
    let spacing = frame.width() / across as f64;
    let stride = stride(curves.len());
    let mut places = vec![];
    for (index, parts) in curves.iter().enumerate() {
        let slot = ((index * stride % curves.len()) as f64 + 0.5) / curves.len() as f64;
        let mut own: Vec<Point> = vec![];
        let free = |point: Point, own: &[Point]| {
            frame.contains(point)
                && taken.iter().all(|other| distance(*other, point) > 2.6 * MARKER)
                && own.iter().all(|other| distance(*other, point) > 5.0 * MARKER)
        };
        for group in 0..across {
            let shifts = [0.0, 0.12, -0.12, 0.24, -0.24, 0.36, -0.36];
            let found = shifts.iter().find_map(|shift| {
                let x = frame.left + spacing * (group as f64 + slot + shift);
                let points = crossings(parts, x);
                let fit = !points.is_empty() && points.iter().all(|point| free(*point, &own));
                fit.then_some(points)
            });
            own.extend(found.unwrap_or_default());
        }
        if own.is_empty() {
            // At any free place, from the middle outwards.
            let samples = sampled(parts, 1.5);
            let (early, late) = samples.split_at(samples.len() / 2);
            own.extend(late.iter().chain(early.iter().rev()).find(|point| free(**point, &[])));
        }
        taken.extend(&own);
        places.push(own);
    }
    places
}

/// A step that visits all of `count` slots and puts neighbours far apart.
fn stride(count: usize) -> usize {
    fn common_divisor(a: usize, b: usize) -> usize {
        if b == 0 { a } else { common_divisor(b, a % b) }
    }
    let ideal = (count as f64 * 0.382).round().max(1.0) as usize;
    (ideal..=count).find(|step| common_divisor(*step, count) == 1).unwrap_or(1)
}

/// Draws a polyline with the dash of a curve.
pub(crate) fn draw_line(canvas: &Canvas, points: &[Point], curve: &Curve) {
    if curve.line {
        canvas.line(&simplified(points), curve.colour(), curve.width(), curve.dash());
    }
}
