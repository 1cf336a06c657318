#![doc = include_str!("../README.md")]

use asperity_core::Validity;

mod dmt;
mod jkr;
mod pull_off;

pub use dmt::DerjaguinMullerToporov;
pub use jkr::{JkrBranch, JohnsonKendallRoberts};
pub use pull_off::{PullOff, pull_off};

/// The validity of an adhesive model, with its range of the Tabor parameter.
fn adhesive_validity([least, most]: [f64; 2], valid_for: &'static str) -> Validity {
    Validity {
        force_monotone: false,
        hertz_limit: None,
        adhesive: true,
        tabor: Some([least, most]),
        valid_for,
        holds_to: Some(1.0),
        ..Validity::default()
    }
}
