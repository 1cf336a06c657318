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
//! # Valid for
//! Elastic contact: hardness does not enter. It knows loads and pressures and no separations, so
//! neither tangent nor stiffness. Against independent solutions for an elastic half-space,
//! `persson-fudge` is within 5 % up to A/A_n = 0.43 and within 3 % beyond. \[seen\]
//!
//! # Source
//! Persson 2001, "Theory of rubber friction and contact mechanics". \[seen\] The correction is
//! that of public programs of Xu and others, 2024. \[seen\]
//!
//! # Example
//! ```
//! use asperity_core::{At, ContactModel, Interface, Quantity, Request, Scene, Surface};
//! use asperity_persson::{Persson, Variance};
//!
//! let scene = Scene::new(Interface::elastic(116e9, 0.31), Surface::new(3.6e-4, 1.11e8, 1e-6), 3e-5);
//! let asked = Request::new([Quantity::AreaFraction]).at([At::Pressure(1e8)]);
//! let persson = Persson::default().solve(&scene, &asked)?;
//! let corrected = Persson { variance: Variance::Fudge }.solve(&scene, &asked)?;
//! assert!(corrected.values(Quantity::AreaFraction)? > persson.values(Quantity::AreaFraction)?);
//! # Ok::<(), asperity_core::ContactError>(())
//! ```

mod area;
mod contact;

use asperity_core::{
    Claims, Contact, ContactError, ContactModel, HeightDistribution, Provenance, Request, Scene,
    Source,
};
use serde::{Deserialize, Serialize};

pub use area::Variance;
use contact::OnScene;

/// The theory of Persson.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Persson {
    /// The variance of the pressure that the area is computed with.
    pub variance: Variance,
}

const FULL: Source = Source {
    id: "persson",
    name: "Persson",
    authors: "Persson",
    year: 2001,
    title: "Theory of rubber friction and contact mechanics",
    provenance: Provenance::Seen,
};

const FUDGE: Source = Source {
    id: "persson-fudge",
    name: "Persson fudge",
    authors: "Persson, corrected by Xu and others",
    year: 2024,
    title: "(title not known; read in public programs)",
    provenance: Provenance::Seen,
};

impl ContactModel for Persson {
    fn source(&self) -> &Source {
        match self.variance {
            Variance::Full => &FULL,
            Variance::Fudge => &FUDGE,
        }
    }

    fn claims(&self) -> Claims {
        Claims::default()
            .without_hertz_limit()
            .valid_for("elastic contact of a surface with Gaussian slopes, at loads")
    }

    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        scene.asperity()?;
        let heights = &scene.heights;
        if matches!(heights, HeightDistribution::Exponential | HeightDistribution::Weibull(_)) {
            let name = heights.name();
            let what = format!("areas of {name} heights: no Gaussian surface has them");
            return Err(ContactError::Unsupported { model: self.name().into(), what });
        }
        let slope = scene.surface.moments().m2;
        Ok(Box::new(OnScene {
            model: *self,
            scene: scene.clone(),
            quantities: request.quantities.clone(),
            // √V.
            pressure_std: scene.interface.equivalent_modulus * (0.5 * slope).sqrt(),
        }))
    }
}
