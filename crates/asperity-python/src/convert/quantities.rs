//! Names of quantities as Python gives them.

use asperity::{Quantity, Request};
use pyo3::prelude::*;
use pyo3::types::PyString;

use crate::convert::error::value_error;
use crate::model::engine::tolerance;

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
