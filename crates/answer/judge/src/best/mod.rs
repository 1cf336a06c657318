//! What is known best about a scene at a load: the one decision behind everything that is printed,
//! drawn, exported or handed over.

mod candidates;
mod choice;
mod contact;
mod expected;
mod model;
mod notes;

pub use self::choice::Other;
pub use self::contact::BestContact;
pub use self::model::{Answering, Best, Known, SolvedContact, Source};
