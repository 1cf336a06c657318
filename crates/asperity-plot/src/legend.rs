//! The legend: for each curve a key with line, dash and marker, and its label. plotters' own legend
//! measures text by its bytes and stands inside one chart.

use crate::canvas::{Canvas, Rect, Type};
use crate::figure::Panel;
use crate::series::Point;
use crate::style::{BLACK, Curve};
use crate::text::{CAPITAL, width};
use crate::trace::simplified;

const SIZE: f64 = 13.3;
const KEY: f64 = 53.0;
const KEY_GAP: f64 = 8.0;
const PAD: f64 = 7.5;
const COLUMN_GAP: f64 = 17.0;
const ROW: f64 = 18.5;
/// Opacity of an area.
pub(crate) const AREA: f64 = 0.4;

/// The legend of all panels, with its size.
pub(crate) struct Legend<'a> {
    /// Each curve, and whether the area under it is filled.
    entries: Vec<(&'a Curve, bool)>,
    rows: usize,
    column: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl<'a> Legend<'a> {
    /// The legend in as many columns as fit into a width.
    pub(crate) fn new(panels: &'a [Panel], widest: f64) -> Self {
        let mut entries: Vec<(&Curve, bool)> = vec![];
        let curves =
            panels.iter().flat_map(|p| p.curves.iter().map(move |curve| (curve, p.stacked)));
        for (curve, filled) in curves.filter(|(curve, _)| !curve.label.is_empty()) {
            match entries.iter_mut().find(|(entry, _)| entry.label == curve.label) {
                Some(entry) => entry.1 |= filled,
                None => entries.push((curve, filled)),
            }
        }
        let label = entries.iter().map(|(curve, _)| width(&curve.label, SIZE)).fold(0.0, f64::max);
        let column = KEY + KEY_GAP + label;
        let fit = ((widest - 2.0 * PAD + COLUMN_GAP) / (column + COLUMN_GAP)).floor().max(1.0);
        let rows = entries.len().div_ceil(fit as usize);
        let columns = entries.len().div_ceil(rows.max(1)) as f64;
        let width = columns * (column + COLUMN_GAP) - COLUMN_GAP + 2.0 * PAD;
        Self { rows, column, width, height: ROW * rows as f64 + 2.0 * PAD, entries }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Draws the legend with its top left corner at a point.
    pub(crate) fn draw(&self, canvas: &Canvas, (left, top): Point) {
        let edge = Rect::sized(left, top, self.width, self.height);
        canvas.outline(&edge, "#AAAAAA", 0.7);
        for (index, (curve, filled)) in self.entries.iter().enumerate() {
            let (column, row) = ((index / self.rows) as f64, (index % self.rows) as f64);
            let x = left + PAD + column * (self.column + COLUMN_GAP);
            let y = top + PAD + (row + 0.5) * ROW;
            if *filled {
                let swatch = Rect::sized(x, y, KEY, 6.5);
                canvas.polygon(&swatch.corners(), curve.colour(), AREA);
            }
            draw_line(canvas, &[(x, y), (x + KEY, y)], curve);
            if !curve.faint {
                canvas.marker((x + 0.5 * KEY, y), curve.marker(), curve.colour());
            }
            let baseline = (x + KEY + KEY_GAP, y + 0.5 * CAPITAL * SIZE);
            canvas.text(&curve.label, baseline, Type::new(SIZE, BLACK, "start"));
        }
    }
}

/// Draws a polyline with the dash of a curve.
pub(crate) fn draw_line(canvas: &Canvas, points: &[Point], curve: &Curve) {
    if curve.line {
        canvas.line(&simplified(points), curve.colour(), curve.width(), curve.dash());
    }
}
