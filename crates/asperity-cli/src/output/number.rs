//! Rounded numbers for tables.

pub use asperity_answer::rounded;
