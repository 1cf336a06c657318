#![doc = include_str!("../README.md")]

mod best;
mod check;
mod evidence;
#[doc(hidden)]
pub mod recommended;

pub use best::{Answering, Best, BestContact, Known, Other, SolvedContact, Source};
pub use check::{Check, DerivedNumber, Plausible, outside, unusual};
pub use evidence::{
    Compared, Estimate, Evidence, EvidenceCase, EvidenceRow, ExpectedContact, SurfaceShape,
    compile_known,
};
pub use recommended::usual_reference;
