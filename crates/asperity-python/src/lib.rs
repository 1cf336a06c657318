//! The Python package `asperity`: arguments in, arrays out.
//!
//! Nothing here computes: every number comes from the crates of this workspace. The interpreter is
//! let go (`detach`) whenever they work, also because a model written in Python takes it back from
//! whichever thread builds its rules.
//!
//! ```text
//! records → scene → rows → answer ┐
//!           python_model → engine ┴→ contact → ask, advice
//!                          engine → joints, joint_table
//! scene, topography → bem
//! ```

mod advice;
mod answer;
mod ask;
mod bem;
mod check;
mod conductance;
mod contact;
mod engine;
mod error;
mod inputs;
mod joint_table;
mod joints;
mod long;
mod numbers;
mod objects;
mod picture;
mod places;
mod python_model;
mod records;
mod rows;
mod scene;
mod table;
mod topography;

/// The compiled part of the package `asperity`.
#[pyo3::pymodule]
mod _asperity {
    #[pymodule_export]
    use crate::advice::{plan, recommend};
    #[pymodule_export]
    use crate::ask::{answer, separations, shares};
    #[pymodule_export]
    use crate::bem::{bem, truth};
    #[pymodule_export]
    use crate::check::{check, findings, pull_off};
    #[pymodule_export]
    use crate::conductance::{correlated, gap_conductance};
    #[pymodule_export]
    use crate::contact::Contact;
    #[pymodule_export]
    use crate::engine::{Engine, model_ids, quantities};
    #[pymodule_export]
    use crate::error::{ContactWarning, NotConverged};
    #[pymodule_export]
    use crate::inputs::inputs_in_si;
    #[pymodule_export]
    use crate::joint_table::JointTable;
    #[pymodule_export]
    use crate::joints::{PartialSlip, Unloading};
    #[pymodule_export]
    use crate::numbers::{floats, in_si};
    #[pymodule_export]
    use crate::picture::svg;
    #[pymodule_export]
    use crate::records::{Asperity, Body, Interface, Surface};
    #[pymodule_export]
    use crate::scene::{SceneFile, template};
    #[pymodule_export]
    use crate::table::contact_table;
    #[pymodule_export]
    use crate::topography::Topography;
}
