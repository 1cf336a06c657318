#![doc = include_str!("../README.md")]

use std::f64::consts::PI;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Formula, Law, Power, Provenance,
    Tolerance, Validity,
};
use serde::{Deserialize, Serialize};

/// The pressure of the embedded plastic asperity.
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
    /// The pressure of the embedded plastic asperity.
    #[serde(rename = "af_flow_pressure")]
    pub flow_pressure: FlowPressure,
}

const SOURCE: Citation = Citation {
    id: "af",
    name: "AF",
    authors: "Abdo & Farhang",
    year: 2005,
    title: "Elastic-plastic contact model for rough surfaces based on plastic asperity concept",
    provenance: Provenance::Derived,
    published: &[
        ("author", "Abdo, J. and Farhang, K."),
        ("journal", "International Journal of Non-Linear Mechanics"),
        ("number", "4"),
        ("pages", "495--506"),
    ],
};

/// R_p/R = 1 - w_c/R, the radius of the embedded plastic asperity over R.
///
/// # Errors
/// The errors of [`Asperity::critical_interference`].
pub fn plastic_radius_ratio(asperity: &Asperity) -> Result<f64, ContactError> {
    Ok(1.0 - asperity.critical_interference()? / asperity.radius)
}

impl Described for AbdoFarhang {
    fn citation(&self) -> &Citation {
        &SOURCE
    }

    fn validity(&self) -> Validity {
        Validity {
            valid_for: "w_c < R; the mean pressure has no plastic limit",
            ..Validity::default()
        }
    }
}

impl AsperityModel for AbdoFarhang {
    fn force(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        let critical = asperity.critical_interference()?;
        let ratio = plastic_radius_ratio(asperity)?;
        let flow = match self.flow_pressure {
            FlowPressure::PressureFactor => 3.0 * ratio,
            FlowPressure::Hardness => 3.0 * ratio / asperity.pressure_factor,
        };
        // 1 - k without cancellation: (1 - k²)/(1 + k).
        let loss = critical / asperity.radius / (1.0 + ratio.sqrt());
        // F/F_c = x^1.5 - k (x-1)^1.5 + 3 k² (p/(S H)) (x-1), without cancellation
        let force = move |x: f64| {
            let y = x - 1.0;
            let powers = x * x.sqrt() + y * y.sqrt();
            (1.0 + 3.0 * x * y) / powers + loss * y * y.sqrt() + flow * y
        };
        let force = Formula::function(force).known_as("AF force", vec![loss, flow]);
        Ok(Law::in_units(critical, asperity.critical_force()?)
            .elastic(0.0..1.0, [Power::new(1.0, 1.5)])
            .elastic_plastic(1.0..f64::INFINITY, force))
    }

    fn area(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        let critical = asperity.critical_interference()?;
        let ratio = plastic_radius_ratio(asperity)?;
        // A/A_c = x; x + k² (x-1)
        let embedded = [Power::new(1.0 + ratio, 1.0), Power::new(-ratio, 0.0)];
        Ok(Law::in_units(critical, PI * asperity.radius * critical)
            .elastic(0.0..1.0, [Power::new(1.0, 1.0)])
            .elastic_plastic(1.0..f64::INFINITY, embedded))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity_core::Interface;

    #[test]
    fn values_of_the_readme_for_a_plastic_radius_close_to_r() {
        // w_c/R = 3e-13: R_p = R within the digits stated.
        let asperity = Asperity::new(&Interface::new(1e15, 0.31, 6e8), 1e-3).unwrap();
        let law = AbdoFarhang::default().force(&asperity, Tolerance::default()).unwrap();
        let (w, f) =
            (asperity.critical_interference().unwrap(), asperity.critical_force().unwrap());
        for (x, value, digits) in [(1.5, 2.983, 1e-3), (6.0, 18.52, 1e-2), (110.0, 342.7, 0.1)] {
            assert!((law.value(x * w).unwrap() / f - value).abs() < digits, "{x}");
        }
    }
}
