//! DMT and JKR: elastic asperities that stick.
//!
//! # Laws
//! With the work of adhesion w_a \[J/m²\]. DMT adds a constant pull to a Hertzian contact:
//! ```text
//! F = (4/3) E √R w^(3/2) - 2π w_a R,      A = π R w       for w > 0                          [seen]
//! ```
//! In JKR's contact, of radius a, the pull stretches the asperity:
//! ```text
//! w = a²/R - √(2π w_a a/E),      F = 4 E a³/(3R) - √(8π w_a E a³),      A = π a²             [seen]
//! ```
//! As the separation is given (not the load of each asperity), there are two branches: on **approach** a
//! contact begins at w = 0, and jumps to F = -(4/3) π w_a R there; on **separation** it lasts, stretched,
//! to w = -w_p, where F = -(5/6) π w_a R: \[derived\]
//! ```text
//! w_p = 3 (π² w_a² R/(64 E²))^(1/3),      r = a/a_p to the power ½, a_p² = R w_p/3:
//! w/w_p = (r⁴ - 4r)/3,      F/((5/6) π w_a R) = (r⁶ - 6r³)/5
//! ```
//! r ≥ 1 on separation, r ≥ 4^(1/3) on approach. A loop of approach and separation loses the energy
//! between the branches. For w_a = 0 all are GW.
//!
//! Motions too small to move the edge of a contact feel 2 E a all the same, which is the quantity
//! `unloading-stiffness`; opening farther follows the separation branch, and no law of unloading
//! (crate `asperity-joints`).
//!
//! # Valid for
//! Elastic asperities alone in their pull, Tabor's parameter μ below about 0.1 (DMT: small, hard) or above
//! about 5 (JKR: large, soft); [`Asperity::tabor_parameter`]. With θ = E σ_z^1.5/(w_a √R) above about
//! 10, roughness all but hides adhesion. Separations that are asked for on the separation branch are
//! those of a joint all of whose asperities have touched before.
//!
//! # Source
//! Derjaguin, Muller & Toporov 1975; Johnson, Kendall & Roberts 1971; over heights: Fuller & Tabor 1975
//! (JKR), Maugis 1996 (DMT). \[recalled; the laws seen\]
//!
//! # Example
//! ```
//! use asperity_adhesion::{JkrBranch, JohnsonKendallRoberts, pull_off};
//! use asperity_core::{ContactModel, Interface, Quantity, Request, Scene, Surface};
//!
//! let mut rubber = Interface::elastic(1e6, 0.5);
//! rubber.work_of_adhesion = Some(0.05); // J/m²
//! let scene = Scene::new(rubber, Surface::new(1e-4, 1e9, 1e-6), 1e-4);
//! let parting = JohnsonKendallRoberts { branch: JkrBranch::Separation };
//! let contact = parting.compile(&scene, &Request::new([Quantity::Force, Quantity::Tangent]))?;
//! let found = pull_off(&*contact)?.expect("it sticks");
//! let force = found.force.value();
//! assert!(force < 0.0);
//! // Half of it is held at two separations: the larger one is not stable under a dead load.
//! assert_eq!(contact.separations_at(0.5 * force)?.len(), 2);
//! # Ok::<(), asperity_core::ContactError>(())
//! ```
//!
//! [`Asperity::tabor_parameter`]: asperity_core::Asperity::tabor_parameter

use asperity_core::{Asperity, Law, Power, Quantity, Validity};

mod dmt;
mod jkr;
mod pull_off;

pub use dmt::DerjaguinMullerToporov;
pub use jkr::{JkrBranch, JohnsonKendallRoberts};
pub use pull_off::{PullOff, pull_off};

/// What models of elastic asperities that stick say of themselves: for which Tabor parameters they are.
fn sticking([least, most]: [f64; 2], valid_for: &'static str) -> Validity {
    Validity::with_adhesion().for_tabor(least, most).valid_for(valid_for).holds_to(1.0)
}

/// Hertz' laws of w in metres: what is left without adhesion, and DMT's contact.
fn hertz(asperity: &Asperity, quantity: Quantity) -> Option<Law> {
    let (e, r) = (asperity.equivalent_modulus, asperity.radius);
    let (unit, exponent) = match quantity {
        Quantity::Force => (4.0 / 3.0 * e * r.sqrt(), 1.5),
        Quantity::Area => (std::f64::consts::PI * r, 1.0),
        _ => return None,
    };
    let all = 0.0..f64::INFINITY;
    Some(Law::in_units(1.0, unit).elastic(all, [Power::new(1.0, exponent)]))
}
