//! Random surfaces, and scans at a glance.

use asperity::bem::RandomSurface;
use asperity_plot::{ScanPicture, draw_scan};
use asperity_topography::{Glance, Level, TopographyError};
use pyo3::prelude::*;

use crate::convert::error::value_error;
use crate::topography::{Spacing, Topography};

/// The most points of the map on a side.
const MAP: usize = 800;

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
    let [dx, dy] = pixel_size.both();
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

/// The surface levelled and filtered, and its report.
pub(crate) fn glance(
    raw: &asperity_topography::Topography,
    level: Option<Level>,
    smooth: Option<f64>,
    cutoff: Option<f64>,
) -> Result<(asperity_topography::Topography, Glance), TopographyError> {
    let level = level.unwrap_or(Level::usual(raw.is_periodic()));
    let mut surface = raw.clone().level(level)?;
    if let Some(smooth) = smooth {
        surface = surface.smooth(smooth)?;
    }
    if let Some(cutoff) = cutoff {
        surface = surface.filter(cutoff)?;
    }
    let glance = Glance::new(raw, level, [smooth, cutoff], &surface)?;
    Ok((surface, glance))
}

/// The picture of a surface with this report.
pub(crate) fn picture(
    surface: &asperity_topography::Topography,
    glance: &Glance,
    title: &str,
) -> PyResult<String> {
    let (heights, columns) = surface.coarse(MAP);
    let [dx, dy] = surface.pixel_size();
    let picture = ScanPicture {
        title: title.into(),
        caption: surface.caption(glance),
        heights,
        columns,
        size: [surface.columns() as f64 * dx, surface.rows() as f64 * dy],
        marks: glance.roll_off.into_iter().chain(glance.cut_off).collect(),
        law: glance.hurst.map(|hurst| format!("power law, H = {hurst:.2}")).unwrap_or_default(),
    };
    draw_scan(&picture, &surface.curves_csv(glance)).map_err(value_error)
}
