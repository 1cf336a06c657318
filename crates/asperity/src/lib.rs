#![doc = include_str!("../../../README.md")]

mod contact_table;
mod counting;
mod cubic;
mod output;
mod readout;
mod recommend;
mod registry;

pub use asperity_af::{AbdoFarhang, FlowPressure};
pub use asperity_at::{AminiTehrani, Reading};
pub use asperity_ceb::ChangEtsionBogy;
pub use asperity_core::*;
pub use asperity_etsion::EtsionKligermanKadin;
pub use asperity_gao::{Displacement, ForceComponent, Gao, LateralOptions, Stick};
pub use asperity_gw::{GreenwoodWilliamson, greenwood_integral};
pub use asperity_jg::{GeometricHardness, JacksonGreen};
pub use asperity_ke::KogutEtsion;
pub use asperity_zmc::ZhaoMaiettaChang;
pub use contact_table::{ContactNode, ContactTable, Interpolation, TableError};
pub use output::{Output, UnknownOutput};
pub use readout::{OutputColumn, OutputValue, Readout};
pub use recommend::{Comparison, Recommendation, recommend, recommend_among};
pub use registry::Model;
