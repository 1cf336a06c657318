#![doc = include_str!("../README.md")]

// This crate takes models from the facade's registry only, and does no arithmetic on results.

mod accept;
mod cells;
mod check;
mod document;
mod error;
mod evidence;
mod film;
mod finish;
mod finishes;
mod fit;
mod free;
mod gap;
mod heights;
mod inputs;
mod interface;
mod kept;
mod keys;
mod likely;
mod materials;
mod measured;
mod measured_keys;
mod measurements;
mod models;
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
mod text_file;
mod unknowns;
mod write;

pub use asperity::Asperities;
pub use check::Measured;
pub use document::HandedFiles;
pub use error::{Place, SceneError};
pub use free::Free;
pub use gap::Gas;
pub use heights::write_heights;
pub use inputs::{SceneInput, key_of_input};
pub use keys::{BODY, Field, INTERFACE, KEYS, Key, SURFACE, Subject};
pub use likely::{gradient, likely_angle, mistaken_unit, notation_hint, with_decimal_point};
pub use materials::{Material, materials, materials_like};
pub use measured_keys::MeasuredKeys;
pub use measurements::read_measurements;
pub use models::LeftOut;
pub use numbers::{Roughness, Way, interface_of};
pub use options::ModelOptions;
pub use quantity::{NO_LOAD, column_of, converted, quantity, quantity_of, unit_of};
pub use scan::{height_map, open_seam};
pub use scene_file::{SceneFile, load, load_scan, parse, parse_handed};
pub use template::{template, template_on};
/// Keys of a section with their values.
pub use toml::Table as Keys;
/// The value of an option.
pub use toml::Value as OptionValue;
pub use unknowns::{AT_AN_END, Unknown, worst_at_ends};
