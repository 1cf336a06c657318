#![doc = include_str!("../README.md")]

use std::f64::consts::PI;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Law, Power, Provenance, Tolerance,
    Validity,
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
    published: &[
        ("author", "Chang, W. R. and Etsion, I. and Bogy, D. B."),
        ("journal", "Journal of Tribology"),
        ("volume", "109"),
        ("number", "2"),
        ("pages", "257--263"),
    ],
};

impl Described for ChangEtsionBogy {
    fn citation(&self) -> &Citation {
        &SOURCE
    }

    fn validity(&self) -> Validity {
        Validity {
            valid_for: "w_c < R; no elastic-plastic range: the force jumps by 50 % at w_c",
            ..Validity::default()
        }
    }
}

impl AsperityModel for ChangEtsionBogy {
    fn force(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        // x ≤ 1: F/F_c = x^1.5; x > 1: F/F_c = 3x - 3/2, which is F = S H A
        Ok(Law::in_units(asperity.critical_interference()?, asperity.critical_force()?)
            .elastic(0.0..1.0, [Power::new(1.0, 1.5)])
            .plastic(1.0..f64::INFINITY, [Power::new(3.0, 1.0), Power::new(-1.5, 0.0)]))
    }

    fn area(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        let critical = asperity.critical_interference()?;
        // x ≤ 1: A/A_c = x; x > 1: A/A_c = 2x - 1
        Ok(Law::in_units(critical, PI * asperity.radius * critical)
            .elastic(0.0..1.0, [Power::new(1.0, 1.0)])
            .plastic(1.0..f64::INFINITY, [Power::new(2.0, 1.0), Power::new(-1.0, 0.0)]))
    }
}
