//! Tables of pressure against clearance for finite-element programs.

pub(crate) mod builder;
pub(crate) mod contact_table;
mod cubic;
pub(crate) mod error;
mod error_bound;
pub(crate) mod format;
pub(crate) mod interaction;
mod kinks;
pub(crate) mod units;
mod writers;
