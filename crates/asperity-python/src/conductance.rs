//! The correlations of thermal contact conductance.

use asperity::joints::conductance::{self, GapRoughness};
use numpy::{PyArray1, ToPyArray};
use pyo3::prelude::*;

use crate::ask::rows::Rows;
use crate::convert::error::value_error;

/// Conductances per area [W/(m^2 K)], relative pressures, and whether the correlation holds at
/// them.
type Correlated<'py> =
    (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<bool>>);

/// A correlation at loads or pressures on scenes, with their roughness or the one given (height_std
/// [m] and mean slope), its range of relative pressures, and the plasticity index of a scene if the
/// correlation is for other contacts.
#[pyfunction]
pub(crate) fn correlated<'py>(
    py: Python<'py>,
    name: &str,
    rows: Rows,
    given: Option<(f64, f64)>,
) -> PyResult<(Correlated<'py>, [f64; 2], Option<String>)> {
    let all = conductance::Correlation::ALL;
    let Some(correlation) = all.into_iter().find(|one| one.id() == name) else {
        let needed = "\"cmy\" or \"mikic\" was required";
        return Err(value_error(format!("correlation is {name:?}: {needed}")));
    };
    let given = given.map(|(height_std, mean_slope)| GapRoughness { height_std, mean_slope });
    let (mut conductances, mut relative, mut holds) = (vec![], vec![], vec![]);
    let mut reason = None;
    for row in 0..rows.len() {
        let found = rows.file_of(row).and_then(|file| {
            let pressure = rows.at(row).pressure(&file.scene).unwrap_or(f64::NAN);
            let roughness = given.unwrap_or_else(|| file.gap_roughness());
            if reason.is_none() {
                reason = correlation.reason_against(&file.scene);
            }
            correlation.at(&file.scene, &roughness, pressure)
        });
        let found = found.map_err(value_error)?;
        conductances.push(found.conductance);
        relative.push(found.relative_pressure);
        holds.push(found.holds);
    }
    let [conductances, relative] = [conductances, relative].map(|column| column.to_pyarray(py));
    Ok(((conductances, relative, holds.to_pyarray(py)), correlation.range(), reason))
}

/// Conductance per area [W/(m^2 K)] of a gas in a gap of mean width ``gap``.
#[pyfunction]
pub(crate) fn gap_conductance(conductivity: f64, gap: f64, gas_parameter: f64) -> PyResult<f64> {
    conductance::gap_conductance(conductivity, gap, gas_parameter).map_err(value_error)
}
