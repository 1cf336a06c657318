#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]

mod average;
mod azimuth;
mod gauss;
mod lateral;
mod nested;
mod oblique;
mod options;
mod pieces;
mod slip;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Law, Provenance, Regime, Tolerance,
    Validity,
};
use serde::{Deserialize, Serialize};

pub use average::{angle_average, angle_average_of_powers};
pub use lateral::{Lateral, LateralLaw, lateral_validity};
pub use oblique::ObliqueContact;
pub use options::{AngleDensity, Displacement, ForceComponent, LateralOptions, Stick};
pub use pieces::{ELASTIC_END, NormalLaw, PLASTIC_FROM, friction, regime_range};
pub use slip::{ObliqueSlip, Response};

/// The model of Gao, Fu, Wang and others.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Gao {
    /// Angle density, tangential displacement, friction limit and force component.
    pub options: LateralOptions,
}

const SOURCE: Citation = Citation {
    id: "gao",
    name: "Gao",
    authors: "Gao, Fu, Wang and others, through Amini & Tehrani",
    year: 2018,
    title: "",
    provenance: Provenance::Derived,
    published: &[
        ("author", "Gao and Fu and Wang and others"),
        (
            "note",
            "The year is about 2018 and the title is not known; read through Amini & Tehrani 2020",
        ),
    ],
};

impl Described for Gao {
    fn citation(&self) -> &Citation {
        &SOURCE
    }

    fn validity(&self) -> Validity {
        lateral_validity("w_c < R; needs the equivalent shear modulus; inclined contacts")
    }
}

impl Gao {
    fn law(
        &self,
        asperity: &Asperity,
        kind: LateralLaw,
        tolerance: Tolerance,
    ) -> Result<Law, ContactError> {
        let lateral = Lateral::new(self.options, asperity, self.id())?;
        let mut law = lateral.law_in_units(kind);
        // I[Q_e; 0, 1] + I[Q_ep; 1, 110] + I[Q_p; 110, ∞]
        for regime in [Regime::Elastic, Regime::ElasticPlastic, Regime::Plastic] {
            let normal = lateral.normal(regime, 0.0);
            let stick = lateral.stick(regime == Regime::ElasticPlastic);
            law.parts.push(lateral.part(stick, normal, regime_range(regime), kind, tolerance));
        }
        Ok(law)
    }
}

impl AsperityModel for Gao {
    fn force(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        self.law(asperity, LateralLaw::Force, tolerance)
    }

    fn area(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        self.law(asperity, LateralLaw::Area, tolerance)
    }

    fn stiffness(
        &self,
        asperity: &Asperity,
        tolerance: Tolerance,
    ) -> Result<Option<Law>, ContactError> {
        self.law(asperity, LateralLaw::Stiffness, tolerance).map(Some)
    }
}
