#![doc = include_str!("../README.md")]

use std::f64::consts::PI;
use std::ops::Range;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Evaluation, Law, Power, Provenance,
    Quantity, Tolerance, Validity, integral_failed, require,
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
    published: &[
        ("author", "Greenwood, J. A. and Williamson, J. B. P."),
        ("journal", "Proceedings of the Royal Society of London A"),
        ("volume", "295"),
        ("number", "1442"),
        ("pages", "300--319"),
        ("doi", "10.1098/rspa.1966.0242"),
    ],
};

impl Described for GreenwoodWilliamson {
    fn citation(&self) -> &Citation {
        &SOURCE
    }

    fn validity(&self) -> Validity {
        Validity {
            valid_for: "plasticity index below about 0.6; yielding is ignored",
            holds_to: Some(1.0),
            ..Validity::default()
        }
    }
}

const ALL: Range<f64> = 0.0..f64::INFINITY;

// The laws have no scale of their own: x is w in metres, so that no unit can overflow.
impl AsperityModel for GreenwoodWilliamson {
    fn force(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        // F = (4/3) E √R w^(3/2)
        let unit = 4.0 / 3.0 * asperity.equivalent_modulus * asperity.radius.sqrt();
        Ok(Law::in_units(1.0, unit).elastic(ALL, [Power::new(1.0, 1.5)]))
    }

    fn area(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        // A = π R w
        Ok(Law::in_units(1.0, PI * asperity.radius).elastic(ALL, [Power::new(1.0, 1.0)]))
    }
}

/// The integral of Greenwood & Williamson, F_n(h) = (2π)^(-1/2) ∫ₕ^∞ (s-h)^n exp(-s²/2) ds.
///
/// `order` n is from 0 to 10, `separation` h from -1e6 to 1e9. The relative error is below 1e-13
/// for h ≥ -64, and below 3e-14 |h| for smaller h. The logarithm stays finite where the value
/// itself underflows.
///
/// # Errors
/// [`ContactError::OutOfRange`] naming `order` or `separation`.
pub fn greenwood_integral(order: f64, separation: f64) -> Result<Evaluation, ContactError> {
    require((0.0..=10.0).contains(&order), "order", order, "a number from 0 to 10")?;
    let inside = (-1e6..=1e9).contains(&separation);
    require(inside, "separation", separation, "a number from -1e6 to 1e9")?;
    let density = Law::in_units(1.0, 1.0).elastic(ALL, [Power::new(1.0, order)]).density();
    let integral = ShiftedGaussian::new(density, 1.0, 1e-14);
    let found = integral.at(separation);
    Ok(found.map_err(integral_failed(Quantity::Force, &separation.into()))?.into())
}
