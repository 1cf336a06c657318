//! Why there is no answer.

use asperity::ContactError;
use asperity_inputs::SceneError;
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
    /// No model can be used for the scene.
    #[error("no model is available for this scene")]
    NoModel,
    /// The reference model has no answer.
    #[error("the reference {id}: {error}")]
    Reference {
        /// The name of the model.
        id: String,
        /// The reason.
        error: ContactError,
    },
    /// Every row is blank; findings give the reasons.
    #[error("no row has a value")]
    NoValue,
}
