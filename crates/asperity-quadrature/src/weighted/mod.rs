//! Integrals of a density over a probability density that is known by its logarithm,
//!
//! ```text
//! I(d) = ∫ q((z - d)/unit) g(z) dz,
//! ```
//!
//! and their slopes. The weight g is followed once, on panels between its breaks ([`Weight`]);
//! groups of panels that lie far from the kinks of q count as twenty points each, so that a
//! table of a thousand panels costs little more than one of ten ([`Overlap`]). For many d, the
//! integral itself becomes Chebyshev series between the d at which a break of g meets a kink of q
//! ([`Cells`]).

mod cells;
mod cut;
mod fit;
mod follow;
mod integral;
mod integrand;
mod panel;
mod run;
mod slope;
mod source;
mod strip;
mod tree;
mod weight;

pub use cells::Cells;
pub use integral::Overlap;
pub use weight::Weight;
