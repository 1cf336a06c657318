#![doc = include_str!("../README.md")]

mod sheet;
mod watch;

pub use sheet::{Cell, Sheet};
pub use watch::{Silent, Watch};
