//! Data and fitted models as a picture.

use std::fmt::Write;

use anyhow::Result;
use asperity::fit::{Data, Fitted, Measured, Observation};
use asperity::short;
use asperity_answer::Sheet;
use asperity_inputs::SceneFile;
use asperity_plot::{Axis, Curve, Figure, MEASURED, Panel, Scale, look_of};

use crate::output::plot::{self, label};
use crate::scene::NamedModel;

/// Points of a model's curve.
const POINTS: usize = 101;
/// The names of the data and of their standard deviations among the curves.
const DATA: &str = "measured";
const SPREAD: &str = "standard deviation";

/// A panel for each measured quantity against each kind of place.
pub fn svg(
    file: &SceneFile,
    data: &Data,
    models: &[NamedModel],
    ranked: &[Fitted],
) -> Result<String> {
    let between = data.between(POINTS);
    let mut sheet = Sheet::new(&["panel", "curve", "x", "y"]);
    let mut row = |one: &Observation, curve: &str, x: f64, y: Option<f64>| {
        sheet.add(&[&name(one), curve], [Some(x), y]);
    };
    for one in data.iter() {
        let x = one.place().1;
        row(one, DATA, x, Some(one.value));
        if let Some(std) = one.std {
            // Blank at the end of a bar.
            let bar = [Some(one.value - std), Some(one.value + std), None];
            bar.into_iter().for_each(|y| row(one, SPREAD, x, y));
        }
    }
    for fitted in ranked {
        let Some((id, model)) = models.iter().find(|(id, _)| *id == fitted.model) else { continue };
        let values = file.fitted_values(model, fitted, &between)?;
        for (one, value) in between.iter().zip(values) {
            row(one, id, one.place().1, value);
        }
    }
    let mut curves = vec![Curve::points(MEASURED, DATA, DATA)];
    if data.has_std() {
        let bars = Curve::new(MEASURED, SPREAD, "± standard deviation");
        curves.push(bars);
    }
    let model = |fitted: &Fitted| {
        Curve::new(look_of(&fitted.model).unwrap_or(0), &fitted.model, &fitted.model)
    };
    curves.extend(ranked.iter().map(model));
    let mut panels: Vec<Panel> = vec![];
    for one in data.iter() {
        let known = |panel: &Panel| panel.only.as_ref().is_some_and(|only| only.1 == name(one));
        if panels.iter().any(known) {
            continue;
        }
        let same = || data.iter().filter(|other| name(other) == name(one));
        let xs: Vec<f64> = same().map(|one| one.place().1).collect();
        let ys: Vec<f64> = same().map(|one| one.value).collect();
        let (x_label, millionths) = match one.place().0 {
            "load_N" => ("load (N)", false),
            "pressure_Pa" => ("pressure (Pa)", false),
            _ => ("reading of the separation (µm)", true),
        };
        let (y_label, in_um) = match one.measured {
            Measured::Quantity(quantity) => (label(quantity), false),
            _ => ("reading of the separation (µm)".into(), true),
        };
        let axis = |column: &str, label: &str, in_um: bool, values: &[f64]| {
            let mut axis = Axis::new(column, label);
            let [low, high] = ends(values);
            let room = 0.03 * (high - low);
            // The first and the last symbol stay inside the frame.
            axis.range = (room > 0.0).then_some((low - room, high + room));
            if in_um {
                return axis.times(1e6);
            }
            axis.scale = Scale::fitting(values);
            if axis.scale == Scale::Log {
                axis.range = Some((low / 1.1, high * 1.1));
            }
            axis
        };
        let x = axis("x", x_label, millionths, &xs);
        let mut y = axis("y", &y_label, in_um, &ys);
        // Residuals are logarithms: over a logarithmic axis they show on another.
        if x.scale == Scale::Log && ends(&ys)[0] > 0.0 {
            y.scale = Scale::Log;
        }
        // Models may leave the range of the data.
        y.range = None;
        let mut panel = Panel::new(x, y);
        panel.only = Some(("panel".into(), name(one)));
        panel.curves.clone_from(&curves);
        panels.push(panel);
    }
    let captions: Vec<String> = ranked.iter().map(caption).collect();
    let captions: Vec<&str> = captions.iter().map(String::as_str).collect();
    plot::drawn(&sheet, &Figure::new("", &captions, panels))
}

fn ends(values: &[f64]) -> [f64; 2] {
    let join = |[low, high]: [f64; 2], value: &f64| [low.min(*value), high.max(*value)];
    values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], join)
}

/// The name of an observation's panel.
fn name(one: &Observation) -> String {
    format!("{} at {}", one.measured.column(), one.place().0)
}

/// A model with its parameters.
fn caption(fitted: &Fitted) -> String {
    let mut text = format!("{}: ", fitted.model);
    for (k, found) in fitted.parameters.iter().enumerate() {
        let gap = if k == 0 { "" } else { ", " };
        let unit = if found.unit.is_empty() { String::new() } else { format!(" {}", found.unit) };
        // An underscore would lower the next letter.
        let name = found.name.replace('_', " ");
        let _ = write!(text, "{gap}{name} {}{unit}", short(found.value));
        if let (Some(lower), Some(upper)) = (found.lower, found.upper) {
            let _ = write!(text, " ({} to {})", short(lower), short(upper));
        }
    }
    if let Some(rms) = fitted.rms {
        let _ = write!(text, "; rms {} %", short(100.0 * rms));
    }
    text + "."
}
