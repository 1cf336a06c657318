#![doc = include_str!("../README.md")]

use std::f64::consts::PI;
use std::ops::Range;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Law, Power, Provenance, Tolerance,
    Validity,
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
    published: &[
        ("author", "Kogut, L. and Etsion, I."),
        ("journal", "Journal of Applied Mechanics"),
        ("volume", "69"),
        ("number", "5"),
        ("pages", "657--662"),
        ("doi", "10.1115/1.1490373"),
    ],
};

impl Described for KogutEtsion {
    fn citation(&self) -> &Citation {
        &SOURCE
    }

    fn validity(&self) -> Validity {
        Validity {
            valid_for: "w_c < R; fitted to finite elements up to 110 w_c, plastic beyond",
            holds_to: Some(110.0),
            ..Validity::default()
        }
    }
}

const BEYOND: Range<f64> = 110.0..f64::INFINITY;

impl AsperityModel for KogutEtsion {
    fn force(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        // F/F_c = x^1.5; 1.03 x^1.425; 1.40 x^1.263; (3/S) x
        Ok(Law::in_units(asperity.critical_interference()?, asperity.critical_force()?)
            .elastic(0.0..1.0, [Power::new(1.0, 1.5)])
            .elastic_plastic(1.0..6.0, [Power::new(1.03, 1.425)])
            .elastic_plastic(6.0..110.0, [Power::new(1.40, 1.263)])
            .plastic(BEYOND, [Power::new(3.0 / asperity.pressure_factor, 1.0)]))
    }

    fn area(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        let critical = asperity.critical_interference()?;
        // A/A_c = x; 0.93 x^1.136; 0.94 x^1.146; 2x
        Ok(Law::in_units(critical, PI * asperity.radius * critical)
            .elastic(0.0..1.0, [Power::new(1.0, 1.0)])
            .elastic_plastic(1.0..6.0, [Power::new(0.93, 1.136)])
            .elastic_plastic(6.0..110.0, [Power::new(0.94, 1.146)])
            .plastic(BEYOND, [Power::new(2.0, 1.0)]))
    }
}
