//! Integrals of a density over a probability density, which is given by its logarithm,
//!
//! ```text
//! I(d) = ∫ q((z - d)/unit) g(z) dz,
//! ```
//!
//! and their slopes. Series represent the weight g on panels between its breaks, once for all d
//! ([`Weight`]). A group of panels far from the kinks of q counts as twenty points ([`Overlap`]):
//! a table of a thousand panels costs three times one of ten. For many d, Chebyshev series
//! represent the integral itself, between the d at which a break of g meets a kink of q
//! ([`OverlapSeries`]).
//!
//! Adaptive discretisation of q g for each d was measured as an alternative: two to sixty times
//! the time on the same panels, seven to two hundred without panels, and wrong at poles.

mod cell;
mod cut;
mod fit;
mod follow;
mod integral;
mod integrand;
mod overlap_series;
mod panel;
mod run;
mod source;
mod strip;
mod tree;
mod weight;

pub use integral::Overlap;
pub use overlap_series::OverlapSeries;
pub use weight::Weight;
