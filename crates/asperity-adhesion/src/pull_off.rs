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

/// The search looks between these separations \[σ_z\], and on twice as far each time where need be.
const NEAR: f64 = 8.0;
/// No separation beyond these is looked at \[σ_z\].
const DEEPEST: f64 = -1e6;
const FARTHEST: f64 = 1e9;
/// Looks within: four for each σ_z, and nothing is narrower there. Further out only adhesion itself
/// is as wide as it is far.
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
    let mut places = vec![-NEAR];
    while rises(places[0])? <= 0.0 {
        if 2.0 * places[0] < DEEPEST {
            let required = "one above 0 where the surfaces are pressed together";
            let value = tangent(places[0])?.value();
            return Err(ContactError::OutOfRange { field: "tangent", value, required });
        }
        places.insert(0, 2.0 * places[0]);
    }
    places.extend((1..=LOOKS).map(|k| NEAR * (2.0 * k as f64 / LOOKS as f64 - 1.0)));
    let mut farthest = NEAR;
    while rises(farthest)? >= 0.0 {
        if farthest >= FARTHEST {
            let force = contact.evaluate(Quantity::Force, Separation::sigmas(farthest))?;
            // Without an end the force falls, but stays above 0; pulling, it must turn.
            let (field, value) = ("force at the farthest separation", force.value());
            let required = "one that has turned within 1e9 asperity_height_std";
            let pulls = force.scaled < 0.0;
            let beyond = ContactError::OutOfRange { field, value, required };
            return if pulls { Err(beyond) } else { Ok(None) };
        }
        farthest = (2.0 * farthest).min(FARTHEST);
        places.push(farthest);
    }
    let looks: Vec<f64> = places.iter().map(|place| rises(*place)).collect::<Result<_, _>>()?;
    let mut least: Option<PullOff> = None;
    for k in (1..places.len()).filter(|k| looks[*k - 1] > 0.0 && looks[*k] <= 0.0) {
        let root = fallible(rises, |rises| bracketed_root(rises, places[k - 1], places[k]))?;
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
