#![doc = include_str!("../README.md")]

use asperity_core::{Asperity, Law, Power, Quantity, Validity};

mod dmt;
mod jkr;
mod pull_off;

pub use dmt::DerjaguinMullerToporov;
pub use jkr::{JkrBranch, JohnsonKendallRoberts};
pub use pull_off::{PullOff, pull_off};

/// The validity of an adhesive model, with its range of the Tabor parameter.
fn adhesive_validity([least, most]: [f64; 2], valid_for: &'static str) -> Validity {
    Validity::with_adhesion().for_tabor(least, most).valid_for(valid_for).holds_to(1.0)
}

/// The laws of Hertz, w in metres: the limit without adhesion, and the contact of DMT.
fn hertz(asperity: &Asperity, quantity: Quantity) -> Option<Law> {
    let (e, r) = (asperity.equivalent_modulus, asperity.radius);
    // F = (4/3) E √R w^(3/2), A = π R w
    let (unit, exponent) = match quantity {
        Quantity::Force => (4.0 / 3.0 * e * r.sqrt(), 1.5),
        Quantity::Area => (std::f64::consts::PI * r, 1.0),
        _ => return None,
    };
    let all = 0.0..f64::INFINITY;
    Some(Law::in_units(1.0, unit).elastic(all, [Power::new(1.0, exponent)]))
}
