//! Conversion of arguments for the library, and of its values, errors and warnings for Python.

pub(crate) mod axis;
pub(crate) mod error;
pub(crate) mod numbers;
pub(crate) mod objects;
pub(crate) mod quantities;
