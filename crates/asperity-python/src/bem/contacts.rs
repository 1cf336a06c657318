//! Contacts of a scan under loads, by boundary elements.

use std::collections::BTreeMap;
use std::sync::atomic::Ordering;

use asperity::bem::{ContactSummary, LoadCase, Solution};
use asperity::{ContactModel, Findings, Request};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::scan::{Scan, load_case};
use crate::ask::long::{continue_unless, run_interruptible};
use crate::convert::error::{refused, value_error, warn};
use crate::convert::quantities::Quantities;

/// Numbers of the contacts by name, NaN where a contact failed; pressures and gaps of all pixels,
/// if kept; rows and columns; the reasons of failures by place; the boundary; the area of loads.
type Contacts<'py> = (
    Bound<'py, PyDict>,
    Option<(Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>)>,
    [usize; 2],
    BTreeMap<usize, String>,
    &'static str,
    f64,
);

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
    let scan = Scan::new(&scan.0, scan.1.as_ref(), scan.2.as_deref())?;
    let (bem, interface) = scan.bem(py, boundary, elastic)?;
    bem.note().map_or(Ok(()), |note| warn(py, &note, 1))?;
    let elements = bem.elements(&interface).map_err(refused)?;
    let area = scan.area(&bem);
    let contact = scan.contact(&bem, interface);
    // Refuses what boundary elements or the interface lack before anything is solved.
    let request = Request::new(quantities.iter().copied());
    bem.compile(&contact, &request).map_err(refused)?;
    let all: Vec<LoadCase> =
        values.into_iter().map(|value| load_case(given, value, area)).collect();
    let mut solved: Vec<Option<Solution>> = vec![None; all.len()];
    let mut summaries: Vec<Option<ContactSummary>> = vec![None; all.len()];
    let (mut notes, mut failed, mut failures) = (Findings::default(), None, BTreeMap::new());
    run_interruptible(py, None, |stop| {
        elements.solve_each(
            &all,
            |_| continue_unless(stop),
            |index, solution| match solution {
                Ok(mut solution) => {
                    if !quantities.is_empty() {
                        summaries[index] = Some(elements.summary(&solution, &quantities));
                    }
                    notes.extend(solution.notes.iter().cloned());
                    if !maps {
                        (solution.pressures, solution.gaps) = (vec![], vec![]);
                    }
                    solved[index] = Some(solution);
                }
                Err(error) if mask => {
                    failures.insert(index, error.to_string());
                }
                Err(error) => {
                    // This error is raised, so the other contacts are not needed.
                    stop.store(true, Ordering::Relaxed);
                    failed.get_or_insert(error);
                }
            },
        );
    })?;
    if let Some(error) = failed {
        return Err(value_error(error));
    }
    notes.iter().try_for_each(|note| warn(py, note, 1))?;
    let numbers = PyDict::new(py);
    let add = |name: &str, of: &dyn Fn(&Solution) -> f64| {
        let of = |solution: &Option<Solution>| solution.as_ref().map_or(f64::NAN, of);
        numbers.set_item(name, PyArray1::from_vec(py, solved.iter().map(of).collect()))
    };
    add("load", &|s| s.mean_pressure * area)?;
    add("pressure", &|s| s.mean_pressure)?;
    add("area_fraction", &|s| s.area)?;
    add("area_fraction_pixels", &|s| s.pixel_area)?;
    add("plastic_fraction", &|s| s.plastic_area)?;
    add("mean_gap", &|s| s.mean_gap)?;
    add("patches", &|s| s.patches.len() as f64)?;
    add("iterations", &|s| s.iterations as f64)?;
    add("residual", &|s| s.residual)?;
    for quantity in quantities {
        let mut values = vec![f64::NAN; summaries.len()];
        for (index, (value, summary)) in values.iter_mut().zip(&summaries).enumerate() {
            let Some(summary) = summary else { continue };
            match summary.evaluate(quantity, &contact) {
                Ok(found) => *value = found.map_or(f64::NAN, |found| found.value()),
                Err(error) if mask => {
                    failures.insert(index, error.to_string());
                }
                Err(error) => return Err(refused(error)),
            }
        }
        let name = quantity.to_string().replace('-', "_");
        numbers.set_item(name, PyArray1::from_vec(py, values))?;
    }
    let map = |of: &dyn Fn(&Solution) -> &Vec<f64>| {
        let pixels = bem.map().heights().len();
        let all = PyArray1::zeros(py, solved.len() * pixels, false);
        let mut numbers = all.readwrite();
        for (part, solution) in numbers.as_slice_mut()?.chunks_mut(pixels).zip(&solved) {
            match solution {
                Some(solution) => part.copy_from_slice(of(solution)),
                None => part.fill(f64::NAN),
            }
        }
        drop(numbers);
        PyResult::Ok(all)
    };
    let maps = match maps {
        true => Some((map(&|s| &s.pressures)?, map(&|s| &s.gaps)?)),
        false => None,
    };
    Ok((numbers, maps, bem.map().shape(), failures, bem.continuation().name(), area))
}
