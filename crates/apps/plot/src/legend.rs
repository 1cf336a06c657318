//! The legend: for each curve a key with line, dash and marker, for each named area a swatch, and
//! the label. plotters' own legend measures text by its bytes and stands inside one chart.

use crate::canvas::{Canvas, Rect, Type};
use crate::panel::Plot;
use crate::series::{Point, Series};
use crate::style::{AREA, BAND, BLACK, Colour, Curve, EDGE, GREY};
use crate::text::{CAPITAL, width};
use crate::trace::draw_line;

/// Sizes of letters, keys and the gap between columns, also of a narrow picture.
const USUAL: [f64; 3] = [13.3, 53.0, 17.0];
const NARROW: [f64; 3] = [12.5, 26.0, 10.0];
/// The width of a narrow picture.
const NARROW_WIDTH: f64 = 700.0;
const KEY_GAP: f64 = 8.0;
const PAD: f64 = 7.5;
const ROW: f64 = 18.5;
/// What bands are.
const ENDS: &str = "lower to upper end";

/// What the key of an entry shows beside its line.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Fill {
    None,
    Area,
    Band,
}

/// A curve, or a shaded area without one.
struct Entry<'a> {
    label: &'a str,
    colour: Colour,
    curve: Option<&'a Curve>,
    fill: Fill,
}

impl<'a> Entry<'a> {
    fn of(plot: &'a Plot<'a>) -> impl Iterator<Item = Self> {
        let stacked = plot.panel.stacked;
        let curves = plot.series.iter().map(move |Series { curve, band, .. }| {
            let fill = match (band.is_empty(), stacked) {
                (false, _) => Fill::Band,
                (true, true) => Fill::Area,
                (true, false) => Fill::None,
            };
            Self { label: &curve.label, colour: curve.colour(), curve: Some(curve), fill }
        });
        let areas = plot.panel.between.iter().map(|area| {
            let colour = Curve::new(area.look, "", "").colour();
            Self { label: &area.label, colour, curve: None, fill: Fill::Area }
        });
        let has_bands = plot.series.iter().any(|series| !series.band.is_empty());
        let bands = Self { label: ENDS, colour: GREY, curve: None, fill: Fill::Band };
        let bands = has_bands.then_some(bands);
        curves.chain(areas).chain(bands).filter(|entry| !entry.label.is_empty())
    }
}

/// The legend of all panels, with its size.
pub(crate) struct Legend<'a> {
    entries: Vec<Entry<'a>>,
    rows: usize,
    size: f64,
    key: f64,
    /// Where columns start.
    columns: Vec<f64>,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl<'a> Legend<'a> {
    /// The legend in as many columns as fit into a width; `None` without entries.
    pub(crate) fn new(plots: &'a [Plot<'a>], widest: f64) -> Option<Self> {
        let mut entries: Vec<Entry> = vec![];
        for entry in plots.iter().flat_map(Entry::of) {
            match entries.iter_mut().find(|known| known.label == entry.label) {
                Some(known) => known.fill = known.fill.max(entry.fill),
                None => entries.push(entry),
            }
        }
        let is_narrow = widest < NARROW_WIDTH;
        let [size, key, gap] = if is_narrow { NARROW } else { USUAL };
        let longest =
            |part: &[Entry]| part.iter().map(|entry| width(entry.label, size)).fold(0.0, f64::max);
        // Rows, where columns start, and the end; columns of a narrow picture differ in width.
        let placed = |count: usize| {
            let rows = entries.len().div_ceil(count).max(1);
            let (mut starts, mut end) = (vec![], PAD);
            for part in entries.chunks(rows) {
                starts.push(end);
                end += key + KEY_GAP + longest(if is_narrow { part } else { &entries }) + gap;
            }
            (rows, starts, end - gap + PAD)
        };
        let counts = (2..=entries.len()).rev().map(placed);
        let fitting = counts.into_iter().find(|(.., width)| *width <= widest);
        let (rows, columns, width) = fitting.unwrap_or_else(|| placed(1));
        let height = ROW * rows as f64 + 2.0 * PAD;
        let is_any = !entries.is_empty();
        is_any.then_some(Self { rows, size, key, columns, width, height, entries })
    }

    /// Draws the legend with its top left corner at a point.
    pub(crate) fn draw(&self, canvas: &Canvas, (left, top): Point) {
        let edge = Rect::sized(left, top, self.width, self.height);
        canvas.outline(&edge, "#AAAAAA", 0.7);
        for (index, entry) in self.entries.iter().enumerate() {
            let row = (index % self.rows) as f64;
            let x = left + self.columns.get(index / self.rows).copied().unwrap_or(PAD);
            let y = top + PAD + (row + 0.5) * ROW;
            let (top, height, opacity) = match (entry.fill, entry.curve) {
                (Fill::None, _) => (y, 0.0, 0.0),
                (Fill::Area, Some(_)) => (y, 6.5, AREA),
                (Fill::Area, None) => (y - 5.0, 10.0, AREA),
                (Fill::Band, _) => (y - 6.5, 13.0, BAND),
            };
            let swatch = Rect::sized(x, top, self.key, height);
            if entry.fill != Fill::None {
                canvas.polygon(&swatch.corners(), entry.colour, opacity);
            }
            if entry.fill == Fill::Band {
                let dash = entry.curve.map_or(&[][..], Curve::dash);
                for y in [swatch.top, swatch.bottom] {
                    canvas.line(&[(x, y), (x + self.key, y)], entry.colour, EDGE, dash);
                }
            }
            if let Some(curve) = entry.curve {
                draw_line(canvas, &[(x, y), (x + self.key, y)], curve);
                if !curve.faint {
                    canvas.marker((x + 0.5 * self.key, y), curve.marker(), entry.colour);
                }
            }
            let baseline = (x + self.key + KEY_GAP, y + 0.5 * CAPITAL * self.size);
            canvas.text(entry.label, baseline, Type::new(self.size, BLACK, "start"));
        }
    }
}
