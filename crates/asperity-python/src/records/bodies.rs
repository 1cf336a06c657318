//! `Body` and `Interface`.

use asperity::ContactError;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use super::{Arg, Field, Origin, Record, instance, record, shown};
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
    ///     Hardness [Pa]; by default 2.8 times the yield strength.
    /// yield_strength : float or str, optional
    ///     Yield strength [Pa]; by default the hardness over 2.8. A body without either never
    ///     yields: only gw, persson, dmt and jkr accept it.
    /// thermal_conductivity : float or str, optional
    ///     k [W/(m K)]; needed by the quantity "thermal-conductance" only.
    /// electrical_resistivity : float or str, optional
    ///     rho [ohm m]; needed by the quantity "electrical-conductance" only.
    /// tangent_modulus : float or str, optional
    ///     Slope of stress over strain beyond yielding [Pa]; needed by the model ghaednia only.
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
        thermal_conductivity=None, electrical_resistivity=None, tangent_modulus=None
    ) from asperity::Body::elastic(0.0, 0.0), |one| asperity::Interface::against_rigid(one).map(drop), by ();
    /// Young's modulus [Pa].
    youngs_modulus: f64,
    /// Poisson's ratio.
    poissons_ratio: f64,
    /// Hardness [Pa], if given.
    hardness: Option<f64>,
    /// Yield strength [Pa], if given.
    yield_strength: Option<f64>,
    /// Thermal conductivity [W/(m K)], if given.
    thermal_conductivity: Option<f64>,
    /// Electrical resistivity [ohm m], if given.
    electrical_resistivity: Option<f64>,
    /// Tangent modulus [Pa], if given.
    tangent_modulus: Option<f64>,
    {
        /// A material of the list, by its name in scene files; `asperity.materials()` has the list.
        ///
        /// >>> import asperity
        /// >>> asperity.Body.material("stainless-304").youngs_modulus
        /// 193000000000.0
        #[staticmethod]
        fn material(name: &str) -> PyResult<Self> {
            let all = asperity_inputs::materials();
            let found = all.iter().find(|material| material.id == name).ok_or_else(|| {
                let near = asperity::nearest_name(name, all.iter().map(|known| &*known.id));
                let near = asperity::nearest_hint(near);
                let needed = "a material of asperity.materials() was required";
                PyValueError::new_err(format!("material is {name:?}{near}: {needed}"))
            })?;
            Self::checked(found.body)
        }
    }
}

/// The materials of scene files: name in text, body and source, by their names.
#[pyfunction]
pub(crate) fn materials(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let all = PyDict::new(py);
    for material in asperity_inputs::materials() {
        let body = Body::checked(material.body)?;
        all.set_item(&material.id, (&material.name, body, &material.source))?;
    }
    Ok(all)
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
    ///     Poisson's ratio of the softer body, above -1 and at most 0.5.
    /// hardness : float or str, optional
    ///     Hardness of the softer body [Pa]; by default 2.8 times the yield strength.
    /// yield_strength : float or str, optional
    ///     Yield strength of the softer body [Pa]; by default the hardness over 2.8. Surfaces
    ///     without either never yield: only gw, persson, dmt and jkr accept them.
    /// equivalent_shear_modulus : float or str, optional
    ///     G [Pa]: 1/G = (2-nu1)/G1 + (2-nu2)/G2; needed by the models gao and at and the quantity
    ///     "tangential-stiffness".
    /// pressure_factor : float, optional
    ///     Maximum contact pressure factor; by default 0.454 + 0.41 nu.
    /// thermal_conductivity : float or str, optional
    ///     k [W/(m K)]: 2/k = 1/k1 + 1/k2; needed by "thermal-conductance".
    /// electrical_resistivity : float or str, optional
    ///     rho [ohm m]: 2 rho = rho1 + rho2; needed by "electrical-conductance".
    /// work_of_adhesion : float or str, optional
    ///     w_a [J/m^2], at least 0; needed by the models dmt and jkr.
    /// tangent_modulus : float or str, optional
    ///     E_t [Pa] of two bodies with the same E and nu; needed by the model ghaednia.
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
        electrical_resistivity=None, work_of_adhesion=None, tangent_modulus=None
    ) from asperity::Interface::elastic(0.0, 0.0), |one| one.check().map(drop), by Vec<asperity::Body>;
    /// Equivalent modulus E [Pa].
    equivalent_modulus: f64,
    /// Poisson's ratio of the softer body.
    poissons_ratio: f64,
    /// Hardness of the softer body [Pa], if given.
    hardness: Option<f64>,
    /// Yield strength of the softer body [Pa], if given.
    yield_strength: Option<f64>,
    /// Equivalent shear modulus G [Pa], if given.
    equivalent_shear_modulus: Option<f64>,
    /// Maximum contact pressure factor, if given.
    pressure_factor: Option<f64>,
    /// Thermal conductivity of the pair [W/(m K)], if given.
    thermal_conductivity: Option<f64>,
    /// Electrical resistivity of the pair [ohm m], if given.
    electrical_resistivity: Option<f64>,
    /// Work of adhesion [J/m^2], if given.
    work_of_adhesion: Option<f64>,
    /// Tangent modulus of two like bodies [Pa], if given.
    tangent_modulus: Option<f64>,
    {
        /// The interface of two deformable bodies; hardness and Poisson's ratio are those of the
        /// softer body.
        #[staticmethod]
        #[pyo3(signature = (first, second, *, work_of_adhesion=None))]
        fn between(first: &Arg<'_>, second: &Arg<'_>, work_of_adhesion: Option<&Arg<'_>>) -> PyResult<Self> {
            let (py, second) = (first.py(), instance::<Body>("second", second)?.get().0);
            let first = instance::<Body>("first", first)?.get().0;
            let found = asperity::Interface::between(&first, &second);
            Self::of(py, &[("first", first), ("second", second)], found, work_of_adhesion)
        }

        /// The interface of a deformable and a rigid body.
        #[staticmethod]
        #[pyo3(signature = (body, *, work_of_adhesion=None))]
        fn against_rigid(body: &Arg<'_>, work_of_adhesion: Option<&Arg<'_>>) -> PyResult<Self> {
            let one = instance::<Body>("body", body)?.get().0;
            let found = asperity::Interface::against_rigid(&one);
            Self::of(body.py(), &[("body", one)], found, work_of_adhesion)
        }

        /// The interface of pickled bodies.
        #[staticmethod]
        fn _of_bodies(
            bodies: Vec<Bound<'_, Body>>,
            work_of_adhesion: Option<f64>,
            pressure_factor: Option<f64>,
        ) -> PyResult<Self> {
            let bodies: Vec<asperity::Body> = bodies.iter().map(|body| body.get().0).collect();
            let mut found = asperity_inputs::interface_of(&bodies).map_err(refused)?;
            (found.work_of_adhesion, found.pressure_factor) = (work_of_adhesion, pressure_factor);
            Ok(Self(Self::checked(found)?.0, bodies))
        }
    }
}

impl Interface {
    /// The interface of bodies with their work of adhesion; warns of unusual bodies.
    fn of(
        py: Python<'_>,
        bodies: &[(&str, asperity::Body)],
        made: Result<asperity::Interface, ContactError>,
        work_of_adhesion: Option<&Arg<'_>>,
    ) -> PyResult<Self> {
        let mut found = made.map_err(refused)?;
        // Findings of the interface appear in its scene.
        if found.findings().is_empty() {
            for (name, body) in bodies {
                body.findings().into_iter().try_for_each(|f| warn(py, f.within(name), 0))?;
            }
        }
        found.work_of_adhesion = Field::read("Interface", "work_of_adhesion", work_of_adhesion)?;
        let bodies = bodies.iter().map(|(_, body)| *body).collect();
        Ok(Self(Self::checked(found)?.0, bodies))
    }
}

impl Origin<Interface> for Vec<asperity::Body> {
    fn call<'py>(
        &self,
        record: &Bound<'py, Interface>,
    ) -> PyResult<Option<(Bound<'py, PyAny>, Bound<'py, PyTuple>)>> {
        if self.is_empty() {
            return Ok(None);
        }
        let bodies: Vec<Body> = self.iter().map(|body| Body(*body, ())).collect();
        let asperity::Interface { work_of_adhesion, pressure_factor, .. } = record.get().0;
        let arguments = (bodies, work_of_adhesion, pressure_factor).into_pyobject(record.py())?;
        Ok(Some((record.get_type().getattr("_of_bodies")?, arguments)))
    }
}
