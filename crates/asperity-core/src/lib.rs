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
//! This crate holds no model; findings and warnings advise some by their ids. SI units everywhere; separations are multiples of σ_z.

mod check;
mod diagnostic;
mod engine;
mod error;
mod heights;
mod law;
mod model;
mod near;
mod request;
mod response;
mod scene;

pub use asperity_quadrature::{Density, Moments, Piece, QuadratureError, Sampler};
pub use check::{Check, DerivedNumber, Finding, Severity};
pub use diagnostic::{Warning, Warnings};
pub use engine::arrays::FillReport;
pub use engine::plan::{Method, Plan, PlannedPart, Step};
pub use engine::sweep::{Case, Sweep};
pub use error::{ContactError, positive};
#[cfg(feature = "statrs")]
pub use heights::statrs::StandardisedHeights;
pub use heights::table::TabulatedHeights;
pub use heights::weibull::WeibullHeights;
pub use heights::{HeightDistribution, Heights, OtherHeights};
pub use law::formula::{Formula, FunctionKey, Power};
pub use law::{Law, Part, Regime, testkit};
pub use model::asperity_model::AsperityModel;
pub use model::contact::Contact;
pub use model::contact_model::ContactModel;
pub use model::described::{Citation, Described, KnownDefect, Provenance, Validity};
pub use near::nearest_name;
pub use request::quantity::Quantity;
pub use request::separation::{At, Datum, Separation, SeparationUnit};
pub use request::tolerance::Tolerance;
pub use request::{Request, linspace};
pub use response::evaluation::{Evaluation, Share};
pub use response::{Column, Response};
pub use scene::Scene;
pub use scene::asperity::Asperity;
pub use scene::interface::{Body, HARDNESS_OVER_YIELD, Interface};
pub use scene::surface::{ProfileMoments, Surface};
