//! Values at a number, or at every number of an array in its shape.

use std::ops::Range;

use asperity::ContactError;
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyFloat;

use crate::ask::long::run_stretches;
use crate::convert::Object;
use crate::convert::numbers::{floats, in_si, scalar};

/// A float, or an array of floats.
pub(crate) enum Given<'py> {
    One([f64; 1]),
    Many(PyReadonlyArrayDyn<'py, f64>),
}

impl<'py> Given<'py> {
    /// Reads numbers, or texts with a unit as numbers in an SI unit; and whether they were texts.
    pub(crate) fn read(numbers: &Object<'py>, name: &str, si: &str) -> PyResult<(Self, bool)> {
        if let Some(number) = scalar(numbers) {
            return Ok((Self::One([number]), false));
        }
        let read = in_si(numbers, si, "")?;
        let given = match scalar(&read) {
            Some(number) => Self::One([number]),
            None => Self::Many(floats(&read, name)?.readonly()),
        };
        Ok((given, !read.is(numbers)))
    }

    pub(crate) fn numbers(&self) -> PyResult<&[f64]> {
        match self {
            Self::One(one) => Ok(one),
            Self::Many(array) => Ok(array.as_slice()?),
        }
    }

    /// Columns in the shape of the numbers.
    pub(crate) fn shaped<const N: usize>(
        &self,
        py: Python<'py>,
        columns: [Vec<f64>; N],
    ) -> PyResult<Vec<Object<'py>>> {
        let shaped = |column: Vec<f64>| match self {
            Self::One(_) => {
                Ok(PyFloat::new(py, column.first().copied().unwrap_or(f64::NAN)).into_any())
            }
            Self::Many(array) => {
                Ok(PyArray1::from_vec(py, column).reshape(array.shape())?.into_any())
            }
        };
        columns.into_iter().map(shaped).collect()
    }

    /// `one` at the number, or at every number by its place, `together` of them in a task.
    pub(crate) fn each<const N: usize>(
        &self,
        py: Python<'py>,
        together: usize,
        one: impl Fn(usize, f64) -> Result<[f64; N], ContactError> + Sync,
        raise: impl Fn(ContactError) -> PyErr,
    ) -> PyResult<Vec<Object<'py>>> {
        if let Self::One([number]) = self {
            let found = py.detach(|| one(0, *number)).map_err(raise)?;
            return Ok(found.map(|value| PyFloat::new(py, value).into_any()).into());
        }
        let numbers = self.numbers()?;
        let run = |range: Range<usize>| -> Result<Vec<[f64; N]>, ContactError> {
            range.map(|k| one(k, numbers[k])).collect()
        };
        let mut columns = [(); N].map(|()| Vec::with_capacity(numbers.len()));
        for found in run_stretches(py, (numbers.len(), together), run, Result::is_err)? {
            for row in found.map_err(&raise)? {
                columns.iter_mut().zip(row).for_each(|(column, value)| column.push(value));
            }
        }
        self.shaped(py, columns)
    }
}
