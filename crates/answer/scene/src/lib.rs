#![doc = include_str!("../README.md")]

// This crate takes models from the facade's registry only, and does no arithmetic on results.

mod check;
mod curvature;
mod document;
mod error;
mod evidence;
mod film;
mod finish;
mod finishes;
mod fit;
mod heights;
mod input;
mod interface;
mod keys;
mod materials;
mod measured;
mod measurements;
mod mistaken_unit;
mod models;
mod options;
mod quantity;
mod ranges;
mod read;
mod resolve;
mod roughness;
mod scan;
mod scans;
mod scene_file;
mod seal;
mod spec;
mod surface;
mod template;
mod text_file;
mod unknown;
mod vary;
mod words;
mod write;

pub use asperity::Asperities;
pub use asperity_curved::{Hertz, Shape};
pub use curvature::Curvature;
pub use document::HandedFiles;
pub use error::{Place, Provenance, SceneError};
pub use finish::Drawing;
pub use fit::Free;
pub use input::SceneInput;
pub use keys::{BODY, Field, INTERFACE, KEYS, Key, SURFACE, Subject, key_of_input};
pub use materials::{Material, materials, materials_like};
pub use measured::{Measured, MeasuredKeys, Scan, height_map, open_seam};
pub use measurements::read_measurements;
pub use mistaken_unit::mistaken_unit;
pub use models::LeftOut;
pub use options::ModelOptions;
pub use quantity::{NO_LOAD, column_of, notation_hint, quantity, quantity_of, unit_of};
pub use ranges::Points;
pub use read::{load, load_scan, parse, parse_handed};
pub use roughness::{Roughness, Way};
pub use scene_file::SceneFile;
pub use seal::{Gas, Seal, SealGas};
pub use spec::{Bodies, Description, HeightsSpec, SceneSpec, SurfaceSpec, interface_of};
pub use template::{template, template_on};
/// Keys of a section with their values.
pub use toml::Table as Keys;
/// The value of an option.
pub use toml::Value as OptionValue;
pub use unknown::Unknown;
