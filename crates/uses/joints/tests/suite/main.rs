//! Tests of joints, in one binary: it is linked once, and they run side by side.
#![allow(clippy::unwrap_used, reason = "a test binary: a panic is the failure")]

mod cycles;
mod element;
mod energy;
mod forces;
mod references;
mod refusals;
mod scenes;
mod skewed;
mod stated;
mod turning;

/// Whether long cases run as well: `.ci/full` sets `ASPERITY_LONG`.
fn is_long() -> bool {
    std::env::var_os("ASPERITY_LONG").is_some()
}
