//! How the curve of a model looks: the same in every picture, and told apart without colour.

use std::fmt::{Result, Write};

use asperity::Model;

/// Of Okabe and Ito, without the yellow that is unreadable in grey.
const COLOURS: [&str; 6] = ["#000000", "#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00"];
const DASHES: [&str; 4] = ["none", "9 4", "3 3", "9 3 2 3"];
/// On a square from -1 to 1.
const SHAPES: [&str; 6] = [
    "M-1 -1H1V1H-1Z",
    "M0 -1.2L1.1 0.8H-1.1Z",
    "M0 -1.3L1.2 0L0 1.3L-1.2 0Z",
    "M0 1.2L1.1 -0.8H-1.1Z",
    "M-1 0A1 1 0 1 1 1 0A1 1 0 1 1 -1 0Z",
    "M-1 -0.4H-0.4V-1H0.4V-0.4H1V0.4H0.4V1H-0.4V0.4H-1Z",
];

/// Colour, dash and marker.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Style {
    colour: &'static str,
    dash: &'static str,
    shape: &'static str,
    filled: bool,
}

impl Style {
    /// That of a model's id.
    pub fn of(id: &str) -> Self {
        let index = Model::all().iter().position(|model| model.id() == id).unwrap_or(0);
        Self {
            colour: COLOURS[index % COLOURS.len()],
            dash: DASHES[(index + index / COLOURS.len()) % DASHES.len()],
            shape: SHAPES[index % SHAPES.len()],
            filled: index < SHAPES.len(),
        }
    }

    pub fn line(&self, svg: &mut String, points: &[(f64, f64)]) -> Result {
        svg.push_str("<polyline points=\"");
        for (across, down) in points {
            write!(svg, "{across:.1},{down:.1} ")?;
        }
        writeln!(
            svg,
            "\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\" stroke-dasharray=\"{}\"/>",
            self.colour, self.dash
        )
    }

    pub fn marker(&self, svg: &mut String, across: f64, down: f64) -> Result {
        let fill = if self.filled { self.colour } else { "white" };
        writeln!(
            svg,
            "<path d=\"{}\" transform=\"translate({across:.1} {down:.1}) scale(4.5)\" fill=\"{fill}\" stroke=\"{}\" stroke-width=\"0.35\"/>",
            self.shape, self.colour
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_models_look_alike_even_in_grey() {
        let styles: Vec<Style> = Model::all().iter().map(|model| Style::of(model.id())).collect();
        for (k, a) in styles.iter().enumerate() {
            for b in &styles[k + 1..] {
                assert!((a.shape, a.filled) != (b.shape, b.filled), "{a:?} {b:?}");
                assert!((a.colour, a.dash) != (b.colour, b.dash), "{a:?} {b:?}");
            }
        }
    }
}
