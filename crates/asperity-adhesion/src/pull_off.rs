//! The largest tension that rough surfaces hold.

use asperity_core::{Contact, ContactError, Evaluation, Quantity, Separation};
use asperity_quadrature::{bracketed_root, fallible};
use serde::Serialize;

/// Where the force is least.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PullOff {
    /// The force there \[N\], below 0; on rough stiff surfaces too small for a double.
    pub force: Evaluation,
    /// Where it is, over σ_z from the mean of the asperity heights.
    pub separation: Separation,
}

/// The search begins between these separations \[σ_z\], and goes on twice as far where need be.
const NEAR: f64 = 8.0;
/// No separation beyond is looked at \[σ_z\].
const FARTHEST: f64 = 1e6;
/// Looks between both ends: on ordinary scenes four for each σ_z, and nothing is narrower.
const LOOKS: usize = 64;

/// The least force of a contact that was compiled for force and tangent; `None` where it falls all the
/// way to 0, and nothing is held: without adhesion, and under heights with a tail so heavy that the
/// highest asperities are always pressed harder than the others pull (exponential heights from
/// θ = 2√π on, by DMT).
///
/// # Errors
/// Those of [`evaluate`](Contact::evaluate_at); [`ContactError::OutOfRange`] for a force that does not
/// rise however far the surfaces are pressed together.
pub fn pull_off(contact: &dyn Contact) -> Result<Option<PullOff>, ContactError> {
    let tangent = |s: f64| contact.evaluate(Quantity::Tangent, Separation::sigmas(s));
    // The tangent over its size; below 0 where nothing touches.
    let rises = |s: f64| -> Result<f64, ContactError> {
        let tangent = tangent(s)?;
        Ok(if tangent.size > 0.0 { tangent.scaled / tangent.size } else { -1.0 })
    };
    let (mut low, mut high) = (-NEAR, NEAR);
    while rises(low)? <= 0.0 {
        if 2.0 * low < -FARTHEST {
            let required = "one above 0 where the surfaces are pressed together";
            let value = tangent(low)?.value();
            return Err(ContactError::OutOfRange { field: "tangent", value, required });
        }
        low *= 2.0;
    }
    while rises(high)? >= 0.0 {
        high *= 2.0;
        if high > FARTHEST {
            return Ok(None);
        }
    }
    let place = |k: usize| low + (high - low) * k as f64 / LOOKS as f64;
    let looks: Vec<f64> = (0..=LOOKS).map(|k| rises(place(k))).collect::<Result<_, _>>()?;
    let mut least: Option<PullOff> = None;
    for k in (0..LOOKS).filter(|k| looks[*k] > 0.0 && looks[*k + 1] <= 0.0) {
        let root = fallible(rises, |rises| bracketed_root(rises, place(k), place(k + 1)))?;
        // Between a rise and a fall there is one, where no error was.
        let Some(s) = root else { continue };
        let separation = Separation::sigmas(s);
        let force = contact.evaluate(Quantity::Force, separation)?;
        let less = |known: PullOff| force.ln_value() > known.force.ln_value();
        if force.scaled < 0.0 && least.is_none_or(less) {
            least = Some(PullOff { force, separation });
        }
    }
    Ok(least)
}
