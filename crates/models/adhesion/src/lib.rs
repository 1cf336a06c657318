#![doc = include_str!("../README.md")]

use asperity_core::{Contact, ContactError, Evaluation, Quantity, Separation, Validity};
use serde::Serialize;

mod dmt;
mod jkr;

pub use dmt::DerjaguinMullerToporov;
pub use jkr::{JkrBranch, JohnsonKendallRoberts};

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

/// The separation of the least force.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PullOff {
    /// The force there \[N\], below 0.
    pub force: Evaluation,
    /// Its separation, in σ_z from the mean of the asperity heights.
    pub separation: Separation,
}

/// The least force of a contact compiled for the force; `None` if no force below 0 is within the
/// range of f64: without adhesion, on rough stiff surfaces, and for heights with so heavy a tail
/// that the highest asperities always push more than the others pull (exponential heights from θ =
/// 2√π, by DMT).
///
/// # Errors
/// The errors of [`Contact`].
pub fn pull_off(contact: &dyn Contact) -> Result<Option<PullOff>, ContactError> {
    let Some(separation) = contact.pull_off()? else { return Ok(None) };
    let force = contact.evaluate(Quantity::Force, separation)?;
    Ok(Some(PullOff { force, separation }))
}
