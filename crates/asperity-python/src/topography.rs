//! `Topography`: a measured surface, from heights in memory.

use asperity_topography::{Estimator, LengthUnit, Level, Statistics, TopographyError};
use numpy::{AllowTypeChange, PyArray1, PyArrayLikeDyn, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::{value_error, warn};
use crate::surface::Surface;

/// A measured surface: heights on a regular grid.
///
/// Parameters
/// ----------
/// heights : array_like
///     One or two dimensions, row by row; NaN where a point is missing.
/// dx : float or (float, float)
///     Distance of neighbouring points along a row, and along a column.
/// unit : str
///     Unit of both, heights and dx: "m", "mm", "um", "nm", "angstrom", "pm".
/// periodic : bool
///     Whether the surface goes on beyond its edges.
#[pyclass(frozen, module = "asperity")]
pub(crate) struct Topography(asperity_topography::Topography);

#[derive(FromPyObject)]
enum Spacing {
    Same(f64),
    Two(f64, f64),
}

fn refused(error: TopographyError) -> PyErr {
    value_error(error)
}

impl Topography {
    fn statistics_of(
        &self,
        level: &str,
        estimator: &str,
        cutoff: Option<f64>,
    ) -> Result<Statistics, TopographyError> {
        let (level, estimator): (Level, Estimator) = (level.parse()?, estimator.parse()?);
        let mut surface = self.0.clone().level(level)?;
        if let Some(cutoff) = cutoff {
            surface = surface.filter(cutoff)?;
        }
        surface.statistics(estimator)
    }
}

#[pymethods]
impl Topography {
    #[new]
    #[pyo3(signature = (heights, dx, unit, periodic=false))]
    fn new(
        heights: PyArrayLikeDyn<'_, f64, AllowTypeChange>,
        dx: Spacing,
        unit: &str,
        periodic: bool,
    ) -> PyResult<Self> {
        let heights = heights.as_array();
        let columns = match heights.shape() {
            [columns] | [_, columns] => *columns,
            other => {
                return Err(value_error(format!(
                    "heights has {} dimensions: one (a profile) or two were required",
                    other.len()
                )));
            }
        };
        let unit = unit.parse::<LengthUnit>().map_err(refused)?;
        let pixel_size = match dx {
            Spacing::Same(dx) => [dx, dx],
            Spacing::Two(dx, dy) => [dx, dy],
        };
        let heights = heights.iter().copied().collect();
        let surface = asperity_topography::Topography::in_unit(heights, columns, pixel_size, unit);
        Ok(Self(surface.map_err(refused)?.with_periodic(periodic)))
    }

    /// Rows and columns.
    #[getter]
    fn shape(&self) -> (usize, usize) {
        (self.0.rows(), self.0.columns())
    }

    /// Distance of neighbouring points along a row and along a column [m].
    #[getter]
    fn pixel_size(&self) -> (f64, f64) {
        let [dx, dy] = self.0.pixel_size();
        (dx, dy)
    }

    /// Share of the points that are missing.
    #[getter]
    fn missing_share(&self) -> f64 {
        self.0.missing_share()
    }

    /// The heights [m].
    #[getter]
    fn heights<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let heights = PyArray1::from_slice(py, self.0.heights());
        Ok(heights.reshape([self.0.rows(), self.0.columns()])?.into_any())
    }

    /// What the surface comes to, in SI units: Sq, Ssk, Sku, moments, asperities by the estimator
    /// ("moments" or "summits"), after levelling ("none", "plane" or "quadratic") and, where a
    /// cut-off [m] is given, a Gaussian filter.
    #[pyo3(signature = (level="plane", estimator="moments", cutoff=None))]
    fn statistics<'py>(
        &self,
        py: Python<'py>,
        level: &str,
        estimator: &str,
        cutoff: Option<f64>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let found = py.detach(|| self.statistics_of(level, estimator, cutoff)).map_err(refused)?;
        found.warnings.iter().try_for_each(|warning| warn(py, &warning.to_string()))?;
        let table = PyDict::new(py);
        for (name, value) in [
            ("sq", found.sq),
            ("ssk", found.ssk),
            ("sku", found.sku),
            ("m0", found.m0),
            ("m2", found.m2),
            ("m4", found.m4),
            ("alpha", found.alpha),
            ("asperity_density", found.asperity_density),
            ("asperity_radius", found.asperity_radius),
            ("asperity_height_std", found.asperity_height_std),
            ("beta", found.beta),
            ("beta_z", found.beta_z),
            ("missing_share", found.missing_share),
        ] {
            table.set_item(name, value)?;
        }
        Ok(table)
    }

    /// The equivalent rough surface of this one on a flat.
    #[pyo3(signature = (level="plane", estimator="moments", cutoff=None))]
    fn surface(
        &self,
        py: Python<'_>,
        level: &str,
        estimator: &str,
        cutoff: Option<f64>,
    ) -> PyResult<Surface> {
        let found = py.detach(|| self.statistics_of(level, estimator, cutoff)).map_err(refused)?;
        found.warnings.iter().try_for_each(|warning| warn(py, &warning.to_string()))?;
        Ok(Surface(found.surface()))
    }

    fn __repr__(&self) -> String {
        let [dx, dy] = self.0.pixel_size();
        format!(
            "<asperity.Topography of {} x {} points, {dx:e} x {dy:e} m apart, {:.1} % missing>",
            self.0.rows(),
            self.0.columns(),
            100.0 * self.0.missing_share()
        )
    }
}
