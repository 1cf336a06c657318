//! A model written in Python, behind the same trait as the others.

use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use asperity::{
    Claims, ContactError, ContactModel, Form, Law, Part, Provenance, Quantity, Regime, Source,
    StiffnessKind, Tolerance,
};
use asperity_quadrature::{QuadratureError, Sampler};
use numpy::{AllowTypeChange, PyArray1, PyArrayLikeDyn};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyType};

use crate::asperity::Asperity;

/// Where a user's model is from is the user's to say: nothing of this is shown.
const SOURCE: Source = Source {
    id: "python",
    name: "Python",
    authors: "",
    year: 0,
    title: "",
    provenance: Provenance::Derived,
};

/// What a user's code raised last, and the words that the engine carries for it.
#[derive(Debug, Clone, Default)]
pub(crate) struct Raised(Arc<Mutex<Option<(String, PyErr)>>>);

impl Raised {
    /// Keeps an exception; returns its words.
    fn keep(&self, py: Python<'_>, error: PyErr) -> String {
        let words = error.to_string();
        let kept = (words.clone(), error.clone_ref(py));
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(kept);
        words
    }

    /// The exception behind a refusal, if it is the one that was raised last.
    pub(crate) fn exception(&self, py: Python<'_>, refusal: &ContactError) -> Option<PyErr> {
        let (ContactError::Refused { reason, .. }
        | ContactError::Integral { source: QuadratureError::Refused { reason }, .. }) = refusal
        else {
            return None;
        };
        let kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let (words, error) = kept.as_ref()?;
        (words == reason).then(|| error.clone_ref(py))
    }
}

/// A class whose instances are the laws of one asperity.
pub(crate) struct PythonModel {
    /// Called with an asperity.
    class: Py<PyAny>,
    name: String,
    own_stiffness: bool,
    monotone: bool,
    /// Tells this model from every other, so that a sweep integrates a law that recurs once.
    number: u64,
    raised: Raised,
}

static MODELS: AtomicU64 = AtomicU64::new(0);

impl PythonModel {
    pub(crate) fn new(class: &Bound<'_, PyAny>, raised: Raised) -> PyResult<Self> {
        let name = match class.getattr_opt("name")? {
            Some(name) => name.extract()?,
            None => class.getattr("__name__")?.extract()?,
        };
        let monotone = class.getattr_opt("force_monotone")?;
        Ok(Self {
            name,
            own_stiffness: class.hasattr("stiffness")?,
            monotone: monotone.map_or(Ok(false), |monotone| monotone.extract())?,
            class: class.clone().unbind(),
            number: MODELS.fetch_add(1, Ordering::Relaxed),
            raised,
        })
    }

    fn law_in_python(
        &self,
        py: Python<'_>,
        asperity: &asperity::Asperity,
        quantity: Quantity,
    ) -> PyResult<Law> {
        let laws = self.class.bind(py).call1((Asperity(*asperity),))?;
        let method = quantity.to_string();
        let unit = asperity.critical_interference().unwrap_or(asperity.radius);
        let kinks = kinks(&laws, &method)?.into_iter().map(|kink| kink / unit);
        let mut kinks: Vec<f64> = kinks.filter(|kink| *kink > 0.0 && kink.is_finite()).collect();
        kinks.sort_by(f64::total_cmp);
        kinks.dedup();
        let sampler = PythonLaw {
            function: laws.getattr(method.as_str())?.unbind(),
            what: format!("{}.{quantity}(w)", self.name),
            unit,
            raised: self.raised.clone(),
        };
        let numbers = |a: &asperity::Asperity| {
            let shear = a.equivalent_shear_modulus.unwrap_or(0.0);
            [a.equivalent_modulus, shear, a.poissons_ratio, a.hardness, a.yield_strength]
                .into_iter()
                .chain([a.pressure_factor, a.radius])
                .collect()
        };
        let form = Form::sampled(Arc::new(sampler))
            .known_as(format!("python model {} {quantity}", self.number), numbers(asperity));
        let mut law = Law::in_units(unit, 1.0);
        for (name, regime, range, kinks) in parts(&laws, kinks)? {
            let name = name.into();
            law.parts.push(Part { name, regime, sign: 1.0, range, kinks, form: form.clone() });
        }
        Ok(law)
    }
}

/// An attribute that may be missing, or None.
fn given<'py>(laws: &Bound<'py, PyAny>, name: &str) -> PyResult<Option<Bound<'py, PyAny>>> {
    Ok(laws.getattr_opt(name)?.filter(|value| !value.is_none()))
}

/// `kinks` of the laws: interferences [m], for all quantities or by quantity; none if not given.
fn kinks(laws: &Bound<'_, PyAny>, quantity: &str) -> PyResult<Vec<f64>> {
    let Some(kinks) = given(laws, "kinks")? else { return Ok(vec![]) };
    let kinks = if kinks.is_callable() { kinks.call0()? } else { kinks };
    let kinks = match kinks.cast::<PyDict>() {
        Ok(by_quantity) => match by_quantity.get_item(quantity)? {
            Some(kinks) => kinks,
            None => return Ok(vec![]),
        },
        Err(_) => kinks,
    };
    kinks.try_iter()?.map(|kink| kink?.extract()).collect()
}

/// Name, regime, range and kinks of each part.
type Parts = Vec<(String, Regime, std::ops::Range<f64>, Vec<f64>)>;

/// One part, or one for each of the `regimes` that the kinks bound.
fn parts(laws: &Bound<'_, PyAny>, kinks: Vec<f64>) -> PyResult<Parts> {
    let Some(regimes) = given(laws, "regimes")? else {
        return Ok(vec![("law".into(), Regime::ElasticPlastic, 0.0..f64::INFINITY, kinks)]);
    };
    let regimes: Vec<String> = regimes.extract()?;
    if regimes.len() != kinks.len() + 1 {
        return Err(crate::error::value_error(format!(
            "regimes has {} names: one more than the {} kinks was required",
            regimes.len(),
            kinks.len()
        )));
    }
    let ends = kinks.iter().copied().chain([f64::INFINITY]);
    let starts = std::iter::once(0.0).chain(kinks.iter().copied());
    let part = |(name, (start, end)): (&String, (f64, f64))| {
        let regime = match name.as_str() {
            "elastic" => Regime::Elastic,
            "plastic" => Regime::Plastic,
            _ => Regime::ElasticPlastic,
        };
        (name.clone(), regime, start..end, vec![])
    };
    Ok(regimes.iter().zip(starts.zip(ends)).map(part).collect())
}

impl fmt::Debug for PythonModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("PythonModel").field("name", &self.name).finish_non_exhaustive()
    }
}

impl ContactModel for PythonModel {
    fn source(&self) -> &Source {
        &SOURCE
    }

    fn id(&self) -> &str {
        &self.name
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn law(
        &self,
        asperity: &asperity::Asperity,
        quantity: Quantity,
        _: Tolerance,
    ) -> Result<Law, ContactError> {
        let has_law = match quantity {
            Quantity::Force | Quantity::Area => true,
            Quantity::Stiffness => self.own_stiffness,
            Quantity::Tangent => false,
        };
        if !has_law {
            return Err(self.no_law(quantity));
        }
        Python::attach(|py| {
            self.law_in_python(py, asperity, quantity).map_err(|error| ContactError::Refused {
                model: self.name.clone(),
                reason: self.raised.keep(py, error),
            })
        })
    }

    fn stiffness(&self) -> StiffnessKind {
        if self.own_stiffness { StiffnessKind::OwnLaw } else { StiffnessKind::Tangent }
    }

    fn claims(&self) -> Claims {
        Claims { force_monotone: self.monotone, hertz_limit: None, angles: false }
    }
}

/// One method of the laws, with interferences in metres.
struct PythonLaw {
    function: Py<PyAny>,
    what: String,
    unit: f64,
    raised: Raised,
}

impl PythonLaw {
    fn values(&self, py: Python<'_>, x: &[f64], out: &mut [f64]) -> PyResult<()> {
        let metres: Vec<f64> = x.iter().map(|x| x * self.unit).collect();
        let w = PyArray1::from_slice(py, &metres);
        let found = self.function.bind(py).call1((w,))?;
        let found: PyArrayLikeDyn<'_, f64, AllowTypeChange> =
            found.extract().map_err(|error: PyErr| {
                crate::error::value_error(format!("{}: numbers were required: {error}", self.what))
            })?;
        let found = found.as_array();
        if found.shape() != [out.len()] {
            return Err(crate::error::value_error(format!(
                "{} has shape {:?} for {} interferences: one value for each was required",
                self.what,
                found.shape(),
                out.len()
            )));
        }
        for ((out, value), w) in out.iter_mut().zip(found.iter()).zip(&metres) {
            if !value.is_finite() {
                return Err(crate::error::value_error(format!(
                    "{} is {value} at w = {w:e} m: a finite number was required",
                    self.what
                )));
            }
            *out = *value;
        }
        Ok(())
    }
}

impl Sampler for PythonLaw {
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        Python::attach(|py| {
            self.values(py, x, out)
                .map_err(|error| QuadratureError::Refused { reason: self.raised.keep(py, error) })
        })
    }
}

/// Whether this is something to make laws of, not laws themselves.
pub(crate) fn is_class(target: &Bound<'_, PyAny>) -> bool {
    target.is_instance_of::<PyType>() || target.is_callable()
}
