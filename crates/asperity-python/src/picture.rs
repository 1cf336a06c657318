//! Pictures of tables, drawn by `asperity-plot`.

use asperity_plot::{Axis, Curve, Figure, Panel, Scale, draw};
use pyo3::prelude::*;

use crate::convert::value_error;

/// A column with its label, and whether its axis is logarithmic.
type Column = (String, String, bool);

/// The SVG picture of a table: a panel for each column of y against x.
#[pyfunction]
pub(crate) fn svg(csv: &str, x: Column, y: Vec<Column>, curve: &str) -> PyResult<String> {
    let axis = |(name, label, log): &Column| {
        let mut axis = Axis::new(name, label);
        if *log {
            axis.scale = Scale::Log;
        }
        axis
    };
    let panel = |column: &Column| {
        let mut panel = Panel::new(axis(&x), axis(column));
        panel.curve_column = "curve".into();
        panel.curves = vec![Curve::new(0, curve, "")];
        panel
    };
    draw(&Figure::new("", &[], y.iter().map(panel).collect()), csv).map_err(value_error)
}
