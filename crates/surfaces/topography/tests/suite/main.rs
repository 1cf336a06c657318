//! Tests of measured surfaces, in one binary: it is linked once, and they run side by side.
#![allow(clippy::unwrap_used, reason = "tests")]

mod broken;
mod files;
mod formats;
mod gaussian;
mod hostile;
mod orientation;
mod others;
mod outliers;
mod parameters;
mod scale;
mod spectra;
mod tables;
mod texts;
mod turned;
mod wording;
