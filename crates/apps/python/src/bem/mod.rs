//! Boundary elements on a scan.

pub(crate) mod contacts;
mod scan;
