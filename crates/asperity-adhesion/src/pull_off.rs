//! The largest tension that rough surfaces hold.

use asperity_core::{Contact, ContactError, Evaluation, Quantity, Separation};
use serde::Serialize;

/// Where the force is least.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PullOff {
    /// The force there \[N\], below 0; on rough stiff surfaces too small for a double.
    pub force: Evaluation,
    /// Where it is, over σ_z from the mean of the asperity heights.
    pub separation: Separation,
}

/// The least force of a contact that was compiled for it; `None` where the force falls all the way
/// to 0: without adhesion, and under heights with a tail so heavy that the highest asperities are
/// always pressed harder than the others pull (exponential heights from θ = 2√π on, by DMT).
///
/// # Errors
/// Those of [`Contact::pull_off`] and [`evaluate`](Contact::evaluate_at).
pub fn pull_off(contact: &dyn Contact) -> Result<Option<PullOff>, ContactError> {
    let Some(separation) = contact.pull_off()? else { return Ok(None) };
    let force = contact.evaluate(Quantity::Force, separation)?;
    Ok(Some(PullOff { force, separation }))
}
