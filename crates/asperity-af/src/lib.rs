//! AF: an elastic asperity with a plastic asperity embedded in it, one critical interference deep.
//!
//! # Law
//! The embedded asperity has radius R_p = R - w_c and its tip lies w_c below the elastic one. The
//! elastic load its core would carry is taken out, and its plastic load put in. With x = w/w_c:
//! ```text
//! x ≤ 1:   F = (4/3) E √R w^(3/2)          A = π R w
//! x > 1:   F = (4/3) E √R w^(3/2) - (4/3) E √R_p (w-w_c)^(3/2) + 2π R_p (w-w_c) S H
//!          A = π R w - π R_p (w-w_c) + 2π R_p (w-w_c)
//! ```
//! In units of F_c and A_c, with k = √(R_p/R) and flow pressure p (S H, or H by option):
//! ```text
//! F/F_c = x^1.5 - k (x-1)^1.5 + 3 k² (p/(S H)) (x-1),      A/A_c = x + k² (x-1)
//! ```
//! F/F_c is 2.98356, 18.52 and 342.7 at x = 1.5, 6 and 110 for R_p → R. Continuous at x = 1; for R_p → R the area is that of CEB. For large x the two powers cancel:
//! they are evaluated as (3x² - 3x + 1)/(x^1.5 + (x-1)^1.5) + (1-k)(x-1)^1.5. \[derived\]
//!
//! # Valid for
//! w_c < R. The term (1-k) x^1.5 never settles: there is no plastic limit of the mean pressure.
//!
//! # Source
//! Abdo & Farhang 2005, "Elastic-plastic contact model for rough surfaces based on plastic asperity
//! concept". The equations are derived from its abstract and from the AT paper's words. \[derived\]
//!
//! # Example
//! ```
//! use asperity_core::{Asperity, AsperityModel, Interface, Quantity, Tolerance};
//! use asperity_af::AbdoFarhang;
//!
//! let asperity = Asperity::new(&Interface::new(116e9, 0.31, 1.12e9), 3.6e-4)?;
//! let force = AbdoFarhang::default().law(&asperity, Quantity::Force, Tolerance::default())?.unwrap();
//! let (w, f) = (asperity.critical_interference()?, asperity.critical_force()?);
//! assert!((force.value(1.5 * w).unwrap() / f - 2.983).abs() < 1e-3);
//! # Ok::<(), asperity_core::ContactError>(())
//! ```

use std::f64::consts::PI;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Formula, Law, Power, Provenance,
    Quantity, Tolerance, Validity,
};
use serde::{Deserialize, Serialize};

/// The pressure under the embedded plastic asperity.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum FlowPressure {
    /// S H, the maximum contact pressure at first yield.
    #[default]
    #[serde(rename = "SH")]
    PressureFactor,
    /// H.
    #[serde(rename = "H")]
    Hardness,
}

/// The model of Abdo and Farhang.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct AbdoFarhang {
    /// The pressure under the embedded plastic asperity.
    pub flow_pressure: FlowPressure,
}

const SOURCE: Citation = Citation {
    id: "af",
    name: "AF",
    authors: "Abdo & Farhang",
    year: 2005,
    title: "Elastic-plastic contact model for rough surfaces based on plastic asperity concept",
    provenance: Provenance::Derived,
};

/// R_p/R = 1 - w_c/R, the radius of the embedded plastic asperity over that of the whole one.
///
/// # Errors
/// Those of [`Asperity::critical_interference`].
pub fn plastic_radius_ratio(asperity: &Asperity) -> Result<f64, ContactError> {
    Ok(1.0 - asperity.critical_interference()? / asperity.radius)
}

impl Described for AbdoFarhang {
    fn citation(&self) -> &Citation {
        &SOURCE
    }

    fn validity(&self) -> Validity {
        Validity::default().valid_for("w_c < R; the mean pressure has no plastic limit")
    }
}

impl AsperityModel for AbdoFarhang {
    fn law(
        &self,
        asperity: &Asperity,
        quantity: Quantity,
        _: Tolerance,
    ) -> Result<Option<Law>, ContactError> {
        let critical = asperity.critical_interference()?;
        let ratio = plastic_radius_ratio(asperity)?;
        let beyond = 1.0..f64::INFINITY;
        Ok(Some(match quantity {
            Quantity::Force => {
                let flow = match self.flow_pressure {
                    FlowPressure::PressureFactor => 3.0 * ratio,
                    FlowPressure::Hardness => 3.0 * ratio / asperity.pressure_factor,
                };
                // 1 - k without cancellation: (1 - k²)/(1 + k).
                let loss = critical / asperity.radius / (1.0 + ratio.sqrt());
                let force = move |x: f64| {
                    let y = x - 1.0;
                    let powers = x * x.sqrt() + y * y.sqrt();
                    (1.0 + 3.0 * x * y) / powers + loss * y * y.sqrt() + flow * y
                };
                let force = Formula::function(force).known_as("AF force", vec![loss, flow]);
                Law::in_units(critical, asperity.critical_force()?)
                    .elastic(0.0..1.0, [Power::new(1.0, 1.5)])
                    .elastic_plastic(beyond, force)
            }
            Quantity::Area => Law::in_units(critical, PI * asperity.radius * critical)
                .elastic(0.0..1.0, [Power::new(1.0, 1.0)])
                .elastic_plastic(beyond, [Power::new(1.0 + ratio, 1.0), Power::new(-ratio, 0.0)]),
            _ => return Ok(None),
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity_core::Interface;

    #[test]
    fn tabulated_values_for_an_almost_undiminished_radius() {
        // w_c/R = 3e-13 here, so R_p = R to what the sheet tabulates.
        let asperity = Asperity::new(&Interface::new(1e15, 0.31, 6e8), 1e-3).unwrap();
        let law = AbdoFarhang::default().law(&asperity, Quantity::Force, Tolerance::default());
        let law = law.unwrap().unwrap();
        let (w, f) =
            (asperity.critical_interference().unwrap(), asperity.critical_force().unwrap());
        for (x, value, digits) in [(1.5, 2.983, 1e-3), (6.0, 18.52, 1e-2), (110.0, 342.7, 0.1)] {
            assert!((law.value(x * w).unwrap() / f - value).abs() < digits, "{x}");
        }
    }
}
