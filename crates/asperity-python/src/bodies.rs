//! `Body` and `Interface`.

use pyo3::prelude::*;

use crate::error::refused;

/// One elastic-plastic body.
///
/// Parameters
/// ----------
/// youngs_modulus : float
///     Young's modulus [Pa], above 0.
/// poissons_ratio : float
///     Poisson's ratio, above -1 and at most 0.5.
/// hardness : float, optional
///     Hardness [Pa]; 2.8 times the yield strength when not given.
/// yield_strength : float, optional
///     Yield strength [Pa]; the hardness over 2.8 when not given. One of the two is needed.
///
/// Examples
/// --------
/// >>> import asperity
/// >>> asperity.Body(210e9, 0.3, hardness=2e9)
/// Body(youngs_modulus=210000000000.0, poissons_ratio=0.3, hardness=2000000000.0)
#[pyclass(frozen, eq, module = "asperity")]
#[derive(PartialEq)]
pub(crate) struct Body(pub(crate) asperity::Body);

#[pymethods]
impl Body {
    #[new]
    #[pyo3(signature = (youngs_modulus, poissons_ratio, hardness=None, yield_strength=None))]
    fn new(
        youngs_modulus: f64,
        poissons_ratio: f64,
        hardness: Option<f64>,
        yield_strength: Option<f64>,
    ) -> PyResult<Self> {
        let body = asperity::Body { youngs_modulus, poissons_ratio, hardness, yield_strength };
        asperity::Interface::against_rigid(&body).map_err(|e| refused(&e))?;
        Ok(Self(body))
    }

    /// Young's modulus [Pa].
    #[getter]
    fn youngs_modulus(&self) -> f64 {
        self.0.youngs_modulus
    }

    /// Poisson's ratio.
    #[getter]
    fn poissons_ratio(&self) -> f64 {
        self.0.poissons_ratio
    }

    /// Hardness [Pa], if it was given.
    #[getter]
    fn hardness(&self) -> Option<f64> {
        self.0.hardness
    }

    /// Yield strength [Pa], if it was given.
    #[getter]
    fn yield_strength(&self) -> Option<f64> {
        self.0.yield_strength
    }

    fn __repr__(&self) -> String {
        let Self(b) = self;
        format!(
            "Body({})",
            named(&[
                ("youngs_modulus", Some(b.youngs_modulus)),
                ("poissons_ratio", Some(b.poissons_ratio)),
                ("hardness", b.hardness),
                ("yield_strength", b.yield_strength),
            ])
        )
    }

    fn __getnewargs__(&self) -> (f64, f64, Option<f64>, Option<f64>) {
        let b = &self.0;
        (b.youngs_modulus, b.poissons_ratio, b.hardness, b.yield_strength)
    }
}

/// The equivalent properties of two bodies in contact: what the laws use.
///
/// Parameters
/// ----------
/// equivalent_modulus : float
///     E [Pa]: 1/E = (1-nu1^2)/E1 + (1-nu2^2)/E2.
/// poissons_ratio : float
///     That of the softer body, above -1 and at most 0.5.
/// hardness : float, optional
///     Of the softer body [Pa]; 2.8 times the yield strength when not given.
/// yield_strength : float, optional
///     Of the softer body [Pa]; the hardness over 2.8 when not given. One of the two is needed.
/// equivalent_shear_modulus : float, optional
///     G [Pa]: 1/G = (2-nu1)/G1 + (2-nu2)/G2; the models gao and at need it.
/// pressure_factor : float, optional
///     Maximum contact pressure factor; 0.454 + 0.41 nu when not given.
///
/// Examples
/// --------
/// >>> import asperity
/// >>> steel = asperity.Body(210e9, 0.3, hardness=2e9)
/// >>> interface = asperity.Interface.between(steel, steel)
/// >>> f"{interface.equivalent_modulus:.4g} {interface.equivalent_shear_modulus:.4g}"
/// '1.154e+11 2.376e+10'
#[pyclass(frozen, eq, module = "asperity")]
#[derive(PartialEq)]
pub(crate) struct Interface(pub(crate) asperity::Interface);

/// What an interface is made of, in the order of its arguments.
type Arguments = (f64, f64, Option<f64>, Option<f64>, Option<f64>, Option<f64>);

#[pymethods]
impl Interface {
    #[new]
    #[pyo3(signature = (equivalent_modulus, poissons_ratio, hardness=None, yield_strength=None, equivalent_shear_modulus=None, pressure_factor=None))]
    fn new(
        equivalent_modulus: f64,
        poissons_ratio: f64,
        hardness: Option<f64>,
        yield_strength: Option<f64>,
        equivalent_shear_modulus: Option<f64>,
        pressure_factor: Option<f64>,
    ) -> PyResult<Self> {
        let interface = asperity::Interface {
            equivalent_modulus,
            equivalent_shear_modulus,
            poissons_ratio,
            hardness,
            yield_strength,
            pressure_factor,
        };
        interface.check().map_err(|e| refused(&e))?;
        Ok(Self(interface))
    }

    /// Two deformable bodies; hardness and Poisson's ratio are those of the softer one.
    #[staticmethod]
    fn between(first: &Body, second: &Body) -> PyResult<Self> {
        asperity::Interface::between(&first.0, &second.0).map(Self).map_err(|e| refused(&e))
    }

    /// A deformable body on a rigid one.
    #[staticmethod]
    fn against_rigid(body: &Body) -> PyResult<Self> {
        asperity::Interface::against_rigid(&body.0).map(Self).map_err(|e| refused(&e))
    }

    /// E [Pa].
    #[getter]
    fn equivalent_modulus(&self) -> f64 {
        self.0.equivalent_modulus
    }

    /// G [Pa], if it was given or follows from bodies.
    #[getter]
    fn equivalent_shear_modulus(&self) -> Option<f64> {
        self.0.equivalent_shear_modulus
    }

    /// Poisson's ratio of the softer body.
    #[getter]
    fn poissons_ratio(&self) -> f64 {
        self.0.poissons_ratio
    }

    /// Hardness of the softer body [Pa], if it was given.
    #[getter]
    fn hardness(&self) -> Option<f64> {
        self.0.hardness
    }

    /// Yield strength of the softer body [Pa], if it was given.
    #[getter]
    fn yield_strength(&self) -> Option<f64> {
        self.0.yield_strength
    }

    /// Maximum contact pressure factor, if it was given.
    #[getter]
    fn pressure_factor(&self) -> Option<f64> {
        self.0.pressure_factor
    }

    pub(crate) fn __repr__(&self) -> String {
        let Self(i) = self;
        format!(
            "Interface({})",
            named(&[
                ("equivalent_modulus", Some(i.equivalent_modulus)),
                ("poissons_ratio", Some(i.poissons_ratio)),
                ("hardness", i.hardness),
                ("yield_strength", i.yield_strength),
                ("equivalent_shear_modulus", i.equivalent_shear_modulus),
                ("pressure_factor", i.pressure_factor),
            ])
        )
    }

    fn __getnewargs__(&self) -> Arguments {
        let i = &self.0;
        (
            i.equivalent_modulus,
            i.poissons_ratio,
            i.hardness,
            i.yield_strength,
            i.equivalent_shear_modulus,
            i.pressure_factor,
        )
    }
}

/// `name=value` of what is there, in Python's spelling.
pub(crate) fn named(fields: &[(&str, Option<f64>)]) -> String {
    let there = fields.iter().filter_map(|(name, value)| Some((name, (*value)?)));
    there.map(|(name, value)| format!("{name}={value:?}")).collect::<Vec<_>>().join(", ")
}
