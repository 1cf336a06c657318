//! Scene files: TOML and the files it names, read into a contact scene.
//!
//! [`load`] reads a file, [`parse`] a text, into a [`SceneFile`]: a [`Scene`](asperity::Scene) with
//! the options of the models and the plane that separations are measured from. [`template`] is a
//! commented file with every key. Unknown keys are refused, and every error names the file, the
//! line and the field, what was found and what is needed.
//!
//! # Heights from a table
//! `heights = { file = "pdf.csv" }` takes a measured density, linear between its points, in metres.
//! Three rules, so that no length is stretched in silence:
//! * The heights are used as they are, in metres about their own mean. `asperity_height_std` is
//!   then no more than the unit of separations (and what a `plasticity_index` refers to).
//! * It may be left out; the table's own standard deviation takes its place. Where both are known
//!   and differ by more than 5 %, there is a warning; by more than a factor of 10, an error, because
//!   one of them is not in metres.
//! * With `separation_from = "surface-mean"` the table's heights must be measured from the mean
//!   plane of the surface: the mean of the table is then the offset. A table whose mean is 0 is
//!   refused there, because it was measured from its own mean.
//!
//! This crate knows the models through the facade's registry alone, and does no arithmetic on
//! results.

mod document;
mod error;
mod heights;
mod interface;
mod measured;
mod options;
mod scene_file;
mod surface;
mod words;
mod write;

pub use error::{Place, SceneError};
pub use heights::write_heights;
pub use options::{ModelOptions, OptionValue};
pub use scene_file::{LeftOut, SceneFile, SeparationFrom, load, parse};
pub use write::{template, write};
