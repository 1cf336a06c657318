//! Boundary elements on a scan, and models compared with them.

pub(crate) mod contacts;
mod scan;
