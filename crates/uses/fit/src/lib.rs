#![doc = include_str!("../README.md")]

mod columns;
mod data;
mod error;
mod fit;
mod fitted;
mod forward;
mod names;
mod observation;
mod parameter;
mod problem;
mod search;
mod solution;
mod spread;

pub use columns::is_column;
pub use data::Data;
pub use error::FitError;
pub use fit::{Fit, Progress};
pub use fitted::{Estimate, Fitted, Residual, rank};
pub use forward::{Rig, places, predict};
pub use observation::{DataColumn, Measured, MeasuredTable, Observation, Position};
pub use parameter::{Parameter, Role, USUAL_FACTOR};
pub use problem::MakeScene;
