//! What boundary elements press: the scan of a scene, or a topography between two bodies.

use asperity::bem::{Bem, BemOptions, Continuation};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::convert::{Object, value_error, warn_of_ranges, warn_unless};
use crate::records::{instance, type_of};
use crate::scene::SceneFile;
use crate::topography::Topography;

/// A scan as it is pressed.
pub(super) struct Pressed {
    pub(super) bem: Bem,
    /// The scene of the scan, or one of a topography between two bodies, with its area.
    pub(super) file: asperity_scene::SceneFile,
}

/// A surface, the two bodies of a topography, the form to remove, and how the scan is pressed.
pub(super) type Arguments<'py> = (Object<'py>, Option<Object<'py>>, Option<String>, Pressing);

/// What lies beyond the edges, and whether the hardness is ignored.
type Pressing = (Option<String>, bool);

impl Pressed {
    /// The scan of a scene, or a topography with the two bodies and the form to remove.
    pub(super) fn new((surface, interface, level, pressing): Arguments<'_>) -> PyResult<Self> {
        let given = options(pressing)?;
        if let Ok(scene) = surface.cast::<SceneFile>() {
            let own = [("interface", interface.is_some()), ("level", level.is_some())];
            if let Some((name, _)) = own.iter().find(|(_, is_given)| *is_given) {
                let reason = format!("{name} was given beside a scene, which has its own");
                return Err(PyTypeError::new_err(reason));
            }
            warn_of_ranges(surface.py(), &scene.get().0, 1)?;
            return Self::of_scene(surface.py(), (*scene.get().0).clone(), given);
        }
        let Ok(topography) = surface.cast::<Topography>() else {
            let found = type_of(&surface);
            let reason = format!("surface is of type {found}: Topography or Scene was required");
            return Err(PyTypeError::new_err(reason));
        };
        let Some(interface) = interface else {
            let needed = "a Topography has none, pass an asperity.Interface";
            return Err(PyTypeError::new_err(format!("interface is missing: {needed}")));
        };
        let interface = instance("interface", &interface)?;
        let topography = topography.get();
        let level = topography.form(surface.py(), level.as_deref(), 1)?;
        // A plane taken from a periodic surface would add steps.
        let periodic = topography.0.is_periodic() || given.boundary == Some(Continuation::Periodic);
        let scan = topography.0.clone().with_periodic(periodic);
        let levelled = scan.levelled(level).map_err(value_error)?;
        let map = asperity_scene::height_map(&levelled).map_err(|error| {
            match levelled.missing_share() > 0.0 {
                true => value_error(format!("{error}: use Topography.fill()")),
                false => value_error(error),
            }
        })?;
        // Boundary elements use no asperities.
        let none = asperity::Surface::new(1.0, 1.0, 1.0);
        let scene = asperity::Scene::new(interface, none, map.area());
        let file = asperity_scene::SceneFile::from(scene).pressing_scan(levelled);
        Self::of_scene(surface.py(), file, given)
    }

    /// The scan of a scene with these options in front of its own; warns of edges that do not
    /// match.
    fn of_scene(
        py: Python<'_>,
        file: asperity_scene::SceneFile,
        given: BemOptions,
    ) -> PyResult<Self> {
        let file = file.pressing(given);
        let bem = file.bem().map_err(value_error)?;
        bem.note().map_or(Ok(()), |note| warn_unless(py, &file.spec.accept, &note, 1))?;
        Ok(Self { bem, file })
    }
}

/// Options by the names of their values.
fn options((boundary, elastic): Pressing) -> PyResult<BemOptions> {
    let named = |name: String| {
        let required = "\"periodic\", \"periodic-part\" or \"free\" was required";
        let unknown = || value_error(format!("boundary is {name:?}: {required}"));
        Continuation::from_name(&name).ok_or_else(unknown)
    };
    Ok(BemOptions { boundary: boundary.map(named).transpose()?, elastic })
}
