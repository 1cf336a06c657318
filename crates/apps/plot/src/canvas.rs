//! Shapes and text drawn over plotters' charts, in displayed pixels.
//!
//! plotters rounds to whole pixels and has dashes of one length and text of one height. Lines,
//! shapes and text of this crate are therefore drawn over its charts.

use std::cell::RefCell;

use plotters::coord::Shift;
use plotters::prelude::{DrawingArea, IntoDrawingArea, SVGBackend};

use crate::error::PlotError;
use crate::series::Point;
use crate::style::{Colour, Marker, WHITE};
use crate::text::{CAPITAL, LINE, escaped, spans};

/// Scale of plotters' drawing area, which makes its rounding to whole pixels invisible.
const FINE: f64 = 10.0;
/// Half the width of a marker.
pub(crate) const MARKER: f64 = 4.7;

/// A length on plotters' drawing area.
pub(crate) fn fine(length: f64) -> i32 {
    (length * FINE).round() as i32
}

/// A rectangle in pixels; `top` is less than `bottom`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rect {
    pub(crate) left: f64,
    pub(crate) top: f64,
    pub(crate) right: f64,
    pub(crate) bottom: f64,
}

impl Rect {
    /// The rectangle of this size with its top left corner at a point.
    pub(crate) fn sized(left: f64, top: f64, width: f64, height: f64) -> Self {
        Self { left, top, right: left + width, bottom: top + height }
    }

    pub(crate) fn width(&self) -> f64 {
        self.right - self.left
    }

    pub(crate) fn height(&self) -> f64 {
        self.bottom - self.top
    }

    /// The pixel of a point given in fractions of the width and, from the bottom, of the height.
    pub(crate) fn at(&self, share: Point) -> Point {
        (self.left + share.0 * self.width(), self.bottom - share.1 * self.height())
    }

    /// The rectangle with its sides moved out, or in if negative.
    pub(crate) fn grown(&self, by: f64) -> Self {
        let (width, height) = (self.width() + 2.0 * by, self.height() + 2.0 * by);
        Self::sized(self.left - by, self.top - by, width, height)
    }

    pub(crate) fn contains(&self, point: Point) -> bool {
        (self.left..=self.right).contains(&point.0) && (self.top..=self.bottom).contains(&point.1)
    }

    /// The rectangle as attributes of a tag.
    fn place(&self) -> String {
        let (Self { left, top, .. }, width, height) = (self, self.width(), self.height());
        format!("x=\"{left:.2}\" y=\"{top:.2}\" width=\"{width:.2}\" height=\"{height:.2}\"")
    }

    pub(crate) fn corners(&self) -> [Point; 4] {
        let Self { left, top, right, bottom } = *self;
        [(left, top), (right, top), (right, bottom), (left, bottom)]
    }
}

/// The style of a line of text: size, colour, anchor (start, middle or end), weight and direction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Type {
    pub(crate) size: f64,
    pub(crate) colour: Colour,
    pub(crate) anchor: &'static str,
    pub(crate) bold: bool,
    pub(crate) upward: bool,
}

impl Type {
    pub(crate) fn new(size: f64, colour: Colour, anchor: &'static str) -> Self {
        Self { size, colour, anchor, bold: false, upward: false }
    }
}

/// The drawing area: plotters' charts, and shapes over them.
pub(crate) struct Canvas<'a> {
    pub(crate) charts: DrawingArea<SVGBackend<'a>, Shift>,
    over: RefCell<String>,
}

/// The text of an svg of this size.
pub(crate) fn picture(
    title: &str,
    (width, height): (f64, f64),
    draw: impl FnOnce(&Canvas) -> Result<(), PlotError>,
) -> Result<String, PlotError> {
    let (mut charts, height) = (String::new(), height.ceil());
    let paper = (fine(width).unsigned_abs(), fine(height).unsigned_abs());
    let area = SVGBackend::with_string(&mut charts, paper).into_drawing_area();
    let canvas = Canvas { charts: area, over: RefCell::default() };
    draw(&canvas)?;
    canvas.charts.present()?;
    let over = canvas.over.take();
    drop(canvas);
    // Without plotters' own root tag, and without the line breaks in its text tags, which some
    // viewers show as blanks.
    let charts =
        charts.split_once('\n').map_or("", |(_, body)| body).replace("\n</text>", "</text>");
    let charts = charts.trim_end().trim_end_matches("</svg>");
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" role=\"img\">\n"
    );
    if !title.is_empty() {
        svg += &format!("<title>{}</title>\n", escaped(title));
    }
    svg += &format!(
        "<rect width=\"{width}\" height=\"{height}\" fill=\"#FFFFFF\"/>\n<g transform=\"scale({})\">\n{charts}</g>\n<g stroke-linejoin=\"round\" xml:space=\"preserve\">\n{over}</g>\n</svg>\n",
        1.0 / FINE
    );
    Ok(svg)
}

fn places(points: &[Point]) -> String {
    let places: Vec<String> = points.iter().map(|(x, y)| format!("{x:.2},{y:.2}")).collect();
    places.join(" ")
}

impl Canvas<'_> {
    fn add(&self, tag: &str) {
        self.over.borrow_mut().push_str(tag);
    }

    /// A line with a pattern of dashes and gaps; solid if the pattern is empty.
    pub(crate) fn line(&self, points: &[Point], colour: Colour, width: f64, dash: &[f64]) {
        let lengths: Vec<String> = dash.iter().map(f64::to_string).collect();
        let dash = match dash {
            [] => String::new(),
            _ => format!(" stroke-dasharray=\"{}\"", lengths.join(" ")),
        };
        if points.len() > 1 {
            let points = places(points);
            self.add(&format!("<polyline points=\"{points}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"{dash}/>\n"));
        }
    }

    /// A filled polygon with this opacity.
    pub(crate) fn polygon(&self, corners: &[Point], colour: Colour, opacity: f64) {
        self.shape(corners, colour, &format!("fill-opacity=\"{opacity:.3}\""));
    }

    /// A filled polygon with an attribute.
    pub(crate) fn shape(&self, corners: &[Point], colour: &str, attribute: &str) {
        let corners = places(corners);
        self.add(&format!("<polygon points=\"{corners}\" fill=\"{colour}\" {attribute}/>\n"));
    }

    /// The outline of a rectangle.
    pub(crate) fn outline(&self, rect: &Rect, colour: Colour, width: f64) {
        let around: Vec<Point> = rect.corners().into_iter().cycle().take(6).collect();
        self.line(&around, colour, width, &[]);
    }

    /// A marker with a thin white rim, which separates it from the lines below it.
    pub(crate) fn marker(&self, (x, y): Point, (path, filled): Marker, colour: Colour) {
        let fill = if filled { colour } else { WHITE };
        // Crosses have no inside.
        let width = if path.ends_with('Z') { 1.7 } else { 2.4 };
        for (fill, stroke, width) in [(WHITE, WHITE, width + 2.4), (fill, colour, width)] {
            self.add(&format!("<path d=\"{path}\" transform=\"translate({x:.2} {y:.2})\" fill=\"{fill}\" stroke=\"{stroke}\" stroke-width=\"{width}\"/>\n"));
        }
    }

    /// A rectangle that shows a text, and a line within it, only under the pointer.
    pub(crate) fn reading(&self, rect: &Rect, x: f64, text: &str) {
        let (place, Rect { top, bottom, .. }) = (rect.place(), rect);
        self.add(&format!("<g class=\"reading\"><title>{}</title><rect {place} fill-opacity=\"0\"/><line x1=\"{x:.2}\" x2=\"{x:.2}\" y1=\"{top:.2}\" y2=\"{bottom:.2}\" stroke=\"#555555\" stroke-opacity=\"0\"/></g>\n", escaped(text)));
    }

    /// A line of text with its baseline at a point.
    pub(crate) fn text(&self, text: &str, (x, y): Point, face: Type) {
        let Type { size, colour, anchor, bold, upward } = face;
        let bold = if bold { " font-weight=\"bold\"" } else { "" };
        let turn = if upward { " rotate(-90)" } else { "" };
        let words = spans(text, size);
        if !text.is_empty() {
            self.add(&format!("<text transform=\"translate({x:.1} {y:.1}){turn}\" font-size=\"{size:.1}\" text-anchor=\"{anchor}\" fill=\"{colour}\"{bold}>{words}</text>\n"));
        }
    }

    /// Lines of text one under another, the capitals of the first beginning at `top`.
    pub(crate) fn lines(&self, lines: &[String], (x, top): Point, face: Type) {
        for (index, line) in lines.iter().enumerate() {
            let baseline = top + CAPITAL * face.size + index as f64 * face.size * LINE;
            self.text(line, (x, baseline), face);
        }
    }

    /// An image that fills a rectangle, its pixels as squares, on a white ground of a class of its
    /// own: a page in the dark gives it another colour.
    pub(crate) fn image(&self, rect: &Rect, address: &str) {
        let place = rect.place();
        self.add(&format!(
            "<rect class=\"ground\" {place} fill=\"{WHITE}\"/>\n<image {place} preserveAspectRatio=\"none\" image-rendering=\"pixelated\" href=\"{address}\"/>\n"
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blanks_are_kept_and_words_escaped() {
        let face = Type::new(10.0, "#000000", "start");
        let draw = |canvas: &Canvas| {
            canvas.text("σ_z = 1 < 2", (1.0, 2.0), face);
            Ok(())
        };
        let svg = picture("a < b", (80.0, 20.5), draw).unwrap();
        assert!(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"80\" height=\"21\" viewBox=\"0 0 80 21\""));
        assert!(svg.contains("<title>a &lt; b</title>") && svg.contains("xml:space=\"preserve\""));
        assert!(svg.contains("\"> = 1 &lt; 2</tspan></text>") && svg.ends_with("</g>\n</svg>\n"));
        assert_eq!(svg.matches("<svg").count() + svg.matches("</svg").count(), 2);
    }
}
