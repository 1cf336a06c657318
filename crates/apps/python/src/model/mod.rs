//! Models by their id, and models written in Python.

pub(crate) mod engine;
mod python_model;
