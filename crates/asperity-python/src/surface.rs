//! `Surface`: the equivalent rough surface.

use asperity::ProfileMoments;
use pyo3::prelude::*;

use crate::bodies::{Interface, named};
use crate::error::refused;

/// Asperities of one radius on a nominally flat surface.
///
/// Parameters
/// ----------
/// asperity_radius : float
///     R [m], above 0.
/// asperity_density : float
///     Asperities per area [1/m^2], above 0.
/// asperity_height_std : float
///     Standard deviation of the asperity heights [m], above 0; not that of the surface heights.
///
/// Examples
/// --------
/// >>> import asperity
/// >>> surface = asperity.Surface(2e-4, 2e8, 1e-6)
/// >>> round(surface.roughness_parameter, 6)
/// 0.04
#[pyclass(frozen, eq, module = "asperity")]
#[derive(PartialEq)]
pub(crate) struct Surface(pub(crate) asperity::Surface);

#[pymethods]
impl Surface {
    #[new]
    fn new(
        asperity_radius: f64,
        asperity_density: f64,
        asperity_height_std: f64,
    ) -> PyResult<Self> {
        let surface =
            asperity::Surface::new(asperity_radius, asperity_density, asperity_height_std);
        surface.check().map_err(|e| refused(&e))?;
        Ok(Self(surface))
    }

    /// From the plasticity index, the roughness parameter (density times radius times height_std),
    /// the standard deviation of the asperity heights [m] and the interface.
    #[staticmethod]
    fn from_plasticity_index(
        plasticity_index: f64,
        roughness_parameter: f64,
        asperity_height_std: f64,
        interface: &Interface,
    ) -> PyResult<Self> {
        asperity::Surface::from_plasticity_index(
            plasticity_index,
            roughness_parameter,
            asperity_height_std,
            &interface.0,
        )
        .map(Self)
        .map_err(|e| refused(&e))
    }

    /// From the spectral moments of profiles of an isotropic Gaussian surface: averages of z^2
    /// [m^2], z'^2 and z''^2 [1/m^2].
    #[staticmethod]
    fn from_moments(m0: f64, m2: f64, m4: f64) -> PyResult<Self> {
        let moments = ProfileMoments { m0, m2, m4 };
        asperity::Surface::from_moments(&moments).map(Self).map_err(|e| refused(&e))
    }

    /// From radius [m], density [1/m^2] and the standard deviation of the surface heights [m].
    #[staticmethod]
    fn from_surface_std(
        asperity_radius: f64,
        asperity_density: f64,
        surface_height_std: f64,
    ) -> PyResult<Self> {
        asperity::Surface::from_surface_std(asperity_radius, asperity_density, surface_height_std)
            .map(Self)
            .map_err(|e| refused(&e))
    }

    /// R [m].
    #[getter]
    fn asperity_radius(&self) -> f64 {
        self.0.asperity_radius
    }

    /// Asperities per area [1/m^2].
    #[getter]
    fn asperity_density(&self) -> f64 {
        self.0.asperity_density
    }

    /// Standard deviation of the asperity heights [m].
    #[getter]
    fn asperity_height_std(&self) -> f64 {
        self.0.asperity_height_std
    }

    /// Density times radius times height_std; 0.03 to 0.06 for classic surfaces.
    #[getter]
    fn roughness_parameter(&self) -> f64 {
        self.0.roughness_parameter()
    }

    /// How far the mean of the asperity heights lies above the mean plane of the surface [m].
    #[getter]
    fn mean_plane_offset(&self) -> f64 {
        self.0.mean_plane_offset()
    }

    pub(crate) fn __repr__(&self) -> String {
        let Self(s) = self;
        format!(
            "Surface({})",
            named(&[
                ("asperity_radius", Some(s.asperity_radius)),
                ("asperity_density", Some(s.asperity_density)),
                ("asperity_height_std", Some(s.asperity_height_std)),
            ])
        )
    }

    fn __getnewargs__(&self) -> (f64, f64, f64) {
        let s = &self.0;
        (s.asperity_radius, s.asperity_density, s.asperity_height_std)
    }
}
