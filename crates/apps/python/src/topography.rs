//! `Topography`: a measured surface, from heights in memory or from a file.

use std::collections::BTreeMap;
use std::path::PathBuf;

use asperity_scene::{Keys, MeasuredKeys};
use asperity_topography::{
    Alignment, Estimator, Glance, Level, ReadOptions, Statistics, TopographyError,
};
use numpy::{PyArray1, PyArrayLikeDyn, PyArrayMethods};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::convert::{Object, object, value_error, warn};
use crate::reading::{Spacing, found, unit_of, unreadable};
use crate::records::record;
use crate::scene::arguments::{KeyValue, keys_of};

/// What a file of a scan may leave out.
const OPTIONS: [&str; 10] = [
    "unit",
    "pixel_size",
    "max_missing",
    "channel",
    "units",
    "columns",
    "skip_lines",
    "missing",
    "factor",
    "delimiter",
];

/// A measured surface: heights on a regular grid.
///
/// Parameters
/// ----------
/// heights : array_like
///     One or two dimensions, row by row; NaN or masked for missing points.
/// dx : float or str, or two of them
///     Distance between neighbouring points along a row, and along a column: in ``unit``, or as
///     "10 nm".
/// unit : str
///     Unit of heights and of a plain dx: "m", "cm", "mm", "um", "nm", "angstrom", "pm".
/// periodic : bool
///     Whether the surface is repeated beyond its edges.
#[pyclass(frozen, module = "asperity")]
pub(crate) struct Topography(pub(crate) asperity_topography::Topography);

#[pymethods]
impl Topography {
    #[new]
    #[pyo3(signature = (heights, dx, unit, periodic=false))]
    fn new(heights: &Object<'_>, dx: Spacing, unit: &str, periodic: bool) -> PyResult<Self> {
        let masked = heights.py().import("numpy.ma")?.getattr("asarray")?;
        let heights = masked.call1((heights, "float64"))?.call_method1("filled", (f64::NAN,))?;
        let heights: PyArrayLikeDyn<'_, f64> = heights.extract()?;
        let heights = heights.as_array();
        let columns = match heights.shape() {
            [columns] | [_, columns] => *columns,
            other => {
                return Err(value_error(format!(
                    "heights has {} dimensions: one (a profile) or two dimensions were required",
                    other.len()
                )));
            }
        };
        let (unit, heights) = (unit_of(unit)?, heights.iter().copied().collect());
        let made =
            asperity_topography::Topography::in_unit(heights, columns, dx.in_unit(unit), unit);
        Ok(Self(made.map_err(value_error)?.with_periodic(periodic)))
    }

    /// A scan from a file in one of the formats that need no other package; see ``asperity.read``
    /// for the keywords.
    #[staticmethod]
    #[pyo3(signature = (path, **options))]
    fn read(
        py: Python<'_>,
        path: PathBuf,
        options: Option<BTreeMap<String, Option<KeyValue>>>,
    ) -> PyResult<Self> {
        let options = options.unwrap_or_default();
        if let Some(name) = options.keys().find(|name| !OPTIONS.contains(&name.as_str())) {
            let text = format!("read() got an unexpected keyword argument '{name}'");
            return Err(PyTypeError::new_err(text));
        }
        let given = options.into_iter().filter_map(|(name, value)| Some((name, value?)));
        let keys = keys_of(given);
        let options = |keys: Keys, name: &str| {
            keys.try_into::<ReadOptions>().map_err(|error| {
                let text = error.message();
                let needed = text.rsplit_once(", expected ").map_or(text, |(_, needed)| needed);
                value_error(format!("{name}: {} was required", needed.replace('`', "\"")))
            })
        };
        for (name, value) in &keys {
            options(Keys::from_iter([(name.clone(), value.clone())]), name)?;
        }
        let options = options(keys, "options")?;
        found(&path)?;
        let read = py.detach(|| asperity_topography::read(&path, &options));
        Ok(Self(read.map_err(unreadable)?))
    }

    /// A profile from positions and heights in one unit; unequal distances are interpolated.
    #[staticmethod]
    fn from_profile(positions: Vec<f64>, heights: Vec<f64>, unit: &str) -> PyResult<Self> {
        let unit = unit_of(unit)?;
        let made = asperity_topography::Topography::from_profile(positions, heights, unit);
        Ok(Self(made.map_err(value_error)?))
    }

    /// Rows and columns.
    #[getter]
    fn shape(&self) -> (usize, usize) {
        (self.0.rows(), self.0.columns())
    }

    /// Distance between neighbouring points along a row and along a column [m].
    #[getter]
    fn pixel_size(&self) -> (f64, f64) {
        self.0.pixel_size().into()
    }

    /// Choices made in reading, such as the channel of a file with several.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.0.notes().iter().map(ToString::to_string).collect()
    }

    /// Share of the points that are missing.
    #[getter]
    fn missing_share(&self) -> f64 {
        self.0.missing_share()
    }

    /// The heights [m].
    #[getter]
    fn heights<'py>(&self, py: Python<'py>) -> PyResult<Object<'py>> {
        let heights = PyArray1::from_slice(py, self.0.heights());
        Ok(heights.reshape([self.0.rows(), self.0.columns()])?.into_any())
    }

    /// The same surface without its "mean", "plane" or "quadratic" form, by least squares; by
    /// default the plane, for a periodic surface the mean.
    #[pyo3(signature = (form=None))]
    fn level(&self, py: Python<'_>, form: Option<&str>) -> PyResult<Self> {
        let form = self.form(py, form, 0)?;
        self.changed(py, |surface| surface.levelled(form))
    }

    /// The same surface with harmonic heights at missing points: each is the mean of its four
    /// neighbours. Beyond an edge the surface continues along its least-squares plane, or
    /// periodically. At most 5 % of the points are filled.
    fn fill(&self, py: Python<'_>) -> PyResult<Self> {
        self.changed(py, asperity_topography::Topography::fill)
    }

    /// The same surface with harmonic heights in the place of outliers: points outside their
    /// neighbours (5 x 5, in a profile 17) by twice the range of these. Call it before ``filter``
    /// and ``smooth``, which spread outliers.
    fn despiked(&self, py: Python<'_>) -> PyResult<Self> {
        self.changed(py, asperity_topography::Topography::despiked)
    }

    /// The roughness at wavelengths below `cutoff` [m] (Gaussian filter, ISO 16610).
    fn filter(&self, py: Python<'_>, cutoff: f64) -> PyResult<Self> {
        self.changed(py, |surface| surface.filter(cutoff))
    }

    /// The same surface without waves shorter than `cutoff` [m], as noise.
    fn smooth(&self, py: Python<'_>, cutoff: f64) -> PyResult<Self> {
        self.changed(py, |surface| surface.smooth(cutoff))
    }

    /// Whether the surface is repeated beyond its edges.
    #[getter]
    fn periodic(&self) -> bool {
        self.0.is_periodic()
    }

    /// The equivalent rough surface of this surface against another, without levelling: their
    /// moments add.
    fn against<'py>(&self, py: Python<'py>, other: &Self) -> PyResult<Object<'py>> {
        let both = py.detach(|| {
            let [one, two] = [self, other].map(|surface| surface.0.statistics(Estimator::Moments));
            Statistics::combined(&one?, &two?)
        });
        let both = both.map_err(value_error)?;
        both.warnings.iter().try_for_each(|warning| warn(py, warning, 0))?;
        record(py, &both.surface().map_err(value_error)?)
    }

    /// The sum of the heights of this surface and of an aligned one, point by point: against a flat
    /// it has the gap between the two, also for boundary elements. Points of equal row and column
    /// meet or, with ``mirrored``, those of equal row and opposite column, as of two scans taken
    /// from above. Levels and filters are of both.
    #[pyo3(signature = (other, mirrored=false))]
    fn facing(&self, py: Python<'_>, other: &Self, mirrored: bool) -> PyResult<Self> {
        let alignment = if mirrored { Alignment::Mirrored } else { Alignment::AsRead };
        self.changed(py, |surface| surface.facing(&other.0, alignment))
    }

    /// Statistics in SI units: Sq, Ssk, Sku, moments, and asperities by the estimator ("moments" or
    /// "summits"), after levelling ("none", "mean", "plane" or "quadratic"; by default the plane,
    /// for a periodic surface the mean) and, with a cut-off [m], a Gaussian filter.
    #[pyo3(signature = (level=None, estimator="moments", cutoff=None))]
    fn statistics<'py>(
        &self,
        py: Python<'py>,
        level: Option<&str>,
        estimator: &str,
        cutoff: Option<f64>,
    ) -> PyResult<Object<'py>> {
        object(py, &self.found(py, level, estimator, cutoff)?)
    }

    /// The equivalent rough surface of this surface on a flat; see ``statistics``.
    #[pyo3(signature = (level=None, estimator="moments", cutoff=None))]
    fn surface<'py>(
        &self,
        py: Python<'py>,
        level: Option<&str>,
        estimator: &str,
        cutoff: Option<f64>,
    ) -> PyResult<Object<'py>> {
        let found = self.found(py, level, estimator, cutoff)?.surface();
        record(py, &found.map_err(value_error)?)
    }

    /// What decides trust, and parameters of ISO 25178-2, in SI units, as the program's ``surface
    /// --format json`` and ``--report``: form removed, lay and ratio of slopes, long waves on the
    /// shorter side, moments over those at half the resolution, Sa to Spc, the power law of the
    /// radial spectrum, and functional parameters (Sk to Vvv; of a profile Rk to Rmr2, Rz, RSm and
    /// Rdq). After levelling and, with cut-offs [m], Gaussian filters (``smooth`` short, ``cutoff``
    /// long).
    #[pyo3(signature = (level=None, smooth=None, cutoff=None))]
    fn report<'py>(
        &self,
        py: Python<'py>,
        level: Option<&str>,
        smooth: Option<f64>,
        cutoff: Option<f64>,
    ) -> PyResult<Object<'py>> {
        let level = self.form(py, level, 0)?.unwrap_or(Level::usual(self.0.is_periodic()));
        let report = || {
            let surface = self.prepared(Some(level), [smooth, cutoff])?;
            let glance = Glance::new(&self.0, level, [smooth, cutoff], &surface)?;
            Ok((glance, surface.functional()?))
        };
        let found = py.detach(report).map_err(|error: TopographyError| value_error(error))?;
        let numbers = object(py, &found.0)?;
        for found in found.1 {
            numbers.set_item(found.name, found.value)?;
        }
        Ok(numbers)
    }

    /// Writes the surface to an ISO 25178-72 ``.x3p`` file.
    fn to_x3p(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        let bytes = py.detach(|| self.0.x3p()).map_err(value_error)?;
        Ok(std::fs::write(path, bytes)?)
    }

    fn __repr__(&self) -> String {
        let [dx, dy] = self.0.pixel_size();
        format!(
            "<asperity.Topography of {} x {} points, {dx:e} x {dy:e} m apart, {} % missing>",
            self.0.rows(),
            self.0.columns(),
            (1e5 * self.0.missing_share()).round() / 1e3
        )
    }
}

impl Topography {
    /// The form to remove; warns if its removal tilts a periodic surface, at the line `above`
    /// frames up.
    pub(crate) fn form(
        &self,
        py: Python<'_>,
        name: Option<&str>,
        above: usize,
    ) -> PyResult<Option<Level>> {
        let level: Option<Level> = name.map(str::parse).transpose().map_err(value_error)?;
        let tilted = level.and_then(|level| level.tilts(self.0.is_periodic()));
        tilted.map_or(Ok(()), |tilted| warn(py, &tilted, above))?;
        Ok(level)
    }

    fn changed(
        &self,
        py: Python<'_>,
        change: impl FnOnce(
            asperity_topography::Topography,
        ) -> Result<asperity_topography::Topography, TopographyError>
        + Send,
    ) -> PyResult<Self> {
        py.detach(|| change(self.0.clone())).map(Self).map_err(value_error)
    }

    fn found(
        &self,
        py: Python<'_>,
        level: Option<&str>,
        estimator: &str,
        cutoff: Option<f64>,
    ) -> PyResult<Statistics> {
        let level = self.form(py, level, 0)?;
        let statistics = || self.prepared(level, [None, cutoff])?.statistics(estimator.parse()?);
        let found = py.detach(statistics).map_err(value_error)?;
        found.warnings.iter().try_for_each(|warning| warn(py, warning, 0))?;
        Ok(found)
    }

    /// The surface levelled and, with cut-offs, without shorter and longer waves.
    fn prepared(
        &self,
        level: Option<Level>,
        [smooth, filter]: [Option<f64>; 2],
    ) -> Result<asperity_topography::Topography, TopographyError> {
        let mut keys = MeasuredKeys::default();
        (keys.level, keys.smooth, keys.filter) = (level, smooth, filter);
        keys.prepare(self.0.clone())
    }
}
