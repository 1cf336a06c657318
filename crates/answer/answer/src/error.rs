//! Why there is no answer.

use asperity::ContactError;
use asperity::bem::BemError;
use asperity_scene::SceneError;
use thiserror::Error;

/// Why there is no answer.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum AnswerError {
    /// The scene file, or a model that it does not have.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// An input that is out of range or missing.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// Boundary elements without a result.
    #[error(transparent)]
    Bem(#[from] BemError),
    /// A model of an answer has no result.
    #[error("{id}: {reason}")]
    OfModel {
        /// The name of the model.
        id: String,
        /// The reason.
        reason: Box<Self>,
    },
    /// Another reason.
    #[error("{0}")]
    Reason(String),
}

impl AnswerError {
    /// This error of a model by its name.
    pub(crate) fn of_model(self, id: &str) -> Self {
        match &self {
            // Its message begins with the model.
            Self::Contact(ContactError::Refused { model, .. }) if id == model => self,
            _ => Self::OfModel { id: id.into(), reason: Box::new(self) },
        }
    }
}

impl From<String> for AnswerError {
    fn from(reason: String) -> Self {
        Self::Reason(reason)
    }
}

impl From<&str> for AnswerError {
    fn from(reason: &str) -> Self {
        Self::Reason(reason.into())
    }
}
