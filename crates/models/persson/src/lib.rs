#![doc = include_str!("../README.md")]

mod area;
mod contact;
mod gap;
mod inverse;
mod plastic;
mod spectrum;

use std::sync::Arc;

use asperity_core::{
    Citation, Contact, ContactError, ContactModel, Described, HeightDistribution, Provenance,
    Request, Scene, Validity,
};
use serde::{Deserialize, Serialize};

pub use area::PerssonVariance;
use contact::OnScene;
use inverse::Inverse;
pub use spectrum::Spectrum;

/// The theory of Persson.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Persson {
    /// The form of the theory.
    pub variance: PerssonVariance,
    /// The Hurst exponent H, from 0.1 to 1. Mean gaps and stiffnesses need it, or a spectrum; it is
    /// about 0.8 for fractured, ground or blasted surfaces.
    #[serde(default)]
    pub hurst_exponent: Option<f64>,
    /// The spectrum, used where there is no Hurst exponent; or the reason why a scan has none.
    #[serde(skip)]
    pub spectrum: Option<Result<Arc<Spectrum>, String>>,
}

const FULL: Citation = Citation {
    id: "persson",
    name: "Persson",
    authors: "Persson",
    year: 2001,
    title: "Theory of rubber friction and contact mechanics",
    provenance: Provenance::Seen,
    published: &[
        ("author", "Persson, B. N. J."),
        ("journal", "Journal of Chemical Physics"),
        ("volume", "115"),
        ("number", "8"),
        ("pages", "3840--3861"),
        ("doi", "10.1063/1.1388626"),
    ],
};

const FUDGE: Citation = Citation {
    id: "persson-fudge",
    name: "Persson fudge",
    authors: "Persson, corrected by Xu and others",
    year: 2024,
    title: "Persson_LE_Area_Xu24 (a program)",
    provenance: Provenance::Seen,
    published: &[("author", "Xu and others"), ("howpublished", "program")],
};

const PLASTIC: Citation = Citation {
    id: "persson-plastic",
    name: "Persson plastic",
    authors: "Persson; Xu, Li & Mulvihill",
    year: 2022,
    title: "Revisiting the Persson theory of elastoplastic contact: A simpler closed-form solution and a rigorous proof of boundary conditions",
    provenance: Provenance::Derived,
    published: &[
        ("author", "Xu, Yang and Li, Xiaobao and Mulvihill, Daniel M."),
        ("eprint", "2208.02665"),
        ("archiveprefix", "arXiv"),
    ],
};

impl Persson {
    /// The variance of the model with this id.
    #[must_use]
    pub fn variance_of(id: &str) -> Option<PerssonVariance> {
        let model = |variance| Self { variance, ..Self::default() };
        PerssonVariance::ALL.into_iter().find(|variance| model(*variance).id() == id)
    }
}

impl Described for Persson {
    fn citation(&self) -> &Citation {
        match self.variance {
            PerssonVariance::Full => &FULL,
            PerssonVariance::Fudge => &FUDGE,
            PerssonVariance::Plastic => &PLASTIC,
        }
    }

    fn variant(&self) -> Vec<&'static str> {
        match self.variance {
            PerssonVariance::Full => vec![],
            PerssonVariance::Fudge => {
                vec!["the variance of the pressure is smaller at small areas"]
            }
            PerssonVariance::Plastic => {
                vec!["no pressure exceeds the hardness, and the variance is smaller at small areas"]
            }
        }
    }

    fn validity(&self) -> Validity {
        let (holds_to, valid_for) = match self.variance {
            PerssonVariance::Plastic => (
                None,
                "areas of surfaces with Gaussian slopes that yield at one hardness; no gaps or stiffnesses",
            ),
            _ => (
                Some(1.0),
                "elastic contact of surfaces with Gaussian slopes; gaps need a Hurst exponent or a scan",
            ),
        };
        Validity {
            asperities: false,
            hertz_limit: None,
            holds_to,
            valid_for,
            ..Validity::default()
        }
    }
}

impl ContactModel for Persson {
    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        let asperity = scene.asperity()?;
        let limit = match self.variance {
            PerssonVariance::Plastic => Some(asperity.hardness()?),
            _ => None,
        };
        let of_scan = self.hurst_exponent.is_none() && matches!(self.spectrum, Some(Ok(_)));
        let gaussian = match &scene.heights {
            HeightDistribution::Gaussian => true,
            // Heights measured on a scan, together with the spectrum of that scan.
            HeightDistribution::Other(_) => of_scan,
            _ => false,
        };
        if !gaussian {
            let name = scene.heights.name();
            let what =
                format!("areas of {name} heights: the theory is for Gaussian surfaces or a scan");
            return Err(ContactError::Unsupported { model: self.id().into(), what });
        }
        let moments = scene.surface.moments();
        let spectrum = match (self.hurst_exponent, &self.spectrum) {
            (Some(hurst), _) => Ok(Arc::new(Spectrum::power_law(&moments, hurst)?)),
            (None, Some(Ok(spectrum))) => Ok(spectrum.clone()),
            (None, none) => {
                let scan = none.as_ref().and_then(|none| none.as_ref().err());
                let scan = scan.map_or(String::new(), |why| format!(" (the scan has none: {why})"));
                let reason =
                    format!("stiffness and mean gap need it or the spectrum of a scan{scan}");
                Err(ContactError::Missing { field: "hurst_exponent", reason })
            }
        };
        // One gradient for area, gap and stiffness: differences of neighbouring points, from which
        // the moments of a scan follow, flatten short waves.
        let gradient = match &spectrum {
            Ok(spectrum) => spectrum.gradient(),
            Err(_) => (2.0 * moments.m2).sqrt(),
        };
        Ok(Box::new(OnScene {
            model: self.clone(),
            scene: scene.clone(),
            quantities: request.quantities.clone(),
            // √V = E g/2.
            limit,
            pressure_std: 0.5 * scene.interface.equivalent_modulus * gradient,
            spectrum,
            inverse: Inverse::default(),
        }))
    }
}
