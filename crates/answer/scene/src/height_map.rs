//! A scan as a map of heights.

use asperity::{Code, Finding};
use asperity_bem::{BemError, HeightMap};
use asperity_topography::Topography;

/// The height map of a scan for boundary elements.
///
/// # Errors
/// [`BemError`] for a profile, and for missing points.
pub fn height_map(scan: &Topography) -> Result<HeightMap, BemError> {
    let [along_row, along_column] = scan.pixel_size();
    let shape = [scan.rows(), scan.columns()];
    HeightMap::new(scan.heights().to_vec(), shape, [along_column, along_row])
}

/// A warning for a scan declared periodic whose edges do not match; `None` for other scans and for
/// those without a [`height_map`].
#[must_use]
pub fn open_seam(scan: &Topography) -> Option<Finding> {
    let map = height_map(scan).ok().filter(|map| scan.is_periodic() && !map.edges_meet())?;
    let step = map.seam_step();
    let fact = format!(
        "the edges of the scan do not match (step {step:.1} times that between neighbours)"
    );
    let found = Finding::warning(Code::OpenSeam, "seam_step", step).fact(fact);
    Some(found.advice(
        "slopes, curvatures and boundary elements include this step; remove periodic if it is not real",
    ))
}
