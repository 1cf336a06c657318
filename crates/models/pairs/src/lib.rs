#![doc = include_str!("../README.md")]

mod antiderivative;
mod integral;
mod model;
#[cfg(test)]
mod tests;

pub use model::AsperityPairs;
