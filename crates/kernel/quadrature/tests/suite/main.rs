//! Tests of integrals through the crate's front, in one binary.

mod deep_overlap;
mod weights;
