#![doc = include_str!("../README.md")]

// This crate takes models from the facade's registry only, and does no arithmetic on results.

mod accept;
mod check;
mod document;
mod error;
mod heights;
mod hints;
mod inputs;
mod interface;
mod measured;
mod mistaken;
mod numbers;
mod options;
mod quantity;
mod scan;
mod scene_file;
mod surface;
mod template;
mod write;

pub use check::Measured;
pub use error::{Place, SceneError};
pub use heights::write_heights;
pub use inputs::{SceneInput, key_of_input};
pub use mistaken::mistaken_unit;
pub use numbers::{Roughness, interface_of};
pub use options::{Asperities, ModelOptions, OptionValue};
pub use quantity::{quantity, unit_of};
pub use scan::{height_map, open_seam};
pub use scene_file::{LeftOut, SceneFile, load, load_scan, parse};
pub use template::{template, template_on};
