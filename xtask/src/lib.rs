//! The workspace's own tasks: physics → table → csv → svg.
//!
//! [`figures`] lists the figures: for each a [`table`] of numbers from the models, and the
//! description of a picture, which `asperity_plot` draws from the text of the csv. [`files`] writes
//! or checks both. [`report`] measures speed and accuracy of the integrals, [`truth`] compares the
//! models with boundary elements.

pub mod dist;
pub mod docs;
pub mod figures;
pub mod files;
pub mod folder;
pub mod guide;
pub mod head;
pub mod html;
pub mod page;
pub mod report;
pub mod table;
pub mod truth;
