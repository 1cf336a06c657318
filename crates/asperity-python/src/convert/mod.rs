//! Arguments of Python as the library takes them, and its values, errors and warnings as Python's.

pub(crate) mod axis;
pub(crate) mod error;
pub(crate) mod numbers;
pub(crate) mod objects;
