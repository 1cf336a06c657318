//! Fits of data that are made from known scenes.
#![allow(clippy::unwrap_used, reason = "a test binary: a panic is the failure")]

mod coverage;
mod kit;
mod limits;
mod ranking;
mod recovery;
