//! The path of unloading of a scan, by boundary elements.

use std::sync::atomic::Ordering;

use asperity::bem::BemError;
use asperity::linspace;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::scan::{Pressed, load_case};
use crate::ask::long::{continue_unless, run_interruptible};
use crate::convert::error::{refused, value_error};

/// Numbers of the contacts by name, the retreat at which contact ends, the boundary, and the area
/// of loads.
type Path<'py> = (Bound<'py, PyDict>, f64, &'static str, f64);

/// Solves the contact at a mean pressure, load or mean gap, and after retreats \[m\] from it: those
/// given, or `points` of them to the end of contact.
#[pyfunction]
pub(crate) fn bem_unloading<'py>(
    scan: (Bound<'py, PyAny>, Option<Bound<'py, PyAny>>, Option<String>),
    given: (&str, f64),
    elastic: bool,
    boundary: Option<&str>,
    retreats: Option<Vec<f64>>,
    points: usize,
) -> PyResult<Path<'py>> {
    let py = scan.0.py();
    let Pressed { bem, scene } = Pressed::new(&scan, boundary, elastic)?;
    let elements = bem.elements(&scene.interface).map_err(refused)?;
    let area = scene.nominal_area;
    let greatest = load_case(given.0, given.1, area);
    let (retreats, end, found) = run_interruptible(py, None, |stop| -> Result<_, BemError> {
        let path = elements.unloading_from(greatest)?;
        let end = path.last_contact();
        let retreats = retreats.unwrap_or_else(|| linspace(0.0, end, points));
        if stop.load(Ordering::Relaxed) {
            return Err(BemError::Cancelled);
        }
        let found = path.at_retreats(&retreats, |_| continue_unless(stop));
        Ok((retreats, end, found.into_iter().collect::<Result<Vec<_>, _>>()?))
    })?
    .map_err(value_error)?;
    let stiffness = found.iter().map(|contact| match &contact.stiffness {
        Some(Ok(stiffness)) => Ok(stiffness * area),
        Some(Err(error)) => Err(value_error(error)),
        None => Ok(f64::NAN),
    });
    let stiffness = stiffness.collect::<PyResult<Vec<_>>>()?;
    let numbers = PyDict::new(py);
    let add = |name, values: Vec<f64>| numbers.set_item(name, PyArray1::from_vec(py, values));
    add("retreat", retreats)?;
    add("load", found.iter().map(|contact| contact.mean_pressure * area).collect())?;
    add("pressure", found.iter().map(|contact| contact.mean_pressure).collect())?;
    add("area_fraction", found.iter().map(|contact| contact.area).collect())?;
    add("mean_gap", found.iter().map(|contact| contact.mean_gap).collect())?;
    add("stiffness", stiffness)?;
    Ok((numbers, end, bem.continuation().name(), area))
}
