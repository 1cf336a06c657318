//! Partial slip of a scan in shear.

use asperity::bem::Bem;
use asperity::joints::UnloadingLaw;
use asperity::{Model, Tolerance};
use asperity_answer::{Amplitude, Sheet, Slip, Subject};
use numpy::PyArray1;
use pyo3::prelude::*;

use super::scan::{Arguments, Pressed};
use crate::ask::long::run_interruptible;
use crate::convert::axis::Axis;
use crate::convert::value_error;
use crate::tables::{Table, table, warn_of};

/// The package's `Table`, the state of each pixel, rows and columns of the scan.
type Cycle<'py> = (Table<'py>, Bound<'py, PyArray1<f64>>, [usize; 2]);

/// The loop of a cycle of this amplitude \[m\] on a scan under a load or pressure, and
/// whether each pixel slips (1) or sticks (2) at the amplitude.
#[pyfunction]
pub(crate) fn bem_slip<'py>(
    py: Python<'py>,
    pressed: Arguments<'py>,
    given: (Axis, f64),
    friction: f64,
    cycle: (f64, usize),
) -> PyResult<Cycle<'py>> {
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
    Ok((table(py, &sheet)?, PyArray1::from_vec(py, states), pixels))
}
