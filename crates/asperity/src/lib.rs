#![doc = include_str!("../README.md")]

mod registry;

#[doc = include_str!("../DEFINITIONS.md")]
pub mod definitions {}

pub use asperity_adhesion::{
    DerjaguinMullerToporov, JkrBranch, JohnsonKendallRoberts, PullOff, pull_off,
};
pub use asperity_af::{AbdoFarhang, FlowPressure};
pub use asperity_at::{AminiTehrani, AtReading};
#[cfg(feature = "bem")]
pub use asperity_bem as bem;
pub use asperity_ceb::ChangEtsionBogy;
pub use asperity_core::*;
pub use asperity_etsion::EtsionKligermanKadin;
pub use asperity_film as film;
#[cfg(feature = "fit")]
pub use asperity_fit as fit;
pub use asperity_gao::{
    AngleDensity, Displacement, ForceComponent, Gao, LateralOptions, ObliqueContact, Stick,
    angle_average, angle_average_of_powers,
};
pub use asperity_ghaednia::Ghaednia;
pub use asperity_gw::{GreenwoodWilliamson, greenwood_integral};
pub use asperity_jg::{GeometricHardness, JacksonGreen};
pub use asperity_joints as joints;
pub use asperity_judge::*;
pub use asperity_ke::KogutEtsion;
pub use asperity_pairs::AsperityPairs;
pub use asperity_persson::{Persson, PerssonVariance, Spectrum};
pub use asperity_random::RandomAsperities;
pub use asperity_zmc::ZhaoMaiettaChang;
pub use registry::{Asperities, Model};
