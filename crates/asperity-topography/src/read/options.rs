//! Options for reading scans.

use crate::error::out_of_range;
use crate::{Distance, LengthUnit, TopographyError};

/// Properties that a file may not state, and the accepted share of missing points.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadOptions {
    /// Unit of the heights, and of a `pixel_size` without one. A unit stated in the file must
    /// agree.
    pub unit: Option<LengthUnit>,
    /// Distance of neighbouring points along a row and along a column; without a unit of its own in
    /// `unit` (by default in the unit stated in the file). A distance stated in the file must
    /// agree to one part in a thousand.
    pub pixel_size: Option<[Distance; 2]>,
    /// The largest share of missing points accepted, 0 to 1; 0.1 by default.
    pub max_missing: f64,
    /// The channel of a file with several (.gwy, .sur): its name, or its number among those of
    /// heights, from 1. By default the first one with heights.
    pub channel: Option<String>,
}

impl ReadOptions {
    /// Checks the range of every option, before a file is read.
    pub(crate) fn check(&self) -> Result<(), TopographyError> {
        for size in self.pixel_size.into_iter().flatten().map(Distance::value) {
            if !(f64::MIN_POSITIVE..=f64::MAX).contains(&size) {
                return Err(out_of_range("pixel_size", size, "a finite length above 0"));
            }
        }
        if !(0.0..=1.0).contains(&self.max_missing) {
            return Err(out_of_range("max_missing", self.max_missing, "a share from 0 to 1"));
        }
        Ok(())
    }
}

impl Default for ReadOptions {
    fn default() -> Self {
        Self { unit: None, pixel_size: None, max_missing: 0.1, channel: None }
    }
}
