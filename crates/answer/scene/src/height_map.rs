//! A scan as a map of heights, and the waves in it.

use asperity::{Code, Finding};
use asperity_bem::{BemError, HeightMap};
use asperity_topography::Topography;

/// Points on a side of the reduced scan.
const COARSE: usize = 128;

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

/// The wavelength \[m\] above which half of Sq² of a scan lies; `None` for scans without a
/// spectrum.
pub(crate) fn long_wavelength(scan: &Topography) -> Option<f64> {
    let size = size(scan);
    // Means of blocks of points have the same long waves.
    let (heights, columns) = scan.coarse(COARSE);
    let rows = heights.len() / columns.max(1);
    let pixel = [size[0] / columns as f64, size[1] / rows as f64];
    let coarse = Topography::new(heights, columns, pixel).ok()?;
    Some(coarse.with_periodic(scan.is_periodic()).spectra().ok()?.median_wavelength)
}

/// Width and height \[m\].
pub(crate) fn size(scan: &Topography) -> [f64; 2] {
    let [dx, dy] = scan.pixel_size();
    [scan.columns() as f64 * dx, scan.rows() as f64 * dy]
}
