//! Scans at a glance.

use asperity_topography::{Glance, Level, TopographyError};

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
