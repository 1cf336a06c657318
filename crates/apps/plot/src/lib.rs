//! Curves as pictures: the text of a csv and a description give the text of an svg.
//!
//! The picture follows from these two alone, byte for byte, on every machine: no files, no fonts of
//! the system, no threads, no physics. Grid, ticks, coordinates and shapes come from `plotters`;
//! this crate adds curves cut at the frame and at gaps, dashes of several lengths, legend keys with
//! dash and marker, areas between curves, bands of values with a lower and an upper end, lowered
//! letters, captions that wrap, and several panels in one picture.
//!
//! Where the csv has columns `area_lower_m2` and `area_upper_m2` beside a drawn `area_m2`, each
//! curve is the middle line of a band between them; rows without ends have none.
//!
//! ```
//! use asperity_plot::{Axis, Curve, Figure, Panel, draw};
//!
//! let mut panel = Panel::new(
//!     Axis::new("separation_m", "separation (µm)").times(1e6),
//!     Axis::new("force_N", "force (N)").log(),
//! );
//! panel.curves = vec![Curve::new(0, "a", "the first model")];
//! let csv = "curve,separation_m,force_N\na,0,100\na,1e-6,1\n";
//! let svg = draw(&Figure::new("Force against separation", &[], vec![panel]), csv)?;
//! assert!(svg.starts_with("<svg "));
//! # Ok::<(), asperity_plot::PlotError>(())
//! ```

mod canvas;
mod clip;
mod contact;
mod error;
mod figure;
mod layout;
mod legend;
mod looks;
mod map;
mod panel;
mod ruler;
mod scan;
mod series;
mod size;
mod style;
mod text;
mod trace;

pub use error::PlotError;
pub use figure::{Axis, Between, Figure, Mark, Panel, Scale, Strip};
pub use looks::{MEASURED, look_of};
pub use map::{Map, draw_map};
pub use scan::{caption_of_surface, draw_material_ratio, draw_surface};
pub use style::Curve;
pub use text::{PREFIXES, legible, number};

use layout::Layout;

/// Draws a figure from the text of a csv; returns the text of an svg.
///
/// # Errors
/// A column or a curve that the csv does not have, a curve in it that no panel draws, a cell that
/// is not a number, or an axis without a usable range.
pub fn draw(figure: &Figure, csv: &str) -> Result<String, PlotError> {
    let plots = panel::plots(figure, csv)?;
    let layout = Layout::new(figure, &plots);
    canvas::picture(&figure.title, (layout.width, layout.height), |canvas| {
        layout.draw(canvas);
        plots.iter().zip(&layout.frames).try_for_each(|(plot, frame)| plot.draw(canvas, frame))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const CSV: &str = "curve,x,y\na,0,1\na,1,10\na,2,100\nb,0,3\nb,1,-5\nb,2,30\n";

    fn figure(keys: &[&str], log: bool) -> Figure {
        let y = Axis::new("y", "force (N)");
        let y = if log { y.log() } else { y };
        let mut panel = Panel::new(Axis::new("x", "separation (m)"), y);
        panel.curves =
            keys.iter().enumerate().map(|(look, key)| Curve::new(look, key, key)).collect();
        Figure::new("", &[], vec![panel])
    }

    fn message(figure: &Figure, csv: &str) -> String {
        draw(figure, csv).err().map(|error| error.to_string()).unwrap_or_default()
    }

    /// The points of the lines of a colour and a width.
    fn lines(svg: &str, style: &str) -> Vec<Vec<(f64, f64)>> {
        let point = |pair: &str| {
            let (x, y) = pair.split_once(',')?;
            Some((x.parse().ok()?, y.parse().ok()?))
        };
        let lines =
            svg.lines().filter(|line| line.starts_with("<polyline") && line.contains(style));
        let points = lines.filter_map(|line| line.split('"').nth(1));
        points.map(|points| points.split(' ').filter_map(point).collect()).collect()
    }

    #[test]
    fn readings_share_the_width_and_have_their_text() {
        let mut figure = figure(&["a", "b"], true);
        let reading = |at: f64| Mark::new(at, &format!("at {at}\na < b"));
        figure.panels[0].readings = [2.0, 0.0, 1.0, 7.0].map(reading).into();
        let svg = draw(&figure, CSV).unwrap();
        let readings: Vec<&str> = svg.lines().filter(|line| line.contains("reading")).collect();
        assert_eq!(readings.len(), 3);
        assert!(svg.contains("<title>at 0\na &lt; b</title>"));
        let number = |text: &str, key: &str| -> f64 {
            text.split_once(key).unwrap().1.split('"').next().unwrap().parse().unwrap()
        };
        let widths: Vec<f64> =
            svg.split("class=\"reading\"").skip(1).map(|part| number(part, "width=\"")).collect();
        assert!((widths[1] / widths[0] - 2.0).abs() < 1e-3, "{widths:?}");
    }

    #[test]
    fn a_long_name_of_an_axis_keeps_to_its_panel() {
        let mut figure = figure(&["a", "b"], false);
        let size = |figure: &Figure| -> f64 {
            let svg = draw(figure, CSV).unwrap();
            let line = svg.lines().find(|line| line.contains("rotate(-90)")).unwrap();
            line.split("font-size=\"").nth(1).unwrap().split('"').next().unwrap().parse().unwrap()
        };
        figure.panels = vec![figure.panels[0].clone(); 3];
        assert!((size(&figure) - size::LABEL).abs() < 0.01);
        let long = "thermal-conductance-per-area (W/m²/K)";
        figure.panels[0].y.label = long.into();
        assert!(text::width(long, size::LABEL) > size::least_height(&figure));
        assert!(text::width(long, size(&figure)) < size::least_height(&figure) + 2.0);
    }

    #[test]
    fn no_curve_is_drawn_outside_or_along_the_frame() {
        let mut figure = figure(&["a", "b"], true);
        figure.panels[0].y.range = Some((2.0, 50.0));
        figure.panels[0].curves.iter_mut().for_each(|curve| curve.label.clear());
        let svg = draw(&figure, CSV).unwrap();
        let frame = lines(&svg, "stroke-width=\"1.3\"").concat();
        let (top, foot) =
            frame.iter().fold((600.0_f64, 0.0_f64), |(t, f), p| (t.min(p.1), f.max(p.1)));
        assert!(foot > top + 350.0);
        let curves = lines(&svg, "stroke-width=\"2\"");
        // b leaves at the foot and returns.
        assert_eq!(curves.len(), 3);
        for curve in curves {
            assert!(curve.iter().all(|point| (top..=foot).contains(&point.1)), "{curve:?}");
            let along = |ends: &[(f64, f64)]| (ends[0].1 - ends[1].1).abs() < 0.1;
            assert!(!curve.windows(2).any(along), "{curve:?}");
        }
    }

    #[test]
    fn values_with_ends_are_the_middle_line_of_a_band() {
        let csv = "curve,x,y_m,y_lower_m,y_upper_m\n\
            a,0,2,1,8\na,1,4,3,9\na,2,5,,\na,3,5,4,7\na,4,6,5,8\nb,0,3,,\nb,4,1,,\n";
        let mut figure = figure(&["a", "b"], false);
        figure.panels[0].y.column = "y_m".into();
        let svg = draw(&figure, csv).unwrap();
        // Two parts of one band, and two swatches of the legend.
        assert_eq!(svg.matches("<polygon").count(), 4, "{svg}");
        assert_eq!(svg.matches(">lower to upper end<").count(), 1);
        let frame = lines(&svg, "stroke-width=\"1.3\"").concat();
        let [top, foot] =
            [f64::min, f64::max].map(|of| frame.iter().map(|p| p.1).reduce(of).unwrap());
        // One line a curve, though the ends make the axis: 9 lies below the top of the frame.
        let middle = lines(&svg, "stroke-width=\"2\"");
        assert_eq!(middle.iter().filter(|line| line.len() > 2).count(), 1);
        let ends = lines(&svg, "stroke-width=\"0.7\"");
        let of_band = ends.iter().filter(|line| line.iter().all(|p| (top..foot).contains(&p.1)));
        assert_eq!(of_band.count(), 4, "{ends:?}");
        let height = |value: f64| {
            let two = middle.iter().find(|line| line.len() > 2).unwrap();
            // The values 2 and 6 of the middle line.
            let (first, last) = (two[0].1, two[two.len() - 1].1);
            first + (value - 2.0) / 4.0 * (last - first)
        };
        let has = |value: f64| ends.iter().flatten().any(|p| (p.1 - height(value)).abs() < 0.1);
        assert!(has(1.0) && has(9.0) && has(7.0) && !has(2.5), "{ends:?}");
        // No two lines of one width look alike.
        let look = |line: &&str| line.split_once("fill=").map(|(_, look)| look.to_string());
        let mut looks: Vec<_> = svg.lines().filter(|l| l.contains("stroke-width=\"2\"")).collect();
        looks.sort_by_key(look);
        looks.dedup_by_key(|line| look(&&**line));
        assert_eq!(looks.len(), 2);
    }

    #[test]
    fn missing_columns_and_curves_that_no_panel_draws_are_refused() {
        assert!(message(&figure(&["a"], false), "").contains("column `x`"));
        assert!(message(&figure(&["a"], false), "curve,x,z\na,1,2\n").contains("column `y`"));
        assert!(message(&figure(&["a", "b", "nobody"], false), CSV).contains("`nobody`"));
        assert!(message(&figure(&["a"], false), CSV).contains("`b`"));
    }

    #[test]
    fn a_gap_is_a_break_that_can_be_joined_by_dots() {
        let csv = "curve,x,y\na,0,1\na,1,1\na,,\na,1,5\na,2,5\n";
        let mut figure = figure(&["a"], false);
        figure.panels[0].curves[0].label.clear();
        let plain = draw(&figure, csv).unwrap();
        assert_eq!(lines(&plain, "stroke-width=\"2\"").len(), 2);
        figure.panels[0].curves[0].join_gaps = true;
        let joined = draw(&figure, csv).unwrap();
        assert_eq!(joined.matches("<polyline").count(), plain.matches("<polyline").count() + 1);
    }

    #[test]
    fn many_panels_are_labelled_and_text_is_escaped() {
        let mut figure = figure(&["a", "b"], false);
        figure.title = "a < b & c".into();
        figure.panels = vec![figure.panels[0].clone(); 3];
        for columns in [0, 2, 3, 7] {
            figure.columns = columns;
            let svg = draw(&figure, CSV).unwrap();
            for label in [">(a)<", ">(b)<", ">(c)<", "a &lt; b &amp; c"] {
                assert!(svg.contains(label), "{label}");
            }
        }
        figure.panels = vec![figure.panels[0].clone(); 30];
        assert!(draw(&figure, CSV).is_ok());
        figure.panels.clear();
        assert!(draw(&figure, CSV).is_ok());
    }
}
