//! The Python package `asperity`: arguments in, arrays out.
//!
//! Nothing here computes: every number comes from the crates of this workspace. The interpreter is
//! let go (`detach`) whenever they work, also because a model written in Python takes it back from
//! whichever thread builds its rules.

mod advice;
mod arrays;
mod asperity;
mod bodies;
mod contact;
mod engine;
mod error;
mod inverse;
mod options;
mod pool;
mod python_model;
mod rows;
mod scene;
mod scenes;
mod surface;
mod topography;

/// The compiled part of the package `asperity`.
#[pyo3::pymodule]
mod _asperity {
    #[pymodule_export]
    use crate::advice::recommend;
    #[pymodule_export]
    use crate::asperity::Asperity;
    #[pymodule_export]
    use crate::bodies::{Body, Interface};
    #[pymodule_export]
    use crate::contact::Contact;
    #[pymodule_export]
    use crate::engine::{Engine, model_ids};
    #[pymodule_export]
    use crate::error::{ContactWarning, NotConverged};
    #[pymodule_export]
    use crate::inverse::separations;
    #[pymodule_export]
    use crate::rows::evaluate_rows;
    #[pymodule_export]
    use crate::scene::{Scene, template};
    #[pymodule_export]
    use crate::scenes::Scenes;
    #[pymodule_export]
    use crate::surface::Surface;
    #[pymodule_export]
    use crate::topography::Topography;
}
