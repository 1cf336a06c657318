//! Random surfaces.

use asperity::bem::RandomSurface;
use asperity_topography::LengthUnit;
use pyo3::prelude::*;

use crate::convert::error::value_error;
use crate::reading::Spacing;
use crate::topography::Topography;

/// Shape, lay and skewness of a random surface, and its seed.
type Shape = (usize, usize);

/// A periodic random surface; see ``asperity.random_surface``.
#[pyfunction]
pub(crate) fn random_surface(
    py: Python<'_>,
    shape: Shape,
    pixel_size: Spacing,
    wavelengths: (f64, f64, f64),
    sizes: (Option<f64>, Option<f64>),
    options: (f64, f64, f64, Option<f64>, u64),
) -> PyResult<Topography> {
    let (long, roll_off, short) = wavelengths;
    let (hurst, anisotropy, direction, skewness, seed) = options;
    let [dx, dy] = pixel_size.in_unit(LengthUnit::Metre);
    let (rows, columns) = shape;
    let made = || {
        let size = [columns as f64 * dx, rows as f64 * dy];
        let surface = RandomSurface::of_wavelengths([long, roll_off, short], size)?;
        let surface = surface.hurst(hurst)?.seed(seed);
        let surface = match sizes {
            (Some(sq), _) => surface.rms_height(sq)?,
            (None, gradient) => surface.gradient(gradient.unwrap_or(f64::NAN))?,
        };
        let surface = surface.lay(anisotropy, direction)?;
        let surface = skewness.map_or(Ok(surface), |skewness| surface.skewness(skewness))?;
        surface.map([rows, columns])
    };
    let map = py.detach(made).map_err(value_error)?;
    let made = asperity_topography::Topography::new(map.heights().to_vec(), columns, [dx, dy]);
    Ok(Topography(made.map_err(value_error)?.with_periodic(true)))
}
