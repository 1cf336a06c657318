//! `Body` and `Interface`.

use asperity::ContactError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use super::{Arg, Field, Record, Setter, instance, record, shown};
use crate::convert::error::{refused, warn};

record! {
    /// One elastic-plastic body.
    ///
    /// Numbers are in SI units, or texts with their unit, as "210 GPa".
    ///
    /// Parameters
    /// ----------
    /// youngs_modulus : float or str
    ///     Young's modulus [Pa], above 0.
    /// poissons_ratio : float
    ///     Poisson's ratio, above -1 and at most 0.5.
    /// hardness : float or str, optional
    ///     Hardness [Pa]; 2.8 times the yield strength when not given.
    /// yield_strength : float or str, optional
    ///     Yield strength [Pa]; the hardness over 2.8 when not given. Without either, the body never
    ///     yields: for gw, persson, dmt and jkr only.
    /// thermal_conductivity : float or str, optional
    ///     k [W/(m K)], for the quantity "thermal-conductance" only.
    /// electrical_resistivity : float or str, optional
    ///     rho [ohm m], for the quantity "electrical-conductance" only.
    ///
    /// Examples
    /// --------
    /// >>> import asperity
    /// >>> asperity.Body(210e9, 0.3, hardness=2e9)
    /// Body(youngs_modulus=210000000000.0, poissons_ratio=0.3, hardness=2000000000.0)
    /// >>> asperity.Body("210 GPa", 0.3, hardness="2 GPa") == asperity.Body(210e9, 0.3, 2e9)
    /// True
    Body (
        youngs_modulus, poissons_ratio, hardness=None, yield_strength=None,
        thermal_conductivity=None, electrical_resistivity=None
    ) from asperity::Body::elastic(0.0, 0.0), |one| asperity::Interface::against_rigid(one).map(drop);
    /// Young's modulus [Pa].
    youngs_modulus: f64,
    /// Poisson's ratio.
    poissons_ratio: f64,
    /// Hardness [Pa], where it was given.
    hardness: Option<f64>,
    /// Yield strength [Pa], where it was given.
    yield_strength: Option<f64>,
    /// Thermal conductivity [W/(m K)], where it was given.
    thermal_conductivity: Option<f64>,
    /// Electrical resistivity [ohm m], where it was given.
    electrical_resistivity: Option<f64>,
    {}
}

record! {
    /// The equivalent properties of two bodies in contact.
    ///
    /// Numbers are in SI units, or texts with their unit, as "116 GPa".
    ///
    /// Parameters
    /// ----------
    /// equivalent_modulus : float or str
    ///     E [Pa]: 1/E = (1-nu1^2)/E1 + (1-nu2^2)/E2.
    /// poissons_ratio : float
    ///     That of the softer body, above -1 and at most 0.5.
    /// hardness : float or str, optional
    ///     Of the softer body [Pa]; 2.8 times the yield strength when not given.
    /// yield_strength : float or str, optional
    ///     Of the softer body [Pa]; the hardness over 2.8 when not given. Without either, the surfaces
    ///     never yield: for gw, persson, dmt and jkr only.
    /// equivalent_shear_modulus : float or str, optional
    ///     G [Pa]: 1/G = (2-nu1)/G1 + (2-nu2)/G2; the models gao and at, and the quantity
    ///     "tangential-stiffness", need it.
    /// pressure_factor : float, optional
    ///     Maximum contact pressure factor; 0.454 + 0.41 nu when not given.
    /// thermal_conductivity : float or str, optional
    ///     k [W/(m K)]: 2/k = 1/k1 + 1/k2; "thermal-conductance" needs it.
    /// electrical_resistivity : float or str, optional
    ///     rho [ohm m]: 2 rho = rho1 + rho2; "electrical-conductance" needs it.
    /// work_of_adhesion : float or str, optional
    ///     w_a [J/m^2], at least 0: the models dmt and jkr need it.
    ///
    /// Examples
    /// --------
    /// >>> import asperity
    /// >>> steel = asperity.Body(210e9, 0.3, hardness=2e9)
    /// >>> interface = asperity.Interface.between(steel, steel)
    /// >>> f"{interface.equivalent_modulus:.4g} {interface.equivalent_shear_modulus:.4g}"
    /// '1.154e+11 2.376e+10'
    Interface (
        equivalent_modulus, poissons_ratio, hardness=None, yield_strength=None,
        equivalent_shear_modulus=None, pressure_factor=None, thermal_conductivity=None,
        electrical_resistivity=None, work_of_adhesion=None
    ) from asperity::Interface::elastic(0.0, 0.0), |one| one.check().map(drop);
    /// Equivalent modulus E [Pa].
    equivalent_modulus: f64,
    /// Poisson's ratio of the softer body.
    poissons_ratio: f64,
    /// Hardness of the softer body [Pa], where it was given.
    hardness: Option<f64>,
    /// Yield strength of the softer body [Pa], where it was given.
    yield_strength: Option<f64>,
    /// Equivalent shear modulus G [Pa], where it was given.
    equivalent_shear_modulus: Option<f64>,
    /// Maximum contact pressure factor, where it was given.
    pressure_factor: Option<f64>,
    /// Thermal conductivity of the pair [W/(m K)], where it was given.
    thermal_conductivity: Option<f64>,
    /// Electrical resistivity of the pair [ohm m], where it was given.
    electrical_resistivity: Option<f64>,
    /// Work of adhesion [J/m^2], where it was given.
    work_of_adhesion: Option<f64>,
    {
        /// Two deformable bodies; hardness and Poisson's ratio are those of the softer one.
        #[staticmethod]
        #[pyo3(signature = (first, second, *, work_of_adhesion=None))]
        fn between(first: &Arg<'_>, second: &Arg<'_>, work_of_adhesion: Option<&Arg<'_>>) -> PyResult<Self> {
            let (py, second) = (first.py(), instance::<Body>("second", second)?.get().0);
            let first = instance::<Body>("first", first)?.get().0;
            let found = asperity::Interface::between(&first, &second);
            Self::of(py, &[first, second], found, work_of_adhesion)
        }

        /// A deformable body on a rigid one.
        #[staticmethod]
        #[pyo3(signature = (body, *, work_of_adhesion=None))]
        fn against_rigid(body: &Arg<'_>, work_of_adhesion: Option<&Arg<'_>>) -> PyResult<Self> {
            let one = instance::<Body>("body", body)?.get().0;
            Self::of(body.py(), &[one], asperity::Interface::against_rigid(&one), work_of_adhesion)
        }
    }
}

impl Interface {
    /// The interface of bodies, with a work of adhesion of the pair.
    fn of(
        py: Python<'_>,
        bodies: &[asperity::Body],
        made: Result<asperity::Interface, ContactError>,
        work_of_adhesion: Option<&Arg<'_>>,
    ) -> PyResult<Self> {
        let mut found = made.map_err(refused)?;
        // Findings of the interface itself appear where it is used.
        if found.findings().is_empty() {
            let mut odd = bodies.iter().flat_map(asperity::Body::findings);
            odd.try_for_each(|finding| warn(py, finding, 0))?;
        }
        found.work_of_adhesion = Field::read("Interface", "work_of_adhesion", work_of_adhesion)?;
        Self::checked(found)
    }
}
