//! The built program, driven from outside.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "tests: a panic is the failure")]

mod adhesion;
mod answer;
mod ball;
mod bem;
mod bem_boundary;
mod bench;
mod compare;
mod conductance;
mod curve;
mod export;
mod files;
mod fit;
mod generate;
mod help;
mod joints;
mod leaks;
mod loads;
mod messages;
mod pairs;
mod random;
mod readme;
mod slip;
mod surface;
mod surface_report;
mod two_surfaces;
