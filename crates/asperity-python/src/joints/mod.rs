//! Joints that open again or are sheared.

mod partial_slip;
mod table;
mod unloading;

pub(crate) use partial_slip::PartialSlip;
pub(crate) use table::JointTable;
pub(crate) use unloading::Unloading;

/// Rows of one task: each is an integral.
const ROWS_PER_TASK: usize = 4;
