//! Integrals of a density against the shifted Gaussian: for many s at one scale, for many scales,
//! for one s, and in columns of numbers.

mod any_scale;
mod column;
mod fill;
mod moments;
mod nearby;
mod patch;
mod ranges;
mod segment;
mod shifted;
mod table;
mod weight;

pub use any_scale::AnyScale;
pub use column::{ArrayAccuracy, ScaledIntegral};
pub use moments::Moments;
pub use nearby::Nearby;
pub use shifted::ShiftedGaussian;
pub use weight::reach;
