//! Tests of what is not computed here: the README's examples, definitions, and tables for CalculiX.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test: a panic is the failure")]

mod calculix;
mod definitions;
mod examples;
