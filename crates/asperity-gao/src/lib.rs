//! Gao: contacts on the shoulders of asperities, spread over angles, with stick and slip.
//!
//! # Law
//! A pair approached vertically by x = (z-d)/w_c touches at an angle φ with the contact-normal
//! interference y = x u, u = |cos φ|; every regime is chosen by y:
//! ```text
//! Q = η A_n q₀ { I[Q_e; 0, 1] + I[Q_ep; 1, 110] + I[Q_p; 110, ∞] },     q₀ = F_c, π R w_c, F_c/w_c
//! I[f; a, b] = ∫ dθ/2π ∫₀¹ du ψ(u) ∫ f(x, u, θ) g(z) dz     over a ≤ x u < b
//! ```
//! N, A*, K_n and r are in [`NormalLaw`], stick and slip in [`ObliqueSlip`], the angle density in
//! [`AngleDensity`]. f depends on the height through x only, so the angle average comes first and
//! leaves an ordinary law q(x) with kinks at x = 1 and 110 and where slip begins.
//!
//! The stiffness is the paper's average of K_i. It is not -dF/dd: ask for the tangent for that.
//!
//! # Valid for
//! w_c < R; needs the equivalent shear modulus. With λ = 4G/E = 0 and the default angle density,
//! the elastic limits against GW are 1/3 (force), 7/16 (area) and 13/21 (stiffness). \[derived\]
//!
//! # Source
//! Gao, Fu, Wang and others, about 2018; its one elastic-plastic range is inferred from the AT
//! paper (Amini & Tehrani 2020), as are the equations. \[derived\]
//!
//! # Example
//! ```
//! use asperity_core::{ContactModel, Interface, Quantity, Request, Scene, Surface};
//! use asperity_gao::{Displacement, Gao};
//!
//! let mut interface = Interface::new(116e9, 0.31, 1.12e9);
//! interface.equivalent_shear_modulus = Some(41e9);
//! let scene = Scene::new(interface, Surface::new(3.6e-4, 1.11e8, 1e-6), 3e-5);
//! let asked = Request::new([Quantity::Force]).at([1.0]);
//! let pushed = Gao::default().solve(&scene, &asked)?;
//! let mut frictionless = Gao::default();
//! frictionless.options.displacement = Displacement::None;
//! let plain = frictionless.solve(&scene, &asked)?;
//! assert!(pushed.values(Quantity::Force)?[0] > plain.values(Quantity::Force)?[0]);
//! # Ok::<(), asperity_core::ContactError>(())
//! ```

#![forbid(unsafe_code)]

mod angles;
mod average;
mod azimuth;
mod gauss;
mod lateral;
mod nested;
mod pieces;
mod slip;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Diagnostic, Law, Provenance,
    Quantity, Regime, Tolerance, Validity,
};
use serde::{Deserialize, Serialize};

pub use angles::AngleDensity;
pub use average::{ObliqueContact, angle_average, angle_average_of_powers};
pub use lateral::{Displacement, ForceComponent, Lateral, LateralOptions, Stick};
pub use pieces::{ELASTIC_END, NormalLaw, PLASTIC_FROM, friction, regime_range};
pub use slip::{ObliqueSlip, Response};

/// The model of Gao, Fu, Wang and others.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Gao {
    /// Angles, displacement, stick and the force's component.
    pub options: LateralOptions,
}

const SOURCE: Citation = Citation {
    id: "gao",
    name: "Gao",
    authors: "Gao, Fu, Wang and others",
    year: 2018,
    title: "(title not known; read through Amini & Tehrani 2020)",
    provenance: Provenance::Derived,
};

impl Described for Gao {
    fn citation(&self) -> &Citation {
        &SOURCE
    }

    fn validity(&self) -> Validity {
        self.options.validity().valid_for(
            "w_c < R; needs the equivalent shear modulus; asperities touch at all angles",
        )
    }

    fn notes(&self) -> Vec<Diagnostic> {
        self.options.notes(self.name())
    }
}

impl AsperityModel for Gao {
    fn law(
        &self,
        asperity: &Asperity,
        quantity: Quantity,
        tolerance: Tolerance,
    ) -> Result<Option<Law>, ContactError> {
        let lateral = Lateral::new(self.options, asperity, self.name())?;
        let Some(mut law) = lateral.law_in_units(quantity) else { return Ok(None) };
        for regime in [Regime::Elastic, Regime::ElasticPlastic, Regime::Plastic] {
            let normal = lateral.normal(regime, 0.0);
            let stick = lateral.stick(regime == Regime::ElasticPlastic);
            law.parts.push(lateral.part(stick, normal, regime_range(regime), quantity, tolerance));
        }
        Ok(Some(law))
    }
}
