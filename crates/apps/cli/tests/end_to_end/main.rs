//! The built program, driven from outside.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "tests: a panic is the failure")]

mod answer;
mod bem;
mod bench;
mod conductance;
mod curve;
mod export;
mod files;
mod fit;
mod help;
mod joints;
mod leaks;
mod pairs;
mod readme;
mod surface;
