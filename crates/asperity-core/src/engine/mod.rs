//! The one integral: laws averaged over heights, and loads turned back into separations.

pub(crate) mod arrays;
pub(crate) mod case;
pub(crate) mod case_integrals;
pub(crate) mod channel;
pub(crate) mod compiled;
pub(crate) mod few;
pub(crate) mod height_integral;
pub(crate) mod integrals;
pub(crate) mod inverse;
pub(crate) mod onset;
pub(crate) mod parallel;
pub(crate) mod plan;
pub(crate) mod readings;
pub(crate) mod sweep;
