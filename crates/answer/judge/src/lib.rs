#![doc = include_str!("../README.md")]

mod check;
#[cfg(feature = "evidence")]
mod corrected;
mod evidence;
#[cfg(feature = "evidence")]
mod ranking;
#[cfg(feature = "evidence")]
mod recommend;
#[doc(hidden)]
pub mod recommended;
#[cfg(feature = "evidence")]
mod weighed;

pub use check::{Check, DerivedNumber, Plausible, unusual};
#[cfg(feature = "evidence")]
pub use corrected::{Corrected, CorrectedRow, CorrectedSeparation, CorrectedValue};
pub use evidence::{Compared, Evidence, EvidenceCase, EvidenceRow};
#[cfg(feature = "evidence")]
pub use evidence::{
    Estimate, ExpectedContact, Ratio, SurfaceShape, compile_compared, compile_known,
};
#[cfg(feature = "evidence")]
pub use ranking::nearest_in_each;
#[cfg(feature = "evidence")]
pub use recommend::{Comparison, EvidenceAt, Expectation, Recommendation, recommend_among};
pub use recommended::usual_reference;
#[cfg(feature = "evidence")]
pub use weighed::{Unlike, Weighed};
