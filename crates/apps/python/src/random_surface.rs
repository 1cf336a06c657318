//! Random surfaces.

use asperity::bem::RandomSurface;
use asperity_topography::LengthUnit;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::convert::value_error;
use crate::reading::Spacing;
use crate::topography::Topography;

/// A periodic random rough surface with an exact spectrum.
///
/// ``shape`` is rows and columns; lengths are in m. The spectrum is flat from the wavelength
/// ``long`` to ``roll_off`` (by default ``long``), falls as q^(-2-2H) down to ``short`` and ends
/// there. The size of the heights is ``sq`` or the rms ``gradient``. ``skewness`` changes the
/// phases of the waves only. ``anisotropy`` is the rms slope across the lay over that along it,
/// ``direction`` the angle of the lay in degrees from the rows towards the columns; the cut-offs
/// are those across the lay. The same arguments make the same heights in the program
/// (``asperity generate``) and in Rust.
///
/// >>> import asperity
/// >>> cut_offs = {"long": 30e-6, "short": 2e-6}
/// >>> surface = asperity.random_surface((128, 256), 0.5e-6, **cut_offs, sq=1e-7, seed=7)
/// >>> report = surface.report()
/// >>> f"{surface.statistics()['sq']:.4g} {report['hurst_exponent']:.1f}"
/// '1e-07 0.8'
#[pyfunction]
#[pyo3(signature = (
    shape, pixel_size, *, long, short, roll_off=None, hurst=0.8, sq=None, gradient=None,
    skewness=None, anisotropy=1.0, direction=0.0, seed=0
))]
#[expect(clippy::too_many_arguments, reason = "the keywords, by their names in Python")]
pub(crate) fn random_surface(
    py: Python<'_>,
    shape: (usize, usize),
    pixel_size: Spacing,
    long: f64,
    short: f64,
    roll_off: Option<f64>,
    hurst: f64,
    sq: Option<f64>,
    gradient: Option<f64>,
    skewness: Option<f64>,
    anisotropy: f64,
    direction: f64,
    seed: u64,
) -> PyResult<Topography> {
    if sq.is_some() == gradient.is_some() {
        return Err(PyTypeError::new_err("exactly one of sq and gradient was required"));
    }
    let roll_off = roll_off.unwrap_or(long);
    let [dx, dy] = pixel_size.in_unit(LengthUnit::METRE);
    let (rows, columns) = shape;
    let made = || {
        let size = [columns as f64 * dx, rows as f64 * dy];
        let surface = RandomSurface::of_wavelengths([long, roll_off, short], size)?;
        let surface = surface.hurst(hurst)?.seed(seed);
        let surface = match sq {
            Some(sq) => surface.rms_height(sq)?,
            None => surface.gradient(gradient.unwrap_or(f64::NAN))?,
        };
        let surface = surface.lay(anisotropy, direction)?;
        let surface = skewness.map_or(Ok(surface), |skewness| surface.skewness(skewness))?;
        surface.map([rows, columns])
    };
    let map = py.detach(made).map_err(value_error)?;
    let made = asperity_topography::Topography::new(map.heights().to_vec(), columns, [dx, dy]);
    Ok(Topography(made.map_err(value_error)?.with_periodic(true)))
}
