//! The README's examples, and models of the registry beside the evidence.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test: a panic is the failure")]

mod best;
mod examples;
