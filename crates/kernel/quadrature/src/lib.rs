//! Quadrature for densities with kinks: adaptive discretisation, polynomials that replace the
//! integral, and the classical methods of the comparisons.
//!
//! The integrals of this workspace are all of one kind,
//!
//! ```text
//! I(s) = ∫₀^∞ q(t/c) φ(s + t) dt,      φ(t) = exp(-t²/2)/√(2π)
//! ```
//!
//! with a density q ≥ 0 that has kinks, jumps and fractional powers, and an entire function φ.
//! For every q, I is an entire function of s, and smooth in c: it is sampled at a few s, and a
//! polynomial through these samples then gives I without a sample of q.
//!
//! 1. adaptive discretisation replaces q(t) φ(s + t) by point masses, on panels that end at the
//!    kinks and are refined until a Legendre tail shows that they are resolved;
//! 2. the sums over these hundreds of masses at Chebyshev's points of a short range of s (and of
//!    scales, for [`AnyScale`]) become a polynomial of 8 to 16 terms; the terms left out are
//!    computed, and bound the error;
//! 3. [`ShiftedGaussian`] does both once for each range, on demand, and then evaluates the value
//!    and its derivatives without a branch, a power or an exponential, with the same digits on
//!    every processor;
//! 4. [`ShiftedGaussian::fill`] evaluates whole arrays, with the values of one range side by side
//!    in the widest registers of the processor.
//!
//! [`Weight`], [`Overlap`] and [`OverlapSeries`] do the same for any other density in place of φ,
//! with kinks, jumps and poles of its own.
//!
//! This crate knows nothing of contact mechanics, and reads no files.

#![forbid(unsafe_code)]

mod chebyshev;
mod density;
mod discretise;
mod error;
mod function_table;
mod gaussian;
mod roots;
mod rules;
mod weighted;

pub use chebyshev::{chebyshev_roots, chebyshev_terms};
pub use density::{Density, Piece, PointMasses, Sampler, WeightFunction};
pub use error::{QuadratureError, WeightFault};
pub use function_table::FunctionTable;
pub use gaussian::{
    AnyScale, ArrayAccuracy, Moments, Nearby, ScaledIntegral, ShiftedGaussian, reach,
};
pub use roots::{bracketed_root, fallible, highest, last_place};
pub use rules::{Estimate, Legendre, Point, TanhSinh, gauss_kronrod, legendre};
pub use weighted::{Overlap, OverlapSeries, Weight};

pub(crate) use discretise::{Goal, discretise};
