//! The scan of a scene, to be solved by boundary elements.

use asperity_bem::{Bem, BemError, Boundary, HeightMap};
use asperity_topography::Topography;

use crate::{Place, SceneError, SceneFile};

/// A scan as boundary elements take it.
///
/// # Errors
/// [`BemError`] for a profile, and for missing points.
pub fn height_map(scan: &Topography) -> Result<HeightMap, BemError> {
    let [along_row, along_column] = scan.pixel_size();
    let shape = [scan.rows(), scan.columns()];
    HeightMap::new(scan.heights().to_vec(), shape, [along_column, along_row])
}

impl SceneFile {
    /// The scan of the scene as a model of boundary elements, levelled and filtered as the scene
    /// says; see [`Bem::new`].
    ///
    /// # Errors
    /// [`SceneError::Missing`] when no scan, or more than one, describes the surface;
    /// [`SceneError::Measured`] for a profile, and for one with missing points.
    pub fn bem(&self, boundary: Boundary, elastic: bool) -> Result<Bem, SceneError> {
        let at = Box::new(Place::field("surface.file"));
        let Some(scan) = &self.scan else {
            let needed = "boundary elements (bem) need the scan of one surface".into();
            return Err(SceneError::Missing { at, needed });
        };
        match height_map(scan) {
            Ok(map) => Ok(Bem::new(map, boundary, elastic)),
            Err(error) => Err(SceneError::Measured { at, reason: error.to_string() }),
        }
    }
}
