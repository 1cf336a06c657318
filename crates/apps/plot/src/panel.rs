//! A panel: its curves and axes, and the drawing into its frame.

use plotters::chart::{ChartBuilder, LabelAreaPosition};
use plotters::style::{Color, IntoFont, RGBColor, TextStyle};

use crate::canvas::{Canvas, Rect, Type, fine};
use crate::clip;
use crate::error::PlotError;
use crate::figure::{Figure, Panel, Strip};
use crate::ruler::Ruler;
use crate::series::{self, Area, CsvTable, Point, Series};
use crate::size::{LABEL, LEAST, SMALL, TICK, TITLE_GAP, labels_that_fit};
use crate::style::{AREA, BAND, BLACK, DARK_GREY, EDGE, GREY};
use crate::text::{CAPITAL, LINE, power_of_ten, widest, width};
use crate::trace::{draw_line, marker_places, simplified};

const GRID: RGBColor = RGBColor(222, 222, 222);
const FINE_GRID: RGBColor = RGBColor(242, 242, 242);
/// Opacity of strips.
const STRIP: f64 = 0.11;
/// Length of a tick; its number stands as far beyond it.
const TICK_LENGTH: f64 = 4.7;
/// Distance between reference lines and their labels.
const GAP: f64 = 5.0;
/// Dash and gap of the line across a jump.
const SPARSE: [f64; 2] = [2.0, 6.0];

/// A panel with its data.
pub(crate) struct Plot<'a> {
    pub(crate) panel: &'a Panel,
    heading: String,
    pub(crate) series: Vec<Series<'a>>,
    areas: Vec<Area<'a>>,
    x: Ruler,
    y: Ruler,
    /// The least size of the name of the vertical axis.
    least: f64,
}

/// The panels of a figure with their data, all of which are drawn.
pub(crate) fn plots<'a>(figure: &'a Figure, csv: &str) -> Result<Vec<Plot<'a>>, PlotError> {
    let table = CsvTable::read(csv)?;
    let each = (0..figure.panels.len()).map(|index| Plot::new(figure, index, &table));
    let all = each.collect::<Result<_, _>>()?;
    table.check_all_drawn()?;
    Ok(all)
}

impl<'a> Plot<'a> {
    /// Takes the data of panel number `index` from the table.
    fn new(figure: &'a Figure, index: usize, table: &CsvTable) -> Result<Self, PlotError> {
        let panel = &figure.panels[index];
        let tag = char::from(b'a' + (index % 26) as u8);
        let tag = if figure.panels.len() > 1 { format!("({tag}) ") } else { String::new() };
        let heading = format!("{tag}{}", panel.title).trim_end().into();
        let mut series = series::curves(panel, table)?;
        let areas = series::areas(panel, table, &mut series)?;
        let of_areas = || areas.iter().flat_map(|area| area.lower.iter().chain(&area.upper));
        let of_bands = || series.iter().flat_map(|s| s.band.iter().flatten().flatten());
        let edges = || of_areas().chain(of_bands());
        let points = || series.iter().flat_map(|s| s.pieces.iter().flatten()).chain(edges());
        let (across, down) = labels_that_fit(figure);
        let least = figure.size.map_or(0.0, |_| LEAST);
        let only_points = series.iter().all(|series| !series.curve.line);
        let shown = points().map(|point| point.0);
        let x = Ruler::new(&panel.x, shown, only_points, across)?;
        let shown = points().filter(|point| x.holds(point.0)).map(|point| point.1);
        let y = Ruler::new(&panel.y, shown, !panel.stacked, down)?;
        Ok(Self { panel, heading, series, areas, x, y, least })
    }

    /// Room to the left of the frame.
    pub(crate) fn left(&self) -> f64 {
        2.0 * TICK_LENGTH + widest(&self.y.labels(), TICK) + LABEL * LINE + 10.0
    }

    /// Room to the right of the frame, for half of the last number.
    pub(crate) fn right(&self) -> f64 {
        self.x.labels().last().map_or(0.0, |label| 0.5 * width(label, TICK)).max(8.0) + 4.0
    }

    /// Room above the frame.
    pub(crate) fn above(&self) -> f64 {
        let named = self.panel.verticals.iter().any(|mark| !mark.label.is_empty());
        let powered = self.y.exponent != 0;
        let marks = if named || powered { SMALL * LINE + GAP } else { 0.0 };
        // A panel letter alone fits beside the labels of marks.
        let beside = self.heading.is_empty() || named && !powered && self.panel.title.is_empty();
        marks + if beside { 0.0 } else { LABEL * LINE } + TITLE_GAP
    }

    /// Room below the frame.
    pub(crate) fn below(&self) -> f64 {
        2.0 * TICK_LENGTH + TICK * LINE + LABEL * LINE + 6.0
    }

    /// Draws the panel into its frame.
    pub(crate) fn draw(&self, canvas: &Canvas, frame: &Rect) -> Result<(), PlotError> {
        self.mesh(canvas, frame)?;
        self.shades(canvas, frame);
        self.reference_lines(canvas, frame);
        let traces = self.traces(frame);
        self.jumps(canvas, frame);
        let mut order: Vec<_> = self.series.iter().map(|s| s.curve).zip(&traces).collect();
        // Sparse dashes over denser lines, and all over those in the background.
        order.sort_by(|(a, _), (b, _)| b.faint.cmp(&a.faint).then(b.ink().total_cmp(&a.ink())));
        for (curve, parts) in order {
            parts.iter().for_each(|part| draw_line(canvas, part, curve));
        }
        let markers = self.markers(&traces, frame);
        for (series, places) in self.series.iter().zip(&markers) {
            let (marker, colour) = (series.curve.marker(), series.curve.colour());
            places.iter().for_each(|place| canvas.marker(*place, marker, colour));
        }
        canvas.outline(frame, BLACK, 1.3);
        self.labels(canvas, frame);
        self.readings(canvas, frame);
        Ok(())
    }

    /// The readings over all else, each from half-way after the one before to half-way to the next.
    fn readings(&self, canvas: &Canvas, frame: &Rect) {
        let inside = self.panel.readings.iter().filter(|mark| self.x.holds(mark.at));
        let mut places: Vec<(f64, &str)> =
            inside.map(|mark| (self.x.share(mark.at), mark.label.as_str())).collect();
        places.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut start = 0.0;
        for (k, (share, text)) in places.iter().enumerate() {
            let end = places.get(k + 1).map_or(1.0, |(next, _)| 0.5 * (share + next));
            let ((left, bottom), (right, top)) = (frame.at((start, 0.0)), frame.at((end, 1.0)));
            let middle = frame.at((*share, 0.0)).0;
            canvas.reading(&Rect { left, top, right, bottom }, middle, text);
            start = end;
        }
    }

    fn strip(&self, strip: &Strip, frame: &Rect) -> Rect {
        let ruler = if strip.upright { &self.x } else { &self.y };
        let [from, to] = [strip.from, strip.to].map(|end| ruler.share(end).clamp(0.0, 1.0));
        let corner = |end, side| frame.at(if strip.upright { (end, side) } else { (side, end) });
        let ((left, bottom), (right, top)) = (corner(from, 0.0), corner(to, 1.0));
        Rect { left, top, right, bottom }
    }

    fn shades(&self, canvas: &Canvas, frame: &Rect) {
        for strip in &self.panel.strips {
            canvas.polygon(&self.strip(strip, frame).corners(), BLACK, STRIP);
        }
        let areas = self.areas.iter().map(|area| (&area.lower, &area.upper, area.colour, AREA));
        let bands = self.series.iter().flat_map(|series| {
            series.band.iter().map(|[lower, upper]| (lower, upper, series.curve.colour(), BAND))
        });
        for (lower, upper, colour, opacity) in areas.chain(bands) {
            let edge = upper.iter().chain(lower.iter().rev());
            let shares: Vec<Point> = edge.map(|p| (self.x.share(p.0), self.y.share(p.1))).collect();
            let inside: Vec<Point> =
                clip::polygon(&shares).into_iter().map(|p| frame.at(p)).collect();
            canvas.polygon(&inside, colour, opacity);
        }
        // Thin, so that bands over each other are told apart and no edge looks like a curve.
        for Series { curve, band, .. } in &self.series {
            let edges = band.iter().flatten().flat_map(|edge| self.inside(edge, frame));
            edges.for_each(|edge| {
                canvas.line(&simplified(&edge), curve.colour(), EDGE, curve.dash())
            });
        }
    }

    /// plotters' chart: grid, ticks and their numbers.
    fn mesh(&self, canvas: &Canvas, frame: &Rect) -> Result<(), PlotError> {
        let (left, below) = (fine(self.left()), fine(self.below()));
        let corner = (fine(frame.left) - left, fine(frame.top));
        // plotters' last pixel belongs to the frame.
        let size = (left + fine(frame.width()) + 1, fine(frame.height()) + 1 + below);
        let area = canvas.charts.clone().shrink(corner, size);
        // plotters divides the size by 1.24 when it writes it.
        let font = ("sans-serif", f64::from(fine(TICK)) * 1.24).into_font();
        let thin = fine(0.8).unsigned_abs();
        ChartBuilder::on(&area)
            .set_label_area_size(LabelAreaPosition::Left, left)
            .set_label_area_size(LabelAreaPosition::Bottom, below)
            .build_cartesian_2d(self.x.clone(), self.y.clone())?
            .configure_mesh()
            .bold_line_style(GRID.stroke_width(thin))
            .light_line_style(FINE_GRID.stroke_width(thin))
            .axis_style(RGBColor(0, 0, 0).stroke_width(thin))
            .label_style(TextStyle::from(font).color(&RGBColor(0, 0, 0)))
            .set_all_tick_mark_size(fine(TICK_LENGTH))
            .draw()?;
        Ok(())
    }

    fn reference_lines(&self, canvas: &Canvas, frame: &Rect) {
        let face = |side| Type::new(SMALL, DARK_GREY, side);
        for mark in self.panel.verticals.iter().filter(|mark| self.x.holds(mark.at)) {
            let [foot, top] = [0.0, 1.0].map(|share| frame.at((self.x.share(mark.at), share)));
            canvas.line(&[foot, top], GREY, 1.3, &[6.0, 3.3]);
            canvas.text(&mark.label, (top.0, top.1 - GAP), face("middle"));
        }
        for mark in self.panel.horizontals.iter().filter(|mark| self.y.holds(mark.at)) {
            let [start, end] = [0.0, 1.0].map(|share| frame.at((share, self.y.share(mark.at))));
            canvas.line(&[start, end], DARK_GREY, 1.3, &[]);
            canvas.text(&mark.label, (end.0 - GAP, end.1 - GAP), face("end"));
        }
    }

    /// The parts of a piece inside the frame, in pixels.
    fn inside(&self, piece: &[Point], frame: &Rect) -> Vec<Vec<Point>> {
        let parts = clip::curve(piece, &self.x, &self.y).into_iter();
        parts.map(|part| part.into_iter().map(|share| frame.at(share)).collect()).collect()
    }

    /// The curves in pixels.
    fn traces(&self, frame: &Rect) -> Vec<Vec<Vec<Point>>> {
        let trace = |Series { curve, pieces, .. }: &Series| match curve.line {
            true => pieces.iter().flat_map(|piece| self.inside(piece, frame)).collect(),
            false => pieces.iter().flatten().flat_map(|p| self.inside(&[*p], frame)).collect(),
        };
        self.series.iter().map(trace).collect()
    }

    /// The ends of gaps joined.
    fn jumps(&self, canvas: &Canvas, frame: &Rect) {
        for Series { curve, pieces, .. } in
            self.series.iter().filter(|series| series.curve.join_gaps)
        {
            for pair in pieces.windows(2) {
                let ends = pair[0].last().into_iter().chain(pair[1].first()).copied();
                for part in self.inside(&ends.collect::<Vec<_>>(), frame) {
                    canvas.line(&part, curve.colour(), 1.0, &SPARSE);
                }
            }
        }
    }

    /// Markers: at sparse places along lines, at every point where requested, and at isolated
    /// points.
    fn markers(&self, traces: &[Vec<Vec<Point>>], frame: &Rect) -> Vec<Vec<Point>> {
        let (mut lined, mut all) = (vec![], vec![]);
        for (Series { curve, .. }, parts) in self.series.iter().zip(traces) {
            let alone = |part: &&Vec<Point>| part.len() == 1 && !curve.faint;
            let marked = |part: &&Vec<Point>| curve.every_point || alone(part);
            all.push(parts.iter().filter(marked).flatten().copied().collect::<Vec<_>>());
            let sparse = curve.line && !curve.every_point && !self.panel.stacked && !curve.faint;
            lined.push(if sparse { parts.clone() } else { vec![] });
        }
        let mut places = marker_places(&lined, frame, all.concat());
        places.iter_mut().zip(all).for_each(|(own, all)| own.extend(all));
        places
    }

    fn labels(&self, canvas: &Canvas, frame: &Rect) {
        let black = |size, side| Type::new(size, BLACK, side);
        let middle = frame.at((0.5, 0.5));
        let baseline = frame.bottom + self.below() - 6.0 - 0.3 * LABEL;
        canvas.text(&self.panel.x.label, (middle.0, baseline), black(LABEL, "middle"));
        // A long name is set smaller, so that it stays out of the panel above.
        let fits = LABEL * (frame.height() / width(&self.panel.y.label, LABEL)).min(1.0);
        let size = fits.max(self.least);
        let face = Type { upward: true, ..black(size, "middle") };
        canvas.text(&self.panel.y.label, (frame.left - self.left() + LABEL, middle.1), face);
        for (exponent, place, side) in [
            (self.x.exponent, (frame.right, baseline), "end"),
            (self.y.exponent, (frame.left, frame.top - GAP), "start"),
        ] {
            if exponent != 0 {
                canvas.text(&format!("×{}", power_of_ten(exponent)), place, black(TICK, side));
            }
        }
        let top = frame.top - self.above() + CAPITAL * LABEL;
        let face = Type { bold: true, ..black(LABEL, "start") };
        canvas.text(&self.heading, (frame.left, top), face);
        for strip in &self.panel.strips {
            let inside = self.strip(strip, frame).grown(-GAP);
            let (side, x) =
                if strip.upright { ("end", inside.right) } else { ("start", inside.left) };
            let y = if strip.upright { inside.top + CAPITAL * SMALL } else { inside.bottom };
            canvas.text(&strip.label, (x, y), Type::new(SMALL, DARK_GREY, side));
        }
        for area in self.areas.iter().filter(|area| !area.label.is_empty()) {
            self.area_label(canvas, area, frame);
        }
    }

    /// The name of an area, inside where it is thickest, if it is thick enough.
    fn area_label(&self, canvas: &Canvas, area: &Area, frame: &Rect) {
        let half = 0.5 * width(area.label, SMALL) + 8.0;
        let pixel = |point: &Point| frame.at((self.x.share(point.0), self.y.share(point.1)));
        let places = area.upper.iter().zip(&area.lower).map(|(up, low)| (pixel(up), pixel(low).1));
        let inside = places.filter(|(up, _)| up.0 - half > frame.left && up.0 + half < frame.right);
        let thick = inside.map(|((x, top), foot)| (x, top.max(frame.top), foot.min(frame.bottom)));
        let thickest = thick.max_by(|a, b| (a.2 - a.1).total_cmp(&(b.2 - b.1)));
        if let Some((x, top, foot)) = thickest.filter(|(_, top, foot)| foot - top > 2.2 * SMALL) {
            let baseline = 0.5 * (top + foot + CAPITAL * SMALL);
            canvas.text(area.label, (x, baseline), Type::new(SMALL, BLACK, "middle"));
        }
    }
}
