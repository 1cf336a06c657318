//! Errors, numbers, names and values of the library in Python.

pub(crate) mod axis;
pub(crate) mod numbers;

use asperity::{Advice, Code, ContactError, Finding, Quantity, Request, Severity, Tolerance};
use asperity_quadrature::QuadratureError;
use pyo3::create_exception;
use pyo3::exceptions::{PyRuntimeError, PyUserWarning, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyString;
use serde::Serialize;

create_exception!(
    asperity,
    NotConverged,
    PyRuntimeError,
    "An integral did not reach the requested tolerance; the message has the error it reached."
);
create_exception!(
    asperity,
    ContactWarning,
    PyUserWarning,
    "A warning about a scene or an answer: a number outside its usual range, a negative force, an area above the nominal one."
);

create_exception!(
    asperity,
    UnsupportedFormat,
    PyValueError,
    "A file of a scan in a format without a reader here."
);

/// Any object of Python.
pub(crate) type Object<'py> = Bound<'py, PyAny>;

/// A `ValueError` with the message of an error of the library.
pub(crate) fn value_error(error: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// The exception of an error of the engine: `ValueError`, or `NotConverged`.
pub(crate) fn refused(error: ContactError) -> PyErr {
    match error {
        ContactError::Integral { source: QuadratureError::NotConverged { .. }, .. } => {
            NotConverged::new_err(error.to_string())
        }
        _ => value_error(error),
    }
}

/// Emits a `ContactWarning` at the line that calls the package, `above` frames of the package up.
pub(crate) fn warn(py: Python<'_>, found: &Finding, above: usize) -> PyResult<()> {
    py.import("asperity._warn")?.call_method1("warn", (warning(found), above)).map(drop)
}

/// Likewise, unless one of these codes accepts it.
pub(crate) fn warn_unless(
    py: Python<'_>,
    accept: &[Code],
    found: &Finding,
    above: usize,
) -> PyResult<()> {
    if found.is_accepted(accept) { Ok(()) } else { warn(py, found, above) }
}

/// A warning where numbers of a scene are known within ranges, of which the middle is taken.
pub(crate) fn taken_in_the_middle(file: &asperity_scene::SceneFile) -> Option<Finding> {
    let (_, note) = file.taken_at("middle").ok()?;
    Some(note?.severity(Severity::Warning))
}

/// Emits that warning.
pub(crate) fn warn_of_ranges(
    py: Python<'_>,
    file: &asperity_scene::SceneFile,
    above: usize,
) -> PyResult<()> {
    let taken = taken_in_the_middle(file);
    taken.map_or(Ok(()), |found| warn_unless(py, &file.spec.accept, &found, above))
}

/// The text of a warning, which filters of warnings find by its code.
pub(crate) fn warning(found: &Finding) -> String {
    let words = |advice: Advice| match advice {
        Advice::CompareCutOffs => "compare cut-offs with Topography.smooth".into(),
        Advice::Despike => "Topography.despiked or despike=True replaces them".into(),
        other => other.to_string(),
    };
    format!("{}: {}", found.code, found.worded(&found.field, words))
}

/// The dict, list or number of a serialisable value; None for NaN. Keys are sorted.
pub(crate) fn object<'py>(py: Python<'py>, of: &impl Serialize) -> PyResult<Object<'py>> {
    let text = serde_json::to_value(of).map_err(value_error)?.to_string();
    py.import("json")?.call_method1("loads", (text,))
}

/// One quantity or more, each once.
pub(crate) struct Quantities(pub(crate) Vec<Quantity>);

impl<'py> FromPyObject<'_, 'py> for Quantities {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let names: Vec<String> = match given.cast::<PyString>() {
            Ok(one) => vec![one.extract()?],
            Err(_) => given.try_iter()?.map(|name| name?.extract()).collect::<PyResult<_>>()?,
        };
        let mut found = vec![];
        for name in names {
            let quantity = name.parse().map_err(value_error)?;
            if !found.contains(&quantity) {
                found.push(quantity);
            }
        }
        if found.is_empty() {
            let known = Quantity::ALL.map(|quantity| quantity.to_string()).join(", ");
            let message = format!("quantities is empty: one or more of {known} were required");
            return Err(value_error(message));
        }
        Ok(Self(found))
    }
}

impl Quantities {
    pub(crate) fn request(&self, rtol: f64) -> PyResult<Request> {
        Ok(Request::new(self.0.iter().copied()).within(tolerance(rtol)?))
    }
}

/// A relative tolerance; a `ValueError` outside its range.
pub(crate) fn tolerance(rtol: f64) -> PyResult<Tolerance> {
    Tolerance::new(rtol).map_err(refused)
}
