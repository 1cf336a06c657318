//! The layout of a figure: margins from the width of labels, then the frames.

use crate::canvas::{Canvas, Rect, Type};
use crate::figure::{self, Figure};
use crate::legend::Legend;
use crate::panel::Plot;
use crate::size::{EDGE, HEIGHT, SMALL, TITLE, WIDTH, least_height};
use crate::style::{BLACK, DARK_GREY};
use crate::text::{LINE, wrap};

/// The positions of all parts of a figure.
pub(crate) struct Layout<'a> {
    words: Words,
    pub(crate) frames: Vec<Rect>,
    legend: Option<(Legend<'a>, f64)>,
    caption_top: f64,
    pub(crate) height: f64,
}

impl<'a> Layout<'a> {
    /// Places the parts of a figure.
    pub(crate) fn new(figure: &'a Figure, plots: &[Plot]) -> Self {
        let words = Words::new(&figure.title, &figure.caption);
        let legend = Legend::new(&figure.panels, WIDTH - 2.0 * EDGE);
        let is_below = figure.legend == figure::Legend::Below && !legend.is_empty();
        let legend_height = if is_below { legend.height + 4.0 } else { 0.0 };
        let caption_height = if words.tail > 0.0 { words.tail + 9.0 } else { 0.0 };
        let tail = legend_height + caption_height + EDGE;
        let (frames, foot) = frames(figure, plots, words.head, tail);
        let caption_top = foot + legend_height + 9.0;
        let legend = is_below.then_some((legend, foot));
        Self { words, frames, legend, caption_top, height: foot + tail }
    }

    /// Draws title, legend and caption.
    pub(crate) fn draw(&self, canvas: &Canvas) {
        self.words.draw(canvas, self.caption_top);
        if let Some((legend, top)) = &self.legend {
            legend.draw(canvas, ((WIDTH - legend.width) / 2.0, *top));
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
    let each = (WIDTH - EDGE) / columns as f64;
    let width = each - left - right;
    // Frames become too narrow with many panels beside each other.
    if columns > 1 && width > 100.0 {
        let height = (1.1 * width).min(293.0);
        let row = above + height + below;
        for index in 0..plots.len() {
            let from = 0.5 * EDGE + (index % columns) as f64 * each + left;
            let top = head + (index / columns) as f64 * row + above;
            frames.push(Rect::sized(from, top, width, height));
        }
        return (frames, head + plots.len().div_ceil(columns) as f64 * row);
    }
    let height = match plots {
        [_] => (HEIGHT - head - tail - above - below).max(least_height(figure)),
        _ => least_height(figure),
    };
    let mut foot = head;
    for plot in plots {
        let width = WIDTH - EDGE - left - right;
        frames.push(Rect::sized(0.5 * EDGE + left, foot + plot.above(), width, height));
        foot += plot.above() + height + plot.below();
    }
    (frames, foot)
}

/// The title above a picture and the caption below it, wrapped.
pub(crate) struct Words {
    title: Vec<String>,
    caption: Vec<String>,
    /// Where the title ends.
    pub(crate) head: f64,
    /// The height of the caption; 0 without one.
    pub(crate) tail: f64,
}

impl Words {
    pub(crate) fn new(title: &str, caption: &[String]) -> Self {
        let title = wrap(title, TITLE, WIDTH - 2.0 * EDGE);
        let lines = caption.iter().flat_map(|part| wrap(part, SMALL, WIDTH - 4.0 * EDGE));
        let caption: Vec<String> = lines.collect();
        let (head, tail) =
            (EDGE + title.len() as f64 * TITLE * LINE, caption.len() as f64 * SMALL * LINE);
        Self { title, caption, head, tail }
    }

    /// Draws both, the caption at this height.
    pub(crate) fn draw(&self, canvas: &Canvas, caption_top: f64) {
        let bold = Type { bold: true, ..Type::new(TITLE, BLACK, "middle") };
        canvas.lines(&self.title, (WIDTH / 2.0, EDGE), bold);
        let small = Type::new(SMALL, DARK_GREY, "start");
        canvas.lines(&self.caption, (2.0 * EDGE, caption_top), small);
    }
}
