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
//! for y in 0..64 {
//!     for x in 0..64 {
//!         let (x, y) = (f64::from(x), f64::from(y));
//!         let z = 20.0 * (0.3 * x).sin() + 20.0 * (0.4 * y).cos() + 5.0 * (1.3 * x + 1.1 * y).sin();
//!         scan += &format!("{z:.3}\t");
//!     }
//!     scan += "\n";
//! }
//! let surface = read_bytes("scan.txt", scan.as_bytes(), &ReadOptions::default())?;
//! let statistics = surface.level(Level::Plane)?.statistics(Estimator::Moments)?;
//! assert_eq!(format!("{:.3e} m", statistics.sq), "2.000e-8 m");
//! assert_eq!(format!("{:.3e} m", statistics.surface().asperity_height_std), "1.840e-8 m");
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
