//! The description of a figure: plain data, no drawing and no physics.
//! Every position is in the units of the CSV; `Axis::multiply` acts on the
//! numbers that are shown and on nothing else.

use super::style::{Colour, CurveStyle};

/// A whole figure of one to three panels.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Figure {
    /// A line above the plot; empty for none.
    pub title: String,
    /// Paragraphs below the plot; each is wrapped to the width of the figure.
    pub caption: Vec<String>,
    /// The panels, labelled (a), (b), (c) when there are more than one.
    pub panels: Vec<Panel>,
    /// Whether the panels stand above or beside each other.
    pub arrangement: Arrangement,
    /// One legend below all panels in place of one in each.
    pub shared_legend: bool,
    /// Accept curves in the CSV that no panel draws; otherwise they are an error.
    pub allow_undrawn: bool,
}

/// Where the next panel goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Arrangement {
    /// Below the one before.
    #[default]
    Stacked,
    /// To the right of the one before.
    SideBySide,
}

/// One pair of axes and what is drawn in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// A short heading above the frame, after the (a); empty for none.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The column that names the curve of a row.
    pub curve_column: String,
    /// Use only the rows whose column (first) holds this value (second).
    pub only: Option<(String, String)>,
    /// The curves, in the order of the legend.
    pub curves: Vec<CurveStyle>,
    /// Vertical reference lines, labelled above the frame.
    pub verticals: Vec<Mark>,
    /// Horizontal reference lines, labelled inside the frame.
    pub horizontals: Vec<Mark>,
    /// Shaded bands.
    pub bands: Vec<Band>,
    /// Text inside the plot.
    pub notes: Vec<Note>,
    /// Where the legend goes.
    pub legend: Legend,
    /// Each curve is added to those before it and the area between is filled.
    pub stacked: bool,
}

impl Panel {
    /// A panel with nothing in it but its axes; the curve column is `curve`.
    pub fn new(x: Axis, y: Axis) -> Self {
        Self {
            title: String::new(),
            x,
            y,
            curve_column: "curve".to_owned(),
            only: None,
            curves: Vec::new(),
            verticals: Vec::new(),
            horizontals: Vec::new(),
            bands: Vec::new(),
            notes: Vec::new(),
            legend: Legend::Auto,
            stacked: false,
        }
    }
}

/// One axis: the column it shows, its name and its scale.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// The column of the CSV.
    pub column: String,
    /// The name with its unit, such as `separation (µm)`.
    pub label: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// Ends of the axis in the units of the CSV; from the drawn curves if `None`.
    pub range: Option<(f64, f64)>,
    /// What a number of the CSV is multiplied by to be shown, such as 1e6 for m in µm.
    pub multiply: f64,
}

impl Axis {
    /// A linear axis over the range of the data.
    pub fn new(column: &str, label: &str) -> Self {
        Self {
            column: column.to_owned(),
            label: label.to_owned(),
            scale: Scale::Linear,
            range: None,
            multiply: 1.0,
        }
    }

    /// The same axis with a logarithmic scale.
    pub fn log(mut self) -> Self {
        self.scale = Scale::Log;
        self
    }

    /// The same axis between two ends, in the units of the CSV.
    pub fn range(mut self, from: f64, to: f64) -> Self {
        self.range = Some((from, to));
        self
    }

    /// The same axis with its numbers multiplied for show.
    pub fn times(mut self, factor: f64) -> Self {
        self.multiply = factor;
        self
    }
}

/// The scale of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Equal differences take equal lengths.
    Linear,
    /// Equal ratios take equal lengths; what is not above zero leaves the frame at its foot.
    Log,
}

/// A reference line across the frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Where, in the units of the CSV.
    pub at: f64,
    /// A few words; empty for none.
    pub label: String,
}

impl Mark {
    /// A reference line with a label.
    pub fn new(at: f64, label: &str) -> Self {
        Self { at, label: label.to_owned() }
    }
}

/// The axis along which a band has its two ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Along {
    /// From one x to another, over the whole height.
    X,
    /// From one y to another, over the whole width.
    Y,
}

/// A shaded band; an infinite end means the edge of the frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// The axis of the two ends.
    pub along: Along,
    /// The lower end, in the units of the CSV.
    pub from: f64,
    /// The upper end, in the units of the CSV.
    pub to: f64,
    /// A few words; empty for none.
    pub label: String,
    /// The colour of the shade; use a light one.
    pub colour: Colour,
}

impl Band {
    /// A light grey band.
    pub fn new(along: Along, from: f64, to: f64, label: &str) -> Self {
        Self { along, from, to, label: label.to_owned(), colour: Colour(228, 228, 228) }
    }
}

/// Text inside the plot.
#[derive(Debug, Clone, PartialEq)]
pub struct Note {
    /// The words; a line break is kept.
    pub text: String,
    /// Top left corner as shares of the frame from its left and top; `None` finds room.
    pub place: Option<(f64, f64)>,
}

impl Note {
    /// Text that is put where it covers least.
    pub fn new(text: &str) -> Self {
        Self { text: text.to_owned(), place: None }
    }
}

/// Where the legend of a panel goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Legend {
    /// Where it covers no curve inside the frame, or else to the right of it.
    #[default]
    Auto,
    /// Inside, in this corner, whatever it covers.
    Inside(Corner),
    /// Outside, to the right of the frame.
    Right,
    /// No box: each name beside a point of its curve, for few points that stand apart. A curve
    /// without a name gets none.
    Direct,
    /// Not drawn.
    Hidden,
}

/// A corner of the frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Corner {
    /// Above, at the left.
    TopLeft,
    /// Above, at the right.
    TopRight,
    /// Below, at the left.
    BottomLeft,
    /// Below, at the right.
    BottomRight,
}
