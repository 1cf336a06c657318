//! The workspace's own tasks: physics → table → csv → svg.
//!
//! [`figures`] lists the figures: for each a [`table`] of numbers from the models, and the
//! description of a picture, which `asperity_plot` draws from the text of the csv. [`files`] writes
//! or checks both. `guide` and `page` make what users read; the guide is a feature, so that the
//! figures need not wait for what it is built from. `dist.sh` makes what users install. The
//! studies, whose numbers are drawn here, are `crates/studies`.

pub mod command;
pub mod figures;
pub mod files;
pub mod folder;
#[cfg(feature = "guide")]
pub mod guide;
#[cfg(feature = "guide")]
mod opened;
pub mod page;
pub mod table;
