#![doc = include_str!("../README.md")]

use std::ops::Range;

use asperity_af::plastic_radius_ratio;
use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Law, Provenance, Regime, Tolerance,
    Validity,
};
use asperity_gao::{
    ELASTIC_END, Lateral, LateralLaw, LateralOptions, NormalLaw, PLASTIC_FROM, Stick,
    lateral_validity,
};
use serde::{Deserialize, Serialize};

/// The reading of equations (11), (26) and (29).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum AtReading {
    /// As printed, with a minus sign.
    #[default]
    Printed,
    /// With a plus sign: every contact counts once.
    Additive,
    /// Elastic up to y = 6, less the share of the plastic asperity from 1 to 6, plus its own law
    /// from 1 on.
    Overlap,
}

/// The model of Amini and Tehrani.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct AminiTehrani {
    /// The reading of the sums.
    pub reading: AtReading,
    /// Angle density, tangential displacement, friction limit and force component.
    #[serde(flatten)]
    pub options: LateralOptions,
}

const SOURCE: Citation = Citation {
    id: "at",
    name: "AT",
    authors: "Amini & Tehrani",
    year: 2020,
    title: "A New Combined Model for considering the Plasticity Effects in Contacting Asperities",
    provenance: Provenance::Seen,
    published: &[
        ("journal", "Mathematical Problems in Engineering"),
        ("eid", "4640204"),
        ("doi", "10.1155/2020/4640204"),
    ],
};

const ADDITIVE: Citation = Citation { id: "at-additive", name: "AT additive", ..SOURCE };
const OVERLAP: Citation = Citation { id: "at-overlap", name: "AT overlap", ..SOURCE };

/// End of ep1 and start of ep2, in y (seen in the paper's public text).
const EP1_END: f64 = 6.0;

/// One term of the sum: name, sign, row of the table of pieces, range of y.
type Term = (&'static str, f64, Regime, Range<f64>);

impl AminiTehrani {
    fn terms(&self, kind: LateralLaw) -> Vec<Term> {
        let (ep, p) = (Regime::ElasticPlastic, Regime::Plastic);
        let sign = if self.reading == AtReading::Additive { 1.0 } else { -1.0 };
        let overlap = self.reading == AtReading::Overlap;
        // In the overlap reading ep1 and ep2 cancel from 1 to 6, unless areas or friction limits
        // differ.
        let cancel = overlap && kind != LateralLaw::Area && self.options.stick == Stick::Clamped;
        let elastic_end = if overlap { EP1_END } else { ELASTIC_END };
        // Q = I[Q_e; 0, 1] ∓ I[Q_ep1; 1, 6] + I[Q_ep2; 6, 110] + I[Q_p; 110, ∞]
        let mut terms = vec![("elastic", 1.0, Regime::Elastic, 0.0..elastic_end)];
        if !cancel {
            terms.push(("elastic-plastic 1", sign, ep, ELASTIC_END..EP1_END));
        }
        let second = if overlap && !cancel { ELASTIC_END } else { EP1_END };
        terms.push(("elastic-plastic 2", 1.0, ep, second..PLASTIC_FROM));
        terms.push(("plastic", 1.0, p, PLASTIC_FROM..f64::INFINITY));
        terms
    }
}

impl Described for AminiTehrani {
    fn citation(&self) -> &Citation {
        match self.reading {
            AtReading::Printed => &SOURCE,
            AtReading::Additive => &ADDITIVE,
            AtReading::Overlap => &OVERLAP,
        }
    }

    fn variant(&self) -> Vec<&'static str> {
        match self.reading {
            AtReading::Printed => vec![],
            AtReading::Additive => vec!["every contact counts once in the sums"],
            AtReading::Overlap => vec![
                "the elastic law holds to w = 6 w_c, less the share of the plastic one, which begins at w_c",
            ],
        }
    }

    fn validity(&self) -> Validity {
        lateral_validity(match self.reading {
            AtReading::Printed => {
                "w_c < R; needs the equivalent shear modulus; inclined contacts; totals can be negative"
            }
            _ => "w_c < R; needs the equivalent shear modulus; inclined contacts",
        })
    }
}

impl AminiTehrani {
    fn law(
        &self,
        asperity: &Asperity,
        kind: LateralLaw,
        tolerance: Tolerance,
    ) -> Result<Law, ContactError> {
        let lateral = Lateral::new(self.options, asperity, self.id())?;
        let mut law = lateral.law_in_units(kind);
        for (name, sign, regime, range) in self.terms(kind) {
            let elastic = regime == Regime::Elastic;
            let loss = if elastic { 0.0 } else { lateral.radius_loss() };
            // A*_ep1 = y, which is the elastic row of the table.
            let row = if name == "elastic-plastic 1" && kind == LateralLaw::Area {
                Regime::Elastic
            } else {
                regime
            };
            let normal: NormalLaw = lateral.normal(row, loss);
            let stick = lateral.stick(name == "elastic-plastic 2");
            let mut part = lateral.part(stick, normal, range, kind, tolerance);
            let shrunk = kind == LateralLaw::Area && !elastic;
            part.sign = sign * if shrunk { plastic_radius_ratio(asperity)? } else { 1.0 };
            (part.name, part.regime) = (name.into(), regime);
            law.parts.push(part);
        }
        Ok(law)
    }
}

impl AsperityModel for AminiTehrani {
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
