//! A model written in Python, by the trait of all models.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use asperity::{
    AsperityModel, Citation, ContactError, Described, Formula, Law, Part, Provenance, Quantity,
    Regime, Tolerance, Validity,
};
use asperity_quadrature::{QuadratureError, Sampler};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::convert::Object;
use crate::records::record;

/// The citation of a user's model; never shown.
const SOURCE: Citation = Citation {
    id: "python",
    name: "Python",
    authors: "",
    year: 0,
    title: "",
    provenance: Provenance::Derived,
    published: &[],
};

/// The last exception of a user's code, and its message, which the engine carries.
#[derive(Debug, Clone, Default)]
pub(crate) struct Raised(Arc<Mutex<Option<(String, PyErr)>>>);

impl Raised {
    /// Keeps an exception; returns its message.
    fn keep(&self, py: Python<'_>, error: PyErr) -> String {
        let message = error.to_string();
        let kept = (message.clone(), error.clone_ref(py));
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(kept);
        message
    }

    /// The exception that caused a refusal, if it is the last one kept.
    pub(crate) fn exception(&self, py: Python<'_>, refusal: &ContactError) -> Option<PyErr> {
        let (ContactError::Refused { reason, .. }
        | ContactError::Integral { source: QuadratureError::Refused { reason }, .. }) = refusal
        else {
            return None;
        };
        let kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let (message, error) = kept.as_ref()?;
        (message == reason).then(|| error.clone_ref(py))
    }
}

/// A class whose instances are the laws of one asperity.
#[derive(Debug)]
pub(crate) struct PythonModel {
    /// The package's `_model.Laws` of the class: returns function, kinks and regimes of an
    /// asperity.
    laws: Py<PyAny>,
    name: String,
    own_stiffness: bool,
    monotone: bool,
    density: bool,
    /// A number of its own: sweeps identify recurring laws by it.
    number: u64,
    raised: Raised,
}

static MODELS: AtomicU64 = AtomicU64::new(0);

impl PythonModel {
    pub(crate) fn new(laws: &Object<'_>, raised: Raised) -> PyResult<Self> {
        Ok(Self {
            name: laws.getattr("name")?.extract()?,
            own_stiffness: laws.getattr("own_stiffness")?.extract()?,
            monotone: laws.getattr("force_monotone")?.extract()?,
            density: laws.getattr("uses_density")?.extract()?,
            laws: laws.clone().unbind(),
            number: MODELS.fetch_add(1, Ordering::Relaxed),
            raised,
        })
    }

    fn law(&self, asperity: &asperity::Asperity, quantity: Quantity) -> Result<Law, ContactError> {
        Python::attach(|py| {
            self.law_in_python(py, asperity, quantity).map_err(|error| ContactError::Refused {
                model: self.name.clone(),
                reason: self.raised.keep(py, error),
            })
        })
    }

    fn law_in_python(
        &self,
        py: Python<'_>,
        asperity: &asperity::Asperity,
        quantity: Quantity,
    ) -> PyResult<Law> {
        let arguments = (record(py, asperity)?, quantity.to_string());
        let (function, kinks, regimes): (Py<PyAny>, Vec<f64>, Vec<String>) =
            self.laws.bind(py).call1(arguments)?.extract()?;
        let unit = asperity.critical_interference().unwrap_or(asperity.radius);
        let kinks: Vec<f64> = kinks.into_iter().map(|kink| kink / unit).collect();
        // The law may use every field of the asperity.
        let id = format!("python model {} {quantity} {asperity:?}", self.number);
        let law = PythonLaw { function, unit, raised: self.raised.clone() };
        let form = Formula::sampled(Arc::new(law)).known_as(id, vec![]);
        let mut law = Law::in_units(unit, 1.0);
        let mut part = |name: String, regime, range, kinks| {
            let (name, form) = (name.into(), form.clone());
            law.parts.push(Part { name, regime, sign: 1.0, range, kinks, form });
        };
        if regimes.is_empty() {
            part("law".into(), Regime::ElasticPlastic, 0.0..f64::INFINITY, kinks);
            return Ok(law);
        }
        // One part for each range between kinks.
        let ends = kinks.iter().copied().chain([f64::INFINITY]);
        let starts = [0.0].into_iter().chain(kinks.iter().copied());
        for (name, (start, end)) in regimes.into_iter().zip(starts.zip(ends)) {
            let regime = match name.as_str() {
                "elastic" => Regime::Elastic,
                "plastic" => Regime::Plastic,
                _ => Regime::ElasticPlastic,
            };
            part(name, regime, start..end, vec![]);
        }
        Ok(law)
    }
}

impl Described for PythonModel {
    fn citation(&self) -> &Citation {
        &SOURCE
    }

    fn id(&self) -> &str {
        &self.name
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn validity(&self) -> Validity {
        let (force_monotone, density) = (self.monotone, self.density);
        Validity { force_monotone, density, hertz_limit: None, ..Validity::default() }
    }
}

impl AsperityModel for PythonModel {
    fn force(&self, asperity: &asperity::Asperity, _: Tolerance) -> Result<Law, ContactError> {
        self.law(asperity, Quantity::Force)
    }

    fn area(&self, asperity: &asperity::Asperity, _: Tolerance) -> Result<Law, ContactError> {
        self.law(asperity, Quantity::Area)
    }

    fn stiffness(
        &self,
        asperity: &asperity::Asperity,
        _: Tolerance,
    ) -> Result<Option<Law>, ContactError> {
        self.own_stiffness.then(|| self.law(asperity, Quantity::Stiffness)).transpose()
    }
}

/// One law, with interferences in metres.
struct PythonLaw {
    function: Py<PyAny>,
    unit: f64,
    raised: Raised,
}

impl Sampler for PythonLaw {
    fn is_costly(&self) -> bool {
        true
    }

    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        Python::attach(|py| {
            let mut values = || -> PyResult<()> {
                let w = PyArray1::from_iter(py, x.iter().map(|x| x * self.unit));
                let found: PyReadonlyArray1<'_, f64> =
                    self.function.bind(py).call1((w,))?.extract()?;
                out.iter_mut().zip(found.as_array()).for_each(|(out, value)| *out = *value);
                Ok(())
            };
            values().map_err(|e| QuadratureError::Refused { reason: self.raised.keep(py, e) })
        })
    }
}
