//! Contacts of a scan under loads, by boundary elements.

use std::collections::BTreeMap;
use std::sync::atomic::Ordering;

use asperity::bem::{LoadCase, Solution};
use asperity::{ContactModel, Findings, Request};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

use super::scan::{Pressed, load_case};
use crate::ask::long::{continue_unless, run_interruptible};
use crate::convert::error::{refused, value_error, warn};
use crate::convert::quantities::Quantities;

/// Numbers of the contacts by name, NaN where a contact failed; pressures and gaps of all pixels,
/// if kept; rows and columns; the reasons of failures by place; the boundary; the area of loads.
type Contacts<'py> = (
    Bound<'py, PyDict>,
    Option<[Bound<'py, PyArray1<f64>>; 2]>,
    [usize; 2],
    BTreeMap<usize, String>,
    &'static str,
    f64,
);

/// The name of a number of a solution, and the number.
type Head = (&'static str, fn(&Solution) -> f64);

/// The numbers of a solution by name; the load still over the area.
const HEADS: [Head; 9] = [
    ("load", |s| s.mean_pressure),
    ("pressure", |s| s.mean_pressure),
    ("area_fraction", |s| s.area),
    ("area_fraction_pixels", |s| s.pixel_area),
    ("plastic_fraction", |s| s.plastic_area),
    ("mean_gap", |s| s.mean_gap),
    ("patches", |s| s.patches.len() as f64),
    ("iterations", |s| s.iterations as f64),
    ("residual", |s| s.residual),
];

/// Solves contacts at mean pressures, loads or mean gaps.
#[pyfunction]
pub(crate) fn bem<'py>(
    scan: (Bound<'py, PyAny>, Option<Bound<'py, PyAny>>, Option<String>),
    given: &str,
    values: Vec<f64>,
    elastic: bool,
    boundary: Option<&str>,
    maps_and_mask: (bool, bool),
    quantities: Option<Quantities>,
) -> PyResult<Contacts<'py>> {
    let (py, (maps, mask)) = (scan.0.py(), maps_and_mask);
    let quantities = quantities.map_or(vec![], |quantities| quantities.0);
    let Pressed { bem, scene: contact } = Pressed::new(&scan, boundary, elastic)?;
    let elements = bem.elements(&contact.interface).map_err(refused)?;
    let area = contact.nominal_area;
    // Refuses what boundary elements or the interface lack before anything is solved.
    let request = Request::new(quantities.iter().copied());
    bem.compile(&contact, &request).map_err(refused)?;
    let all: Vec<LoadCase> =
        values.into_iter().map(|value| load_case(given, value, area)).collect();
    let pixels = bem.map().heights().len();
    let missing = |numbers: usize| vec![f64::NAN; numbers * all.len()];
    let mut maps = maps.then(|| [missing(pixels), missing(pixels)]);
    let mut columns: Vec<Vec<f64>> = vec![missing(1); HEADS.len() + quantities.len()];
    let (mut notes, mut failed, mut failures) = (Findings::default(), None, BTreeMap::new());
    run_interruptible(py, None, |stop| {
        let mut fail = |index, error: PyErr, message| match mask {
            true => drop(failures.insert(index, message)),
            false => {
                // This error is raised, so the other contacts are not needed.
                stop.store(true, Ordering::Relaxed);
                failed.get_or_insert(error);
            }
        };
        elements.solve_each(
            &all,
            |_| continue_unless(stop),
            |index, solution| match solution {
                Ok(solution) => {
                    let (heads, of_joints) = columns.split_at_mut(HEADS.len());
                    for (column, (_, number)) in heads.iter_mut().zip(HEADS) {
                        column[index] = number(&solution);
                    }
                    heads[0][index] *= area;
                    let summary =
                        (!quantities.is_empty()).then(|| elements.summary(&solution, &quantities));
                    for (column, &quantity) in of_joints.iter_mut().zip(&quantities) {
                        match summary.as_ref().map(|summary| summary.evaluate(quantity, &contact)) {
                            Some(Ok(Some(found))) => column[index] = found.value(),
                            Some(Err(error)) => {
                                fail(index, refused(error.clone()), error.to_string())
                            }
                            _ => {}
                        }
                    }
                    let kept = maps.iter_mut().flatten();
                    for (all, map) in kept.zip([&solution.pressures, &solution.gaps]) {
                        all[index * pixels..][..pixels].copy_from_slice(map);
                    }
                    notes.extend(solution.notes);
                }
                Err(error) => fail(index, value_error(&error), error.to_string()),
            },
        );
    })?;
    if let Some(error) = failed {
        return Err(error);
    }
    notes.iter().try_for_each(|note| warn(py, note, 1))?;
    let names = HEADS.iter().map(|(name, _)| (*name).to_string());
    let names = names.chain(quantities.iter().map(|q| q.to_string().replace('-', "_")));
    let arrays = columns.into_iter().map(|column| PyArray1::from_vec(py, column));
    let numbers = names.zip(arrays).into_py_dict(py)?;
    let maps = maps.map(|maps| maps.map(|map| PyArray1::from_vec(py, map)));
    Ok((numbers, maps, bem.map().shape(), failures, bem.continuation().name(), area))
}
