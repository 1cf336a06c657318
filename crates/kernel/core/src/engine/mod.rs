//! Laws averaged over heights, and the separations of loads.

pub(crate) mod alone;
pub(crate) mod averages;
pub(crate) mod case_integrals;
pub(crate) mod contact;
pub(crate) mod height_integral;
pub(crate) mod inverse;
pub(crate) mod laws;
pub(crate) mod list;
pub(crate) mod parallel;
pub(crate) mod prepared;
pub(crate) mod row_integrals;
pub(crate) mod sweep;
