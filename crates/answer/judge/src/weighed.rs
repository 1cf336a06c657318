//! Models as the registry hands them over.

use asperity_core::{ContactError, ContactModel};

/// A model that is weighed, and what its registry knows of it.
pub trait Weighed: ContactModel + Clone {
    /// The model of an id.
    ///
    /// # Errors
    /// [`ContactError::UnknownModel`].
    fn of_id(id: &str) -> Result<Self, ContactError>;

    /// The same laws on asperities of one radius.
    fn equal(&self) -> &Self;

    /// In what the solved surfaces differ from those of the model, if they do.
    fn unlike(&self) -> Option<Unlike> {
        None
    }
}

/// In what the surfaces of a model differ from the solved ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unlike {
    /// Two rough surfaces are pressed on each other, the solved ones by a flat.
    Pairs,
    /// The bodies harden.
    Hardening,
    /// The model is the solution itself.
    Solution,
}

impl Unlike {
    /// Why a model is not corrected.
    pub(crate) fn reason(self) -> &'static str {
        match self {
            Self::Pairs => {
                "the solved surfaces are pressed by a flat, not by another rough surface"
            }
            Self::Hardening => "the solved surfaces do not harden; solve without correction",
            Self::Solution => "boundary elements are the reference; solve without correction",
        }
    }
}
