//! Persson: the real area at a load, from the slopes of the whole surface and without asperities.
//!
//! # Equations
//! With the nominal pressure p, the equivalent modulus E and the mean square gradient g² = 2 m₂ of
//! the surface, the pressure at full contact has the variance V = E² g²/4, and
//! ```text
//! A/A_n = erf(p/√(2 V'))
//! persson:        V' = V
//! persson-fudge:  V' = (γ + (1-γ) A/A_n) V,   γ = 0.45
//! ```
//! For small loads A/A_n → √(8/(π γ')) p/(E g), γ' = 1 or γ; for large ones A → A_n in both.
//!
//! m₂ is that of [`Surface::moments`](asperity_core::Surface::moments). Of a surface that was given
//! by moments, or by a scan from whose moments its asperities came, it is what was given or
//! measured; of one given by asperities (or a scan whose summits were counted), that of the
//! isotropic Gaussian surface that has them.
//!
//! The mean gap u, from the mean plane, follows from the elastic energy, p du = -dU per area. With
//! the spectrum C(q), ⟨h²⟩ = 2π ∫ q C dq, and the gradient g(q) of all waves up to q,
//! ```text
//! U = (π E/2) ∫ q² C P (γ + (1-γ) P²) dq,   P = erf(√2 p/(E g(q)))
//! -dp/du = p/(√(2/π) g ∫ f(b/y) dy/q),      f(t) = (γ + 3(1-γ) erf² t) exp(-t²)
//! ```
//! b = √2 p/(E g) and γ = 1 for `persson`, 0.45 for `persson-fudge`; y = g(q)/g runs from 0 to 1.
//! Stiffness and tangent are -dF/du = -A_n dp/du. The [`Spectrum`] is that of a scan, or a power law
//! between two wave numbers, which follow from m₀, m₂, m₄ and a Hurst exponent.
//!
//! # Valid for
//! Elastic contact of surfaces with Gaussian slopes: hardness does not enter, and heights of any other
//! density are refused, unless the spectrum of a scan answers for them. Against independent solutions for an elastic half-space,
//! the area of `persson-fudge` is within 5 % up to A/A_n = 0.43 and within 3 % beyond. \[seen\] Beyond
//! p/(E g) of 17 gaps are below 1e-250 of the heights and refused, beyond 19 stiffnesses as well.
//!
//! # Source
//! Persson 2001, "Theory of rubber friction and contact mechanics"; the energy with γ = 1 is that of
//! Persson 2007, Physical Review Letters 99, 125502, as public programs of Xu and others, 2024, have
//! it, and the correction of the area is theirs. \[seen\] The energy with γ = 0.45 is that of Yang &
//! Persson 2008, with P as above. \[recalled; the programs of Xu and others have it with corrected P,
//! and one of their own with a second term: neither is computed here\] No paper was read.
//!
//! # Example
//! ```
//! use asperity_core::{At, ContactModel, Interface, Quantity, Request, Scene, Surface};
//! use asperity_persson::{Persson, PerssonVariance};
//!
//! let scene = Scene::new(Interface::elastic(116e9, 0.31), Surface::new(3.6e-4, 1.11e8, 1e-6), 3e-5);
//! let asked = Request::new([Quantity::AreaFraction]).at([At::Pressure(1e8)]);
//! let persson = Persson::default().solve(&scene, &asked)?;
//! let corrected = Persson { variance: PerssonVariance::Fudge, ..Persson::default() }.solve(&scene, &asked)?;
//! assert!(corrected.values(Quantity::AreaFraction)? > persson.values(Quantity::AreaFraction)?);
//! # Ok::<(), asperity_core::ContactError>(())
//! ```

mod area;
mod contact;
mod gap;
mod spectrum;

use std::sync::Arc;

use asperity_core::{
    Citation, Contact, ContactError, ContactModel, Described, HeightDistribution, Provenance,
    Request, Scene, Validity,
};
use serde::{Deserialize, Serialize};

pub use area::PerssonVariance;
use contact::OnScene;
pub use spectrum::Spectrum;

/// The theory of Persson.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Persson {
    /// The variance of the pressure that the area is computed with.
    pub variance: PerssonVariance,
    /// H, from 0.1 to 1: mean gaps and stiffnesses need it, or a spectrum; surfaces that were
    /// fractured, ground or blasted have some 0.8.
    #[serde(default)]
    pub hurst_exponent: Option<f64>,
    /// The spectrum, where there is no Hurst exponent; or why a scan has none.
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
};

const FUDGE: Citation = Citation {
    id: "persson-fudge",
    name: "Persson fudge",
    authors: "Persson, corrected by Xu and others",
    year: 2024,
    title: "Persson_LE_Area_Xu24 (a program)",
    provenance: Provenance::Seen,
};

impl Persson {
    /// The variance that an id stands for.
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
        }
    }

    fn validity(&self) -> Validity {
        Validity::without_asperities().valid_for(
            "elastic contact of a surface with Gaussian slopes; gaps need a Hurst exponent or a scan",
        )
    }
}

impl ContactModel for Persson {
    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        scene.asperity()?;
        let of_scan = self.hurst_exponent.is_none() && matches!(self.spectrum, Some(Ok(_)));
        let gaussian = match &scene.heights {
            HeightDistribution::Gaussian => true,
            // What was measured of a scan, beside the spectrum of that scan.
            HeightDistribution::Other(_) => of_scan,
            _ => false,
        };
        if !gaussian {
            let name = scene.heights.name();
            let what = format!("areas of {name} heights: it is of Gaussian surfaces, or of a scan");
            return Err(ContactError::Unsupported { model: self.name().into(), what });
        }
        let moments = scene.surface.moments();
        let spectrum = match (self.hurst_exponent, &self.spectrum) {
            (Some(hurst), _) => Ok(Arc::new(Spectrum::power_law(&moments, hurst)?)),
            (None, Some(Ok(spectrum))) => Ok(spectrum.clone()),
            (None, none) => {
                let scan = none.as_ref().and_then(|none| none.as_ref().err());
                let scan = scan.map_or(String::new(), |why| format!(" (the scan has none: {why})"));
                let reason =
                    format!("the stiffness of {}, or its mean gap,{scan} needs it", self.name());
                Err(ContactError::Missing { field: "hurst_exponent", reason })
            }
        };
        Ok(Box::new(OnScene {
            model: self.clone(),
            scene: scene.clone(),
            quantities: request.quantities.clone(),
            // √V.
            pressure_std: scene.interface.equivalent_modulus * (0.5 * moments.m2).sqrt(),
            spectrum,
        }))
    }
}
