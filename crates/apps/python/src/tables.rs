//! Contact tables for finite-element codes, and sheets as tables of the package.

use asperity::Severity;
use asperity_answer::{Cell, Export, Nodes, Sheet, Silent, Subject, TableFormat, UnitSystem};
use asperity_scene as scene;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::convert::axis::Axis;
use crate::convert::{Object, object, tolerance, value_error, warn_of_ranges, warn_unless};
use crate::model::engine::Engine;
use crate::scene::SceneFile;

/// Clearances [m], pressures [Pa] and tangents [Pa/m], the relative errors of pressure and tangent
/// between the nodes, and the text.
type Contact<'py> = (Bound<'py, PyDict>, f64, f64, String);
/// Columns by their heads, findings, and results in sentences: the package's `Table`.
pub(crate) type Table<'py> = (Bound<'py, PyDict>, Object<'py>, Vec<String>);

/// The columns of a sheet by their heads: arrays of numbers, NaN for blanks, or lists of words.
pub(crate) fn columns<'py>(py: Python<'py>, sheet: &Sheet) -> PyResult<Bound<'py, PyDict>> {
    let found = PyDict::new(py);
    for (k, head) in sheet.heads.iter().enumerate() {
        let cells = || sheet.rows.iter().map(|row| &row[k]);
        if cells().any(|cell| matches!(cell, Cell::Text(_))) {
            found.set_item(head, cells().map(Cell::text).collect::<Vec<_>>())?;
        } else {
            let numbers = cells().map(|cell| cell.number().unwrap_or(f64::NAN));
            found.set_item(head, PyArray1::from_vec(py, numbers.collect()))?;
        }
    }
    Ok(found)
}

/// A sheet as the package's `Table`.
pub(crate) fn table<'py>(py: Python<'py>, sheet: &Sheet) -> PyResult<Table<'py>> {
    Ok((columns(py, sheet)?, object(py, &sheet.findings)?, sheet.results.clone()))
}

/// Emits the warnings of a sheet that the scene does not accept.
pub(crate) fn warn_of(py: Python<'_>, file: &scene::SceneFile, sheet: &Sheet) -> PyResult<()> {
    let mut warnings = sheet.findings.iter().filter(|found| found.severity < Severity::Note);
    warnings.try_for_each(|found| warn_unless(py, &file.spec.accept, found, 1))
}

/// A table between two places, with nodes at equal distances or, if an error is given, as many as
/// that error needs; the conductance is added to the text, if requested.
#[pyfunction]
pub(crate) fn contact_table<'py>(
    py: Python<'py>,
    engine: &Engine,
    scene: &SceneFile,
    ends: (Axis, f64, f64),
    spacing: (usize, Option<f64>, f64),
    form: (&str, &str),
    conductance: bool,
) -> PyResult<Contact<'py>> {
    warn_of_ranges(py, &scene.0, 1)?;
    let (model, file) = (engine.on(&scene.0)?, &scene.0);
    let format = form.0.parse::<TableFormat>();
    let format =
        format.map_err(|needed| value_error(format!("format is {:?}: {needed}", form.0)))?;
    let units: UnitSystem = form.1.parse().map_err(|e| value_error(format!("units: {e}")))?;
    let (count, max_error, rtol) = spacing;
    let tolerance = tolerance(rtol)?;
    let (axis, first, last) = ends;
    let ends = [first, last].map(|end| axis.at(end, file.spec.separation_from));
    let export = Export {
        subject: Subject { file, name: "", model: &model, tolerance },
        nodes: Nodes::Range { ends, count, log: false, max_error },
        format,
        units,
        conductance,
    };
    let mut sheet = Sheet::default();
    let found = py.detach(|| export.answer(&mut sheet, &Silent)).map_err(value_error)?;
    warn_of(py, file, &sheet)?;
    let of_films = "format is \"film\": solve(film=...) returns these columns";
    let [of_pressure, of_tangent] = found.errors.ok_or_else(|| value_error(of_films))?;
    Ok((columns(py, &sheet)?, of_pressure, of_tangent, found.text))
}
