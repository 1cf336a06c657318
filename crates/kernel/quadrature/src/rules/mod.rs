//! Quadrature rules for single integrals.

mod kronrod;
pub(crate) mod legendre;
mod tanh_sinh;

pub use kronrod::{Estimate, gauss_kronrod};
pub use legendre::{Legendre, legendre};
pub use tanh_sinh::{Point, TanhSinh};
