//! CEB: an asperity past the critical interference keeps its volume, at the mean pressure S H.
//!
//! # Law
//! With x = w/w_c, w_c = (π S H/(2E))² R:
//! ```text
//! x ≤ 1:   F = (4/3) E √R w^(3/2)      A = π R w
//! x > 1:   F = S H A                   A = π R (2w - w_c)
//! ```
//! In units of F_c = (2/3) π R w_c S H and A_c = π R w_c: x^(3/2) and 3x - 3/2; x and 2x - 1.
//!
//! The force jumps by 50 % at x = 1: from F_c to (3/2) F_c. That is the published model, and the
//! tangent -dF/dd holds the jump. \[seen\]
//!
//! # Valid for
//! w_c < R. A first step beyond GW: there is no transition between elastic and plastic.
//!
//! # Source
//! Chang, Etsion & Bogy 1987, "An elastic-plastic model for the contact of rough surfaces". \[seen\]
//!
//! # Example
//! ```
//! use asperity_core::{Asperity, AsperityModel, Interface, Quantity, Tolerance};
//! use asperity_ceb::ChangEtsionBogy;
//!
//! let asperity = Asperity::new(&Interface::new(116e9, 0.31, 1.12e9), 3.6e-4)?;
//! let force = ChangEtsionBogy.law(&asperity, Quantity::Force, Tolerance::default())?.unwrap();
//! let (w, f) = (asperity.critical_interference()?, asperity.critical_force()?);
//! assert!((force.value(2.0 * w).unwrap() / f - 4.5).abs() < 1e-12);
//! # Ok::<(), asperity_core::ContactError>(())
//! ```

use std::f64::consts::PI;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Law, Power, Provenance, Quantity,
    Tolerance, Validity,
};
use serde::{Deserialize, Serialize};

/// The model of Chang, Etsion and Bogy.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct ChangEtsionBogy;

const SOURCE: Citation = Citation {
    id: "ceb",
    name: "CEB",
    authors: "Chang, Etsion & Bogy",
    year: 1987,
    title: "An elastic-plastic model for the contact of rough surfaces",
    provenance: Provenance::Seen,
};

impl Described for ChangEtsionBogy {
    fn citation(&self) -> &Citation {
        &SOURCE
    }

    fn validity(&self) -> Validity {
        Validity::default().valid_for(
            "w_c < R; elastic or plastic, nothing between: the force jumps by half at w_c",
        )
    }
}

impl AsperityModel for ChangEtsionBogy {
    fn law(
        &self,
        asperity: &Asperity,
        quantity: Quantity,
        _: Tolerance,
    ) -> Result<Option<Law>, ContactError> {
        let critical = asperity.critical_interference()?;
        let beyond = 1.0..f64::INFINITY;
        Ok(Some(match quantity {
            Quantity::Force => Law::in_units(critical, asperity.critical_force()?)
                .elastic(0.0..1.0, [Power::new(1.0, 1.5)])
                .plastic(beyond, [Power::new(3.0, 1.0), Power::new(-1.5, 0.0)]),
            Quantity::Area => Law::in_units(critical, PI * asperity.radius * critical)
                .elastic(0.0..1.0, [Power::new(1.0, 1.0)])
                .plastic(beyond, [Power::new(2.0, 1.0), Power::new(-1.0, 0.0)]),
            _ => return Ok(None),
        }))
    }
}
