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
    use crate::{
        ask::advice::{best, check, profile, pull_off},
        ask::contact::Contact,
        ask::values::{answer, separations, shares},
        bem::contacts::{bem, sealing_pressure},
        convert::numbers::quantity,
        convert::{ContactWarning, NotConverged, UnsupportedFormat},
        fit::fit,
        joints::{JointTable, PartialSlip, Unloading},
        model::engine::{Engine, column_of, model_ids, quantities},
        random_surface::random_surface,
        records::{checked, derived, interface_of, material, materials},
        records::{moments_of_both, numbers_of, surface_of},
        scene::{SceneFile, template},
        tables::contact_table,
        topography::Topography,
    };
}
