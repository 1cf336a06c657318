//! Tests of scene files, in one binary: it is linked once, and they run side by side.
#![allow(clippy::unwrap_used, reason = "a panic is how a test fails")]

mod examples;
mod finishes;
mod hostile;
mod lay;
mod measured;
mod options;
mod pairs;
mod random_asperities;
mod random_fits;
mod scene_errors;
mod scene_files;
mod two_surfaces;
mod units;
mod varied;
mod wording;
mod written;
