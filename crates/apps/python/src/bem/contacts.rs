//! Contacts of a scan under loads, and its sealing pressures.

use asperity::bem::LoadCase;
use asperity_answer::{Press, Sheet, sealing};
use numpy::PyArray1;
use pyo3::prelude::*;

use super::scan::{Arguments, Pressed};
use crate::ask::long::run_interruptible;
use crate::convert::Quantities;
use crate::model::engine::without;
use crate::tables::{Table, table, warn_of};

/// The package's `Table`; pressures and gaps of all pixels, if kept; rows, columns of the scan.
type Contacts<'py> = (Table<'py>, Option<[Bound<'py, PyArray1<f64>>; 2]>, [usize; 2]);

/// Solves contacts at mean pressures or loads.
#[pyfunction]
pub(crate) fn bem<'py>(
    py: Python<'py>,
    pressed: Arguments<'py>,
    given: (String, Vec<f64>),
    keep: bool,
    quantities: Option<Quantities>,
) -> PyResult<Contacts<'py>> {
    let quantities = quantities.map_or(vec![], |quantities| quantities.0);
    let Pressed { bem, file } = Pressed::new(pressed)?;
    let (name, values) = given;
    let area = if name == "load" { file.scene.nominal_area } else { 1.0 };
    let all: Vec<_> = values.iter().map(|value| LoadCase::MeanPressure(value / area)).collect();
    let press = Press { keep, ..Press::new(&file, &bem, &all, &quantities) };
    let mut sheet = Sheet::default();
    let solved = run_interruptible(py, |stop| press.solve(&mut sheet, stop))?;
    let mut solved = solved.map_err(|error| without(&sheet, error))?.into_iter();
    warn_of(py, &file, &sheet)?;
    let pixels = bem.map().heights().len();
    let missing = || vec![f64::NAN; pixels];
    let mut maps = [vec![], vec![]];
    for row in sheet.rows.iter().filter(|_| keep) {
        // A load without a solution has blanks.
        let is_solved = row[2].number().is_some();
        let solution = is_solved.then(|| solved.next()).flatten();
        let of = solution.map_or_else(|| [missing(), missing()], |s| [s.pressures, s.gaps]);
        maps.iter_mut().zip(of).for_each(|(maps, map)| maps.extend(map));
    }
    let maps = keep.then(|| maps.map(|map| PyArray1::from_vec(py, map)));
    Ok((table(py, &sheet)?, maps, bem.map().shape()))
}

/// Sealing pressures along x and y over samples of the surface.
#[pyfunction]
pub(crate) fn sealing_pressure<'py>(
    py: Python<'py>,
    pressed: Arguments<'py>,
    samples: usize,
) -> PyResult<Table<'py>> {
    let Pressed { bem, file } = Pressed::new(pressed)?;
    let mut sheet = Sheet::default();
    let found =
        run_interruptible(py, |stop| sealing((&file, &bem), samples, &mut sheet, stop).map(drop))?;
    found.map_err(|error| without(&sheet, error))?;
    warn_of(py, &file, &sheet)?;
    table(py, &sheet)
}
