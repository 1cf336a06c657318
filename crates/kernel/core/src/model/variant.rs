//! The laws of a model on asperities that are distributed otherwise than in GW.

use std::sync::Arc;

use crate::{
    AsperityModel, Citation, ContactError, ContactModel, Described, HeightDistribution, Validity,
};

/// A model whose laws are averaged over other asperities than equal ones under a flat:
/// `ke` becomes `ke-random` or `ke-pairs`.
#[derive(Debug, Clone)]
pub struct Variant {
    model: Arc<dyn ContactModel>,
    word: &'static str,
    id: String,
    name: String,
    differs: &'static str,
    what: &'static str,
    /// What the variant states of its laws, by default what the model does.
    pub validity: Validity,
}

impl Variant {
    /// The variant of this word, which ends its id and its name: how it `differs` from the model,
    /// and `what` a model cannot give that is refused ("averages over ..").
    #[must_use]
    pub fn new(
        model: impl ContactModel + 'static,
        word: &'static str,
        differs: &'static str,
        what: &'static str,
    ) -> Self {
        let (id, name) = (format!("{}-{word}", model.id()), format!("{} {word}", model.name()));
        let validity = model.validity();
        Self { model: Arc::new(model), word, id, name, differs, what, validity }
    }

    /// The laws of one upright asperity without adhesion, to be averaged over Gaussian heights.
    ///
    /// # Errors
    /// [`ContactError::Unsupported`] for other models and for other heights.
    pub fn laws(&self, heights: &HeightDistribution) -> Result<&dyn AsperityModel, ContactError> {
        let Validity { adhesive, angles, .. } = self.validity;
        let one = self.model.asperity_model().filter(|_| self.model.sum_of_contacts().is_none());
        let Some(model) = one else {
            return Err(self.refused("it has no law of one asperity"));
        };
        let reason = match heights {
            _ if adhesive => "adhesion changes with the radius",
            _ if angles => "contacts are inclined",
            HeightDistribution::Gaussian => return Ok(model),
            _ => "heights must be Gaussian",
        };
        Err(self.refused(&format!("{reason}; {}", self.advice())))
    }

    /// What to do where the variant is refused.
    #[must_use]
    pub fn advice(&self) -> String {
        format!("use a model without -{}", self.word)
    }

    fn refused(&self, reason: &str) -> ContactError {
        let what = format!("{}: {reason}", self.what);
        ContactError::Unsupported { model: self.model.id().into(), what }
    }
}

/// It has the citation of the model, and its own id and name.
impl Described for Variant {
    fn citation(&self) -> &Citation {
        self.model.citation()
    }

    fn id(&self) -> &str {
        &self.id
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn variant(&self) -> Vec<&'static str> {
        [self.model.variant(), vec![self.differs]].concat()
    }

    fn validity(&self) -> Validity {
        self.validity
    }
}
