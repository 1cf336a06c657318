//! Partial slip of a scan in shear.

use asperity::bem::Bem;
use asperity::joints::UnloadingLaw;
use asperity::{Model, Tolerance};
use asperity_answer::{Amplitude, Sheet, Slip, Subject};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::scan::{Arguments, Pressed};
use crate::ask::long::run_interruptible;
use crate::convert::axis::Axis;
use crate::convert::value_error;
use crate::tables::{columns, warn_of};

/// The loop of a cycle of this amplitude \[m\] on a scan under a load or pressure, and
/// whether each pixel slips (1) or sticks (2) at the amplitude. The fields of the package's class,
/// rows and columns.
#[pyfunction]
pub(crate) fn bem_slip<'py>(
    py: Python<'py>,
    pressed: Arguments<'py>,
    given: (Axis, f64),
    friction: f64,
    cycle: (f64, usize),
) -> PyResult<(Bound<'py, PyDict>, [usize; 2])> {
    let Pressed { bem, file } = Pressed::new(pressed)?;
    let (pixels, model) = (bem.map().shape(), Model::new(bem));
    let ((axis, number), (amplitude, points)) = (given, cycle);
    let (at, tolerance) = (axis.at(number, file.spec.separation_from), Tolerance::default());
    let subject = Subject { file: &file, name: "", id: Bem::ID, model: &model, tolerance };
    let slip = Slip { subject, law: UnloadingLaw::Hertz, friction };
    let (mut sheet, cycle) = (Sheet::default(), [Amplitude::Shift(amplitude)]);
    let states =
        run_interruptible(py, |stop| slip.answer(&[at], &cycle, points, &mut sheet, stop))?;
    let states = states.map_err(value_error)?;
    warn_of(py, &file, &sheet)?;
    let fields = columns(py, &sheet)?;
    fields.set_item("states", PyArray1::from_vec(py, states))?;
    Ok((fields, pixels))
}
