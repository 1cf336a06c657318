//! Sizes, in displayed pixels.

use crate::figure::Figure;

/// Width of every figure in pixels.
pub(crate) const WIDTH: f64 = 800.0;
/// Height of a figure of one panel, unless its caption is very long.
pub(crate) const HEIGHT: f64 = 600.0;
/// Size of the numbers at the ticks.
pub(crate) const TICK: f64 = 14.0;
/// Size of the names of axes and panels.
pub(crate) const LABEL: f64 = 15.3;
/// The least size of a name in a small picture.
pub(crate) const LEAST: f64 = 12.0;
/// Size of the title.
pub(crate) const TITLE: f64 = 16.7;
/// Size of caption and marks.
pub(crate) const SMALL: f64 = 12.7;
/// Between title, headings and frames.
pub(crate) const TITLE_GAP: f64 = 5.0;
/// Around everything.
pub(crate) const EDGE: f64 = 12.0;

/// Room above and below the frame of a small picture, and its least height.
const AROUND: f64 = 175.0;
const LOWEST: f64 = 110.0;

impl Figure {
    pub(crate) fn width(&self) -> f64 {
        self.size.map_or(WIDTH, |[width, _]| width)
    }

    pub(crate) fn height(&self) -> f64 {
        self.size.map_or(HEIGHT, |[_, height]| height)
    }

    /// Room around everything.
    pub(crate) fn edge(&self) -> f64 {
        if self.size.is_some() { 0.5 * EDGE } else { EDGE }
    }
}

/// The number of labels along the two axes of a panel.
pub(crate) fn labels_that_fit(figure: &Figure) -> (usize, usize) {
    let across = match figure.columns.min(figure.panels.len()) {
        0 | 1 => figure.width(),
        columns => figure.width() / columns as f64 - 75.0,
    };
    ((across / 60.0) as usize + 1, (least_height(figure) / 40.0) as usize + 1)
}

/// The least height of the frames of a figure.
pub(crate) fn least_height(figure: &Figure) -> f64 {
    match (figure.panels.len(), figure.columns > 1) {
        (0 | 1, _) if figure.size.is_some() => (figure.height() - AROUND).max(LOWEST),
        (0 | 1, _) => 350.0,
        (2, false) => 273.0,
        (_, false) => 213.0,
        (_, true) => 293.0,
    }
}
