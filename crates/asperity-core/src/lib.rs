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

mod arrays;
mod asperity;
mod begins;
mod case;
mod channel;
mod check;
mod compiled;
mod contact;
mod contact_model;
mod contact_radii;
mod crossings;
mod error;
mod evaluation;
mod few;
mod form;
mod height_integral;
mod heights;
#[cfg(feature = "statrs")]
mod heights_statrs;
mod heights_table;
mod heights_weibull;
mod integrals;
mod interface;
mod inverse;
mod law;
mod model;
mod of_case;
mod parallel;
mod plan;
mod quantity;
mod readings;
mod request;
mod response;
mod scene;
mod separation;
mod shape;
mod surface;
mod sweep;
pub mod testkit;
mod tolerance;
mod warning;

pub use arrays::Filled;
pub use asperity::Asperity;
pub use asperity_quadrature::{Density, Moments, Piece, QuadratureError, Sampler};
pub use check::{Check, Finding, Number, Severity};
pub use contact::Contact;
pub use contact_model::ContactModel;
pub use error::{ContactError, positive};
pub use evaluation::{Evaluation, Share};
pub use form::{Form, FunctionKey, Power};
pub use heights::{HeightDistribution, Heights, OtherHeights};
#[cfg(feature = "statrs")]
pub use heights_statrs::StandardisedHeights;
pub use heights_table::TabulatedHeights;
pub use heights_weibull::WeibullHeights;
pub use interface::{Body, HARDNESS_OVER_YIELD, Interface};
pub use law::{Law, Part, Regime};
pub use model::{AsperityModel, Claims, Misses, Provenance, Source};
pub use plan::{Method, Plan, PlannedPart, Step};
pub use quantity::Quantity;
pub use request::{Request, linspace};
pub use response::{Column, Response};
pub use scene::Scene;
pub use separation::{At, Datum, Separation, SeparationUnit};
pub use surface::{ProfileMoments, Surface};
pub use sweep::{Case, Sweep};
pub use tolerance::Tolerance;
pub use warning::{Warning, Warnings};
