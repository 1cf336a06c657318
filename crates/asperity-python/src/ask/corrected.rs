//! Models divided by their expected ratio to boundary elements.

use asperity::{ContactError, Corrected, CorrectedRow, Request};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

use crate::ask::rows::Rows;
use crate::ask::values::{Failures, failures};
use crate::convert::axis::Axis;
use crate::convert::quantities::Quantities;
use crate::model::engine::Engine;

/// Value, lower and upper end of each quantity, row by row; NaN for what is refused.
struct Found {
    columns: Vec<[Vec<f64>; 3]>,
    /// The same of the separation; NaN where the evidence does not determine it.
    separations: [Vec<f64>; 3],
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
    let columns = found.columns.into_iter().chain([found.separations]).map(arrays);
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
    let mut columns: Vec<[Vec<f64>; 3]> =
        request.quantities.iter().map(|_| [const { vec![] }; 3]).collect();
    let mut separations = [const { vec![] }; 3];
    let add = |column: &mut [Vec<f64>; 3], numbers: [f64; 3]| {
        column.iter_mut().zip(numbers).for_each(|(column, number)| column.push(number));
    };
    let (mut refused, mut apart) = (vec![], vec![]);
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
        let mut reason = at.as_ref().err().cloned();
        for (column, quantity) in columns.iter_mut().zip(&request.quantities) {
            let found = at.as_ref().ok().map(|at| at.value(*quantity));
            let numbers = match found {
                Some(Ok(found)) => [found.value, found.lower, found.upper],
                Some(Err(error)) => {
                    reason.get_or_insert(error);
                    [f64::NAN; 3]
                }
                None => [f64::NAN; 3],
            };
            add(column, numbers);
        }
        let separation = |at: &CorrectedRow<'_>| {
            let (found, scene) = (at.separation()?, rows.scene(row)?);
            let of = |separation| unit.of(separation, rows.datum(row), &scene);
            Ok::<_, ContactError>([of(found.value)?, of(found.lower)?, of(found.upper)?])
        };
        let found = at.as_ref().map_err(Clone::clone).and_then(separation);
        add(&mut separations, *found.as_ref().unwrap_or(&[f64::NAN; 3]));
        match (reason, found) {
            (Some(reason), _) => refused.push((row, reason)),
            (None, Err(reason)) => apart.push((row, reason)),
            (None, Ok(_)) => {}
        }
        drop(at);
        prepared = Some((place, compiled));
    }
    Found { columns, separations, refused, apart }
}
