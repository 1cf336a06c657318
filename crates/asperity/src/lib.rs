#![doc = include_str!("../README.md")]

mod corrected;
mod evidence;
mod ranking;
mod recommend;
mod registry;
mod tables;
mod truth;

#[doc = include_str!("../DEFINITIONS.md")]
pub mod definitions {}

pub use asperity_adhesion::{
    DerjaguinMullerToporov, JkrBranch, JohnsonKendallRoberts, PullOff, pull_off,
};
pub use asperity_af::{AbdoFarhang, FlowPressure};
pub use asperity_at::{AminiTehrani, AtReading};
pub use asperity_bem as bem;
pub use asperity_ceb::ChangEtsionBogy;
pub use asperity_core::*;
pub use asperity_etsion::EtsionKligermanKadin;
pub use asperity_fit as fit;
pub use asperity_gao::{
    AngleDensity, Displacement, ForceComponent, Gao, LateralOptions, ObliqueContact, Stick,
    angle_average, angle_average_of_powers,
};
pub use asperity_ghaednia::Ghaednia;
pub use asperity_gw::{GreenwoodWilliamson, greenwood_integral};
pub use asperity_jg::{GeometricHardness, JacksonGreen};
pub use asperity_joints as joints;
pub use asperity_ke::KogutEtsion;
pub use asperity_persson::{Persson, PerssonVariance, Spectrum};
pub use asperity_random::RandomAsperities;
pub use asperity_zmc::ZhaoMaiettaChang;
pub use corrected::{Corrected, CorrectedRow, CorrectedSeparation, CorrectedValue};
pub use evidence::{
    Compared, Estimate, Evidence, EvidenceCase, EvidenceRow, ExpectedContact, Ratio, SurfaceShape,
};
pub use ranking::nearest_to_bem;
pub use recommend::{
    Comparison, Deviation, EvidenceAt, Expectation, Recommendation, recommend, recommend_among,
    usual_reference,
};
pub use registry::Model;
pub use tables::contact_table::{ContactNode, ContactTable};
pub use tables::error::TableError;
pub use tables::format::{Interpolation, TableFormat};
pub use tables::interaction::ConductanceAgainst;
pub use tables::units::UnitSystem;
pub use truth::{ContactState, Truth, Unranked, beside_table, compare_with_bem, summary, unranked};
