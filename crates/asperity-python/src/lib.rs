//! The Python package `asperity`: arguments in, arrays out.
//!
//! The crates of this workspace compute every number. The interpreter is released (`detach`)
//! meanwhile: a model written in Python acquires it on the thread that builds its rules.
//!
//! ```text
//! convert → records → scene → ask, joints, tables, fit
//!                     model ↗
//! ask, scene, topography → bem
//! topography → reading
//! ```

mod ask;
mod bem;
mod convert;
mod fit;
mod joints;
mod model;
mod picture;
mod random_surface;
mod reading;
mod records;
mod scene;
mod tables;
mod topography;

/// The compiled part of the package `asperity`.
#[pyo3::pymodule]
mod _asperity {
    #[pymodule_export]
    use crate::ask::advice::{check, plan, pull_off, recommend};
    #[pymodule_export]
    use crate::ask::contact::Contact;
    #[pymodule_export]
    use crate::ask::values::{answer, corrected, separations, shares};
    #[pymodule_export]
    use crate::bem::contacts::{bem, bem_unloading, truth};
    #[pymodule_export]
    use crate::convert::numbers::{floats, in_si};
    #[pymodule_export]
    use crate::convert::{ContactWarning, NotConverged, UnsupportedFormat};
    #[pymodule_export]
    use crate::fit::fit;
    #[pymodule_export]
    use crate::joints::{JointTable, PartialSlip, Unloading};
    #[pymodule_export]
    use crate::model::engine::{Engine, model_ids, quantities};
    #[pymodule_export]
    use crate::picture::svg;
    #[pymodule_export]
    use crate::random_surface::random_surface;
    #[pymodule_export]
    use crate::records::{
        checked, derived, interface_of, material, materials, moments_of_both, numbers_of,
        surface_of,
    };
    #[pymodule_export]
    use crate::scene::{SceneFile, template};
    #[pymodule_export]
    use crate::tables::{contact_table, correlated, gap_conductance};
    #[pymodule_export]
    use crate::topography::Topography;
}
