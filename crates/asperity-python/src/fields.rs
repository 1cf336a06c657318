//! The dataclasses `Body`, `Interface`, `Surface` and `Asperity` of the package, and the library's structs.

use asperity::ProfileMoments;
use pyo3::prelude::*;

use crate::error::{refused, warn};

/// A struct of the library: read from the attributes of the dataclass of its name, and given back
/// as a dict of its arguments.
macro_rules! fields {
    ($name:ident, $empty:expr, $($field:ident: $type:ty),+) => {
        #[derive(Clone, Copy, FromPyObject, IntoPyObject)]
        pub(crate) struct $name {
            $($field: $type),+
        }

        impl From<$name> for asperity::$name {
            fn from(given: $name) -> Self {
                let mut found = $empty;
                $(found.$field = given.$field;)+
                found
            }
        }

        impl From<asperity::$name> for $name {
            fn from(found: asperity::$name) -> Self {
                Self { $($field: found.$field),+ }
            }
        }
    };
}

fields!(Body, asperity::Body::new(1.0, 0.0, 1.0),
    youngs_modulus: f64, poissons_ratio: f64, hardness: Option<f64>, yield_strength: Option<f64>,
    thermal_conductivity: Option<f64>, electrical_resistivity: Option<f64>);
fields!(Interface, asperity::Interface::new(1.0, 0.0, 1.0),
    equivalent_modulus: f64, poissons_ratio: f64, hardness: Option<f64>,
    yield_strength: Option<f64>, equivalent_shear_modulus: Option<f64>,
    pressure_factor: Option<f64>, thermal_conductivity: Option<f64>,
    electrical_resistivity: Option<f64>, work_of_adhesion: Option<f64>);
fields!(Surface, asperity::Surface::new(1.0, 1.0, 1.0),
    asperity_radius: f64, asperity_density: f64, asperity_height_std: f64);
fields!(Asperity, NO_ASPERITY,
    equivalent_modulus: f64, equivalent_shear_modulus: Option<f64>, poissons_ratio: f64,
    hardness: Option<f64>, yield_strength: Option<f64>, pressure_factor: f64, radius: f64,
    work_of_adhesion: Option<f64>);

/// To be filled.
const NO_ASPERITY: asperity::Asperity = asperity::Asperity {
    equivalent_modulus: 0.0,
    equivalent_shear_modulus: None,
    poissons_ratio: 0.0,
    hardness: None,
    yield_strength: None,
    pressure_factor: 0.0,
    work_of_adhesion: None,
    radius: 0.0,
};

/// The same body in doubles, if every number is in its range.
#[pyfunction]
pub(crate) fn checked_body(body: Body) -> PyResult<Body> {
    asperity::Interface::against_rigid(&body.into()).map_err(refused)?;
    Ok(body)
}

/// The same interface in doubles, if every number is in its range.
#[pyfunction]
pub(crate) fn checked_interface(interface: Interface) -> PyResult<Interface> {
    asperity::Interface::from(interface).check().map_err(refused)?;
    Ok(interface)
}

/// The same surface in doubles, if every number is in its range.
#[pyfunction]
pub(crate) fn checked_surface(surface: Surface) -> PyResult<Surface> {
    asperity::Surface::from(surface).check().map_err(refused)?;
    Ok(surface)
}

/// The interface of two bodies; of one on a rigid body, if there is no second.
#[pyfunction]
pub(crate) fn interface_of(
    py: Python<'_>,
    first: Body,
    second: Option<Body>,
) -> PyResult<Interface> {
    let (first, second) = (first.into(), second.map(Into::into));
    let interface = match &second {
        Some(second) => asperity::Interface::between(&first, second),
        None => asperity::Interface::against_rigid(&first),
    };
    let interface = interface.map_err(refused)?;
    // What the interface shows as well is said when it is used.
    if interface.findings().is_empty() {
        let bodies = [Some(first), second].into_iter().flatten();
        let mut odd = bodies.flat_map(|body: asperity::Body| body.findings());
        odd.try_for_each(|finding| warn(py, finding, 1))?;
    }
    Ok(interface.into())
}

/// The roughness parameter, and how far the mean of the asperity heights lies above the mean plane.
#[pyfunction]
pub(crate) fn roughness_of(surface: Surface) -> (f64, f64) {
    let surface = asperity::Surface::from(surface);
    (surface.roughness_parameter(), surface.mean_plane_offset())
}

/// By plasticity index, roughness parameter and height_std on an interface.
#[pyfunction]
pub(crate) fn surface_from_plasticity_index(
    index: f64,
    parameter: f64,
    height_std: f64,
    interface: Interface,
) -> PyResult<Surface> {
    let interface = interface.into();
    let made = asperity::Surface::from_plasticity_index(index, parameter, height_std, &interface);
    made.map(Into::into).map_err(refused)
}

/// By the spectral moments of profiles.
#[pyfunction]
pub(crate) fn surface_from_moments(m0: f64, m2: f64, m4: f64) -> PyResult<Surface> {
    let made = asperity::Surface::from_moments(&ProfileMoments { m0, m2, m4 });
    made.map(Into::into).map_err(refused)
}

/// By radius, density and the standard deviation of the surface heights.
#[pyfunction]
pub(crate) fn surface_from_std(radius: f64, density: f64, std: f64) -> PyResult<Surface> {
    let made = asperity::Surface::from_surface_std(radius, density, std);
    made.map(Into::into).map_err(refused)
}

/// The critical interference [m] and force [N] of an asperity.
#[pyfunction]
pub(crate) fn critical_of(one: Asperity) -> PyResult<(f64, f64)> {
    let one = asperity::Asperity::from(one);
    Ok((one.critical_interference().map_err(refused)?, one.critical_force().map_err(refused)?))
}
