//! What a file may leave open.

use crate::LengthUnit;

/// What a file may leave open, and how much of it may be missing.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadOptions {
    /// Unit of the heights, and of `pixel_size` where that is given. A file that states its unit
    /// must agree.
    pub unit: Option<LengthUnit>,
    /// Distance of neighbouring points along a row and along a column, in `unit` (in the unit the
    /// file states for its heights where `unit` is not given). A file that states it must agree
    /// to one part in a thousand.
    pub pixel_size: Option<[f64; 2]>,
    /// The largest share of missing points that is accepted, 0 to 1; 0.1 by default.
    pub max_missing: f64,
}

impl Default for ReadOptions {
    fn default() -> Self {
        Self { unit: None, pixel_size: None, max_missing: 0.1 }
    }
}
