//! The correlations of thermal contact conductance.

use asperity::joints::conductance;
use pyo3::prelude::*;

use crate::convert::error::value_error;
use crate::scene::SceneFile;

/// Conductances per area [W/(m^2 K)], relative pressures, and whether the correlation holds at
/// them.
type Correlated = (Vec<f64>, Vec<f64>, Vec<bool>);

/// A correlation at pressures, its range of relative pressures, and the plasticity index of the
/// scene if the correlation is for other contacts.
#[pyfunction]
pub(crate) fn correlated(
    name: &str,
    scene: &SceneFile,
    pressures: Vec<f64>,
) -> PyResult<(Correlated, [f64; 2], Option<f64>)> {
    let all = conductance::Correlation::ALL;
    let Some(correlation) = all.into_iter().find(|one| one.id() == name) else {
        let needed = "\"cmy\" or \"mikic\" was required";
        return Err(value_error(format!("correlation is {name:?}: {needed}")));
    };
    let (file, roughness) = (&scene.0, scene.0.gap_roughness());
    let mut columns = Correlated::default();
    for pressure in pressures {
        let found = correlation.at(&file.scene, &roughness, pressure).map_err(value_error)?;
        columns.0.push(found.conductance);
        columns.1.push(found.relative_pressure);
        columns.2.push(found.holds);
    }
    Ok((columns, correlation.range(), correlation.foreign(&file.scene)))
}

/// Conductance per area [W/(m^2 K)] of a gas in a gap of mean width ``gap``.
#[pyfunction]
pub(crate) fn gap_conductance(conductivity: f64, gap: f64, gas_parameter: f64) -> PyResult<f64> {
    conductance::gap_conductance(conductivity, gap, gas_parameter).map_err(value_error)
}
