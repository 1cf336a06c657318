#![doc = include_str!("../README.md")]

// This crate takes models from the facade's registry only, and does no arithmetic on results.

mod accept;
mod cells;
mod check;
mod document;
mod error;
mod evidence;
mod fit;
mod free;
mod hardness;
mod heights;
mod hints;
mod in_si;
mod inputs;
mod interface;
mod iso_units;
mod materials;
mod measured;
mod measured_keys;
mod measurements;
mod mistaken;
mod models;
mod notation;
mod numbers;
mod options;
mod quantity;
mod scaled;
mod scan;
mod scene_file;
mod sides;
mod small_scan;
mod surface;
mod template;
mod units;
mod write;

pub use check::Measured;
pub use document::HandedFiles;
pub use error::{Needed, Place, SceneError};
pub use free::{Free, unit_of_free};
pub use heights::write_heights;
pub use inputs::{SceneInput, key_of_input};
pub use iso_units::{gradient, likely_angle};
pub use materials::{Material, materials, materials_like};
pub use measurements::read_measurements;
pub use mistaken::mistaken_unit;
pub use models::LeftOut;
pub use notation::{notation_hint, with_decimal_point, without_thousands};
pub use numbers::{Roughness, interface_of};
pub use options::{Asperities, ModelOptions, OptionValue};
pub use quantity::{NO_LOAD, quantity, quantity_hint, quantity_of, unit_of};
pub use scan::{height_map, open_seam};
pub use scene_file::{SceneFile, load, load_scan, parse, parse_handed, parse_handed_scan};
pub use template::{template, template_on};
pub use units::{converted, is_unit};
