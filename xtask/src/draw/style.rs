//! How one curve looks: colour, dash, marker. Two curves must stay apart in
//! colour, in grey and by shape alone, so every numbered style differs in all.

/// An opaque colour: red, green and blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Colour(pub u8, pub u8, pub u8);

impl Colour {
    /// Text, frame and the first curve.
    pub const BLACK: Self = Self(0, 0, 0);
    /// The paper.
    pub const WHITE: Self = Self(255, 255, 255);
    /// Captions and labels of marks.
    pub const DARK_GREY: Self = Self(70, 70, 70);
    /// Reference lines and the last of the palette.
    pub const GREY: Self = Self(135, 135, 135);
    /// Blue of Okabe and Ito.
    pub const BLUE: Self = Self(0, 114, 178);
    /// Vermillion of Okabe and Ito.
    pub const VERMILLION: Self = Self(213, 94, 0);
    /// Bluish green of Okabe and Ito, a little darker.
    pub const GREEN: Self = Self(0, 138, 100);
    /// Orange of Okabe and Ito.
    pub const ORANGE: Self = Self(230, 159, 0);
    /// Sky blue of Okabe and Ito.
    pub const SKY: Self = Self(86, 180, 233);
    /// Reddish purple of Okabe and Ito.
    pub const PINK: Self = Self(204, 121, 167);
    /// Wine of Paul Tol's muted scheme.
    pub const WINE: Self = Self(136, 34, 85);
    /// Indigo of Paul Tol's muted scheme.
    pub const INDIGO: Self = Self(51, 34, 136);

    /// The ten curve colours, in an order in which neighbours differ in luminance.
    pub const PALETTE: [Self; 10] = [
        Self::BLACK,
        Self::ORANGE,
        Self::BLUE,
        Self::VERMILLION,
        Self::INDIGO,
        Self::SKY,
        Self::GREEN,
        Self::PINK,
        Self::WINE,
        Self::GREY,
    ];

    /// This colour mixed with white; 0 leaves it, 1 gives white.
    pub fn tint(self, towards_white: f64) -> Self {
        let share = towards_white.clamp(0.0, 1.0);
        let mix = |c: u8| (f64::from(c) + (255.0 - f64::from(c)) * share).round() as u8;
        Self(mix(self.0), mix(self.1), mix(self.2))
    }
}

/// The pattern of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dash {
    /// Unbroken.
    Solid,
    /// Long dashes.
    Long,
    /// Ordinary dashes.
    Dashed,
    /// Short dashes.
    Short,
    /// Dots.
    Dotted,
    /// A dash and a dot.
    DashDot,
    /// A dash and two dots.
    DashDotDot,
    /// A long dash and a short one.
    LongShort,
    /// A long dash and three dots.
    LongDots,
    /// Two dashes and a dot.
    TwoDashDot,
    /// Dots far apart; used for gaps.
    Sparse,
}

impl Dash {
    /// Lengths in pixels of ink and gap, alternating; empty for an unbroken line.
    pub(crate) fn lengths(self) -> &'static [f64] {
        match self {
            Self::Solid => &[],
            Self::Long => &[52.0, 16.0],
            Self::Dashed => &[30.0, 16.0],
            Self::Short => &[16.0, 12.0],
            Self::Dotted => &[8.0, 11.0],
            Self::DashDot => &[32.0, 13.0, 8.0, 13.0],
            Self::DashDotDot => &[30.0, 11.0, 8.0, 11.0, 8.0, 11.0],
            Self::LongShort => &[48.0, 13.0, 18.0, 13.0],
            Self::LongDots => &[40.0, 10.0, 8.0, 10.0, 8.0, 10.0, 8.0, 10.0],
            Self::TwoDashDot => &[24.0, 11.0, 24.0, 11.0, 8.0, 11.0],
            Self::Sparse => &[6.0, 18.0],
        }
    }

    /// Share of the line that is ink; lines with less are drawn over lines with more.
    pub(crate) fn ink_share(self) -> f64 {
        let lengths = self.lengths();
        let all: f64 = lengths.iter().sum();
        let ink: f64 = lengths.iter().step_by(2).sum();
        if all > 0.0 { ink / all } else { 1.0 }
    }
}

/// The outline of a marker.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// A disc.
    Circle,
    /// A square.
    Square,
    /// A triangle standing on its base.
    Triangle,
    /// A triangle standing on its tip.
    Nabla,
    /// A square standing on its tip.
    Diamond,
    /// A diagonal cross; always open.
    Cross,
    /// An upright cross; always open.
    Plus,
}

/// A marker: its outline, and whether it is filled with the curve's colour or white.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Marker {
    /// The outline.
    pub shape: Shape,
    /// Filled with the colour of the curve, or white inside.
    pub filled: bool,
}

impl Marker {
    /// A marker filled with the colour of the curve.
    pub const fn filled(shape: Shape) -> Self {
        Self { shape, filled: true }
    }

    /// A marker that is white inside.
    pub const fn open(shape: Shape) -> Self {
        Self { shape, filled: false }
    }
}

/// How one curve of the CSV is drawn and what the legend calls it.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveStyle {
    /// The value in the curve column of the CSV.
    pub key: String,
    /// The text of the legend.
    pub label: String,
    /// The line; `None` draws a marker at every point and no line (measured data).
    pub line: Option<Dash>,
    /// The marker, placed sparsely along a line to tell the curves apart.
    pub marker: Option<Marker>,
    /// The colour of line and marker.
    pub colour: Colour,
    /// Joins the ends of a gap by a light dotted line, so that a jump reads as one.
    pub join_gaps: bool,
}

const DASHES: [Dash; 10] = [
    Dash::Solid,
    Dash::Long,
    Dash::Dashed,
    Dash::TwoDashDot,
    Dash::DashDot,
    Dash::Dotted,
    Dash::LongShort,
    Dash::Short,
    Dash::DashDotDot,
    Dash::LongDots,
];

const MARKERS: [Marker; 10] = [
    Marker::filled(Shape::Circle),
    Marker::open(Shape::Square),
    Marker::filled(Shape::Triangle),
    Marker::open(Shape::Diamond),
    Marker::open(Shape::Cross),
    Marker::open(Shape::Nabla),
    Marker::filled(Shape::Square),
    Marker::open(Shape::Circle),
    Marker::filled(Shape::Diamond),
    Marker::open(Shape::Plus),
];

impl CurveStyle {
    /// The style of number `index`: colour, dash and marker that the nine others have not.
    pub fn numbered(index: usize, key: &str, label: &str) -> Self {
        let slot = index % Colour::PALETTE.len();
        Self {
            key: key.to_owned(),
            label: label.to_owned(),
            line: Some(DASHES[slot]),
            marker: Some(MARKERS[slot]),
            colour: Colour::PALETTE[slot],
            join_gaps: false,
        }
    }

    /// Markers at every point and no line, as for measured data.
    pub fn points(key: &str, label: &str, marker: Marker, colour: Colour) -> Self {
        Self {
            key: key.to_owned(),
            label: label.to_owned(),
            line: None,
            marker: Some(marker),
            colour,
            join_gaps: false,
        }
    }

    /// The same style with the gaps of the curve joined by a light dotted line.
    pub fn joined(mut self) -> Self {
        self.join_gaps = true;
        self
    }
}
