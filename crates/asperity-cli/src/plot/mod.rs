//! Curves as a picture: from the table that is printed, and from nothing else.
//!
//! SVG knows dashes, text anchors and fractions of a pixel, so that it is written as it is.

mod axis;
mod style;

use std::fmt::Write;

use anyhow::{Context, Result};
use asperity::Output;

use crate::reading::column_name;
use crate::table::{Cells, Table};
use axis::Axis;
use style::Style;

const WIDTH: f64 = 860.0;
const PANEL: f64 = 400.0;
const LEFT: f64 = 90.0;
const RIGHT: f64 = 170.0;
const TOP: f64 = 28.0;
const BOTTOM: f64 = 56.0;
/// Markers along a curve stand at this distance, every curve's a little further on.
const MARKER_STEP: f64 = 110.0;

/// One curve: its place among the models, its name, and its points; gaps where there is no value.
struct Curve<'a> {
    style: Style,
    name: &'a str,
    points: Vec<(f64, Option<f64>)>,
}

/// The picture of a table's outputs against the separation, one panel for each.
pub fn svg(table: &Table, outputs: &[Output]) -> Result<String> {
    let height = PANEL * outputs.len() as f64;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height}\" viewBox=\"0 0 {WIDTH} {height}\" font-family=\"sans-serif\" font-size=\"14\" role=\"img\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
    );
    for (index, &output) in outputs.iter().enumerate() {
        let curves = curves(table, output)?;
        writeln!(svg, "<g transform=\"translate(0 {})\">", PANEL * index as f64)?;
        panel(&mut svg, output, &curves)?;
        svg.push_str("</g>\n");
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}

fn curves(table: &Table, output: Output) -> Result<Vec<Curve<'_>>> {
    let cells = |name: &str| {
        let column = table.columns.iter().find(|column| column.name == name);
        column.map(|c| &c.cells).with_context(|| format!("the table has no column {name}"))
    };
    let name = column_name(output);
    let (Cells::Words(models), Cells::Numbers(x), Cells::Numbers(y)) =
        (cells("model")?, cells("separation_over_sigma")?, cells(&name)?)
    else {
        anyhow::bail!("the table's columns are not numbers against numbers");
    };
    let mut curves: Vec<Curve> = vec![];
    for (model, (x, y)) in models.iter().zip(x.iter().zip(y)) {
        if curves.last().is_none_or(|curve| curve.name != model) {
            curves.push(Curve { style: Style::of(model), name: model, points: vec![] });
        }
        if let (Some(curve), Some(x)) = (curves.last_mut(), x) {
            curve.points.push((*x, y.filter(|y| y.is_finite())));
        }
    }
    for curve in &mut curves {
        curve.points.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
    Ok(curves)
}

fn panel(svg: &mut String, output: Output, curves: &[Curve]) -> Result<()> {
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let x = Axis::linear(points().map(|p| p.0), (LEFT, WIDTH - RIGHT));
    let values: Vec<f64> = points().filter_map(|p| p.1).collect();
    let y = Axis::fitting(&values, output, (PANEL - BOTTOM, TOP));
    frame(svg, &x, &y, output)?;
    let mut hidden = vec![];
    for (index, curve) in curves.iter().enumerate() {
        let pixels: Vec<Option<(f64, f64)>> = curve
            .points
            .iter()
            .map(|&(across, up)| Some((x.pixel(across)?, y.pixel(up?)?)))
            .collect();
        if curve.points.iter().any(|p| p.1.is_some_and(|value| y.pixel(value).is_none())) {
            hidden.push(curve.name);
        }
        draw(svg, &pixels, &curve.style, index, curves.len())?;
        legend(svg, curve, index)?;
    }
    if !hidden.is_empty() {
        let (across, down) = (LEFT, TOP - 10.0);
        let names = hidden.join(", ");
        writeln!(
            svg,
            "<text x=\"{across}\" y=\"{down}\" font-size=\"12\">{names}: values of 0 and below are not on this logarithmic axis</text>"
        )?;
    }
    Ok(())
}

fn frame(svg: &mut String, x: &Axis, y: &Axis, output: Output) -> Result<()> {
    let (right, bottom) = (WIDTH - RIGHT, PANEL - BOTTOM);
    for (at, label) in x.ticks() {
        writeln!(
            svg,
            "<path d=\"M{at:.1} {TOP}V{bottom}\" stroke=\"#ddd\"/><text x=\"{at:.1}\" y=\"{}\" text-anchor=\"middle\">{label}</text>",
            bottom + 18.0
        )?;
    }
    for (at, label) in y.ticks() {
        writeln!(
            svg,
            "<path d=\"M{LEFT} {at:.1}H{right}\" stroke=\"#ddd\"/><text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{label}</text>",
            LEFT - 8.0,
            at + 5.0
        )?;
    }
    let name = match output.unit() {
        "" => output.to_string(),
        "m2" => format!("{output} (m²)"),
        "ln m2" => format!("{output} (of m²)"),
        "ln N" => format!("{output} (of N)"),
        unit => format!("{output} ({unit})"),
    };
    writeln!(
        svg,
        "<rect x=\"{LEFT}\" y=\"{TOP}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"black\"/>\n<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">separation (standard deviations of asperity heights)</text>\n<text transform=\"translate(20 {}) rotate(-90)\" text-anchor=\"middle\">{name}</text>",
        right - LEFT,
        bottom - TOP,
        (LEFT + right) / 2.0,
        bottom + 42.0,
        (TOP + bottom) / 2.0
    )?;
    Ok(())
}

/// A curve, broken where it has no place on the axes, with markers that no other curve's cover.
fn draw(
    svg: &mut String,
    pixels: &[Option<(f64, f64)>],
    style: &Style,
    index: usize,
    count: usize,
) -> Result<()> {
    for piece in pixels.split(Option::is_none) {
        let piece: Vec<(f64, f64)> = piece.iter().copied().flatten().collect();
        if piece.len() > 1 {
            style.line(svg, &piece)?;
        }
        let mut next = LEFT + MARKER_STEP * (0.1 + index as f64 / count as f64);
        for (k, &(across, down)) in piece.iter().enumerate() {
            // Few points have a marker each; a point alone is seen by nothing else.
            let sparse = piece.len() > 1 && pixels.len() > 12;
            if !sparse || across >= next || (k + 1 == piece.len() && across < LEFT + MARKER_STEP) {
                style.marker(svg, across, down)?;
                next = across.max(next) + MARKER_STEP;
            }
        }
    }
    Ok(())
}

fn legend(svg: &mut String, curve: &Curve, index: usize) -> Result<()> {
    let (left, down) = (WIDTH - RIGHT + 14.0, TOP + 12.0 + 24.0 * index as f64);
    curve.style.line(svg, &[(left, down), (left + 50.0, down)])?;
    curve.style.marker(svg, left + 25.0, down)?;
    writeln!(svg, "<text x=\"{}\" y=\"{}\">{}</text>", left + 60.0, down + 5.0, curve.name)?;
    Ok(())
}
