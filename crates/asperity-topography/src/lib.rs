//! Measured surfaces: from a scan to moments and asperity parameters.
//!
//! ```text
//! file → Topography → level → (filter) → Statistics → asperity_core::Surface
//! ```
//!
//! [`read`] knows ASCII matrices, XYZ points, profiles, NumPy `.npy`, ISO 25178-72 `.x3p` and
//! uncompressed Digital Surf `.sur`. Units and pixel sizes come from the file or from
//! [`ReadOptions`]; nothing is guessed. Missing points stay missing.
//!
//! This crate reads hostile bytes: every declared size is checked against the bytes that are
//! there before memory is set aside, and no input reaches a panic. It knows no contact model.
//!
//! ```
//! use asperity_topography::{Estimator, Level, ReadOptions, read_bytes};
//!
//! let mut scan = String::from("# Width: 64 um\n# Height: 64 um\n# Value units: nm\n");
//! for row in 0..64_i32 {
//!     let heights = (0..64_i32).map(|column| format!("{}", (row * row + 7 * column * row) % 101));
//!     scan.push_str(&heights.collect::<Vec<_>>().join("\t"));
//!     scan.push('\n');
//! }
//! let topography = read_bytes("scan.txt", scan.as_bytes(), &ReadOptions::default())?;
//! let statistics = topography.level(Level::Plane)?.statistics(Estimator::Moments)?;
//! assert!((statistics.surface().asperity_height_std - 27e-9).abs() < 2e-9);
//! # Ok::<(), asperity_topography::TopographyError>(())
//! ```

mod density;
mod error;
mod estimator;
mod filter;
mod level;
mod moments;
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
pub use read::{MAX_FILE_BYTES, ReadOptions, read, read_bytes};
pub use statistics::Statistics;
pub use summits::Summits;
pub use topography::{MAX_POINTS, Topography};
pub use unit::LengthUnit;
pub use warning::Warning;
