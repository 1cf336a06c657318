//! The legend: for each curve a key with line, dash and marker, and its label.

use anyhow::Result;

use super::canvas::{Canvas, Side, Type};
use super::clip::Rect;
use super::series::Point;
use super::style::{Colour, CurveStyle};
use super::text::{self, CAPITAL};
use super::trace;

/// Size of the labels in pixels.
pub(crate) const SIZE: f64 = 40.0;
/// Width of curves in pixels.
pub(crate) const CURVE: u32 = 6;

const KEY: f64 = 160.0;
const KEY_GAP: f64 = 24.0;
const PAD: f64 = 22.0;
const COLUMN_GAP: f64 = 50.0;
const PITCH: f64 = 46.0;
const ROW_GAP: f64 = 9.0;

/// A legend with its labels wrapped and its size known.
pub(crate) struct Box<'a> {
    entries: Vec<(&'a CurveStyle, Vec<String>)>,
    /// Top and height of each row, below the upper edge of the box.
    rows: Vec<(f64, f64)>,
    column: f64,
    filled: bool,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl<'a> Box<'a> {
    /// A legend of these curves in so many columns; `filled` keys show an area.
    pub(crate) fn new(
        styles: Vec<&'a CurveStyle>,
        columns: usize,
        widest: f64,
        filled: bool,
    ) -> Self {
        let entries: Vec<(&CurveStyle, Vec<String>)> = styles
            .into_iter()
            .map(|style| (style, text::wrap(&style.label, SIZE, widest)))
            .collect();
        let columns = columns.clamp(1, entries.len().max(1));
        let rows = entries.len().div_ceil(columns);
        let columns = entries.len().div_ceil(rows.max(1));
        let label = entries.iter().map(|(_, lines)| text::widest(lines, SIZE)).fold(0.0, f64::max);
        let mut tops = Vec::new();
        let mut height = PAD;
        for row in 0..rows {
            let lines = entries.iter().skip(row).step_by(rows).map(|(_, lines)| lines.len()).max();
            let tall = PITCH * lines.unwrap_or(1).max(1) as f64;
            tops.push((height, tall));
            height += tall + ROW_GAP;
        }
        let column = KEY + KEY_GAP + label;
        let gaps = COLUMN_GAP * columns.saturating_sub(1) as f64;
        Self {
            entries,
            rows: tops,
            column,
            filled,
            width: column * columns as f64 + gaps + 2.0 * PAD,
            height: height - ROW_GAP + PAD,
        }
    }

    /// A legend in as many columns as fit into a width.
    pub(crate) fn in_width(styles: &[&'a CurveStyle], width: f64, filled: bool) -> Self {
        let make = |columns| Self::new(styles.to_vec(), columns, width * 0.8, filled);
        (2..=styles.len()).rev().map(make).find(|made| made.width <= width).unwrap_or(make(1))
    }

    /// Whether there is anything to show.
    pub(crate) fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Draws the legend with its top left corner here.
    pub(crate) fn draw(&self, canvas: &Canvas, left: f64, top: f64, boxed: bool) -> Result<()> {
        let rect = Rect::sized(left, top, self.width, self.height);
        if boxed {
            canvas.rect(&rect, Colour::WHITE, 0.92)?;
            canvas.outline(&rect, Colour(170, 170, 170), 2)?;
        }
        for (index, (style, lines)) in self.entries.iter().enumerate() {
            let rows = self.rows.len().max(1);
            let (from, tall) = self.rows.get(index % rows).copied().unwrap_or((PAD, PITCH));
            let across = (index / rows) as f64 * (self.column + COLUMN_GAP);
            let x = left + PAD + across;
            let middle = top + from + tall / 2.0;
            self.key(canvas, style, (x, middle))?;
            let first = middle - (lines.len() as f64 - 1.0) * PITCH / 2.0 - CAPITAL * SIZE / 2.0;
            let face = Type::new(SIZE, Colour::BLACK, Side::Start);
            canvas.lines(lines, (x + KEY + KEY_GAP, first), PITCH, face)?;
        }
        Ok(())
    }

    fn key(&self, canvas: &Canvas, style: &CurveStyle, left: Point) -> Result<()> {
        let right = (left.0 + KEY, left.1);
        if self.filled {
            let swatch = Rect::sized(left.0, left.1 - 17.0, KEY, 34.0);
            canvas.rect(&swatch, area_colour(style), 1.0)?;
        }
        let line_at = if self.filled { -17.0 } else { 0.0 };
        stroke(canvas, &[(left.0, left.1 + line_at), (right.0, right.1 + line_at)], style)?;
        if let Some(marker) = style.marker.filter(|_| !self.filled) {
            canvas.marker((left.0 + KEY / 2.0, left.1 + line_at), marker, style.colour)?;
        }
        Ok(())
    }
}

/// The colour of the area under a stacked curve.
pub(crate) fn area_colour(style: &CurveStyle) -> Colour {
    style.colour.tint(0.6)
}

/// Draws a polyline in pixels with the dash of a curve.
pub(crate) fn stroke(canvas: &Canvas, points: &[Point], style: &CurveStyle) -> Result<()> {
    if let Some(dash) = style.line {
        for part in trace::dashed(points, dash.lengths()) {
            canvas.line(&trace::simplified(&part, 0.1), style.colour, CURVE)?;
        }
    }
    Ok(())
}
