//! Contact tables for finite-element codes.

use asperity::Tolerance;
use asperity_answer::{
    ConductanceAgainst, Export, Sheet, Silent, Subject, TableFormat, UnitSystem,
};
use pyo3::prelude::*;

use crate::convert::axis::Axis;
use crate::convert::error::{refused, value_error};
use crate::model::engine::Engine;
use crate::scene::SceneFile;

/// Clearances [m], pressures [Pa], tangents [Pa/m], the relative errors of pressure and tangent
/// between the nodes, and the text.
type Table = (Vec<f64>, Vec<f64>, Vec<f64>, f64, f64, String);

/// A table between two places, with nodes at equal distances or, if an error is given, as many as
/// that error needs; conductance and friction are added to the text, if given.
#[pyfunction]
pub(crate) fn contact_table(
    py: Python<'_>,
    engine: &Engine,
    scene: &SceneFile,
    ends: (Axis, f64, f64),
    spacing: (usize, Option<f64>, f64),
    form: (&str, &str),
    beside: (Option<String>, Option<f64>),
) -> PyResult<Table> {
    let (model, file) = (engine.on(&scene.0)?, &scene.0);
    let format = form.0.parse::<TableFormat>();
    let format =
        format.map_err(|needed| value_error(format!("format is {:?}: {needed}", form.0)))?;
    let units: UnitSystem = form.1.parse().map_err(|e| value_error(format!("units: {e}")))?;
    let (nodes, max_error, rtol) = spacing;
    let tolerance = Tolerance::new(rtol).map_err(refused)?;
    let (axis, first, last) = ends;
    let (conductance, friction) = beside;
    let against = |name: String| {
        let found = name.parse::<ConductanceAgainst>();
        found.map_err(|needed| value_error(format!("conductance is {name:?}: {needed}")))
    };
    let export = Export {
        subject: Subject { file, name: "", id: "", model: &model, tolerance },
        ends: [first, last].map(|end| axis.at(end, file.separation_from)),
        nodes,
        max_error,
        format,
        units,
        conductance: conductance.map(against).transpose()?,
        friction,
    };
    let mut sheet = Sheet::default();
    let found = py.detach(|| export.answer(&mut sheet, &Silent)).map_err(value_error)?;
    let column = |k: usize| sheet.rows.iter().filter_map(|row| row[k].number()).collect();
    let [pressure_error, tangent_error] = [found.pressure_error, found.tangent_error];
    Ok((column(0), column(1), column(2), pressure_error, tangent_error, found.text))
}
