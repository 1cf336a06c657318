//! The few things that are drawn, on top of `plotters`; all in pixels.

use anyhow::{Result, anyhow};
use plotters::coord::Shift;
use plotters::element::{Circle, PathElement, Polygon, Rectangle};
use plotters::prelude::{
    Color, DrawingArea, DrawingAreaErrorKind, IntoDrawingArea, IntoFont, RGBAColor, RGBColor,
    SVGBackend, ShapeStyle, TextStyle,
};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontStyle, FontTransform};

use super::clip::Rect;
use super::series::Point;
use super::style::{Colour, Marker, Shape};
use super::text::CAPITAL;
use super::trace::MARKER;

/// What `plotters` is given is this many times as large, because it rounds to
/// whole pixels: the kinks of the rounding would show in flat curves.
pub(crate) const FINE: u32 = 4;

/// How a line of text is set.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Type {
    pub(crate) size: f64,
    pub(crate) colour: Colour,
    pub(crate) bold: bool,
    pub(crate) side: Side,
}

/// Which part of a text is at the given place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    Start,
    Middle,
    End,
}

impl Type {
    pub(crate) fn new(size: f64, colour: Colour, side: Side) -> Self {
        Self { size, colour, bold: false, side }
    }
}

/// The paper.
pub(crate) struct Canvas<'a> {
    area: DrawingArea<SVGBackend<'a>, Shift>,
}

fn whole(point: Point) -> (i32, i32) {
    let fine = f64::from(FINE);
    ((point.0 * fine).round() as i32, (point.1 * fine).round() as i32)
}

fn ink(colour: Colour, alpha: f64) -> RGBAColor {
    RGBColor(colour.0, colour.1, colour.2).mix(alpha)
}

fn done<E: std::error::Error + Send + Sync>(
    result: Result<(), DrawingAreaErrorKind<E>>,
) -> Result<()> {
    result.map_err(|error| anyhow!("drawing failed: {error}"))
}

impl<'a> Canvas<'a> {
    /// White paper of this size in pixels; the picture goes to the string.
    pub(crate) fn new(svg: &'a mut String, width: u32, height: u32) -> Result<Self> {
        let area = SVGBackend::with_string(svg, (width * FINE, height * FINE)).into_drawing_area();
        let canvas = Self { area };
        let paper = Rect::sized(0.0, 0.0, f64::from(width), f64::from(height));
        canvas.rect(&paper, Colour::WHITE, 1.0)?;
        Ok(canvas)
    }

    /// Ends the picture.
    pub(crate) fn finish(self) -> Result<()> {
        done(self.area.present())
    }

    /// A polyline.
    pub(crate) fn line(&self, points: &[Point], colour: Colour, width: u32) -> Result<()> {
        let mut pixels: Vec<(i32, i32)> = points.iter().copied().map(whole).collect();
        pixels.dedup();
        if pixels.len() < 2 {
            return Ok(());
        }
        let style =
            ShapeStyle { color: ink(colour, 1.0), filled: false, stroke_width: width * FINE };
        done(self.area.draw(&PathElement::new(pixels, style)))
    }

    /// A filled polygon.
    pub(crate) fn polygon(&self, points: &[Point], colour: Colour) -> Result<()> {
        let mut pixels: Vec<(i32, i32)> = points.iter().copied().map(whole).collect();
        pixels.dedup();
        if pixels.len() < 3 {
            return Ok(());
        }
        done(self.area.draw(&Polygon::new(pixels, ink(colour, 1.0).filled())))
    }

    /// A filled rectangle.
    pub(crate) fn rect(&self, rect: &Rect, colour: Colour, alpha: f64) -> Result<()> {
        let corners = [whole((rect.left, rect.top)), whole((rect.right, rect.bottom))];
        done(self.area.draw(&Rectangle::new(corners, ink(colour, alpha).filled())))
    }

    /// The outline of a rectangle.
    pub(crate) fn outline(&self, rect: &Rect, colour: Colour, width: u32) -> Result<()> {
        let corners = [
            (rect.left, rect.top),
            (rect.right, rect.top),
            (rect.right, rect.bottom),
            (rect.left, rect.bottom),
        ];
        self.closed(&corners, colour, width)
    }

    fn closed(&self, corners: &[Point], colour: Colour, width: u32) -> Result<()> {
        let around: Vec<Point> = corners.iter().chain(corners.iter().take(2)).copied().collect();
        self.line(&around, colour, width)
    }

    /// A line of text with its baseline at this height.
    pub(crate) fn text(&self, text: &str, baseline: Point, face: Type) -> Result<()> {
        // plotters puts the baseline 0.76 of the size below the place of "top" text.
        let top = (baseline.0, baseline.1 - 0.76 * face.size);
        self.set(text, top, face, FontTransform::None)
    }

    /// A line of text that reads upwards, with its baseline at this x.
    pub(crate) fn upward(&self, text: &str, baseline: Point, face: Type) -> Result<()> {
        let top = (baseline.0 - 0.76 * face.size, baseline.1);
        self.set(text, top, face, FontTransform::Rotate270)
    }

    fn set(&self, text: &str, top: Point, face: Type, turn: FontTransform) -> Result<()> {
        let side = match face.side {
            Side::Start => HPos::Left,
            Side::Middle => HPos::Center,
            Side::End => HPos::Right,
        };
        let weight = if face.bold { FontStyle::Bold } else { FontStyle::Normal };
        // plotters divides the size by 1.24 when it writes it.
        let font = ("sans-serif", face.size * f64::from(FINE) * 1.24)
            .into_font()
            .style(weight)
            .transform(turn);
        let colour = ink(face.colour, 1.0);
        let style = TextStyle::from(font).color(&colour).pos(Pos::new(side, VPos::Top));
        done(self.area.draw_text(text, &style, whole(top)))
    }

    /// Lines of text one under another, the capitals of the first beginning at `top`.
    pub(crate) fn lines(&self, lines: &[String], at: Point, pitch: f64, face: Type) -> Result<()> {
        for (index, line) in lines.iter().enumerate() {
            let baseline = at.1 + CAPITAL * face.size + index as f64 * pitch;
            self.text(line, (at.0, baseline), face)?;
        }
        Ok(())
    }

    /// A marker with a thin white rim, so that it stands off the lines below it.
    pub(crate) fn marker(&self, at: Point, marker: Marker, colour: Colour) -> Result<()> {
        let corners = |radius: f64| -> Vec<Point> {
            corners(marker.shape)
                .iter()
                .map(|c| (at.0 + c.0 * radius, at.1 + c.1 * radius))
                .collect()
        };
        match marker.shape {
            Shape::Circle => {
                let disc = |radius: f64, colour: Colour| {
                    let style = ink(colour, 1.0).filled();
                    done(self.area.draw(&Circle::new(
                        whole(at),
                        (radius * f64::from(FINE)).round() as u32,
                        style,
                    )))
                };
                disc(MARKER + 3.0, Colour::WHITE)?;
                disc(MARKER, colour)?;
                if !marker.filled {
                    disc(MARKER - 5.0, Colour::WHITE)?;
                }
                Ok(())
            }
            Shape::Cross | Shape::Plus => {
                let arms = corners(MARKER);
                for (colour, width) in [(Colour::WHITE, 13), (colour, 7)] {
                    self.line(&[arms[0], arms[1]], colour, width)?;
                    self.line(&[arms[2], arms[3]], colour, width)?;
                }
                Ok(())
            }
            _ if marker.filled => {
                self.polygon(&corners(MARKER + 4.0), Colour::WHITE)?;
                self.polygon(&corners(MARKER), colour)
            }
            _ => {
                self.polygon(&corners(MARKER + 4.0), Colour::WHITE)?;
                self.closed(&corners(MARKER - 2.0), colour, 5)
            }
        }
    }
}

/// The corners of a marker of half width one, made to look equally large.
fn corners(shape: Shape) -> &'static [Point] {
    match shape {
        Shape::Circle => &[],
        Shape::Square => &[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
        Shape::Triangle => &[(0.0, -1.2), (1.1, 0.75), (-1.1, 0.75)],
        Shape::Nabla => &[(0.0, 1.2), (1.1, -0.75), (-1.1, -0.75)],
        Shape::Diamond => &[(0.0, -1.25), (1.15, 0.0), (0.0, 1.25), (-1.15, 0.0)],
        Shape::Cross => &[(-0.85, -0.85), (0.85, 0.85), (-0.85, 0.85), (0.85, -0.85)],
        Shape::Plus => &[(-1.1, 0.0), (1.1, 0.0), (0.0, -1.1), (0.0, 1.1)],
    }
}
