//! Names of curves beside their points, each where it overlaps least.

use crate::canvas::{Canvas, MARKER, Rect, Type};
use crate::series::{Point, Series};
use crate::size::SMALL;
use crate::style::BLACK;
use crate::text::{CAPITAL, LINE, width};
use crate::trace::sampled;

/// Space around a name.
const AIR: f64 = 6.0;

/// Writes the name of each curve that has one.
pub(crate) fn draw(
    canvas: &Canvas,
    frame: &Rect,
    series: &[Series],
    traces: &[Vec<Vec<Point>>],
    markers: &[Vec<Point>],
) {
    let mut taken: Vec<Point> = traces.iter().flat_map(|parts| sampled(parts, 2.7)).collect();
    let rim = |place: &Point| Rect::sized(place.0, place.1, 0.0, 0.0).grown(MARKER).corners();
    taken.extend(markers.iter().flatten().flat_map(rim));
    let named = series.iter().zip(traces).filter(|(series, _)| !series.curve.label.is_empty());
    let mut named: Vec<_> = named.map(|(s, parts)| (&s.curve.label, parts.concat())).collect();
    // Curves with the fewest points first: they have the fewest positions.
    named.sort_by_key(|(_, points)| points.len());
    let inside = frame.grown(-4.0);
    for (label, points) in named {
        let size = (width(label, SMALL), SMALL * LINE);
        let places = points.iter().flat_map(|point| around(*point, size));
        let places = places.filter(|rect| rect.corners().iter().all(|c| inside.contains(*c)));
        let covered = |rect: &Rect| {
            let wide = rect.grown(AIR);
            taken.iter().filter(|point| wide.contains(**point)).count()
        };
        if let Some(rect) = places.min_by_key(covered) {
            let baseline = rect.top + 0.5 * (size.1 + CAPITAL * SMALL);
            canvas.text(label, (rect.left, baseline), Type::new(SMALL, BLACK, "start"));
            // An overlap with a name counts more than one with a curve.
            let edges: Vec<Point> = rect.corners().into_iter().cycle().take(5).collect();
            let name = sampled(&[edges], 3.0);
            taken.extend(name.iter().cycle().take(100 * name.len()));
        }
    }
}

/// Boxes around a marker and clear of it: right and left of it, then above and below, in the middle
/// and flush with either side.
fn around((x, y): Point, (width, height): Point) -> Vec<Rect> {
    let gap = MARKER + AIR + 1.5;
    let middle = y - 0.5 * height;
    let mut corners = vec![(x + gap, middle), (x - gap - width, middle)];
    for top in [y - gap - height, y + gap] {
        let lefts = [x - 0.5 * width, x + MARKER - width, x - MARKER];
        corners.extend(lefts.map(|left| (left, top)));
    }
    corners.into_iter().map(|(left, top)| Rect::sized(left, top, width, height)).collect()
}
