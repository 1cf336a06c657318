//! Draws one panel: shades, grid, curves, markers, axes, and the text in it.

use anyhow::Result;

use super::canvas::{Canvas, Side, Type};
use super::clip::{Frame, Rect, clip_polygon};
use super::figure::{Along, Band};
use super::layout::{LEADER, MarkLabels, SMALL};
use super::legend::{area_colour, stroke};
use super::plot::{Plot, Traces};
use super::series::Point;
use super::style::{Colour, Dash, Marker, Shape};
use super::text::CAPITAL;
use super::trace;

/// Draws a panel into its frame.
pub(crate) fn draw(canvas: &Canvas, plot: &Plot, rect: Rect, marks: &MarkLabels) -> Result<()> {
    let brush = Brush { canvas, plot, rect, frame: Frame { rect, x: &plot.x, y: &plot.y } };
    let traces = plot.traces(rect)?;
    let mut taken = plot.taken(&traces, rect);
    brush.bands()?;
    brush.grid()?;
    brush.areas()?;
    brush.reference_lines(marks)?;
    brush.curves(&traces)?;
    brush.axes(marks)?;
    brush.heading(marks)?;
    brush.area_labels()?;
    brush.legend(&mut taken)?;
    brush.notes(&mut taken)?;
    brush.band_labels(&mut taken)?;
    brush.line_labels(&mut taken)
}

/// One panel on its paper.
pub(crate) struct Brush<'b, 'c, 'p> {
    pub(crate) canvas: &'b Canvas<'c>,
    pub(crate) plot: &'b Plot<'p>,
    pub(crate) rect: Rect,
    pub(crate) frame: Frame<'b>,
}

impl Brush<'_, '_, '_> {
    pub(crate) fn band_rect(&self, band: &Band) -> Option<Rect> {
        let ruler = match band.along {
            Along::X => &self.plot.x,
            Along::Y => &self.plot.y,
        };
        let (from, to) =
            (ruler.share(band.from).clamp(0.0, 1.0), ruler.share(band.to).clamp(0.0, 1.0));
        let rect = match band.along {
            Along::X => {
                Rect { left: self.frame.across(from), right: self.frame.across(to), ..self.rect }
            }
            Along::Y => Rect { top: self.frame.up(to), bottom: self.frame.up(from), ..self.rect },
        };
        (to > from).then_some(rect)
    }

    fn bands(&self) -> Result<()> {
        for band in &self.plot.panel.bands {
            if let Some(rect) = self.band_rect(band) {
                self.canvas.rect(&rect, band.colour, 1.0)?;
            }
        }
        Ok(())
    }

    fn areas(&self) -> Result<()> {
        for series in &self.plot.series {
            if let Some(base) = &series.base {
                let edge = series.pieces.iter().flatten().chain(base.iter().rev());
                let polygon: Vec<Point> = edge.map(|point| self.frame.pixel(*point)).collect();
                let inside = clip_polygon(&self.rect, &polygon);
                self.canvas.polygon(&inside, area_colour(series.style))?;
            }
        }
        Ok(())
    }

    fn reference_lines(&self, marks: &MarkLabels) -> Result<()> {
        let (plot, rect) = (self.plot, self.rect);
        let lengths = [18.0, 10.0];
        for mark in plot.panel.verticals.iter().filter(|mark| plot.x.holds(mark.at)) {
            let x = self.frame.across(plot.x.share(mark.at));
            for part in trace::dashed(&[(x, rect.bottom), (x, rect.top)], &lengths) {
                self.canvas.line(&part, Colour::GREY, 4)?;
            }
        }
        for mark in plot.panel.horizontals.iter().filter(|mark| plot.y.holds(mark.at)) {
            let y = self.frame.up(plot.y.share(mark.at));
            self.canvas.line(&[(rect.left, y), (rect.right, y)], Colour::DARK_GREY, 4)?;
        }
        for (middle, lines, place) in &marks.labels {
            let foot = rect.top - LEADER - 8.0;
            self.canvas.line(&[(*place, rect.top), (*middle, foot + 6.0)], Colour::GREY, 3)?;
            let pitch = SMALL * 1.2;
            let top = foot - (lines.len() as f64 - 1.0) * pitch - CAPITAL * SMALL - 8.0;
            let face = Type::new(SMALL, Colour::DARK_GREY, Side::Middle);
            self.canvas.lines(lines, (*middle, top), pitch, face)?;
        }
        Ok(())
    }

    fn curves(&self, traces: &Traces) -> Result<()> {
        for series in self.plot.series.iter().filter(|series| series.style.join_gaps) {
            for pair in series.pieces.windows(2) {
                if let ([.., from], [to, ..]) = (pair[0].as_slice(), pair[1].as_slice()) {
                    for part in self.frame.clip(&[*from, *to]) {
                        for dot in trace::dashed(&part, Dash::Sparse.lengths()) {
                            self.canvas.line(&dot, series.style.colour.tint(0.25), 4)?;
                        }
                    }
                }
            }
        }
        let mut order: Vec<usize> = (0..traces.curves.len()).collect();
        let ink = |index: &usize| self.plot.series[*index].style.line.map_or(0.0, Dash::ink_share);
        order.sort_by(|a, b| ink(b).total_cmp(&ink(a)));
        for index in order {
            let style = self.plot.series[index].style;
            for part in &traces.curves[index] {
                stroke(self.canvas, part, style)?;
            }
        }
        for (series, places) in self.plot.series.iter().zip(&traces.markers) {
            let marker = series.style.marker.unwrap_or(Marker::filled(Shape::Circle));
            for place in places {
                self.canvas.marker(*place, marker, series.style.colour)?;
            }
        }
        Ok(())
    }
}
