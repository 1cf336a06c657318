//! What boundary elements press: the scan of a scene, or a topography between two bodies.

use asperity::bem::{Bem, Continuation, LoadCase};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::convert::error::value_error;
use crate::records::{Interface, instance, with_article};
use crate::scene::SceneFile;
use crate::topography::Topography;

/// The scan of a scene, or a topography with the two bodies and the form to remove.
pub(super) enum Scan<'a> {
    Scene(&'a asperity_inputs::SceneFile),
    Topography(&'a Topography, asperity::Interface, Option<&'a str>),
}

impl<'a> Scan<'a> {
    pub(super) fn new(
        surface: &'a Bound<'_, PyAny>,
        interface: Option<&Bound<'_, PyAny>>,
        level: Option<&'a str>,
    ) -> PyResult<Self> {
        if let Ok(scene) = surface.cast::<SceneFile>() {
            return match interface {
                None => Ok(Self::Scene(&scene.get().0)),
                Some(_) => Err(PyTypeError::new_err(
                    "interface was given beside a scene, which has its own",
                )),
            };
        }
        let Ok(topography) = surface.cast::<Topography>() else {
            let found = with_article(surface);
            let reason = format!("surface must be a Topography or a Scene, not {found}");
            return Err(PyTypeError::new_err(reason));
        };
        let Some(interface) = interface else {
            let needed = "a Topography has none, pass an asperity.Interface";
            return Err(PyTypeError::new_err(format!("interface is missing: {needed}")));
        };
        let interface = instance::<Interface>("interface", interface)?.get().0;
        Ok(Self::Topography(topography.get(), interface, level))
    }

    pub(super) fn bem(
        &self,
        py: Python<'_>,
        boundary: Option<&str>,
        elastic: bool,
    ) -> PyResult<(Bem, asperity::Interface)> {
        let named = |name: &str| {
            let required = "\"periodic\", \"periodic-part\" or \"free\" was required";
            let unknown = || value_error(format!("boundary is {name:?}: {required}"));
            Continuation::from_name(name).ok_or_else(unknown)
        };
        let boundary = boundary.map(named).transpose()?;
        match self {
            Self::Scene(file) => {
                let bem = file.bem(boundary, elastic).map_err(value_error)?;
                Ok((bem, file.scene.interface))
            }
            Self::Topography(topography, interface, level) => {
                let level = topography.form(py, *level, 1)?;
                // A plane taken from a periodic surface would add steps.
                let declared = topography.0.is_periodic().then_some(Continuation::Periodic);
                let boundary = boundary.or(declared);
                let periodic = [boundary, declared].contains(&Some(Continuation::Periodic));
                let scan = topography.0.clone().with_periodic(periodic);
                let levelled = scan.levelled(level).map_err(value_error)?;
                let map = asperity_inputs::height_map(&levelled).map_err(|error| {
                    match levelled.missing_share() > 0.0 {
                        true => value_error(format!("{error}: use Topography.fill()")),
                        false => value_error(error),
                    }
                })?;
                Ok((Bem::new(map, boundary, elastic), *interface))
            }
        }
    }

    /// The scene whose nominal area and interface quantities use.
    pub(super) fn contact(&self, bem: &Bem, interface: asperity::Interface) -> asperity::Scene {
        match self {
            Self::Scene(file) => file.scene.clone(),
            Self::Topography(..) => {
                // Boundary elements use no asperities.
                let surface = asperity::Surface::new(1.0, 1.0, 1.0);
                asperity::Scene::new(interface, surface, bem.map().area())
            }
        }
    }

    /// The area of the loads: the nominal area of a scene, or that of a topography.
    pub(super) fn area(&self, bem: &Bem) -> f64 {
        match self {
            Self::Scene(file) => file.scene.nominal_area,
            Self::Topography(..) => bem.map().area(),
        }
    }
}

/// A mean gap \[m\], a load \[N\] on `area` \[m^2\] or a pressure \[Pa\], as `given` names it.
pub(super) fn load_case(given: &str, value: f64, area: f64) -> LoadCase {
    match given {
        "gap" => LoadCase::MeanGap(value),
        "load" => LoadCase::MeanPressure(value / area),
        _ => LoadCase::MeanPressure(value),
    }
}
