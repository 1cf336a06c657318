//! `[surface]` from measured files.

use crate::SceneError;
use crate::document::Section;
use crate::surface::Described;

/// The surface of one measured file, or of two pressed together.
pub(crate) fn surface(section: &Section<'_>) -> Result<Described, SceneError> {
    let key = if section.has("file") { "file" } else { "files" };
    let needed = "this build reads no measured surfaces: asperity_radius, asperity_density and asperity_height_std";
    Err(section.missing(key, needed))
}
