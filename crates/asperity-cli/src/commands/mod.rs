//! One command a file.

pub mod bem;
pub mod check;
pub mod compare;
pub mod conductance;
pub mod curve;
pub mod export;
pub mod history;
pub mod init;
pub mod models;
pub mod plan;
pub mod pull_off;
pub mod recommend;
pub mod scales;
pub mod slip;
pub mod solve;
pub mod surface;
pub mod truth;
pub mod unload;
