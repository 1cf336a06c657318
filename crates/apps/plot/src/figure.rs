//! The description of a figure: plain data. Every position is in the units of the csv;
//! [`Axis::multiply`] acts on the displayed numbers only.
//!
//! In all texts an underscore lowers the next letter, as in `w_c`.

use crate::style::Curve;

/// A whole figure.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Figure {
    /// A title above the panels; empty for none.
    pub title: String,
    /// Paragraphs below the panels; each is wrapped.
    pub caption: Vec<String>,
    /// The panels, labelled (a), (b), ... when there are more than one.
    pub panels: Vec<Panel>,
    /// Panels beside each other; fewer than two for one above the other.
    pub columns: usize,
    /// Width and height in pixels of a small picture of one panel, which has less room around it;
    /// letters keep their size.
    pub size: Option<[f64; 2]>,
}

impl Figure {
    /// A figure with its panels one above the other.
    #[must_use]
    pub fn new(title: &str, caption: &[&str], panels: Vec<Panel>) -> Self {
        let caption = caption.iter().map(|part| (*part).to_owned()).collect();
        Self { title: title.into(), caption, panels, ..Self::default() }
    }
}

/// One pair of axes with its curves.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Panel {
    /// A short heading above the frame, after the (a); empty for none.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The column that names the curve of a row; by default `curve`.
    pub curve_column: String,
    /// The rows to use: a column and its value; all rows if `None`.
    pub only: Option<(String, String)>,
    /// The curves, in the order of the legend.
    pub curves: Vec<Curve>,
    /// Each curve is added to those before it and the area between is filled.
    pub stacked: bool,
    /// Areas between two curves, such as a curve's error band.
    pub between: Vec<Between>,
    /// Shaded strips.
    pub strips: Vec<Strip>,
    /// Vertical reference lines, labelled above the frame.
    pub verticals: Vec<Mark>,
    /// Horizontal reference lines, labelled inside at the right.
    pub horizontals: Vec<Mark>,
    /// Texts for places along x: elements of the class `reading`, each with a line at its place,
    /// invisible, and the text as its title. Viewers show it under the pointer.
    pub readings: Vec<Mark>,
}

impl Panel {
    /// A panel without curves.
    #[must_use]
    pub fn new(x: Axis, y: Axis) -> Self {
        Self { x, y, curve_column: "curve".into(), ..Self::default() }
    }
}

/// One axis: the column it shows, its name and its scale.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Axis {
    /// The column of the csv.
    pub column: String,
    /// The name with its unit, such as `separation (µm)`.
    pub label: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// Ends of the axis in the units of the csv; from the drawn curves if `None`.
    pub range: Option<(f64, f64)>,
    /// The factor between the csv and the displayed numbers, such as 1e6 for m in µm.
    pub multiply: f64,
}

impl Axis {
    /// A linear axis over the range of the data.
    #[must_use]
    pub fn new(column: &str, label: &str) -> Self {
        Self { column: column.into(), label: label.into(), multiply: 1.0, ..Self::default() }
    }

    /// The same axis with a logarithmic scale.
    #[must_use]
    pub fn log(mut self) -> Self {
        self.scale = Scale::Log;
        self
    }

    /// The same axis between two ends, in the units of the csv.
    #[must_use]
    pub fn range(mut self, from: f64, to: f64) -> Self {
        self.range = Some((from, to));
        self
    }

    /// The same axis with its displayed numbers multiplied.
    #[must_use]
    pub fn times(mut self, factor: f64) -> Self {
        self.multiply = factor;
        self
    }
}

/// The scale of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Scale {
    /// Equal differences take equal lengths.
    #[default]
    Linear,
    /// Equal ratios take equal lengths; values of 0 and below leave the frame at the bottom.
    Log,
}

impl Scale {
    /// Logarithmic where most values are above zero and the largest is 50 times the smallest of
    /// those, or more.
    #[must_use]
    pub fn fitting(values: &[f64]) -> Self {
        let positive = || values.iter().copied().filter(|value| *value > 0.0);
        let (low, high) =
            positive().fold((f64::INFINITY, 0.0_f64), |(l, h), v| (l.min(v), h.max(v)));
        let mostly = 2 * positive().count() > values.len();
        if mostly && high / low >= 50.0 { Self::Log } else { Self::Linear }
    }
}

/// A reference line across the frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// The place, in the units of the csv.
    pub at: f64,
    /// A label; empty for none.
    pub label: String,
}

impl Mark {
    /// A reference line with a label.
    #[must_use]
    pub fn new(at: f64, label: &str) -> Self {
        Self { at, label: label.into() }
    }
}

/// The area between two curves of the csv, shaded; the curves need not be drawn themselves.
#[derive(Debug, Clone, PartialEq)]
pub struct Between {
    /// The lower curve, by its name in the curve column.
    pub lower: String,
    /// The upper curve's; it has the same x.
    pub upper: String,
    /// The number of its colour, as for curves; the area is translucent.
    pub look: usize,
    /// Its name in the legend; empty for an area without an entry.
    pub label: String,
}

/// A shaded strip across the frame; an infinite end means the edge of the frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// From one x to another over the whole height, or from one y to another over the whole width.
    pub upright: bool,
    /// The lower end, in the units of the csv.
    pub from: f64,
    /// The upper end, in the units of the csv.
    pub to: f64,
    /// A label for a corner of it; empty for none.
    pub label: String,
}

impl Strip {
    /// A strip from one x to another.
    #[must_use]
    pub fn upright(from: f64, to: f64, label: &str) -> Self {
        Self { upright: true, from, to, label: label.into() }
    }

    /// A strip from one y to another.
    #[must_use]
    pub fn across(from: f64, to: f64, label: &str) -> Self {
        Self { upright: false, ..Self::upright(from, to, label) }
    }
}
