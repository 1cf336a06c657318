//! Models divided by their expected ratio to boundary elements.

use asperity::{ContactError, Corrected, Quantity};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

use crate::ask::asked::{Arguments, Asked, Failures, ROWS_PER_TASK};
use crate::convert::axis::Axis;

/// The id of the corrected model; for each quantity and for the separation values and ends of their
/// intervals; rows with a value refused, and rows without a separation only.
#[pyfunction]
pub(crate) fn corrected<'py>(
    py: Python<'py>,
    asked: Arguments<'_>,
    unit: Axis,
) -> PyResult<(String, Bound<'py, PyDict>, Failures, Failures)> {
    let asked = Asked::new(asked)?;
    let Asked { rows, model, request, .. } = &asked;
    // Under the id by which the model was asked for.
    let id = asked.engine().id_asked(model);
    let make = |row| {
        let file = rows.file_of(row)?;
        Ok(Corrected::new(model, &file.scene, file.surface_shape()?, request)?.named(&id))
    };
    // Value, lower and upper end of each quantity and of the separation.
    let of = |corrected: &Corrected, row| {
        let at = corrected.at(rows.at(row))?;
        let value = |quantity: &Quantity| -> Result<_, ContactError> {
            let found = at.value(*quantity)?;
            Ok([found.value, found.lower, found.upper])
        };
        let separation = || -> Result<_, ContactError> {
            let (found, scene) = (at.separation()?, rows.scene(row)?);
            let of = |separation| unit.of(separation, rows.datum(row), &scene);
            Ok([of(found.value)?, of(found.lower)?, of(found.upper)?])
        };
        let numbers = request.quantities.iter().map(value).chain([separation()]);
        Ok(numbers.collect::<Vec<_>>())
    };
    let (found, mut refused) = asked.on_scenes(py, ROWS_PER_TASK, false, make, of)?;
    let (mut apart, last) = (vec![], request.quantities.len());
    let mut columns = vec![[(); 3].map(|()| Vec::with_capacity(rows.len())); last + 1];
    for (row, found) in found.into_iter().enumerate() {
        for (k, column) in columns.iter_mut().enumerate() {
            let numbers = found.as_ref().and_then(|found| found[k].as_ref().ok());
            let numbers = numbers.unwrap_or(&[f64::NAN; 3]);
            column.iter_mut().zip(numbers).for_each(|(column, number)| column.push(*number));
        }
        let mut reasons = found.into_iter().flatten().enumerate();
        match reasons.find_map(|(k, found)| Some((k == last, found.err()?))) {
            Some((true, reason)) => apart.push((row, reason)),
            Some((false, reason)) => refused.push((row, reason)),
            None => {}
        }
    }
    refused.sort_by_key(|(row, _)| *row);
    let names = request.quantities.iter().map(ToString::to_string).chain(["separation".into()]);
    let columns = columns.into_iter().map(|ends| ends.map(|end| PyArray1::from_vec(py, end)));
    let columns = names.zip(columns).into_py_dict(py)?;
    let raised = |rows| asked.failures(py, rows);
    Ok((format!("{id}-corrected"), columns, raised(refused), raised(apart)))
}
