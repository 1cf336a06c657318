//! The report of a measured surface.

use asperity_topography::{Glance, Topography};

use crate::{PlotError, ScanPicture, draw_scan};

/// The most points of the map on a side.
const MAP: usize = 800;

/// Draws a levelled and filtered surface with its report: its map, the density of its heights,
/// spectra, slope and curvature against scale; returns the text of an svg.
///
/// # Errors
/// Those of [`draw_scan`].
pub fn draw_surface(
    surface: &Topography,
    glance: &Glance,
    title: &str,
) -> Result<String, PlotError> {
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
    draw_scan(&picture, &surface.curves_csv(glance))
}
