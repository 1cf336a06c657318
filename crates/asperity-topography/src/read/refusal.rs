//! Refusals of a field of a file, by format.

use crate::TopographyError;
use crate::error::excerpt;

pub(super) fn gwy(field: &'static str, found: impl ToString, required: &str) -> TopographyError {
    of("gwy", field, &found.to_string(), required)
}

pub(super) fn npy(field: &'static str, found: impl ToString, required: &str) -> TopographyError {
    of("npy", field, &found.to_string(), required)
}

pub(super) fn sdf(field: &'static str, found: impl ToString, required: &str) -> TopographyError {
    of("sdf", field, &found.to_string(), required)
}

pub(super) fn sur(field: &'static str, found: impl ToString, required: &str) -> TopographyError {
    of("sur", field, &found.to_string(), required)
}

pub(super) fn x3p(field: &'static str, found: impl ToString, required: &str) -> TopographyError {
    of("x3p", field, &found.to_string(), required)
}

fn of(format: &'static str, field: &'static str, found: &str, required: &str) -> TopographyError {
    let (found, required) = (excerpt(found), required.to_owned());
    TopographyError::Field { format, field, found, required }
}
