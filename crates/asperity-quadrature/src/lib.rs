//! Quadrature for densities with kinks: adaptive discretisation, Gauss rules with the density as
//! their weight, and the classical methods they are measured against.
//!
//! The integrals of this workspace are all of one kind,
//!
//! ```text
//! I(s) = ∫₀^∞ q(t/c) φ(s + t) dt,      φ(t) = exp(-t²/2)/√(2π)
//! ```
//!
//! with a density q ≥ 0 that has kinks, jumps and fractional powers, and an entire function φ.
//! Integrating panel by panel pays for q at every evaluation. Here q goes into the weight:
//!
//! 1. [`discretise`] replaces q(t) φ(s + t) by positive point masses, on panels that end at the
//!    kinks and are refined until a Legendre tail shows that they are resolved;
//! 2. hundreds of masses are compressed into the few nodes of their Gauss rule;
//! 3. [`ShiftedGaussian`] does both once for each short range of s, on demand, and then answers the
//!    value and its derivative from 4 to 16 nodes without a branch or a power.
//!
//! This crate knows nothing of contact mechanics, and reads no files.

mod any_scale;
mod avx2;
mod chebyshev;
mod compress;
mod density;
mod discretise;
mod error;
mod exponentials;
mod gaussian;
mod kronrod;
mod legendre;
mod nearby;
mod overlap;
mod roots;
mod rules;
mod segment;
mod tanh_sinh;
mod terms;

pub use any_scale::AnyScale;
pub use avx2::with_wide_registers;
pub use chebyshev::Tabulated;
pub use density::{Density, Piece, Sampler};
pub use discretise::{Discretised, Goal, discretise};
pub use error::{QuadratureError, WeightFault};
pub use gaussian::{Curvature, Moments, ShiftedGaussian};
pub use kronrod::{Estimate, gauss_kronrod};
pub use legendre::{Legendre, legendre};
pub use nearby::Nearby;
pub use overlap::{Cells, Overlap, Weight};
pub use roots::bracketed_root;
pub use segment::reach;
pub use tanh_sinh::{Point, TanhSinh};
