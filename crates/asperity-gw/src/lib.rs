//! GW: every asperity is a Hertzian sphere, and none ever yields.
//!
//! # Law
//! ```text
//! F = (4/3) E √R w^(3/2),      A = π R w
//! ```
//! For Gaussian heights, with t = d/σ_z:
//! ```text
//! F = (4/3) η A_n E √R σ_z^(3/2) F_{3/2}(t),      A = π η A_n R σ_z F_1(t)
//! F_n(t) = (2π)^(-1/2) ∫ₜ^∞ (s-t)^n exp(-s²/2) ds
//! ```
//!
//! # Valid for
//! Plasticity index ψ below about 0.6; every other model tends to this one as ψ → 0. Hardness and
//! shear modulus do not enter.
//!
//! # Source
//! Greenwood & Williamson 1966, "Contact of nominally flat surfaces". \[seen\]
//!
//! # Example
//! Exponential heights have a closed form: F = √π η A_n R σ E √(σ/R) exp(-d/σ).
//! ```
//! use asperity_core::{ContactModel, HeightDistribution, Interface, Quantity, Request, Scene, Surface};
//! use asperity_gw::GreenwoodWilliamson;
//!
//! let (e, r, eta, sigma, area) = (116e9, 3.6e-4, 1.11e8, 1e-6, 3e-5);
//! let mut scene = Scene::new(Interface::new(e, 0.31, 1.12e9), Surface::new(r, eta, sigma), area);
//! scene.heights = HeightDistribution::Exponential;
//! let answer = GreenwoodWilliamson.solve(&scene, &Request::new([Quantity::Force]).at([2.0]))?;
//! let closed = std::f64::consts::PI.sqrt() * eta * area * r * sigma * e * (sigma / r).sqrt() * (-2.0f64).exp();
//! assert!((answer.values(Quantity::Force)?[0] / closed - 1.0).abs() < 1e-14);
//! # Ok::<(), asperity_core::ContactError>(())
//! ```

use std::f64::consts::PI;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Evaluation, Law, Power, Provenance,
    Quantity, Tolerance, Validity,
};
use asperity_quadrature::ShiftedGaussian;
use serde::{Deserialize, Serialize};

/// The model of Greenwood and Williamson.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct GreenwoodWilliamson;

const SOURCE: Citation = Citation {
    id: "gw",
    name: "GW",
    authors: "Greenwood & Williamson",
    year: 1966,
    title: "Contact of nominally flat surfaces",
    provenance: Provenance::Seen,
};

impl Described for GreenwoodWilliamson {
    fn citation(&self) -> &Citation {
        &SOURCE
    }

    fn validity(&self) -> Validity {
        Validity::default()
            .valid_for("plasticity index below about 0.6: no asperity yields")
            .holds_to(1.0)
    }
}

impl AsperityModel for GreenwoodWilliamson {
    fn law(
        &self,
        asperity: &Asperity,
        quantity: Quantity,
        _: Tolerance,
    ) -> Result<Option<Law>, ContactError> {
        // Nothing sets a scale: x is w in metres, and no unit overflows before the answer does.
        let (e, r) = (asperity.equivalent_modulus, asperity.radius);
        let all = 0.0..f64::INFINITY;
        Ok(Some(match quantity {
            Quantity::Force => {
                Law::in_units(1.0, 4.0 / 3.0 * e * r.sqrt()).elastic(all, [Power::new(1.0, 1.5)])
            }
            Quantity::Area => Law::in_units(1.0, PI * r).elastic(all, [Power::new(1.0, 1.0)]),
            _ => return Ok(None),
        }))
    }
}

/// F_n(h) = (2π)^(-1/2) ∫ₕ^∞ (s-h)^n exp(-s²/2) ds, the integral of Greenwood & Williamson, for
/// `order` n from 0 to 10 and `separation` h from -1e6 to 1e9; relative error below 1e-13
/// for h ≥ -64, and below 3e-14 |h| under that.
///
/// Far in the tail the value comes with its logarithm; it is never 0 by underflow alone.
///
/// # Errors
/// [`ContactError::OutOfRange`] naming `order` or `separation`.
pub fn greenwood_integral(order: f64, separation: f64) -> Result<Evaluation, ContactError> {
    if !(0.0..=10.0).contains(&order) {
        let required = "a number from 0 to 10";
        return Err(ContactError::OutOfRange { field: "order", value: order, required });
    }
    if !(-1e6..=1e9).contains(&separation) {
        let required = "a number from -1e6 to 1e9";
        return Err(ContactError::OutOfRange { field: "separation", value: separation, required });
    }
    let all = 0.0..f64::INFINITY;
    let density = Law::in_units(1.0, 1.0).elastic(all, [Power::new(1.0, order)]).density();
    let integral = ShiftedGaussian::new(density, 1.0, 1e-14);
    let failed = |source| {
        let (quantity, at) = (Quantity::Force, separation.into());
        ContactError::Integral { quantity, at, source }
    };
    Ok(integral.at(separation).map_err(failed)?.into())
}
