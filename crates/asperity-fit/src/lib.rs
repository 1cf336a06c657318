#![doc = include_str!("../README.md")]

mod columns;
mod combinations;
mod data;
mod describe;
mod deviations;
mod distance;
mod error;
mod few_contacts;
mod fit;
mod fitted;
mod forward;
mod likely_unit;
mod limits;
mod misfit;
mod observation;
mod other_stiffness;
mod outlier;
mod parameter;
mod problem;
mod ranking;
mod reach;
mod recorded;
mod remark;
mod search;
mod spread;
mod units;

pub use columns::is_column;
pub use data::Data;
pub use error::FitError;
pub use fit::{Fit, Progress};
pub use fitted::{Estimate, Fitted, Residual};
pub use forward::{Rig, places, predict};
pub use observation::{DataColumn, Measured, MeasuredTable, Observation};
pub use parameter::{Parameter, Role, USUAL_FACTOR};
pub use problem::MakeScene;
pub use ranking::{Ranking, rank};
