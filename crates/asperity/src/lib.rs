#![doc = include_str!("../README.md")]

mod advice;
mod contact_table;
mod cubic;
mod error_bound;
mod evidence;
mod evidence_csv;
mod fe_interaction;
mod fe_tables;
mod fe_units;
mod kinks;
mod ranking;
mod recommend;
mod registry;
mod table_builder;
mod table_error;
mod table_format;
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
pub use asperity_gao::{
    AngleDensity, Displacement, ForceComponent, Gao, LateralOptions, ObliqueContact, Stick,
    angle_average, angle_average_of_powers,
};
pub use asperity_gw::{GreenwoodWilliamson, greenwood_integral};
pub use asperity_jg::{GeometricHardness, JacksonGreen};
pub use asperity_joints as joints;
pub use asperity_ke::KogutEtsion;
pub use asperity_persson::{Persson, PerssonVariance, Spectrum};
pub use asperity_random::RandomAsperities;
pub use asperity_zmc::ZhaoMaiettaChang;
pub use contact_table::{ContactNode, ContactTable};
pub use evidence::{Deviation, Evidence, EvidenceCase, EvidenceRow, Nearest};
pub use fe_interaction::ConductanceAgainst;
pub use fe_units::UnitSystem;
pub use recommend::{
    Comparison, EvidenceAt, Recommendation, recommend, recommend_among, usual_reference,
};
pub use registry::Model;
pub use table_error::TableError;
pub use table_format::{Interpolation, TableFormat};
pub use truth::{ContactState, Truth, compare_with_bem, summary};
