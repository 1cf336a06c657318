#![doc = include_str!("../README.md")]

mod columns;
mod combinations;
mod data;
mod distance;
mod doubt;
mod doubts;
mod error;
mod fit;
mod fitted;
mod forward;
mod limits;
mod names;
mod observation;
mod outlier;
mod parameter;
mod problem;
mod ranking;
mod search;
mod solution;
mod spread;

pub use columns::is_column;
pub use data::Data;
pub use doubt::Doubts;
pub use error::FitError;
pub use fit::{Fit, Progress};
pub use fitted::{Estimate, Fitted, Residual};
pub use forward::{Rig, places, predict};
pub use observation::{DataColumn, Measured, MeasuredTable, Observation, Position};
pub use parameter::{Parameter, Role, USUAL_FACTOR};
pub use problem::MakeScene;
pub use ranking::{Ranking, rank};
