//! The workspace's own tasks: physics → table → csv → svg.
//!
//! [`figures`] lists the figures: for each a [`table`] of numbers from the models, and the
//! description of a picture, which `asperity_plot` draws from the text of the csv. [`files`] writes
//! or checks both. The other tasks are features, so that the figures need not wait for what they
//! are built from: `report` measures speed and accuracy of the integrals, `truth` compares the
//! models with boundary elements, `guide` and `page` make what users read. `dist.sh` makes what
//! they install.

pub mod command;
pub mod docs;
pub mod figures;
pub mod files;
pub mod folder;
#[cfg(feature = "guide")]
pub mod guide;
pub mod html;
#[cfg(feature = "page")]
pub mod page;
#[cfg(feature = "report")]
pub mod report;
pub mod table;
#[cfg(feature = "truth")]
pub mod truth;
