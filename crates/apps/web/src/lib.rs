//! The explorer: asperity in a browser tab.
//!
//! A [`Desk`] holds the text of a scene and the files that it names, and answers messages in json.
//! The page (`www/`) shows the answers and does no arithmetic; numbers, pictures, units and texts
//! come from here. `cargo xtask page` builds both.

mod advice;
mod answer;
mod desk;
mod fields;
mod files;
mod labels;
mod link;
mod message;
mod picture;
mod press;
mod random;
mod read_scene;
mod refusal;
mod scan_report;
mod shown;
mod span;
mod surface_keys;
mod table;
#[cfg(target_arch = "wasm32")]
mod wasm;

pub use desk::Desk;
