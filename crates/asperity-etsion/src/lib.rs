//! Etsion: one elastic-plastic range for loading, fitted to finite elements up to x = 170.
//!
//! # Law
//! With x = w/w_c, w_c = (π S H/(2E))² R, F_c = (2/3) π R w_c S H and A_c = π R w_c:
//! ```text
//!              F/F_c                      A/A_c
//! x ≤ 1        x^1.5                      x
//! 1..170       1 + 1.32 (x-1)^1.27        1 + 1.19 (x-1)^1.1
//! x > 170      (3/S) x                    2x
//! ```
//! The slope is 0 just above x = 1, so the force dips below Hertz there. Above x = 170 the fit
//! ends: the contact is taken as fully plastic, as in KE, and the force jumps there (at S = 0.577
//! by -0.94 %, so that it is not monotone) as does the area; that jump is up to 0.72 % of the
//! tangent (at ψ = 13, d = 0). That range is ours, not the paper's. \[recalled\]
//!
//! # Valid for
//! w_c < R, loading only.
//!
//! # Source
//! Etsion, Kligerman & Kadin 2005, "Unloading of an elastic-plastic loaded spherical contact".
//! \[recalled\]
//!
//! # Example
//! ```
//! use asperity_core::{Asperity, AsperityModel, Interface, Quantity, Tolerance};
//! use asperity_etsion::EtsionKligermanKadin;
//!
//! let asperity = Asperity::new(&Interface::new(116e9, 0.31, 1.12e9), 3.6e-4)?;
//! let force = EtsionKligermanKadin.law(&asperity, Quantity::Force, Tolerance::default())?.unwrap();
//! let (w, f) = (asperity.critical_interference()?, asperity.critical_force()?);
//! assert!((force.value(2.0 * w).unwrap() / f - 2.32).abs() < 1e-12);
//! # Ok::<(), asperity_core::ContactError>(())
//! ```

use std::f64::consts::PI;

use asperity_core::{
    Asperity, AsperityModel, Claims, ContactError, Law, Power, Provenance, Quantity, Source,
    Tolerance,
};
use serde::{Deserialize, Serialize};

/// The model of Etsion, Kligerman and Kadin, loading.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct EtsionKligermanKadin;

const SOURCE: Source = Source {
    id: "etsion",
    name: "Etsion",
    authors: "Etsion, Kligerman & Kadin",
    year: 2005,
    title: "Unloading of an elastic-plastic loaded spherical contact",
    provenance: Provenance::Recalled,
};

impl AsperityModel for EtsionKligermanKadin {
    fn source(&self) -> &Source {
        &SOURCE
    }

    fn law(
        &self,
        asperity: &Asperity,
        quantity: Quantity,
        _: Tolerance,
    ) -> Result<Option<Law>, ContactError> {
        let critical = asperity.critical_interference()?;
        let fit = |c, p| [Power::new(1.0, 0.0), Power::from_origin(c, 1.0, p)];
        let beyond = 170.0..f64::INFINITY;
        Ok(Some(match quantity {
            Quantity::Force => Law::in_units(critical, asperity.critical_force()?)
                .elastic(0.0..1.0, [Power::new(1.0, 1.5)])
                .elastic_plastic(1.0..170.0, fit(1.32, 1.27))
                .plastic(beyond, [Power::new(3.0 / asperity.pressure_factor, 1.0)]),
            Quantity::Area => Law::in_units(critical, PI * asperity.radius * critical)
                .elastic(0.0..1.0, [Power::new(1.0, 1.0)])
                .elastic_plastic(1.0..170.0, fit(1.19, 1.1))
                .plastic(beyond, [Power::new(2.0, 1.0)]),
            _ => return Ok(None),
        }))
    }

    fn claims(&self) -> Claims {
        // Whether the step at x = 170 rises or falls depends on S.
        Claims::default()
            .not_monotone()
            .valid_for("w_c < R, loading; fitted to finite elements up to 170 w_c, plastic beyond")
            .holds_to(170.0)
    }
}
