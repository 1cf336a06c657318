//! Heights with any other density.

use std::sync::Arc;

use asperity_quadrature::{Moments, QuadratureError};

use super::overlap::{Extent, OverlapIntegral};
use crate::heights::other::OtherHeights;

/// Any other heights: in metres, or in units of σ_z.
#[derive(Debug)]
pub(super) struct Other {
    pub(super) integral: OverlapIntegral,
    /// σ_z in the unit of the heights.
    pub(super) height_std: f64,
    pub(super) heights: Arc<OtherHeights>,
    pub(super) tolerance: f64,
}

impl Other {
    pub(super) fn at(&self, s: f64, extent: Extent) -> Result<Moments, QuadratureError> {
        let found = self.integral.at(&self.heights.weight()?, s * self.height_std, extent)?;
        let error = found.error + self.heights.heights().error();
        // Far out, the logarithm of a density that falls as steeply as exp(-z^30) has no digits.
        if error.is_infinite() {
            let (asked, evaluations) = (self.tolerance, 0);
            return Err(QuadratureError::NotConverged { reached: error, asked, evaluations });
        }
        Ok(Moments {
            slope: found.slope * self.height_std,
            sizes: [found.sizes[0], found.sizes[1] * self.height_std],
            error,
            ..found
        })
    }
}
