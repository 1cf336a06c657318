#![doc = include_str!("../README.md")]

mod bem;
mod conductance;
mod export;
mod history;
mod number;
mod pull_off;
mod reasons;
mod sheet;
mod slip;
mod subject;
mod truth_sheet;
mod unloading;
mod unloading_scan;
mod watch;

pub use bem::{Press, Pressed};
pub use conductance::{Conductance, Gas};
pub use export::{ConductanceAgainst, Export, Exported, TableFormat, UnitSystem};
pub use history::history;
pub use number::{once, rounded, within};
pub use pull_off::pull_off;
pub use reasons::by_reason;
pub use sheet::{Cell, Sheet};
pub use slip::{Amplitude, Slip};
pub use subject::{Subject, Unanswered, unit_warning};
pub use truth_sheet::truth;
pub use unloading::{Retreats, unloading};
pub use unloading_scan::unloading_scan;
pub use watch::{Silent, Watch};
