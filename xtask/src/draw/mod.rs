//! Figures: a description and the text of a CSV give the text of an SVG.
//!
//! The picture follows from these two alone, byte for byte. It is drawn by
//! `plotters` in whole quarters of a pixel, 2400 pixels wide and shown 800 wide, so
//! that the rounding cannot be seen. What `plotters` would get wrong is done here before it draws:
//! curves are cut at the frame and at gaps, dashes run on over short segments,
//! and legend keys show line, dash and marker.
//!
//! ```
//! use xtask::draw::{Axis, CurveStyle, Figure, Panel, draw};
//!
//! let mut panel = Panel::new(
//!     Axis::new("separation_m", "separation (µm)").times(1e6),
//!     Axis::new("force_N", "force (N)").log(),
//! );
//! panel.curves = vec![CurveStyle::numbered(0, "a", "the first model")];
//! let figure = Figure { panels: vec![panel], ..Figure::default() };
//! let csv = "curve,separation_m,force_N\na,0,100\na,1e-6,1\n";
//! assert!(draw(&figure, csv)?.starts_with("<svg "));
//! # Ok::<(), anyhow::Error>(())
//! ```

mod axes;
mod canvas;
mod clip;
mod figure;
mod layout;
mod legend;
mod matrix;
mod panel;
mod plot;
mod room;
mod ruler;
mod series;
mod style;
mod table;
#[cfg(test)]
mod tests;
mod text;
mod ticks;
mod trace;
mod words;

use anyhow::{Context, Result, bail};

pub use figure::{
    Along, Arrangement, Axis, Band, Corner, Figure, Legend, Mark, Note, Panel, Scale,
};
pub use matrix::{Cell, Matrix, draw_matrix};
pub use style::{Colour, CurveStyle, Dash, Marker, Shape};
pub(crate) use text::power_of_ten;

use canvas::{Canvas, FINE, Side, Type};
use layout::{Layout, SMALL, TITLE, WIDTH};
use plot::Plot;
use table::Table;

/// The least width of a frame in pixels.
const LEAST_WIDTH: f64 = 320.0;

/// Draws a figure from the text of a CSV; gives the text of an SVG.
///
/// # Errors
///
/// A column or a curve that the CSV does not have, a curve in it that no panel
/// draws, a cell that is not a number, or an axis without a usable range.
pub fn draw(figure: &Figure, csv: &str) -> Result<String> {
    if !(1..=3).contains(&figure.panels.len()) {
        bail!("figure `{}` has {} panels, not one to three", figure.title, figure.panels.len());
    }
    let table = Table::read(csv)?;
    let mut plots = (0..figure.panels.len())
        .map(|index| Plot::new(figure, index, &table))
        .collect::<Result<Vec<Plot>>>()?;
    series::check_all_drawn(figure, &table)?;
    let layout = settle_legends(figure, &mut plots)?;
    if layout.frames.iter().any(|frame| frame.width() < LEAST_WIDTH) {
        bail!(
            "the legends of figure `{}` leave no room for its panels: let them share one",
            figure.title
        );
    }

    let mut svg = String::new();
    let canvas = Canvas::new(&mut svg, WIDTH as u32, layout.height)?;
    draw_parts(&canvas, &plots, &layout)?;
    canvas.finish()?;
    dressed(&svg, &figure.title, layout.height)
}

/// Lays the figure out; automatic legends without room inside go to the right.
fn settle_legends<'a>(figure: &Figure, plots: &mut [Plot<'a>]) -> Result<Layout<'a>> {
    let layout = layout::arrange(figure, plots);
    let mut moved = false;
    for (plot, frame) in plots.iter_mut().zip(&layout.frames) {
        if plot.legend == Legend::Auto {
            let traces = plot.traces(*frame)?;
            let taken = plot.taken(&traces, *frame);
            if plot.legend_inside(&taken, *frame).is_none() {
                plot.legend = Legend::Right;
                moved = true;
            }
        }
    }
    Ok(if moved { layout::arrange(figure, plots) } else { layout })
}

fn draw_parts(canvas: &Canvas, plots: &[Plot], layout: &Layout) -> Result<()> {
    let face = Type { bold: true, ..Type::new(TITLE, Colour::BLACK, Side::Middle) };
    canvas.lines(&layout.title, (WIDTH / 2.0, 40.0), TITLE * text::LINE, face)?;
    for ((plot, frame), marks) in plots.iter().zip(&layout.frames).zip(&layout.marks) {
        panel::draw(canvas, plot, *frame, marks)?;
    }
    if let Some((legend, left, top)) = &layout.shared {
        legend.draw(canvas, *left, *top, true)?;
    }
    let face = Type::new(SMALL, Colour::DARK_GREY, Side::Start);
    canvas.lines(&layout.caption, (72.0, layout.caption_top), SMALL * 1.35, face)
}

/// Puts a root tag that shows the picture at a third of its size, and takes the
/// line breaks out of the text tags, which some viewers show as blanks.
fn dressed(svg: &str, title: &str, height: u32) -> Result<String> {
    let (_, body) = svg.split_once('\n').context("the drawing has no root tag")?;
    let width = WIDTH as u32;
    let mut dressed = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" \
         viewBox=\"0 0 {width} {height}\" stroke-linejoin=\"round\" role=\"img\">\n",
        width / 3,
        height / 3
    );
    if !title.is_empty() {
        let safe = title.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        dressed.push_str(&format!("<title>{safe}</title>\n"));
    }
    dressed.push_str(&format!("<g transform=\"scale({})\">\n", 1.0 / f64::from(FINE)));
    let mut size = None;
    for line in body.lines() {
        if line == "</svg>" {
            dressed.push_str("</g>\n");
        }
        if line == "</text>" {
            dressed.truncate(dressed.trim_end().len());
        }
        match size {
            Some(size) => dressed.push_str(&text::subscripts(line, size)),
            None => dressed.push_str(line),
        }
        size = text::size(line);
        if size.is_none() {
            dressed.push('\n');
        }
    }
    Ok(dressed)
}
