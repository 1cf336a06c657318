//! Values of rows, the separations of loads, and shares.

use asperity::{
    At, Case, Contact, ContactError, Evaluation, Findings, Separation, Share, Sweep, positive,
};
use numpy::PyArray1;
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::ask::advice::check_rows;
use crate::ask::answer::Aspect;
use crate::ask::asked::{Arguments, Asked, Failures, ROWS_PER_TASK, arrays, split};
use crate::convert::axis::Axis;
use crate::convert::{Object, value_error, warn_of_ranges, warning};

/// The model's name on these scenes; quantities of every row, NaN where a row fails, by name; the
/// failures, and the texts of findings.
///
/// `stop` ends the call at the first failure, and `checked` adds the findings of the scenes.
#[pyfunction]
pub(crate) fn answer<'py>(
    py: Python<'py>,
    asked: Arguments<'_>,
    aspect: &str,
    stop: bool,
    checked: bool,
) -> PyResult<(String, Bound<'py, PyDict>, Failures, Vec<String>)> {
    let asked = Asked::new(asked)?;
    let of: Aspect = match aspect {
        "ln" => |found, _| found.ln_value(),
        "error" => Evaluation::bound,
        _ => |found, _| found.value(),
    };
    let answer = asked.answer(py, (of, aspect == "value"), stop)?;
    let Asked { rows, model, request, .. } = &asked;
    let found = py.detach(|| {
        let of_scenes = if checked { check_rows(&asked) } else { Findings::default() };
        let unit = rows.mistaken_unit().into_iter();
        rows.accepted(unit.chain(of_scenes).chain(answer.warnings).collect())
    });
    let texts = found.iter().map(warning);
    let columns = arrays(py, request.quantities.iter().zip(answer.columns))?;
    Ok((model.name().into(), columns, asked.failures(py, answer.failures), texts.collect()))
}

/// The separations that carry the load or pressure of every row, in `unit` and from the scene's
/// plane: the largest, or a list of arrays with `all`, ascending; and the failed rows, with NaN.
#[pyfunction]
pub(crate) fn separations<'py>(
    py: Python<'py>,
    asked: Arguments<'_>,
    unit: Axis,
    all: bool,
    stop: bool,
) -> PyResult<(Object<'py>, Failures)> {
    let asked = Asked::new(asked)?;
    let rows = &asked.rows;
    if let Some(file) = rows.one_file() {
        // Curved bodies have an approach, a quantity.
        file.need_flat().map_err(value_error)?;
        warn_of_ranges(py, file, 1)?;
    }
    let of = |contact: &dyn Contact, row, found| unit.of(found, rows.datum(row), contact.scene());
    if all {
        // All separations of a load take long.
        let (found, failed) = asked.each(py, ROWS_PER_TASK / 8, stop, |contact, row| {
            let found = contact.separations_at(load(contact, rows.at(row))?)?;
            found.into_iter().map(|found| of(contact, row, found)).collect::<Result<Vec<_>, _>>()
        })?;
        let found = found.into_iter().map(|row| PyArray1::from_vec(py, row.unwrap_or_default()));
        let found = found.collect::<Vec<_>>().into_bound_py_any(py)?;
        return Ok((found, asked.failures(py, failed)));
    }
    let (found, failed) = if rows.one_scene().is_some() {
        asked.each(py, ROWS_PER_TASK, stop, |contact, row| {
            of(contact, row, contact.separation(rows.at(row))?)
        })?
    } else {
        let sweep = Sweep::new(&asked.model, &asked.request.quantities, asked.request.tolerance);
        let one = |(row, case, found): (usize, Option<Case>, Result<f64, ContactError>)| {
            let found = found?;
            case.map_or(Ok(found), |case| {
                let scene = asked.model.scene_of(&case.scene)?;
                Ok(unit.of(Separation::sigmas(found), rows.datum(row), &scene)?)
            })
        };
        let swept = |cases: &[Case]| sweep.separations(cases);
        split(py, (rows.len(), ROWS_PER_TASK), stop, |range| {
            rows.evaluate(range, swept).map(one).collect()
        })?
    };
    let found = found.into_iter().map(|row| row.unwrap_or(f64::NAN)).collect();
    Ok((PyArray1::from_vec(py, found).into_any(), asked.failures(py, failed)))
}

/// The load at a place.
fn load(contact: &dyn Contact, at: At) -> Result<f64, ContactError> {
    match at {
        At::Load(load) => Ok(load),
        At::Pressure(pressure) => {
            Ok(positive("pressure", pressure)? * contact.scene().nominal_area)
        }
        at => Err(contact.unsupported(&format!("the load at {at}"))),
    }
}

/// The share of every part of the law in the quantity of every row, by the part's name.
#[pyfunction]
pub(crate) fn shares<'py>(py: Python<'py>, asked: Arguments<'py>) -> PyResult<Bound<'py, PyDict>> {
    let asked = Asked::new(asked)?;
    let (rows, quantity) = (&asked.rows, asked.request.quantities[0]);
    let one = |contact: &dyn Contact, row| contact.shares_at(quantity, rows.at(row));
    let (found, failed) = asked.each(py, ROWS_PER_TASK, true, one)?;
    if let Some((_, error)) = failed.into_iter().next() {
        return Err(asked.raise(py, error));
    }
    let mut columns: Vec<(String, Vec<f64>)> = vec![];
    for (shares, row) in found.into_iter().zip(0..) {
        for Share { name, share, .. } in shares.into_iter().flatten() {
            let known = columns.iter().position(|(column, _)| *column == name);
            let place = known.unwrap_or_else(|| {
                columns.push((name.into(), vec![0.0; rows.len()]));
                columns.len() - 1
            });
            columns[place].1[row] = share;
        }
    }
    arrays(py, columns)
}
