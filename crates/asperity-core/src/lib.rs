//! Scenes, laws, heights and the one integral behind every statistical rough-contact model.
//!
//! ```text
//! Q(d) = η A_n ∫₀^∞ q(w) g(d + w) dw
//! ```
//!
//! A [`Law`] q says how one asperity answers an interference w; [`Heights`] g say how the
//! asperities are spread; a [`Scene`] is what is in contact, a [`Request`] what is asked of it.
//! A [`ContactModel`] supplies the law and nothing else. Data flows one way:
//!
//! ```text
//! scene + request → model.law(asperity, quantity) → compiled → response
//! ```
//!
//! This crate names no model. SI units everywhere; separations are multiples of σ_z.

mod angles;
mod asperity;
mod channel;
mod compiled;
mod error;
mod evaluation;
mod height_integral;
mod heights;
mod heights_statrs;
mod heights_table;
mod interface;
mod inverse;
mod law;
mod model;
mod plan;
mod quantity;
mod request;
mod response;
mod scene;
mod surface;
mod sweep;
pub mod testkit;
mod warning;

pub use angles::{AngleDensity, ObliqueContact, angle_average, angle_average_of_powers};
pub use asperity::Asperity;
pub use compiled::Compiled;
pub use error::{ContactError, positive};
pub use evaluation::{Evaluation, Share};
pub use heights::{HeightDistribution, Heights};
pub use heights_statrs::StandardisedHeights;
pub use heights_table::TabulatedHeights;
pub use interface::{Body, HARDNESS_OVER_YIELD, Interface};
pub use law::{Form, FunctionKey, Law, Part, Power, Regime};
pub use model::{Claims, ContactModel, Provenance, Source, StiffnessKind};
pub use plan::{Method, Plan, PlannedPart, Step};
pub use quantity::{Quantity, Tolerance};
pub use request::{Request, linspace};
pub use response::{Column, Response};
pub use scene::Scene;
pub use surface::{ProfileMoments, Surface};
pub use sweep::{Case, Sweep};
pub use warning::Warning;
