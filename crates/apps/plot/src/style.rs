//! The look of a curve: colour, dash and marker. Curves must be distinct in colour, in grey and by
//! shape alone, so each number has its own of all three.

/// Opacity of an area, and of a band, which lies over others.
pub(crate) const AREA: f64 = 0.4;
pub(crate) const BAND: f64 = 0.18;
/// Width of the edges of a band.
pub(crate) const EDGE: f64 = 0.7;
/// The look of one curve of the csv, and its name in the legend.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[non_exhaustive]
pub struct Curve {
    /// The name in the curve column of the csv.
    pub key: String,
    /// The text of the legend.
    pub label: String,
    /// The number of its colour, dash and marker: ten differ in all three, twelve in the marker.
    pub look: usize,
    /// Whether its points are joined by a line.
    pub line: bool,
    /// A marker at every point, instead of a few that identify the curve.
    pub every_point: bool,
    /// Joins the ends of a gap by a light dotted line, which marks a jump.
    pub join_gaps: bool,
    /// Thin, light grey and unbroken, without markers: the others in the background.
    pub faint: bool,
}

impl Curve {
    /// A line with a few markers.
    #[must_use]
    pub fn new(look: usize, key: &str, label: &str) -> Self {
        Self { key: key.into(), label: label.into(), look, line: true, ..Self::default() }
    }

    /// A line in the background; such curves share a label, and one key of the legend.
    #[must_use]
    pub fn faint(key: &str, label: &str) -> Self {
        Self { faint: true, ..Self::new(0, key, label) }
    }

    /// Markers at every point and no line, as for measured data.
    #[must_use]
    pub fn points(look: usize, key: &str, label: &str) -> Self {
        Self { line: false, every_point: true, ..Self::new(look, key, label) }
    }

    pub(crate) fn colour(&self) -> Colour {
        if self.faint { LIGHT_GREY } else { COLOURS[self.look % COLOURS.len()] }
    }

    /// Width of its line.
    pub(crate) fn width(&self) -> f64 {
        if self.faint { 1.1 } else { 2.0 }
    }

    pub(crate) fn dash(&self) -> &'static [f64] {
        DASHES[(self.look + self.look / DASHES.len()) % DASHES.len()]
    }

    pub(crate) fn marker(&self) -> Marker {
        MARKERS[self.look % MARKERS.len()]
    }

    /// Fraction of the line that is drawn.
    pub(crate) fn ink(&self) -> f64 {
        let (ink, all): (f64, f64) =
            (self.dash().iter().step_by(2).sum(), self.dash().iter().sum());
        if all > 0.0 { ink / all } else { 1.0 }
    }
}

/// A colour in svg notation.
pub(crate) type Colour = &'static str;

pub(crate) const BLACK: Colour = "#000000";
pub(crate) const WHITE: Colour = "#FFFFFF";
pub(crate) const DARK_GREY: Colour = "#464646";
pub(crate) const GREY: Colour = "#878787";
const LIGHT_GREY: Colour = "#A8A8A8";
const INDIGO: Colour = "#332288";

/// Colours of Okabe and Ito (the green a little darker, without the yellow), indigo and wine of
/// Paul Tol's muted scheme, and grey; neighbours differ in luminance.
const COLOURS: [Colour; 10] = [
    BLACK, "#E69F00", "#0072B2", "#D55E00", INDIGO, "#56B4E9", "#008A64", "#CC79A7", "#882255",
    GREY,
];

/// Lengths of ink and gap in pixels, alternating; none for an unbroken line.
const DASHES: [&[f64]; 10] = [
    &[],
    &[17.3, 5.3],
    &[10.0, 5.3],
    &[8.0, 3.7, 8.0, 3.7, 2.7, 3.7],
    &[10.7, 4.3, 2.7, 4.3],
    &[2.7, 3.7],
    &[16.0, 4.3, 6.0, 4.3],
    &[5.3, 4.0],
    &[10.0, 3.7, 2.7, 3.7, 2.7, 3.7],
    &[13.3, 3.3, 2.7, 3.3, 2.7, 3.3, 2.7, 3.3],
];

/// The path of an outline around (0, 0), and whether it is filled with the curve's colour or white.
pub(crate) type Marker = (&'static str, bool);

const CIRCLE: &str = "M-4.2 0A4.2 4.2 0 1 1 4.2 0A4.2 4.2 0 1 1 -4.2 0Z";
const SQUARE: &str = "M-3.7 -3.7H3.7V3.7H-3.7Z";
const TRIANGLE: &str = "M0 -5L4.6 3.2H-4.6Z";
const NABLA: &str = "M0 5L4.6 -3.2H-4.6Z";
const DIAMOND: &str = "M0 -5.2L4.8 0L0 5.2L-4.8 0Z";
const CROSS: &str = "M-3.6 -3.6L3.6 3.6M-3.6 3.6L3.6 -3.6";
const PLUS: &str = "M-4.6 0H4.6M0 -4.6V4.6";

const MARKERS: [Marker; 12] = [
    (CIRCLE, true),
    (SQUARE, false),
    (TRIANGLE, true),
    (DIAMOND, false),
    (CROSS, false),
    (NABLA, false),
    (SQUARE, true),
    (CIRCLE, false),
    (DIAMOND, true),
    (PLUS, false),
    (TRIANGLE, false),
    (NABLA, true),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fifteen_looks_differ_in_grey_and_without_markers() {
        let curves: Vec<Curve> = (0..15).map(|look| Curve::new(look, "", "")).collect();
        for (k, a) in curves.iter().enumerate() {
            for b in &curves[k + 1..] {
                assert!((a.marker(), a.dash()) != (b.marker(), b.dash()), "{a:?} {b:?}");
                assert!((a.colour(), a.dash()) != (b.colour(), b.dash()), "{a:?} {b:?}");
            }
        }
    }
}
