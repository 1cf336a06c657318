//! Fits of scenes to measurements.

use std::path::PathBuf;

use asperity::fit::{DataColumn, FitError, MeasuredTable, rank};
use asperity::{Code, Finding, Severity};
use asperity_answer::Watch;
use asperity_scene::{Free, SceneError, read_measurements};
use pyo3::prelude::*;

use crate::ask::long::run_interruptible;
use crate::convert::{Object, object, value_error, warn, warn_of_ranges, warn_unless};
use crate::model::engine::Engine;
use crate::scene::SceneFile;

/// Columns of measurements, or the name of their file.
#[derive(FromPyObject)]
pub(crate) enum Measurements {
    Columns(Vec<DataColumn>),
    File(PathBuf),
}

/// Models fitted to data, by rising BIC, as dicts.
#[pyfunction]
pub(crate) fn fit<'py>(
    py: Python<'py>,
    scene: &SceneFile,
    data: Measurements,
    free: Vec<String>,
    engines: Vec<Py<Engine>>,
) -> PyResult<Object<'py>> {
    warn_of_ranges(py, &scene.0, 1)?;
    let file = &*scene.0;
    let table = match data {
        Measurements::Columns(columns) => MeasuredTable { columns, lines: vec![] },
        Measurements::File(path) => read_measurements(path).map_err(value_error)?,
    };
    let data = file.data(&table).map_err(value_error)?;
    let free = free.iter().map(|free| free.parse().map_err(value_error));
    let free: Vec<Free> = free.collect::<PyResult<_>>()?;
    let mut fitted = vec![];
    for engine in &engines {
        let (engine, alone) = (engine.get(), engines.len() == 1);
        let model = engine.on(file)?;
        let found =
            run_interruptible(py, |stop| file.fit(&model, &data, &free, &mut |_| stop.step("")))?;
        match found {
            Ok(found) => fitted.push(found),
            Err(SceneError::Fit(FitError::NoStart { reason, .. })) if engine.is_written() => {
                return Err(engine.raise(py, reason));
            }
            Err(error @ SceneError::Fit(FitError::NoStart { .. })) if !alone => {
                let found = Finding::warning(Code::LeftOut, "model", f64::NAN);
                warn_unless(py, &file.spec.accept, &found.fact(format!("left out: {error}")), 1)?;
            }
            Err(error) => return Err(value_error(error)),
        }
    }
    let ranked = rank(fitted);
    let found = file.findings().into_iter().chain(file.findings_of_fits(&ranked));
    let mut warnings = found.filter(|found| found.severity < Severity::Note);
    warnings.try_for_each(|found| warn(py, &found, 1))?;
    object(py, &ranked)
}
