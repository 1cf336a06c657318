#![doc = include_str!("../README.md")]

mod asked;
mod corrected;
mod error;
mod inquiry;
mod models;
mod recommend;
mod sheet;
mod watch;

pub use asked::{Asked, Line};
pub use error::AnswerError;
pub use inquiry::{Beside, Inquiry, column_beside};
pub use models::{
    ALL_MODELS, NamedModel, by_reason, models, models_beside_bem, named_model, note_adhesion, once,
    one_model, one_or_usual, reference, scene_findings, use_asperities,
};
pub use recommend::{Recommend, judge};
pub use sheet::{Cell, Sheet};
pub use watch::{Silent, Watch};
