//! The text inside a frame: legend, notes, and labels of bands, lines and areas.

use anyhow::Result;

use super::canvas::{Side, Type};
use super::clip::Rect;
use super::figure::{Along, Corner, Legend};
use super::layout::SMALL;
use super::legend;
use super::panel::Brush;
use super::room::{AIR, Taken};
use super::series::Point;
use super::style::Colour;
use super::text::{self, CAPITAL, LINE};
use super::trace::MARKER;

impl Brush<'_, '_, '_> {
    pub(crate) fn legend(&self, taken: &mut Taken) -> Result<()> {
        let region = self.rect.grown(-SMALL * 0.7);
        let (made, rect): (legend::Box, Rect) = match self.plot.legend {
            Legend::Hidden => return Ok(()),
            Legend::Direct => return self.direct_labels(taken),
            Legend::Right => {
                let made = self.plot.legend_box(1, 520.0);
                let rect =
                    Rect::sized(self.rect.right + 30.0, self.rect.top, made.width, made.height);
                (made, rect)
            }
            Legend::Auto => match self.plot.legend_inside(taken, self.rect) {
                Some(found) => found,
                None => return Ok(()),
            },
            Legend::Inside(corner) => {
                let made = self.plot.legend_box(1, self.rect.width() * 0.5);
                let left = match corner {
                    Corner::TopLeft | Corner::BottomLeft => region.left,
                    Corner::TopRight | Corner::BottomRight => region.right - made.width,
                };
                let top = match corner {
                    Corner::TopLeft | Corner::TopRight => region.top,
                    Corner::BottomLeft | Corner::BottomRight => region.bottom - made.height,
                };
                let rect = Rect::sized(left, top, made.width, made.height);
                (made, rect)
            }
        };
        if made.is_empty() {
            return Ok(());
        }
        made.draw(self.canvas, rect.left, rect.top, self.plot.legend != Legend::Right)?;
        taken.boxes.push(rect);
        Ok(())
    }

    /// Each name beside the point of its curve where it covers least.
    fn direct_labels(&self, taken: &mut Taken) -> Result<()> {
        let region = self.rect.grown(-12.0);
        let named = self.plot.series.iter().filter(|series| !series.style.label.is_empty());
        let mut named: Vec<_> = named.collect();
        // Those with the fewest points have the least choice.
        named.sort_by_key(|series| series.pieces.iter().map(Vec::len).sum::<usize>());
        for series in named {
            let (width, height) = block(std::slice::from_ref(&series.style.label));
            let points: Vec<Point> =
                series.pieces.iter().flatten().map(|point| self.frame.pixel(*point)).collect();
            let beside = points.iter().flat_map(|point| around(*point, width, height));
            let inside = beside.filter(|rect| {
                region.contains((rect.left, rect.top)) && region.contains((rect.right, rect.bottom))
            });
            if let Some(rect) = inside.min_by_key(|rect| taken.cost(rect)) {
                let face = Type::new(SMALL, Colour::BLACK, Side::Start);
                self.canvas.text(
                    &series.style.label,
                    (rect.left, rect.top + 0.8 * height),
                    face,
                )?;
                taken.boxes.push(rect);
            }
        }
        Ok(())
    }

    pub(crate) fn notes(&self, taken: &mut Taken) -> Result<()> {
        let region = self.rect.grown(-SMALL * 0.7);
        for note in &self.plot.panel.notes {
            let lines = text::wrap(&note.text, SMALL, self.rect.width() * 0.6);
            let (width, height) = block(&lines);
            let rect = match note.place {
                Some((x, y)) => Rect::sized(
                    self.rect.left + x * self.rect.width(),
                    self.rect.top + y * self.rect.height(),
                    width,
                    height,
                ),
                None => taken.best(&region, width, height),
            };
            self.inside_text(&lines, rect, taken)?;
        }
        Ok(())
    }

    pub(crate) fn band_labels(&self, taken: &mut Taken) -> Result<()> {
        for band in self.plot.panel.bands.iter().filter(|band| !band.label.is_empty()) {
            let Some(shade) = self.band_rect(band) else {
                continue;
            };
            let lines = text::wrap(&band.label, SMALL, self.rect.width() * 0.6);
            let (width, height) = block(&lines);
            let region = shade.grown(-12.0);
            if width <= region.width() || band.along == Along::Y {
                let rect = taken.best(&region, width, height);
                self.inside_text(&lines, rect, taken)?;
            } else {
                let one = text::width(&band.label, SMALL);
                let rect = taken.best(&region, SMALL * LINE, one);
                let baseline = (rect.left + SMALL, (rect.top + rect.bottom) / 2.0);
                let face = Type::new(SMALL, Colour::DARK_GREY, Side::Middle);
                self.canvas.upward(&band.label, baseline, face)?;
                taken.boxes.push(rect);
            }
        }
        Ok(())
    }

    pub(crate) fn line_labels(&self, taken: &mut Taken) -> Result<()> {
        let marks = self.plot.panel.horizontals.iter();
        for mark in marks.filter(|mark| !mark.label.is_empty() && self.plot.y.holds(mark.at)) {
            let y = self.frame.up(self.plot.y.share(mark.at));
            let lines = [mark.label.clone()];
            let (width, height) = block(&lines);
            let strip = Rect {
                left: self.rect.left + 20.0,
                right: self.rect.right - 20.0,
                top: y - 22.0 - height,
                bottom: y + 22.0 + height,
            };
            let rect = taken.best(&strip, width, height);
            self.inside_text(&lines, rect, taken)?;
        }
        Ok(())
    }

    /// Text in a box; near the right side it is set flush right, so that a
    /// viewer with wider letters does not push it over the frame.
    fn inside_text(&self, lines: &[String], rect: Rect, taken: &mut Taken) -> Result<()> {
        let right = rect.left - self.rect.left > self.rect.right - rect.right;
        let (side, x) = if right { (Side::End, rect.right) } else { (Side::Start, rect.left) };
        if taken.covered(&rect) > 0 {
            self.canvas.rect(&rect.grown(6.0), Colour::WHITE, 0.8)?;
        }
        let face = Type::new(SMALL, Colour::DARK_GREY, side);
        self.canvas.lines(lines, (x, rect.top + 6.0), SMALL * LINE, face)?;
        taken.boxes.push(rect);
        Ok(())
    }

    /// The names of stacked areas, inside each where it is thickest.
    pub(crate) fn area_labels(&self) -> Result<()> {
        for series in &self.plot.series {
            let Some(base) = &series.base else { continue };
            let half = text::width(&series.style.label, SMALL) / 2.0 + 24.0;
            let (mut thickest, mut place) = (SMALL * 2.2, None);
            for (up, low) in series.pieces.iter().flatten().zip(base) {
                let (up, low) = (self.frame.pixel(*up), self.frame.pixel(*low));
                let (top, bottom) = (up.1.max(self.rect.top), low.1.min(self.rect.bottom));
                let inside = up.0 - half > self.rect.left && up.0 + half < self.rect.right;
                if inside && bottom - top > thickest {
                    (thickest, place) = (bottom - top, Some((up.0, (top + bottom) / 2.0)));
                }
            }
            if let Some((x, y)) = place {
                let face = Type::new(SMALL, Colour::BLACK, Side::Middle);
                self.canvas.text(&series.style.label, (x, y + CAPITAL * SMALL / 2.0), face)?;
            }
        }
        Ok(())
    }
}

/// Boxes of this size around a marker and clear of it: right and left of it, then above and below
/// in the middle and flush with either side.
fn around(point: Point, width: f64, height: f64) -> Vec<Rect> {
    let gap = MARKER + AIR + 4.0;
    let middle = point.1 - height / 2.0;
    let mut places = vec![(point.0 + gap, middle), (point.0 - gap - width, middle)];
    for top in [point.1 - gap - height, point.1 + gap] {
        let lefts = [point.0 - width / 2.0, point.0 + MARKER - width, point.0 - MARKER];
        places.extend(lefts.map(|left| (left, top)));
    }
    places.into_iter().map(|(left, top)| Rect::sized(left, top, width, height)).collect()
}

/// The size of a block of small text.
fn block(lines: &[String]) -> (f64, f64) {
    (text::widest(lines, SMALL), lines.len() as f64 * SMALL * LINE)
}
