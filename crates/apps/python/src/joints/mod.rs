//! Joints that open again or are sheared.

mod table;
mod unloading;

pub(crate) use table::JointTable;
pub(crate) use unloading::{PartialSlip, Unloading};

/// Rows of one task: each is an integral.
const ROWS_PER_TASK: usize = 4;
