//! KE: power laws fitted to finite elements, in two elastic-plastic ranges.
//!
//! # Law
//! With x = w/w_c, w_c = (π S H/(2E))² R, F_c = (2/3) π R w_c S H and A_c = π R w_c:
//! ```text
//!              F/F_c            A/A_c
//! x ≤ 1        x^1.5            x
//! 1..6         1.03 x^1.425     0.93 x^1.136
//! 6..110       1.40 x^1.263     0.94 x^1.146
//! x > 110      (3/S) x          2x              (F = 2π R w H: mean pressure H)
//! ```
//! The fits do not meet: at S = 0.577 the force jumps by +3 %, +1.68 % and +7.88 %, the area by
//! -7 %, +2.90 % and +7.12 %. The tangent -dF/dd holds these jumps. \[seen\]
//!
//! # Valid for
//! w_c < R. Published end points at x = 110⁻: F/F_c = 534 (the fit gives 530.2), A/A_c = 205 (205.4).
//!
//! # Source
//! Kogut & Etsion 2002, "Elastic-plastic contact analysis of a sphere and a rigid flat"; 2003, "A
//! finite element based elastic-plastic model for the contact of rough surfaces". \[seen\]
//!
//! # Example
//! ```
//! use asperity_core::{ContactModel, Interface, Quantity, Request, Scene, Surface};
//! use asperity_ke::KogutEtsion;
//!
//! let interface = Interface::new(116e9, 0.31, 1.12e9);
//! let scene = Scene::new(interface, Surface::new(3.6e-4, 1.11e8, 1e-6), 3e-5);
//! let asked = Request::new([Quantity::Force]).at([2.0]).with_shares();
//! let answer = KogutEtsion.solve(&scene, &asked)?;
//! let shares = answer.column(Quantity::Force)?.shares.clone().unwrap_or_default();
//! assert_eq!(shares[0].as_deref().unwrap_or_default().iter().map(|s| &*s.name).collect::<Vec<_>>(),
//!            ["elastic", "elastic-plastic", "elastic-plastic 2", "plastic"]);
//! # Ok::<(), asperity_core::ContactError>(())
//! ```

use std::f64::consts::PI;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Law, Power, Provenance, Quantity,
    Tolerance, Validity,
};
use serde::{Deserialize, Serialize};

/// The model of Kogut and Etsion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct KogutEtsion;

const SOURCE: Citation = Citation {
    id: "ke",
    name: "KE",
    authors: "Kogut & Etsion",
    year: 2002,
    title: "Elastic-plastic contact analysis of a sphere and a rigid flat",
    provenance: Provenance::Seen,
};

impl Described for KogutEtsion {
    fn citation(&self) -> &Citation {
        &SOURCE
    }

    fn validity(&self) -> Validity {
        Validity::default()
            .valid_for("w_c < R; fitted to finite elements up to 110 w_c, plastic beyond")
            .holds_to(110.0)
    }
}

impl AsperityModel for KogutEtsion {
    fn law(
        &self,
        asperity: &Asperity,
        quantity: Quantity,
        _: Tolerance,
    ) -> Result<Option<Law>, ContactError> {
        let critical = asperity.critical_interference()?;
        let beyond = 110.0..f64::INFINITY;
        Ok(Some(match quantity {
            Quantity::Force => Law::in_units(critical, asperity.critical_force()?)
                .elastic(0.0..1.0, [Power::new(1.0, 1.5)])
                .elastic_plastic(1.0..6.0, [Power::new(1.03, 1.425)])
                .elastic_plastic(6.0..110.0, [Power::new(1.40, 1.263)])
                .plastic(beyond, [Power::new(3.0 / asperity.pressure_factor, 1.0)]),
            Quantity::Area => Law::in_units(critical, PI * asperity.radius * critical)
                .elastic(0.0..1.0, [Power::new(1.0, 1.0)])
                .elastic_plastic(1.0..6.0, [Power::new(0.93, 1.136)])
                .elastic_plastic(6.0..110.0, [Power::new(0.94, 1.146)])
                .plastic(beyond, [Power::new(2.0, 1.0)]),
            _ => return Ok(None),
        }))
    }
}
