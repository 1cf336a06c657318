//! The workspace's own tasks: physics → table → csv → svg.
//!
//! [`figures`] lists what there is: for each a [`table`] of numbers that calls the models, and the
//! description of a picture, which `asperity_plot` draws from the text of the csv. [`files`] writes or
//! checks both. [`report`] measures how fast and how accurate the integrals are, [`truth`] how far the
//! models are from boundary elements.

pub mod figures;
pub mod files;
pub mod folder;
pub mod report;
pub mod table;
pub mod truth;
