//! Models divided by their expected ratio to boundary elements.

use asperity::{ContactError, Corrected, Quantity, Request};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

use crate::ask::rows::Rows;
use crate::ask::values::{Failures, failures};
use crate::convert::axis::Axis;
use crate::convert::quantities::Quantities;
use crate::model::engine::Engine;

/// Value, lower and upper end of each quantity and of the separation, row by row; NaN for what is
/// refused.
struct Found {
    columns: Vec<[Vec<f64>; 3]>,
    refused: Vec<(usize, ContactError)>,
    /// Rows without a separation only.
    apart: Vec<(usize, ContactError)>,
}

/// The id of the corrected model; for each quantity and for the separation values and ends of their
/// intervals; rows with a value refused, and rows without a separation only.
#[pyfunction]
pub(crate) fn corrected<'py>(
    py: Python<'py>,
    engine: &Engine,
    rows: Rows,
    unit: Axis,
    quantities: Quantities,
    rtol: f64,
) -> PyResult<(String, Bound<'py, PyDict>, Failures, Failures)> {
    let rows = &rows;
    let model = engine.on_all(&rows.files)?;
    let request = quantities.request(rtol)?;
    let asked = engine.id_asked(&model);
    let found = py.detach(|| answer((&model, &asked), rows, unit, &request));
    let arrays = |column: [Vec<f64>; 3]| column.map(|numbers| PyArray1::from_vec(py, numbers));
    let names = quantities.names().into_iter().chain(["separation".into()]);
    let columns = found.columns.into_iter().map(arrays);
    let columns = names.zip(columns).into_py_dict(py)?;
    let raised = |rows| failures(py, engine, rows);
    Ok((format!("{asked}-corrected"), columns, raised(found.refused), raised(found.apart)))
}

/// The answers of a model under the id by which it was asked for.
fn answer(
    (model, id): (&asperity::Model, &str),
    rows: &Rows,
    unit: Axis,
    request: &Request,
) -> Found {
    let columns = (0..=request.quantities.len()).map(|_| [const { vec![] }; 3]);
    let mut found = Found { columns: columns.collect(), refused: vec![], apart: vec![] };
    // Prepared once for neighbouring rows of a scene.
    let mut prepared: Option<(usize, Result<Corrected, ContactError>)> = None;
    for row in 0..rows.len() {
        let place = rows.place(row);
        let compiled = match prepared.take() {
            Some((known, compiled)) if known == place => compiled,
            _ => rows.file_of(row).and_then(|file| {
                let corrected = Corrected::new(model, &file.scene, file.surface_shape()?, request)?;
                Ok(corrected.named(id))
            }),
        };
        let at = compiled.as_ref().map_err(Clone::clone).and_then(|found| found.at(rows.at(row)));
        let at = at.as_ref().map_err(Clone::clone);
        let value = |quantity: &Quantity| {
            let found = at.clone()?.value(*quantity)?;
            Ok([found.value, found.lower, found.upper])
        };
        let separation = || {
            let (found, scene) = (at.clone()?.separation()?, rows.scene(row)?);
            let of = |separation| unit.of(separation, rows.datum(row), &scene);
            Ok([of(found.value)?, of(found.lower)?, of(found.upper)?])
        };
        let mut numbers: Vec<Result<_, ContactError>> =
            request.quantities.iter().map(value).collect();
        let refused = numbers.iter().find_map(|found| found.clone().err());
        numbers.push(separation());
        let apart = numbers.last().and_then(|found| found.clone().err());
        match refused {
            Some(reason) => found.refused.push((row, reason)),
            None => found.apart.extend(apart.map(|reason| (row, reason))),
        }
        for (column, numbers) in found.columns.iter_mut().zip(numbers) {
            let numbers = numbers.unwrap_or([f64::NAN; 3]);
            column.iter_mut().zip(numbers).for_each(|(column, number)| column.push(number));
        }
        prepared = Some((place, compiled));
    }
    found
}
