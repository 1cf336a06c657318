//! A curve in pixels: fewer points, dashes, samples, and places for markers.

use super::clip::Rect;
use super::series::Point;

/// Half the width of a marker in pixels.
pub(crate) const MARKER: f64 = 14.0;

/// How many places for a marker a curve over the whole width of a frame has.
fn markers_across(frame: &Rect) -> usize {
    (frame.width() / 380.0).floor().clamp(3.0, 5.0) as usize
}

fn distance(a: Point, b: Point) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

fn between(a: Point, b: Point, share: f64) -> Point {
    (a.0 + share * (b.0 - a.0), a.1 + share * (b.1 - a.1))
}

/// The polyline without the points that change it by less than a tolerance, so
/// that dense data rounded to whole pixels show no steps (Douglas and Peucker).
pub(crate) fn simplified(points: &[Point], tolerance: f64) -> Vec<Point> {
    let Some(last) = points.len().checked_sub(1) else {
        return Vec::new();
    };
    let mut keep = vec![false; points.len()];
    keep[0] = true;
    keep[last] = true;
    let mut spans = vec![(0, last)];
    while let Some((from, to)) = spans.pop() {
        let (mut farthest, mut place) = (tolerance, None);
        for (index, point) in points.iter().enumerate().take(to).skip(from + 1) {
            let away = distance_to_segment(*point, points[from], points[to]);
            if away > farthest {
                (farthest, place) = (away, Some(index));
            }
        }
        if let Some(index) = place {
            keep[index] = true;
            spans.extend([(from, index), (index, to)]);
        }
    }
    points.iter().zip(keep).filter(|(_, kept)| *kept).map(|(point, _)| *point).collect()
}

fn distance_to_segment(point: Point, from: Point, to: Point) -> f64 {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let square = dx * dx + dy * dy;
    if square <= 0.0 {
        return distance(point, from);
    }
    let share = ((point.0 - from.0) * dx + (point.1 - from.1) * dy) / square;
    distance(point, between(from, to, share.clamp(0.0, 1.0)))
}

/// The inked parts of a polyline under a pattern of ink and gap lengths.
pub(crate) fn dashed(points: &[Point], lengths: &[f64]) -> Vec<Vec<Point>> {
    if lengths.is_empty() || points.len() < 2 {
        return vec![points.to_vec()];
    }
    let mut parts = Vec::new();
    let mut part = vec![points[0]];
    let (mut turn, mut left) = (0, lengths[0]);
    for pair in points.windows(2) {
        let length = distance(pair[0], pair[1]);
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let here = between(pair[0], pair[1], done / length);
            if turn % 2 == 0 {
                part.push(here);
                parts.push(std::mem::take(&mut part));
            } else {
                part = vec![here];
            }
            turn = (turn + 1) % lengths.len();
            left = lengths[turn];
        }
        left -= length - done;
        if turn % 2 == 0 {
            part.push(pair[1]);
        }
    }
    if part.len() > 1 {
        parts.push(part);
    }
    parts
}

/// Points along polylines at most so many pixels apart.
pub(crate) fn sampled(parts: &[Vec<Point>], every: f64) -> Vec<Point> {
    let mut samples = Vec::new();
    for part in parts {
        samples.extend(part.first().copied());
        for pair in part.windows(2) {
            let count = (distance(pair[0], pair[1]) / every).ceil().max(1.0) as usize;
            samples.extend((1..=count).map(|i| between(pair[0], pair[1], i as f64 / count as f64)));
        }
    }
    samples
}

/// Every point at which polylines cross a vertical.
fn crossings(parts: &[Vec<Point>], x: f64) -> Vec<Point> {
    let mut found = Vec::new();
    for pair in parts.iter().flat_map(|part| part.windows(2)) {
        let (from, to) = (pair[0], pair[1]);
        if (from.0 < x) != (to.0 < x) {
            found.push(between(from, to, (x - from.0) / (to.0 - from.0)));
        }
    }
    found
}

/// Places for the sparse markers of several curves: each curve has its own
/// verticals, and no two markers touch each other or a measured point.
pub(crate) fn marker_places(
    curves: &[Vec<Vec<Point>>],
    frame: &Rect,
    measured: Vec<Point>,
) -> Vec<Vec<Point>> {
    let frame = frame.grown(-1.7 * MARKER);
    let count = curves.len().max(1);
    let across = markers_across(&frame);
    let spacing = frame.width() / across as f64;
    let stride = stride(count);
    let mut taken = measured;
    let mut places = Vec::new();
    for (index, parts) in curves.iter().enumerate() {
        let slot = (index * stride % count) as f64 + 0.5;
        let mut own: Vec<Point> = Vec::new();
        let free = |point: Point, own: &[Point]| {
            frame.contains(point)
                && taken.iter().all(|other| distance(*other, point) > 2.6 * MARKER)
                && own.iter().all(|other| distance(*other, point) > 5.0 * MARKER)
        };
        for group in 0..across {
            let x = frame.left + spacing * (group as f64 + slot / count as f64);
            let tries = [0.0, 0.12, -0.12, 0.24, -0.24, 0.36, -0.36];
            let found = tries.iter().find_map(|try_| {
                let points = crossings(parts, x + try_ * spacing);
                let fit = !points.is_empty() && points.iter().all(|point| free(*point, &own));
                fit.then_some(points)
            });
            own.extend(found.unwrap_or_default());
        }
        if own.is_empty() {
            let samples = sampled(parts, 4.0);
            let middle = samples.len() / 2;
            let (early, late) = samples.split_at(middle);
            let outward = late.iter().chain(early.iter().rev());
            own.extend(outward.copied().find(|point| free(*point, &[])));
        }
        taken.extend(&own);
        places.push(own);
    }
    places
}

/// A step that visits all of `count` slots and puts neighbours far apart.
fn stride(count: usize) -> usize {
    let ideal = (count as f64 * 0.382).round().max(1.0) as usize;
    (ideal..=count).find(|step| greatest_common_divisor(*step, count) == 1).unwrap_or(1)
}

fn greatest_common_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_run_on_over_many_short_segments() {
        let points: Vec<Point> = (0..=1000).map(|i| (f64::from(i) * 0.1, 0.0)).collect();
        let parts = dashed(&points, &[20.0, 10.0]);
        assert_eq!(parts.len(), 4);
        let ends = |part: &Vec<Point>| (part[0].0, part[part.len() - 1].0);
        for (index, part) in parts.iter().take(3).enumerate() {
            let (from, to) = ends(part);
            assert!((from - 30.0 * index as f64).abs() < 1e-6, "{from}");
            assert!((to - from - 20.0).abs() < 1e-6);
        }
        assert!((ends(&parts[3]).1 - 100.0).abs() < 1e-9);
    }

    #[test]
    fn simplifying_keeps_corners_and_drops_what_is_straight() {
        let mut points: Vec<Point> = (0..100).map(|i| (f64::from(i), 0.0)).collect();
        points.extend((1..100).map(|i| (99.0, f64::from(i))));
        assert_eq!(simplified(&points, 0.3), [(0.0, 0.0), (99.0, 0.0), (99.0, 99.0)]);
    }

    #[test]
    fn markers_of_identical_curves_do_not_touch() {
        let frame = Rect::sized(0.0, 0.0, 1900.0, 1400.0);
        let line = vec![vec![(0.0, 700.0), (1900.0, 600.0)]];
        let places = marker_places(&vec![line; 10], &frame, Vec::new());
        let all: Vec<Point> = places.concat();
        assert!(places.iter().all(|own| own.len() >= 3));
        for (index, a) in all.iter().enumerate() {
            assert!(all[index + 1..].iter().all(|b| distance(*a, *b) > 2.0 * MARKER));
        }
    }
}
