//! The layout of a figure: margins from the width of labels, then the frames.

use crate::canvas::{Canvas, Rect, Type};
use crate::figure::Figure;
use crate::legend::Legend;
use crate::panel::Plot;
use crate::size::{EDGE, SMALL, TITLE, WIDTH, least_height};
use crate::style::{BLACK, DARK_GREY};
use crate::text::{LINE, wrap};

/// The positions of all parts of a figure.
pub(crate) struct Layout<'a> {
    title: Vec<String>,
    pub(crate) frames: Vec<Rect>,
    legend: Option<(Legend<'a>, f64)>,
    caption: Vec<String>,
    caption_top: f64,
    pub(crate) width: f64,
    pub(crate) height: f64,
}

impl<'a> Layout<'a> {
    /// Places the parts of a figure.
    pub(crate) fn new(figure: &Figure, plots: &'a [Plot<'a>]) -> Self {
        let (width, edge) = (figure.width(), figure.edge());
        let title = wrap(&figure.title, TITLE, width - 2.0 * edge);
        let caption = caption_lines(&figure.caption);
        let legend = Legend::new(plots, width - 2.0 * edge);
        let legend_height = legend.as_ref().map_or(0.0, |legend| legend.height + 4.0);
        let caption_height = if caption.is_empty() { 0.0 } else { lines_height(&caption) + 9.0 };
        let tail = legend_height + caption_height + edge;
        let head = edge + title.len() as f64 * TITLE * LINE;
        let (frames, foot) = frames(figure, plots, head, tail);
        let caption_top = foot + legend_height + 9.0;
        let legend = legend.map(|legend| (legend, foot));
        Self { title, frames, legend, caption, caption_top, width, height: foot + tail }
    }

    /// Draws title, legend and caption.
    pub(crate) fn draw(&self, canvas: &Canvas) {
        draw_title(canvas, &self.title);
        draw_caption(canvas, &self.caption, self.caption_top);
        if let Some((legend, top)) = &self.legend {
            legend.draw(canvas, ((self.width - legend.width) / 2.0, *top));
        }
    }
}

/// The frames of the panels, of equal width, and the lower end of their axes.
fn frames(figure: &Figure, plots: &[Plot], head: f64, tail: f64) -> (Vec<Rect>, f64) {
    let largest = |of: fn(&Plot) -> f64| plots.iter().map(of).fold(0.0, f64::max);
    let (left, right) = (largest(|plot| plot.left()), largest(|plot| plot.right()));
    let (above, below) = (largest(|plot| plot.above()), largest(|plot| plot.below()));
    let mut frames = vec![];
    let columns = figure.columns.clamp(1, plots.len().max(1));
    let each = (figure.width() - figure.edge()) / columns as f64;
    let width = each - left - right;
    // Frames become too narrow with many panels beside each other.
    if columns > 1 && width > 100.0 {
        let height = (1.1 * width).min(293.0);
        let row = above + height + below;
        for index in 0..plots.len() {
            let from = 0.5 * figure.edge() + (index % columns) as f64 * each + left;
            let top = head + (index / columns) as f64 * row + above;
            frames.push(Rect::sized(from, top, width, height));
        }
        return (frames, head + plots.len().div_ceil(columns) as f64 * row);
    }
    let height = match plots {
        [_] => (figure.height() - head - tail - above - below).max(least_height(figure)),
        _ => least_height(figure),
    };
    let mut foot = head;
    for plot in plots {
        let width = figure.width() - figure.edge() - left - right;
        frames.push(Rect::sized(0.5 * figure.edge() + left, foot + plot.above(), width, height));
        foot += plot.above() + height + plot.below();
    }
    (frames, foot)
}

/// The paragraphs of a caption, wrapped.
pub(crate) fn caption_lines(caption: &[String]) -> Vec<String> {
    caption.iter().flat_map(|part| wrap(part, SMALL, WIDTH - 4.0 * EDGE)).collect()
}

/// The height that lines of small text take.
pub(crate) fn lines_height(lines: &[String]) -> f64 {
    lines.len() as f64 * SMALL * LINE
}

pub(crate) fn draw_title(canvas: &Canvas, title: &[String]) {
    let face = Type { bold: true, ..Type::new(TITLE, BLACK, "middle") };
    canvas.lines(title, (WIDTH / 2.0, EDGE), face);
}

pub(crate) fn draw_caption(canvas: &Canvas, caption: &[String], top: f64) {
    canvas.lines(caption, (2.0 * EDGE, top), Type::new(SMALL, DARK_GREY, "start"));
}
