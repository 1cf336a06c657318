#![doc = include_str!("../README.md")]

mod density;
mod error;
mod estimator;
mod fill;
mod filter;
mod level;
mod moments;
mod outliers;
mod read;
mod statistics;
mod summits;
mod topography;
mod unit;
mod warning;

pub use density::HeightDensity;
pub use error::TopographyError;
pub use estimator::Estimator;
pub use level::Level;
pub use moments::{ArealMoments, Moments};
pub use outliers::Outliers;
pub use read::{MAX_FILE_BYTES, ReadOptions, read, read_bytes};
pub use statistics::Statistics;
pub use summits::Summits;
pub use topography::{MAX_POINTS, Topography};
pub use unit::LengthUnit;
