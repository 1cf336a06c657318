//! Errors with the place that they are about.

use std::error::Error;

use asperity::ContactError;
use asperity_scene::SceneError;
use serde::Serialize;

use crate::labels::raised;

/// An error with its place.
#[derive(Debug, Default, Serialize)]
pub(crate) struct Refusal {
    pub(crate) message: String,
    pub(crate) line: Option<usize>,
    pub(crate) field: Option<String>,
    /// The message without line and key, to follow the name of the field in the form.
    pub(crate) field_message: Option<String>,
}

impl Refusal {
    pub(crate) fn new(message: impl ToString) -> Self {
        Self { message: message.to_string(), ..Self::default() }
    }

    pub(crate) fn at(field: &str, message: impl ToString) -> Self {
        Self { field: Some(field.into()), ..Self::new(message) }
    }

    fn of_scene(error: &SceneError) -> Self {
        let Some(at) = error.place() else { return Self::new(error) };
        // A field that names its file has it behind: `surface.file = "a.x3p"`.
        let field = at.field.split(" = ").next().unwrap_or_default();
        Self { line: at.line, field_message: Some(error.reason()), ..Self::at(field, error) }
    }
}

impl<E: Error + 'static> From<E> for Refusal {
    fn from(error: E) -> Self {
        let any: &dyn Error = &error;
        match (any.downcast_ref(), any.downcast_ref::<ContactError>()) {
            (Some(error), _) => Self::of_scene(error),
            (_, Some(error)) => Self::new(raised(&error.to_string())),
            _ => Self::new(error),
        }
    }
}

#[cfg(test)]
mod tests {
    use asperity_scene::HandedFiles;

    use super::*;

    #[test]
    fn a_share_of_missing_points_is_about_its_own_field() {
        let row = |k: usize| if k < 4 { "nan\t1\t3\t2\n" } else { "2\t4\t1\t3\n" };
        let text = (0..8).map(row).collect::<String>().into_bytes();
        let files = HandedFiles::from([("a.txt".to_string(), text)]);
        let scene = crate::surface_keys::with_scan(asperity_scene::template(), "a.txt").unwrap();
        let scene =
            scene.replace("file = \"a.txt\"", "file = \"a.txt\"\nunit = \"um\"\npixel_size = 1");
        let refused = Refusal::from(asperity_scene::parse_handed(&scene, &files).unwrap_err());
        assert_eq!(refused.field.as_deref(), Some("surface.max_missing"), "{}", refused.message);
        let refused =
            Refusal::from(asperity_scene::parse_handed(&scene, &HandedFiles::new()).unwrap_err());
        assert_eq!(refused.field.as_deref(), Some("surface.file"), "{}", refused.message);
    }
}
