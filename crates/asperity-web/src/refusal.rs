//! Errors with the place that they are about.

use asperity_scene::SceneError;
use serde::Serialize;

/// An error with its place.
#[derive(Debug, Serialize)]
pub(crate) struct Refusal {
    pub(crate) message: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) line: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) field: Option<String>,
}

impl Refusal {
    pub(crate) fn new(message: impl ToString) -> Self {
        Self { message: message.to_string(), line: None, field: None }
    }

    pub(crate) fn at(field: &str, message: impl ToString) -> Self {
        Self { field: Some(field.into()), ..Self::new(message) }
    }
}

impl From<SceneError> for Refusal {
    fn from(error: SceneError) -> Self {
        let message = error.to_string();
        let (SceneError::Unreadable { at, .. }
        | SceneError::Unwritable { at, .. }
        | SceneError::Syntax { at, .. }
        | SceneError::UnknownKey { at, .. }
        | SceneError::Value { at, .. }
        | SceneError::Missing { at, .. }
        | SceneError::Conflict { at, .. }
        | SceneError::Measured { at, .. }
        | SceneError::Contact { at, .. }) = error
        else {
            return Self::new(message);
        };
        // A field that names its file has it behind: `surface.file = "a.x3p"`.
        let field = at.field.split(" = ").next().unwrap_or_default().to_string();
        Self { message, line: at.line, field: Some(field) }
    }
}

macro_rules! refusals {
    ($($error:ty),*) => {$(
        impl From<$error> for Refusal {
            fn from(error: $error) -> Self {
                Self::new(error)
            }
        }
    )*};
}
refusals!(
    asperity::ContactError,
    asperity::QuadratureError,
    asperity::TableError,
    asperity::bem::BemError,
    asperity_plot::PlotError,
    asperity_topography::TopographyError,
    String
);
