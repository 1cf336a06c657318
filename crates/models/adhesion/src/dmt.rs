//! Derjaguin, Muller & Toporov: the contact of Hertz with a constant attraction around it.

use std::f64::consts::PI;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Law, Power, Provenance, Tolerance,
    Validity,
};
use asperity_gw::GreenwoodWilliamson;
use serde::{Deserialize, Serialize};

use crate::adhesive_validity;

/// The model of Derjaguin, Muller and Toporov.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct DerjaguinMullerToporov;

const SOURCE: Citation = Citation {
    id: "dmt",
    name: "DMT",
    authors: "Derjaguin, Muller & Toporov",
    year: 1975,
    title: "Effect of contact deformations on the adhesion of particles",
    provenance: Provenance::Seen,
    published: &[
        ("author", "Derjaguin, B. V. and Muller, V. M. and Toporov, Y. P."),
        ("journal", "Journal of Colloid and Interface Science"),
        ("volume", "53"),
        ("number", "2"),
        ("pages", "314--326"),
        ("doi", "10.1016/0021-9797(75)90018-1"),
    ],
};

impl Described for DerjaguinMullerToporov {
    fn citation(&self) -> &Citation {
        &SOURCE
    }

    fn validity(&self) -> Validity {
        adhesive_validity(
            [0.0, 0.1],
            "elastic asperities with adhesion; Tabor parameter below about 0.1",
        )
    }
}

impl AsperityModel for DerjaguinMullerToporov {
    fn force(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        let pull = 2.0 * PI * asperity.adhesion(SOURCE.id)? * asperity.radius;
        let law = GreenwoodWilliamson.force(asperity, tolerance)?;
        if pull == 0.0 {
            return Ok(law);
        }
        // F = (4/3) E √R w^(3/2) - 2π w_a R for w > 0
        let constant = [Power::new(pull / law.value_unit, 0.0)];
        Ok(law.less_adhesion(0.0..f64::INFINITY, constant))
    }

    fn area(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        // Refuses scenes without a work of adhesion.
        asperity.adhesion(SOURCE.id)?;
        GreenwoodWilliamson.area(asperity, tolerance)
    }
}
