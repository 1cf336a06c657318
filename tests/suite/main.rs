//! One binary for all tests that need more than one crate.
#![allow(clippy::unwrap_used, reason = "a test binary: a panic is the failure")]

mod arrays;
mod check;
mod circles;
mod claims;
mod contact_radii;
mod crossings;
mod few_places;
mod figures;
mod hard_cases;
mod heights;
mod inputs;
mod invariants;
mod inverse;
mod kit;
mod ladder;
mod lateral;
mod parallel;
mod plans;
mod properties;
mod published;
mod reference;
mod rows;
mod scenes;
mod sweeps;
mod tangents;
mod tidy;
mod waves;
mod work;

/// Whether long cases run as well: `.ci/full` sets `ASPERITY_LONG`.
fn is_long() -> bool {
    std::env::var_os("ASPERITY_LONG").is_some()
}

/// Each case where long cases run, otherwise one of `of`.
fn one_of<T>(of: usize, cases: impl IntoIterator<Item = T>) -> impl Iterator<Item = T> {
    cases.into_iter().step_by(if is_long() { 1 } else { of })
}
