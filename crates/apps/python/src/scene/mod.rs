//! `Scene`: the contact of two bodies, as described by a scene file.

pub(crate) mod arguments;

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use asperity::{Code, ContactError, HeightDistribution, Quantity};
use asperity_scene::{Bodies, Keys, key_of_input};
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict, PyTuple};

use crate::convert::numbers::{in_si, number};
use crate::convert::{Object, Quantities, object, refused, value_error, warn, warn_of_ranges};
use crate::reading::found;
use crate::records::{self, instance};
use arguments::{KeyValue, heights_key, inputs, keys_of};

/// For each number with a range whether each combination of ends has its upper end.
type Uppers = BTreeMap<String, Vec<bool>>;

/// Two bodies, their equivalent rough surface, and the nominal area of contact.
///
/// Numbers are in SI units, or texts with their unit, as "100 mm2".
///
/// Parameters
/// ----------
/// interface : Interface
///     The two bodies.
/// surface : Surface or dict
///     The equivalent rough surface, or the keys of the section [surface] of a scene file, as
///     ``{"ra": "0.8 um", "finish": "ground"}``: such a surface is known within ranges, and
///     ``asperity.ranges`` gives answers on it.
/// nominal_area : float or str
///     The apparent area of contact [m^2], above 0, of flat bodies.
/// heights : "gaussian", "exponential", {"skewness": s} or (heights, densities)
///     The distribution of the asperity heights. A skewness from -1 to 2 stands for a Weibull
///     density. A table has heights [m], ascending, and the density there [1/m]: linear between its
///     points, 0 outside; heights count from the table's own mean. By default those of ``surface``,
///     or Gaussian ones; likewise of the next two.
/// separation_from : "asperity-mean" or "surface-mean"
///     The plane of separation 0: the mean of the asperity heights (for exponential heights the
///     lowest asperity), or the mean plane of the surface.
/// mean_plane_offset : float, optional
///     Measured height of the mean of the asperity heights above the mean plane of the surface [m];
///     by default of the table of heights, or of an isotropic Gaussian surface.
/// options : dict, optional
///     Options of the models, as in the section [options] of a scene file.
/// accept : sequence of str
///     Codes of warnings that are not emitted, as "few-contacts"; each warning begins with its code.
/// curvature : dict, optional
///     Curved bodies, in the place of the nominal area: the keys of the section [curvature] of a
///     scene file, as ``{"radius": "10 mm"}`` or ``{"radius_x": 0.46, "radius_y": 0.3}``. Models
///     then answer under loads and at approaches.
///
/// Examples
/// --------
/// >>> import asperity
/// >>> interface = asperity.Interface(116e9, 0.31, hardness=1.12e9)
/// >>> scene = asperity.Scene(interface, asperity.Surface(3.6e-4, 1.1e8, 1e-6), nominal_area=3e-5)
/// >>> round(scene.plasticity_index, 2)
/// 5.98
/// >>> scene.replace(hardness="2.24 GPa").interface.hardness
/// 2240000000.0
#[pyclass(frozen, name = "Scene", module = "asperity")]
pub(crate) struct SceneFile(pub(crate) Arc<asperity_scene::SceneFile>);

#[pymethods]
impl SceneFile {
    #[new]
    #[pyo3(
        signature = (
            interface, surface, nominal_area=None, heights=None, separation_from=None,
            mean_plane_offset=None, options=None, accept=vec![], curvature=None
        ),
        text_signature = "(interface, surface, nominal_area=None, heights=None, separation_from=None, mean_plane_offset=None, options=None, accept=(), curvature=None)"
    )]
    #[expect(clippy::too_many_arguments, reason = "the signature in Python")]
    fn new(
        interface: &Object<'_>,
        surface: &Object<'_>,
        nominal_area: Option<&Object<'_>>,
        heights: Option<&Object<'_>>,
        separation_from: Option<&str>,
        mean_plane_offset: Option<&Object<'_>>,
        options: Option<BTreeMap<String, KeyValue>>,
        accept: Vec<String>,
        curvature: Option<BTreeMap<String, KeyValue>>,
    ) -> PyResult<Self> {
        let mut of_surface = match surface.extract::<BTreeMap<_, KeyValue>>() {
            Ok(keys) => keys_of(keys),
            Err(_) => {
                records::surface_keys(surface)?.into_iter().map(|(k, x)| (k, x.into())).collect()
            }
        };
        let offset = mean_plane_offset.map(|given| number("Scene", "mean_plane_offset", given));
        for (key, value) in [
            ("heights", heights.map(heights_key).transpose()?),
            ("separation_from", separation_from.map(Into::into)),
            ("mean_plane_offset", offset.transpose()?.map(Into::into)),
        ] {
            let Some(value) = value else { continue };
            if of_surface.insert(key.into(), value).is_some() {
                let reason = format!("Scene: {key} is given twice, in surface and beside it");
                return Err(PyTypeError::new_err(reason));
            }
        }
        let of_pair = instance("interface", interface)?;
        let bodies = Bodies::of(records::bodies(interface)?, of_pair);
        let area = nominal_area.map(|given| number("Scene", "nominal_area", given)).transpose()?;
        let options = keys_of(options.unwrap_or_default());
        let sections: [(_, asperity_scene::OptionValue); 3] = [
            ("surface", of_surface.into()),
            ("options", options.into()),
            ("accept", accept.into()),
        ];
        let shape = curvature.map(|keys| ("curvature", keys_of(keys).into()));
        let area = area.map(|area| ("nominal_area", area.into()));
        let keys = sections.into_iter().chain(area).chain(shape);
        let keys = keys.map(|(name, value)| (name.to_string(), value)).collect();
        let made = asperity_scene::SceneFile::with_keys(&bodies, keys);
        Ok(Self(Arc::new(made.map_err(value_error)?)))
    }

    /// Reads a scene file and the files it names; warnings of the codes in ``accept`` are not
    /// emitted.
    #[staticmethod]
    #[pyo3(signature = (path, accept=vec![]), text_signature = "(path, accept=())")]
    fn from_toml(py: Python<'_>, path: PathBuf, accept: Vec<String>) -> PyResult<Self> {
        found(&path)?;
        Self::read(py, py.detach(|| asperity_scene::load(&path)), &accept)
    }

    /// Reads a scene from the text of a scene file; relative paths in it begin at ``directory``.
    #[staticmethod]
    #[pyo3(
        signature = (text, directory=PathBuf::from("."), accept=vec![]),
        text_signature = "(text, directory='.', accept=())"
    )]
    fn parse(
        py: Python<'_>,
        text: &str,
        directory: PathBuf,
        accept: Vec<String>,
    ) -> PyResult<Self> {
        Self::read(py, py.detach(|| asperity_scene::parse(text, &directory)), &accept)
    }

    /// The two bodies.
    #[getter]
    fn interface<'py>(&self, py: Python<'py>) -> PyResult<Object<'py>> {
        let written = self.0.spec.bodies.interface().map_err(refused)?;
        records::interface(py, &written, self.0.bodies())
    }

    /// The equivalent rough surface, in the middle of its ranges.
    #[getter]
    fn surface<'py>(&self, py: Python<'py>) -> PyResult<Object<'py>> {
        records::surface(py, &self.0.scene.surface, self.0.roughness())
    }

    /// The apparent area of contact [m^2]; ``ValueError`` of curved bodies, which have none.
    #[getter]
    fn nominal_area(&self) -> PyResult<f64> {
        self.0.need_flat().map_err(value_error)?;
        Ok(self.0.scene.nominal_area)
    }

    /// The numbers of curved bodies in m, by their keys; None of flat bodies.
    #[getter]
    fn curvature<'py>(&self, py: Python<'py>) -> PyResult<Option<Object<'py>>> {
        let keys = self.0.spec.curvature.and_then(|bodies| Keys::try_from(bodies).ok());
        keys.map(|keys| object(py, &keys)).transpose()
    }

    /// The distribution of the asperity heights: its name, its skewness, or a table.
    #[getter]
    fn heights<'py>(&self, py: Python<'py>) -> PyResult<Object<'py>> {
        match (self.0.table(), &self.0.scene.heights) {
            (Some(table), _) => {
                let (z, density): (Vec<f64>, Vec<f64>) = table.points().iter().copied().unzip();
                (PyTuple::new(py, z)?, PyTuple::new(py, density)?).into_bound_py_any(py)
            }
            (None, HeightDistribution::Weibull(heights)) => {
                Ok([("skewness", heights.skewness())].into_py_dict(py)?.into_any())
            }
            (None, heights) => heights.name().into_bound_py_any(py),
        }
    }

    /// The plane of separation 0.
    #[getter]
    fn separation_from<'py>(&self, py: Python<'py>) -> PyResult<Object<'py>> {
        object(py, &self.0.spec.separation_from)
    }

    /// Height of the mean of the asperity heights above the mean plane [m], if given.
    #[getter]
    fn mean_plane_offset(&self) -> Option<f64> {
        // The mean of a table is derived, not given.
        let of_pair = self.0.spec.surface.mean_plane_offset;
        let alone = || self.0.scene.mean_plane_offset.filter(|_| self.0.table().is_none());
        if self.0.scene.pair.is_some() { of_pair } else { alone() }
    }

    /// The options that differ from the defaults.
    #[getter]
    fn options<'py>(&self, py: Python<'py>) -> PyResult<Object<'py>> {
        object(py, &self.0.spec.options.changed())
    }

    /// Codes of warnings that are not emitted.
    #[getter]
    fn accept<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.0.spec.accept.iter().map(|code| code.name()))
    }

    /// A copy with other numbers, by the names of a scene file: that of the file with these numbers
    /// in the place of those written. Their order does not matter.
    ///
    /// Of a scene with bodies, hardness, youngs_modulus and so on are those of both bodies, and
    /// body1_hardness that of one. Numbers of a surface are those of the first of two (of both
    /// where the counterface is "same", until it has a number of its own), and counterface_m0 and
    /// so on those of the second: as written, so that a plasticity_index stays where
    /// asperity_height_std or hardness changes, or m0 where m2 does.
    #[pyo3(signature = (**numbers))]
    fn replace(&self, numbers: Option<BTreeMap<String, Object<'_>>>) -> PyResult<Self> {
        let numbers = numbers.unwrap_or_default();
        let values = numbers.iter().map(|(name, given)| number("Scene", name, given));
        let inputs = inputs(&self.0, numbers.keys())?;
        let values = inputs.into_iter().zip(values.collect::<PyResult<Vec<_>>>()?);
        Ok(Self(Arc::new(self.0.with_inputs(values).map_err(refused)?)))
    }

    /// The scene with every number that is known within a range at its "lower" or "upper" end, or
    /// in the "middle", where answers in single numbers are calculated.
    fn at(&self, end: &str) -> PyResult<Self> {
        Ok(Self(Arc::new(self.0.taken_at(end).map_err(value_error)?.0)))
    }

    /// One asperity of the surface with every input resolved.
    #[getter]
    fn asperity<'py>(&self, py: Python<'py>) -> PyResult<Object<'py>> {
        records::record(py, &self.0.scene.asperity().map_err(refused)?)
    }

    /// The square root of height_std over the critical interference.
    #[getter]
    fn plasticity_index(&self) -> PyResult<f64> {
        self.0.scene.plasticity_index().map_err(refused)
    }

    /// The factors of Patir & Cheng for the flow of a film, by name, at ratios of the film to the
    /// standard deviation of the heights of both surfaces. One surface faces a smooth one, or its
    /// like with ``pairs=True``. ``ValueError`` outside the range of a fit.
    ///
    /// >>> import asperity
    /// >>> scene = asperity.Scene.parse(asperity.template())
    /// >>> factors = scene.flow_factors([2.0, 3.0], quantities="pressure-flow-factor-x")
    /// >>> [round(x, 4) for x in factors["pressure-flow-factor-x"]]
    /// [0.7063, 0.8323]
    #[pyo3(signature = (lambda_ratio, *, quantities=None, pairs=false))]
    fn flow_factors(
        &self,
        lambda_ratio: Vec<f64>,
        quantities: Option<Quantities>,
        pairs: bool,
    ) -> PyResult<BTreeMap<String, Vec<f64>>> {
        let id = if pairs { "gw-pairs" } else { "gw" };
        let flow = self.0.flow(&id.parse().map_err(refused)?).map_err(value_error)?;
        let all = || Quantity::ALL.into_iter().filter(|one| one.is_flow_factor()).collect();
        let column = |quantity: &Quantity| {
            let at = |film: &f64| Ok(flow.factor(*quantity, *film)?.value());
            let column = lambda_ratio.iter().map(at).collect::<Result<_, ContactError>>();
            Ok((quantity.to_string(), column.map_err(refused)?))
        };
        quantities.map_or_else(all, |names| names.0).iter().map(column).collect()
    }

    /// The ids of the models that this scene allows, from simplest to most complex.
    fn models(&self) -> Vec<String> {
        self.0.models().0.iter().map(|model| model.id().to_string()).collect()
    }

    /// The text of a scene file that reads back exactly, also written to ``path``, if given.
    ///
    /// >>> import asperity
    /// >>> scene = asperity.Scene.parse(asperity.template())
    /// >>> asperity.Scene.parse(scene.to_toml()) == scene
    /// True
    #[pyo3(signature = (path=None))]
    fn to_toml(&self, path: Option<PathBuf>) -> PyResult<String> {
        let text = self.0.to_toml().map_err(value_error)?;
        if let Some(path) = path {
            let reason = |error| format!("{}: cannot be written: {error}", path.display());
            std::fs::write(&path, &text).map_err(|error| value_error(reason(error)))?;
        }
        Ok(text)
    }

    /// The scene in the middle of its ranges, those at points of them, and for each number with a
    /// range whether the points at the ends, which are the first, are at its upper end.
    fn _points(&self) -> PyResult<(Vec<Self>, Uppers)> {
        let points = self.0.points().map_err(refused)?;
        let corners: Vec<Vec<bool>> = points.corners().collect();
        let names = points.unknowns.into_iter().enumerate();
        let names = names.map(|(k, one)| (one.name, corners.iter().map(|all| all[k]).collect()));
        let made = |file| Self(Arc::new(file));
        let scenes = [points.middle].into_iter().chain(points.all);
        Ok((scenes.map(made).collect(), names.collect()))
    }

    /// The values of inputs by name, with numbers in SI units in the place of texts with a unit.
    fn _inputs_in_si<'py>(&self, given: &Bound<'py, PyDict>) -> PyResult<Bound<'py, PyDict>> {
        inputs(&self.0, given.keys().extract::<Vec<String>>()?.iter())?;
        let found = given.copy()?;
        for (name, value) in given {
            let key = key_of_input(name.extract()?);
            if let Some(unit) = asperity_scene::unit_of(key) {
                found.set_item(&name, in_si(&value, unit, key)?)?;
            }
        }
        Ok(found)
    }

    /// Warns where numbers are known within ranges, of which the middle is taken.
    fn _warn_of_ranges(&self, py: Python<'_>) -> PyResult<()> {
        warn_of_ranges(py, &self.0, 1)
    }

    /// The id of the default reference of comparisons.
    fn _usual_reference(&self) -> &'static str {
        asperity::usual_reference(&self.0.scene)
    }

    /// The text of the scene with the statistics of its scans: a file may change under its name.
    fn _identity(&self) -> PyResult<String> {
        let measured = self.0.measured.as_ref().map(|of| &of.statistics);
        Ok(format!("{}{measured:?}", self.to_toml(None)?))
    }

    fn __eq__(&self, other: &Self) -> PyResult<bool> {
        Ok(self._identity()? == other._identity()?)
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: Object<'_>) -> Py<Self> {
        slf
    }

    fn __repr__(&self) -> PyResult<String> {
        Ok(format!("Scene.parse(\"\"\"\n{}\"\"\")", self.to_toml(None)?))
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Object<'py>, (String,))> {
        Ok((slf.get_type().getattr("parse")?, (slf.get().to_toml(None)?,)))
    }
}

impl SceneFile {
    fn read(
        py: Python<'_>,
        read: Result<asperity_scene::SceneFile, asperity_scene::SceneError>,
        accept: &[String],
    ) -> PyResult<Self> {
        let codes = accept.iter().map(|name| Code::named(name)).collect::<Result<Vec<_>, _>>();
        let file = read.map_err(value_error)?.accepting(&codes.map_err(value_error)?);
        file.warnings.iter().try_for_each(|warning| warn(py, warning, 0))?;
        Ok(Self(Arc::new(file)))
    }
}

/// A commented scene file with every key.
#[pyfunction]
pub(crate) fn template() -> &'static str {
    asperity_scene::template()
}
