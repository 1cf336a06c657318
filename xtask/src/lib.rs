//! The workspace's own tasks: physics → table → csv → svg.
//!
//! [`table`] calls the models, [`draw`] turns the text of a csv into a picture and knows no
//! physics, [`figures`] lists what there is, [`files`] writes or checks it. [`report`] measures how fast and
//! how accurate the integrals are.

pub mod draw;
pub mod figures;
pub mod files;
pub mod report;
pub mod table;
