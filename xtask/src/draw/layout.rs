//! Where everything goes: margins from the width of labels, then the frames.

use super::clip::Rect;
use super::figure::{Arrangement, Figure, Mark};
use super::legend;
use super::plot::Plot;
use super::room;
use super::style::CurveStyle;
use super::text::{self, LINE};

/// Width of every figure in pixels; it is shown at a third of it.
pub(crate) const WIDTH: f64 = 2400.0;
/// Height of a figure of one panel, unless its caption is very long.
const HEIGHT: f64 = 1800.0;
/// Size of the numbers at the ticks.
pub(crate) const TICK: f64 = 42.0;
/// Size of the names of axes and panels.
pub(crate) const LABEL: f64 = 46.0;
/// Size of the title.
pub(crate) const TITLE: f64 = 50.0;
/// Size of caption, marks and notes.
pub(crate) const SMALL: f64 = 38.0;
/// Length of a major tick.
pub(crate) const TICK_LENGTH: f64 = 14.0;
/// Between frame and numbers.
pub(crate) const TICK_GAP: f64 = 26.0;
/// Height of the leaders between the frame and the labels of its marks.
pub(crate) const LEADER: f64 = 26.0;

const EDGE: f64 = 36.0;

/// The labels of the vertical marks of a panel, above its frame.
#[derive(Debug, Clone, Default)]
pub(crate) struct MarkLabels {
    /// The middle of each label and its lines, with the place of its mark.
    pub(crate) labels: Vec<(f64, Vec<String>, f64)>,
    pub(crate) height: f64,
    /// Whether the labels leave room for the heading at their left.
    pub(crate) beside_heading: bool,
}

/// The places of all parts of a figure.
pub(crate) struct Layout<'a> {
    pub(crate) height: u32,
    pub(crate) title: Vec<String>,
    pub(crate) frames: Vec<Rect>,
    pub(crate) marks: Vec<MarkLabels>,
    pub(crate) shared: Option<(legend::Box<'a>, f64, f64)>,
    pub(crate) caption: Vec<String>,
    pub(crate) caption_top: f64,
}

/// How many labels fit along the two axes of a panel: linear x, log x, linear y, log y.
pub(crate) fn labels_that_fit(figure: &Figure) -> [f64; 4] {
    let panels = figure.panels.len().max(1) as f64;
    let down = least_height(figure) * 1.15;
    let across = match figure.arrangement {
        Arrangement::SideBySide => WIDTH / panels - 220.0,
        Arrangement::Stacked => 2000.0,
    };
    [across / 210.0, across / 112.0, down / 130.0, down / 75.0].map(|most: f64| most.max(3.0))
}

/// A length that the frames of a figure are at least high.
pub(crate) fn least_height(figure: &Figure) -> f64 {
    match (figure.panels.len(), figure.arrangement) {
        (0 | 1, _) => 1050.0,
        (2, Arrangement::Stacked) => 820.0,
        (_, Arrangement::Stacked) => 640.0,
        (_, Arrangement::SideBySide) => 560.0,
    }
}

/// Places the parts of a figure.
pub(crate) fn arrange<'a>(figure: &Figure, plots: &[Plot<'a>]) -> Layout<'a> {
    let beside = figure.arrangement == Arrangement::SideBySide && plots.len() > 1;
    let columns = columns(plots, beside);
    let marks: Vec<MarkLabels> = plots
        .iter()
        .zip(&columns)
        .map(|(plot, column)| mark_labels(plot, column.0, column.1))
        .collect();
    let title = text::wrap(&figure.title, TITLE, WIDTH - 2.0 * EDGE);
    let caption: Vec<String> = figure
        .caption
        .iter()
        .flat_map(|part| text::wrap(part, SMALL, WIDTH - 4.0 * EDGE))
        .collect();
    let shared = figure.shared_legend.then(|| shared_legend(plots));
    let head = EDGE + title.len() as f64 * (TITLE * LINE + 6.0);
    let shared_height = shared.as_ref().map_or(0.0, |made| made.height + 12.0);
    let caption_height =
        if caption.is_empty() { 0.0 } else { caption.len() as f64 * SMALL * 1.35 + 24.0 };
    let tail = shared_height + caption_height + EDGE;

    let above: Vec<f64> = plots.iter().zip(&marks).map(|(p, m)| p.above(m)).collect();
    let below: Vec<f64> = plots.iter().zip(&columns).map(|(p, c)| p.below(c.1 - c.0)).collect();
    let largest = |all: &[f64]| all.iter().copied().fold(0.0, f64::max);
    let mut frames = Vec::new();
    let mut foot = head;
    if beside {
        let width = columns[0].1 - columns[0].0;
        let frame = (width * 1.1).clamp(least_height(figure), 880.0);
        let top = head + largest(&above);
        frames.extend(columns.iter().map(|c| Rect::sized(c.0, top, c.1 - c.0, frame)));
        foot = top + frame + largest(&below);
    } else {
        let frame = match plots.len() {
            1 => (HEIGHT - head - tail - above[0] - below[0]).max(least_height(figure)),
            _ => least_height(figure),
        };
        for ((column, above), below) in columns.iter().zip(&above).zip(&below) {
            frames.push(Rect::sized(column.0, foot + above, column.1 - column.0, frame));
            foot += above + frame + below;
        }
    }
    let shared = shared.map(|made| {
        let left = (WIDTH - made.width) / 2.0;
        (made, left, foot)
    });
    let height = ((foot + tail) / 3.0).ceil() * 3.0;
    Layout {
        height: height as u32,
        title,
        frames,
        marks,
        shared,
        caption,
        caption_top: foot + shared_height + 24.0,
    }
}

/// The left and right side of each frame; all frames are equally wide.
fn columns(plots: &[Plot], beside: bool) -> Vec<(f64, f64)> {
    let lefts: Vec<f64> = plots.iter().map(|plot| plot.left()).collect();
    let rights: Vec<f64> = plots.iter().map(Plot::right).collect();
    if beside {
        let taken: f64 = lefts.iter().chain(&rights).sum();
        let width = (WIDTH - EDGE - taken) / plots.len() as f64;
        let mut from = EDGE / 2.0;
        let mut columns = Vec::new();
        for (left, right) in lefts.iter().zip(&rights) {
            columns.push((from + left, from + left + width));
            from += left + width + right;
        }
        columns
    } else {
        let left = lefts.iter().copied().fold(0.0, f64::max) + EDGE / 2.0;
        let right = WIDTH - EDGE / 2.0 - rights.iter().copied().fold(0.0, f64::max);
        plots.iter().map(|_| (left, right)).collect()
    }
}

fn mark_labels(plot: &Plot, left: f64, right: f64) -> MarkLabels {
    let shown = |mark: &&Mark| plot.x.holds(mark.at) && !mark.label.is_empty();
    let mut marks: Vec<&Mark> = plot.panel.verticals.iter().filter(shown).collect();
    if marks.is_empty() {
        return MarkLabels::default();
    }
    marks.sort_by(|a, b| a.at.total_cmp(&b.at));
    let (from, to) = (left - 60.0, right + 30.0);
    let gap = 28.0;
    let lines_within =
        |widest: f64| marks.iter().map(|m| text::wrap(&m.label, SMALL, widest)).collect();
    let mut lines: Vec<Vec<String>> = lines_within(to - from);
    let wide: f64 = lines.iter().map(|lines| text::widest(lines, SMALL) + gap).sum();
    if wide > to - from {
        lines = lines_within((to - from) / marks.len() as f64 - gap);
    }
    let places: Vec<f64> =
        marks.iter().map(|mark| left + plot.x.share(mark.at) * (right - left)).collect();
    let wanted: Vec<(f64, f64)> = places
        .iter()
        .zip(&lines)
        .map(|(place, lines)| (*place, text::widest(lines, SMALL) / 2.0))
        .collect();
    let middles = room::spread(&wanted, gap, from, to);
    let most = lines.iter().map(Vec::len).max().unwrap_or(1);
    let height = LEADER + 8.0 + most as f64 * SMALL * 1.2;
    let first = middles.first().zip(wanted.first());
    let beside_heading = first.is_some_and(|(middle, label)| {
        plot.y.ticks.factor.is_none() && middle - label.1 > left + plot.heading_width()
    });
    let labels = middles.into_iter().zip(lines).zip(places);
    let labels = labels.map(|((middle, lines), place)| (middle, lines, place)).collect();
    MarkLabels { labels, height, beside_heading }
}

fn shared_legend<'a>(plots: &[Plot<'a>]) -> legend::Box<'a> {
    let mut styles: Vec<&'a CurveStyle> = Vec::new();
    for style in plots.iter().flat_map(|plot| &plot.panel.curves) {
        if styles.iter().all(|known| known.key != style.key) {
            styles.push(style);
        }
    }
    let filled = plots.iter().all(|plot| plot.panel.stacked);
    legend::Box::in_width(&styles, WIDTH - 2.0 * EDGE, filled)
}
