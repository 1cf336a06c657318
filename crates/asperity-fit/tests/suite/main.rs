//! Fits of data that are made from known scenes.

mod coverage;
mod kit;
mod recovery;
mod words;
