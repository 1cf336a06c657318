//! AT: Gao's spread normals combined with AF's embedded plastic asperity, in three readings.
//!
//! # Law
//! With I[f; a, b] the average over heights and angles of [`asperity_gao`], over a ≤ y < b:
//! ```text
//! printed    Q = I[Q_e; 0,1] - I[Q_ep1; 1,6] + I[Q_ep2; 6,110] + I[Q_p; 110,∞]
//! additive   Q = I[Q_e; 0,1] + I[Q_ep1; 1,6] + I[Q_ep2; 6,110] + I[Q_p; 110,∞]
//! overlap    Q = I[Q_e; 0,6] - I[Q_ep1; 1,6] + I[Q_ep2; 1,110] + I[Q_p; 110,∞]
//! ```
//! * ep1 and ep2 share Gao's elastic-plastic N and K_n, and r = √A* - s₀ with s₀ = √(w_c/R), as
//!   does p; the area of ep1 alone is A*_ep1 = y. For force and stiffness the overlap reading is
//!   therefore I[Q_e; 0,6] + I[Q_ep2; 6,110] + I[Q_p; 110,∞], and is computed so.
//! * Areas of ep1, ep2 and p carry the factor R_p/R = 1 - w_c/R, that of e does not.
//!
//! **printed** is the paper's equation as it stands: contacts with 1 < y < 6 count negatively, and
//! force, area or stiffness are negative in a window of the plasticity index. Such values are
//! returned, with a warning. **additive** is a partition of unity. **overlap** takes AF's idea
//! literally. Every equation's reading is in the README's ledger of misprints.
//!
//! # Valid for
//! w_c < R; needs the equivalent shear modulus. The stiffness is the paper's average of K_i, not
//! -dF/dd: ask for the tangent for that.
//!
//! # Source
//! Amini & Tehrani 2020, "A New Combined Model for considering the Plasticity Effects in Contacting
//! Asperities", Mathematical Problems in Engineering, article 4640204. \[seen; readings derived\]
//!
//! # Example
//! ```
//! use asperity_at::{AminiTehrani, AtReading};
//! use asperity_core::{ContactModel, Interface, Quantity, Request, Scene, Surface};
//!
//! let mut interface = Interface::new(116e9, 0.31, 1.12e9);
//! interface.equivalent_shear_modulus = Some(41e9);
//! let surface = Surface::from_plasticity_index(2.0, 0.04, 1e-6, &interface)?;
//! let scene = Scene::new(interface, surface, 3e-5);
//! let asked = Request::new([Quantity::Force]).at([1.0]);
//! let printed = AminiTehrani::default().solve(&scene, &asked)?;
//! assert!(printed.values(Quantity::Force)?[0] < 0.0);
//! assert!(printed.warnings.iter().any(|w| w.to_string().contains("force is negative")));
//! let additive = AminiTehrani { reading: AtReading::Additive, ..Default::default() };
//! assert!(additive.solve(&scene, &asked)?.values(Quantity::Force)?[0] > 0.0);
//! # Ok::<(), asperity_core::ContactError>(())
//! ```

use std::ops::Range;

use asperity_af::plastic_radius_ratio;
use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Diagnostic, Law, Provenance,
    Quantity, Regime, Tolerance, Validity,
};
use asperity_gao::{ELASTIC_END, Lateral, LateralOptions, NormalLaw, PLASTIC_FROM, Stick};
use serde::{Deserialize, Serialize};

/// How equations (11), (26) and (29) are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum AtReading {
    /// With the printed minus sign.
    #[default]
    Printed,
    /// With a plus sign.
    Additive,
    /// Elastic up to y = 6, less its share from 1 to 6, plus the plastic asperity's from 1 on.
    Overlap,
}

/// The model of Amini and Tehrani.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct AminiTehrani {
    /// How the sums are read.
    pub reading: AtReading,
    /// Angles, displacement, stick and the force's component.
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
};

const ADDITIVE: Citation = Citation { id: "at-additive", name: "AT additive", ..SOURCE };
const OVERLAP: Citation = Citation { id: "at-overlap", name: "AT overlap", ..SOURCE };

/// Where ep1 ends and ep2 begins, in y. \[seen\]
const EP1_END: f64 = 6.0;

/// One term of the sum: name, sign, row of the table of pieces, range of y.
type Term = (&'static str, f64, Regime, Range<f64>);

impl AminiTehrani {
    fn terms(&self, quantity: Quantity) -> Vec<Term> {
        let (ep, p) = (Regime::ElasticPlastic, Regime::Plastic);
        let sign = if self.reading == AtReading::Additive { 1.0 } else { -1.0 };
        let overlap = self.reading == AtReading::Overlap;
        // In the overlap reading ep1 and ep2 cancel from 1 to 6, unless their areas or limits differ.
        let cancel = overlap && quantity != Quantity::Area && self.options.stick == Stick::Clamped;
        let elastic_end = if overlap { EP1_END } else { ELASTIC_END };
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

    fn validity(&self) -> Validity {
        self.options.validity().valid_for(match self.reading {
            AtReading::Printed => "w_c < R; needs the equivalent shear modulus; a part is subtracted: totals may be negative",
            _ => "w_c < R; needs the equivalent shear modulus; asperities touch at all angles",
        })
    }

    fn notes(&self) -> Vec<Diagnostic> {
        self.options.notes(self.name())
    }
}

impl AsperityModel for AminiTehrani {
    fn law(
        &self,
        asperity: &Asperity,
        quantity: Quantity,
        tolerance: Tolerance,
    ) -> Result<Option<Law>, ContactError> {
        let lateral = Lateral::new(self.options, asperity, self.name())?;
        let Some(mut law) = lateral.law_in_units(quantity) else { return Ok(None) };
        for (name, sign, regime, range) in self.terms(quantity) {
            let elastic = regime == Regime::Elastic;
            let loss = if elastic { 0.0 } else { lateral.radius_loss() };
            // The area of ep1 is that of the elastic row, A* = y; all else is its own row's.
            let row = if name == "elastic-plastic 1" && quantity == Quantity::Area {
                Regime::Elastic
            } else {
                regime
            };
            let normal: NormalLaw = lateral.normal(row, loss);
            let stick = lateral.stick(name == "elastic-plastic 2");
            let mut part = lateral.part(stick, normal, range, quantity, tolerance);
            let shrunk = quantity == Quantity::Area && !elastic;
            part.sign = sign * if shrunk { plastic_radius_ratio(asperity)? } else { 1.0 };
            (part.name, part.regime) = (name.into(), regime);
            law.parts.push(part);
        }
        Ok(Some(law))
    }
}
