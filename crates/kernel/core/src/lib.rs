//! Scenes, laws, heights and the one integral behind every statistical rough-contact model.
//!
//! ```text
//! Q(d) = η A_n ∫₀^∞ q(w) g(d + w) dw
//! ```
//!
//! A [`Law`] q is the response of one asperity to an interference w; [`Heights`] g describe the
//! asperity heights; a [`Scene`] describes the surfaces in contact, a [`Request`] the quantities
//! and the places. An [`AsperityModel`] supplies only the law:
//!
//! ```text
//! scene + request → model.force(asperity) → compiled → response
//! ```
//!
//! This crate contains no model. All units are SI;
//! plain separations are multiples of σ_z.

mod engine;
mod error;
mod finding;
mod heights;
mod law;
mod model;
mod request;
mod response;
mod scene;
mod text;
mod units;

#[doc(hidden)]
pub use asperity_quadrature::{Density, Moments, Piece};
pub use asperity_quadrature::{QuadratureError, Sampler};
pub use engine::contact::contact_of_laws;
#[doc(hidden)]
pub use engine::parallel::map_runs;
pub use engine::sweep::{Case, Sweep};
pub use error::ContactError;
#[doc(hidden)]
pub use error::{integral_failed, positive, require};
pub use finding::{Advice, Code, Finding, Findings, Severity};
pub use heights::HeightDistribution;
pub use heights::other::{Heights, OtherHeights};
pub use heights::table::TabulatedHeights;
pub use heights::weibull::WeibullHeights;
pub use law::formula::{Formula, FunctionKey, Power};
pub use law::{Law, Part, Regime, ShareParts, testkit};
pub use model::contact::{Contact, ContactEngine, Interval};
pub use model::contact_model::{AsperityModel, ContactModel, SumOfContacts};
pub use model::described::{Citation, Described, KnownDefect, Provenance, Validity, Wraps};
pub use model::variant::Variant;
pub use request::quantity_table::Quantity;
pub use request::separation::{At, Datum, Separation, SeparationUnit};
pub use request::{Request, Tolerance, linspace};
pub use response::evaluation::{Evaluation, Share};
pub use response::fill::FillReport;
pub use response::plan::{Plan, PlannedPart, Step};
pub use response::row_check::RowCheck;
pub use response::{Column, Response};
pub use scene::asperity::Asperity;
pub use scene::hardness::{
    BRINELL_LIMITS, ROCKWELL_C_LIMITS, hardness_of_vickers, vickers_of_brinell,
    vickers_of_rockwell_c,
};
pub use scene::material::{Body, HARDNESS_OVER_YIELD, Interface, MaterialNumber};
pub use scene::pair::{Pair, RoughSurface};
pub use scene::surface::{ProfileMoments, Surface};
pub use scene::{ATOMIC_DISTANCE, Scene};
pub use text::{nearest_hint, nearest_name, short, shortest_digits, written};
#[doc(hidden)]
pub use units::{Units, plain_unit, units, units_of};
