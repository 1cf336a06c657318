//! `Asperity`: what a law written in Python is made for.

use pyo3::prelude::*;

use crate::bodies::named;
use crate::error::refused;

/// One asperity, with every input resolved: what a law written in Python is made for.
///
/// Made by the engine, and by ``Scene.asperity``.
#[pyclass(frozen, eq, module = "asperity")]
#[derive(PartialEq)]
pub(crate) struct Asperity(pub(crate) asperity::Asperity);

#[pymethods]
impl Asperity {
    /// E [Pa].
    #[getter]
    fn equivalent_modulus(&self) -> f64 {
        self.0.equivalent_modulus
    }

    /// G [Pa], where it was given.
    #[getter]
    fn equivalent_shear_modulus(&self) -> Option<f64> {
        self.0.equivalent_shear_modulus
    }

    /// Poisson's ratio of the softer body.
    #[getter]
    fn poissons_ratio(&self) -> f64 {
        self.0.poissons_ratio
    }

    /// Hardness of the softer body [Pa].
    #[getter]
    fn hardness(&self) -> f64 {
        self.0.hardness
    }

    /// Yield strength of the softer body [Pa].
    #[getter]
    fn yield_strength(&self) -> f64 {
        self.0.yield_strength
    }

    /// Maximum contact pressure factor.
    #[getter]
    fn pressure_factor(&self) -> f64 {
        self.0.pressure_factor
    }

    /// Radius [m].
    #[getter]
    fn radius(&self) -> f64 {
        self.0.radius
    }

    /// The interference at which yielding begins [m]; ValueError where it would exceed the radius.
    #[getter]
    fn critical_interference(&self) -> PyResult<f64> {
        self.0.critical_interference().map_err(|e| refused(&e))
    }

    /// The force at the critical interference [N]; ValueError where there is none.
    #[getter]
    fn critical_force(&self) -> PyResult<f64> {
        self.0.critical_force().map_err(|e| refused(&e))
    }

    fn __repr__(&self) -> String {
        let Self(a) = self;
        format!(
            "<asperity.Asperity {}>",
            named(&[
                ("radius", Some(a.radius)),
                ("equivalent_modulus", Some(a.equivalent_modulus)),
                ("hardness", Some(a.hardness)),
                ("poissons_ratio", Some(a.poissons_ratio)),
            ])
        )
    }
}
