//! Joints that open again or are sheared.

mod partial_slip;
mod table;
mod unloading;

use std::ops::Range;

use asperity::{ContactError, SeparationUnit};
use numpy::{PyArray1, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyFloat;

use crate::ask::long::{pool, run_stretches};
use crate::convert::axis::Axis;
use crate::convert::error::warn;
use crate::convert::numbers::{floats, scalar};
pub(crate) use partial_slip::PartialSlip;
pub(crate) use table::JointTable;
pub(crate) use unloading::Unloading;

/// Separations in multiples of σ_z.
pub(crate) const SIGMAS: Axis = Axis::Separation(SeparationUnit::Sigma);
/// Rows of one task: each is an integral.
const ROWS_PER_TASK: usize = 4;

/// `one` at a number, or at every number of an array in its shape; `mistaken` is the warning about
/// a number with another unit.
pub(crate) fn over<'py>(
    numbers: &Bound<'py, PyAny>,
    name: &str,
    mistaken: impl Fn(f64) -> Option<String>,
    one: impl Fn(f64) -> Result<f64, ContactError> + Sync,
    raise: impl Fn(ContactError) -> PyErr + Copy,
) -> PyResult<Bound<'py, PyAny>> {
    let py = numbers.py();
    if let Some(number) = scalar(numbers) {
        mistaken(number).map_or(Ok(()), |text| warn(py, &text, 0))?;
        let found = py.detach(|| one(number)).map_err(raise)?;
        return Ok(PyFloat::new(py, found).into_any());
    }
    let numbers = floats(numbers, name)?.readonly();
    let given = numbers.as_slice()?;
    // Single numbers of an array may be small: the largest shows the unit.
    let largest = given.iter().copied().fold(0.0, f64::max);
    mistaken(largest).map_or(Ok(()), |text| warn(py, &text, 0))?;
    let run = |range: Range<usize>| -> Result<Vec<f64>, ContactError> {
        given[range].iter().map(|number| one(*number)).collect()
    };
    let mut values = Vec::with_capacity(given.len());
    run_stretches(py, &*pool(None)?, given.len(), ROWS_PER_TASK, run, |found| {
        values.extend(found.map_err(raise)?);
        Ok(true)
    })?;
    Ok(PyArray1::from_vec(py, values).reshape(numbers.shape())?.into_any())
}
