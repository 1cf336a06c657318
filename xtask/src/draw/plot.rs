//! A panel made ready: its curves, its two rulers, and the room around its frame.

use anyhow::{Context, Result, bail};

use super::clip::{Frame, Rect};
use super::figure::{Axis, Figure, Legend, Panel, Scale};
use super::layout::{LABEL, MarkLabels, SMALL, TICK, TICK_GAP, labels_that_fit, least_height};
use super::legend;
use super::room::Taken;
use super::ruler::Ruler;
use super::series::{self, Point, Series};
use super::style::CurveStyle;
use super::table::Table;
use super::text::{self, LINE};
use super::trace::{self, MARKER};

/// A panel with its data.
pub(crate) struct Plot<'a> {
    pub(crate) panel: &'a Panel,
    /// The (a) and the heading; empty for none.
    pub(crate) heading: String,
    pub(crate) series: Vec<Series<'a>>,
    pub(crate) x: Ruler,
    pub(crate) y: Ruler,
    pub(crate) legend: Legend,
    /// The name of the vertical axis, wrapped.
    pub(crate) y_label: Vec<String>,
}

/// The curves of a panel in pixels, and the places of their markers.
pub(crate) struct Traces {
    pub(crate) curves: Vec<Vec<Vec<Point>>>,
    pub(crate) markers: Vec<Vec<Point>>,
}

impl<'a> Plot<'a> {
    /// Takes the data of panel number `index` from the table.
    pub(crate) fn new(figure: &'a Figure, index: usize, table: &Table) -> Result<Self> {
        let panel = &figure.panels[index];
        let tag = char::from(b'a' + (index % 26) as u8);
        let heading = match (figure.panels.len() > 1, panel.title.as_str()) {
            (true, title) => format!("({tag}) {title}").trim_end().to_owned(),
            (false, title) => title.to_owned(),
        };
        let make = || -> Result<Self> {
            let series = series::of_panel(panel, table)?;
            let points = || {
                let tops = series.iter().flat_map(|one| one.pieces.iter().flatten());
                tops.chain(series.iter().flat_map(|one| one.base.iter().flatten()))
            };
            let across: Vec<f64> = points().map(|point| point.0).collect();
            let fits = labels_that_fit(figure);
            let most = |axis: &Axis, at: usize| fits[at + usize::from(axis.scale == Scale::Log)];
            let with_room = series.iter().all(|one| one.style.line.is_none());
            let x = Ruler::new(&panel.x, &across, with_room, most(&panel.x, 0))?;
            let up: Vec<f64> =
                points().filter(|point| x.holds(point.0)).map(|point| point.1).collect();
            let y = Ruler::new(&panel.y, &up, !panel.stacked, most(&panel.y, 2))?;
            let legend = if figure.shared_legend {
                Legend::Hidden
            } else if panel.stacked && panel.legend == Legend::Auto {
                Legend::Right
            } else {
                panel.legend
            };
            let y_label = text::wrap(&panel.y.label, LABEL, least_height(figure) + 40.0);
            Ok(Self { panel, heading: heading.clone(), series, x, y, legend, y_label })
        };
        make().with_context(|| format!("panel {} of figure `{}`", index + 1, figure.title))
    }

    /// Room to the left of the frame.
    pub(crate) fn left(&self) -> f64 {
        let numbers = self.y.ticks.ticks.iter().filter_map(|tick| tick.label.as_deref());
        let widest = numbers.map(|label| text::width(label, TICK)).fold(0.0, f64::max);
        let name = self.y_label.len() as f64 * LABEL * LINE + 16.0;
        TICK_GAP + widest + name + 10.0
    }

    /// Room to the right of the frame.
    pub(crate) fn right(&self) -> f64 {
        let beside = match self.legend {
            Legend::Right => self.legend_box(1, 520.0).width + 30.0,
            _ => 0.0,
        };
        50.0 + beside
    }

    /// Width of the heading, with some air after it.
    pub(crate) fn heading_width(&self) -> f64 {
        // Bold letters are about a tenth wider.
        text::width(&self.heading, LABEL) * 1.12 + 30.0
    }

    /// Room above the frame, with the labels of marks there.
    pub(crate) fn above(&self, marks: &MarkLabels) -> f64 {
        let own_row = !self.heading.is_empty() && !marks.beside_heading;
        let heading = if own_row { LABEL * LINE + 8.0 } else { 0.0 };
        let factor = if self.y.ticks.factor.is_some() { TICK * LINE } else { 0.0 };
        heading + factor + marks.height + 14.0
    }

    /// Room below a frame of this width.
    pub(crate) fn below(&self, width: f64) -> f64 {
        let lines = self.x_label(width).len() as f64;
        let lines = if self.x.ticks.factor.is_some() { lines.max(1.0) } else { lines };
        TICK_GAP + TICK * LINE + lines * LABEL * LINE + 14.0
    }

    /// The name of the horizontal axis, wrapped.
    pub(crate) fn x_label(&self, width: f64) -> Vec<String> {
        let factor = if self.x.ticks.factor.is_some() { 360.0 } else { 0.0 };
        text::wrap(&self.panel.x.label, LABEL, width + 60.0 - factor)
    }

    /// The legend in so many columns.
    pub(crate) fn legend_box(&self, columns: usize, widest: f64) -> legend::Box<'a> {
        let mut styles: Vec<&'a CurveStyle> = self.panel.curves.iter().collect();
        if self.panel.stacked {
            styles.reverse();
        }
        legend::Box::new(styles, columns, widest, self.panel.stacked)
    }

    /// The curves in the pixels of a frame; an error names a curve outside it.
    pub(crate) fn traces(&self, rect: Rect) -> Result<Traces> {
        let frame = Frame { rect, x: &self.x, y: &self.y };
        let mut curves = Vec::new();
        for series in &self.series {
            let mut parts: Vec<Vec<Point>> = Vec::new();
            if series.style.line.is_some() {
                parts.extend(series.pieces.iter().flat_map(|piece| frame.clip(piece)));
            } else {
                let points = series.pieces.iter().flatten();
                parts.extend(points.flat_map(|point| frame.clip(std::slice::from_ref(point))));
            }
            if parts.is_empty() {
                bail!(
                    "curve `{}` of `{}` has nothing inside the ranges of the axes",
                    series.style.key,
                    self.panel.y.column
                );
            }
            curves.push(parts);
        }
        let mut lined: Vec<Vec<Vec<Point>>> = Vec::new();
        let mut measured = Vec::new();
        for (parts, series) in curves.iter().zip(&self.series) {
            match (series.style.line, series.style.marker) {
                (Some(_), Some(_)) if !self.panel.stacked => lined.push(parts.clone()),
                (Some(_), _) => lined.push(Vec::new()),
                (None, _) => {
                    measured.extend(parts.iter().flatten());
                    lined.push(Vec::new());
                }
            }
        }
        let mut markers = trace::marker_places(&lined, &rect, measured);
        for ((own, parts), series) in markers.iter_mut().zip(&curves).zip(&self.series) {
            let alone = |part: &&Vec<Point>| series.style.line.is_none() || part.len() == 1;
            own.extend(parts.iter().filter(alone).flatten());
        }
        Ok(Traces { curves, markers })
    }

    /// What text inside the frame has to keep clear of.
    pub(crate) fn taken(&self, traces: &Traces, rect: Rect) -> Taken {
        let frame = Frame { rect, x: &self.x, y: &self.y };
        let mut taken = Taken::default();
        for parts in &traces.curves {
            taken.curves.extend(trace::sampled(parts, 8.0));
        }
        for (x, y) in traces.markers.iter().flatten() {
            let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
            taken.curves.extend(corners.map(|(dx, dy)| (x + dx * MARKER, y + dy * MARKER)));
        }
        for mark in self.panel.verticals.iter().filter(|mark| self.x.holds(mark.at)) {
            let x = frame.across(self.x.share(mark.at));
            taken.lines.extend(trace::sampled(&[vec![(x, rect.top), (x, rect.bottom)]], 12.0));
        }
        for mark in self.panel.horizontals.iter().filter(|mark| self.y.holds(mark.at)) {
            let y = frame.up(self.y.share(mark.at));
            taken.lines.extend(trace::sampled(&[vec![(rect.left, y), (rect.right, y)]], 12.0));
        }
        taken
    }

    /// Whether an automatic legend finds room inside a frame without covering a
    /// curve, and where.
    pub(crate) fn legend_inside(
        &self,
        taken: &Taken,
        rect: Rect,
    ) -> Option<(legend::Box<'a>, Rect)> {
        let region = rect.grown(-SMALL * 0.7);
        for columns in [1, 2] {
            let made = self.legend_box(columns, rect.width() * 0.5);
            let small = made.width < 0.75 * region.width()
                && made.height < 0.75 * region.height()
                && made.width * made.height < 0.35 * region.width() * region.height();
            if !small || made.is_empty() {
                continue;
            }
            let found = taken.best(&region, made.width, made.height);
            if taken.covered(&found) == 0 {
                return Some((made, found));
            }
        }
        None
    }
}
