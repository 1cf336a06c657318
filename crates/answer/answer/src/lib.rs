#![doc = include_str!("../README.md")]

mod answer;
mod bem;
mod blanks;
mod check;
mod compiled;
mod curve;
mod error;
mod export;
mod history;
mod leak;
mod models;
mod number;
mod patch;
mod pull_off;
mod ranges;
mod sealing;
mod search;
mod several;
mod sheet;
mod sliding;
mod slip;
mod slip_scan;
mod solved;
mod subject;
mod unloading;
mod unloading_scan;
mod watch;

pub use answer::{Answer, Basis, basis, has_property, lines, title};
pub use bem::{Press, Pressed};
pub use blanks::Blanks;
pub use check::check_sheet;
pub use compiled::{Asked, Line, NO_EVIDENCE};
pub use curve::{ADHESIVE, Beside, Inquiry, OPENING};
pub use error::AnswerError;
pub use export::{Export, Exported, Nodes, TableFormat, UnitSystem};
pub use history::history;
pub use models::{
    ALL_MODELS, best_and_nearest, grouped, models, of_joint, once, one_model, one_or_usual,
    scene_findings, use_asperities,
};
pub use number::{rounded, within};
pub use patch::patch;
pub use pull_off::pull_off;
pub use ranges::with_ranges;
pub use sealing::sealing;
pub use search::{NoEnds, Numbers, Search};
pub use several::at_values;
pub use sheet::{Cell, ENDS, Sheet, column_of_end};
pub use slip::{Amplitude, Slip};
pub use solved::{solve, solved_contact};
pub use subject::{Retreats, Subject, unit_warning};
pub use unloading::unloading;
pub use watch::{Silent, Watch};
