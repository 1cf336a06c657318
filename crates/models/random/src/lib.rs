#![doc = include_str!("../README.md")]

mod average;
mod contact;
mod kernel;
#[cfg(test)]
mod tests;

pub use contact::{FARTHEST, RandomAsperities};
