//! `[surface]` from measured files.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity::{ContactError, Diagnostic, ProfileMoments, Surface, TabulatedHeights};
use asperity_topography::{
    Estimator, HeightDensity, LengthUnit, Level, ReadOptions, Statistics, Topography,
    TopographyError, read, read_bytes,
};
use serde::Deserialize;

use crate::document::Document;
use crate::heights::HeightsKey;
use crate::scan::open_seam;
use crate::{Measured, Place, Roughness, SceneError};

/// What a scene file is read for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Asked {
    /// Models of asperities, among others.
    Asperities,
    /// Boundary elements, on a scan that is declared periodic if the file or the caller says so.
    Scan { periodic: bool },
}

/// The bandwidth α of the surface that stands in where a scan has no asperities.
const BANDWIDTH: f64 = 3.0;

/// The keys of `[surface]` for measured files.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct MeasuredKeys {
    file: Option<PathBuf>,
    files: Option<Vec<PathBuf>>,
    unit: Option<LengthUnit>,
    pixel_size: Option<PixelSize>,
    channel: Option<String>,
    estimator: Estimator,
    level: Option<Level>,
    filter: Option<f64>,
    smooth: Option<f64>,
    periodic: bool,
    max_missing: Option<f64>,
    fill_missing: bool,
    despike: bool,
}

/// `pixel_size` of square pixels, or along a row and along a column.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(
    untagged,
    expecting = "a length in the unit of the heights, or a list of two, along a row and a column,"
)]
enum PixelSize {
    Square(f64),
    Rectangle([f64; 2]),
}

/// The surface of a scene.
#[derive(Debug, Clone)]
pub(crate) struct SurfaceDescription {
    pub(crate) surface: Surface,
    pub(crate) measured: Option<Measured>,
    /// The density of its summits' heights, if requested.
    pub(crate) heights: Option<TabulatedHeights>,
    pub(crate) notes: Vec<Diagnostic>,
    /// The scan, levelled and filtered, if there is exactly one.
    pub(crate) scan: Option<Arc<Topography>>,
    /// The reason why the scan has no asperities.
    pub(crate) no_asperities: Option<String>,
    /// The keys from which the asperities follow, if they are not given directly.
    pub(crate) follows_from: &'static [&'static str],
    /// The numbers from which the asperities follow, if they are not given directly or measured.
    pub(crate) roughness: Option<Roughness>,
}

/// The surface of one measured file, or of two files in contact.
pub(crate) fn measured(
    document: &Document<'_>,
    heights: &HeightsKey,
    asked: Asked,
) -> Result<SurfaceDescription, SceneError> {
    let mut keys: MeasuredKeys = document.surface()?;
    keys.periodic |= asked == Asked::Scan { periodic: true };
    let measured_heights = matches!(heights, HeightsKey::Measured);
    let conflict = |one, other, needed| Err(document.conflict(one, other, needed));
    if keys.smooth.zip(keys.filter).is_some_and(|(smooth, filter)| smooth >= filter) {
        let needed = "a value of smooth below filter, which keeps some wavelengths,";
        return conflict("surface.smooth", "surface.filter", needed);
    }
    let one = |at: &str, path: &Path| {
        let (handed, path) = (document.handed(at, path)?, document.path(path));
        let options = read_options(&keys);
        let read = match handed {
            Some(bytes) => read_bytes(&path.to_string_lossy(), bytes, &options),
            None => read(&path, &options),
        };
        let found = read.and_then(|read| {
            let [dx, dy] = read.pixel_size();
            let topography = prepare(read, &keys)?;
            let statistics = topography.statistics(keys.estimator)?;
            if asked == Asked::Asperities {
                statistics.surface()?;
            }
            let density = (measured_heights && asked == Asked::Asperities)
                .then(|| density(&topography))
                .transpose()?;
            Ok((Measured { statistics, pixel_size: dx.max(dy) }, density, topography))
        });
        found.map_err(|error| match without_path(error) {
            // Errors of an option are at that option, all others at the file.
            TopographyError::OutOfRange { field, value, required } => {
                SceneError::value(document.place(&format!("surface.{field}")), value, required)
            }
            TopographyError::Cutoff { field, value, required } => {
                SceneError::value(document.place(&format!("surface.{field}")), value, &required)
            }
            error => {
                let reason = format!("{}: {error}", path.display());
                SceneError::Measured { at: document.place(at), reason }
            }
        })
    };
    let (at, (measured, density, scan)) = match (&keys.file, keys.files.as_deref()) {
        (Some(_), Some(_)) => {
            let needed = "file = \"a.x3p\" or files = [\"a.x3p\", \"b.x3p\"]";
            return conflict("surface.file", "surface.files", needed);
        }
        (_, Some(_)) if keys.estimator == Estimator::Summits => {
            let needed = "estimator = \"moments\" for two surfaces: moments add, summits do not,";
            return conflict("surface.estimator", "surface.files", needed);
        }
        (_, Some(_)) if measured_heights => {
            let needed = "one file: the heights of two surfaces do not add,";
            return conflict("surface.heights", "surface.files", needed);
        }
        (_, Some([first, second])) => {
            let at = "surface.files";
            let (a, ..) = one("surface.files[1]", first)?;
            let (b, ..) = one("surface.files[2]", second)?;
            let pixel_size = a.pixel_size.max(b.pixel_size);
            let both = Statistics::combined(&a.statistics, &b.statistics);
            let refused = |reason| SceneError::Measured { at: document.place(at), reason };
            let statistics = both.map_err(|error| refused(error.to_string()))?;
            (at, (Measured { statistics, pixel_size }, None, None))
        }
        (_, Some(files)) => {
            let needed = "a list of two paths, one for each surface in contact,";
            return Err(SceneError::value(
                document.place("surface.files"),
                format_args!("a list of {}", files.len()),
                needed,
            ));
        }
        (file, None) => {
            let at = "surface.file";
            let (measured, density, scan) = one(at, file.as_deref().unwrap_or(Path::new("")))?;
            (at, (measured, density, Some(Arc::new(scan))))
        }
    };
    let statistics = &measured.statistics;
    let at = document.place(at);
    let refused = |reason: TopographyError| SceneError::Measured {
        at: at.clone(),
        reason: reason.to_string(),
    };
    let (surface, no_asperities) = match statistics.surface() {
        Ok(surface) => (surface, None),
        // The surface is not used.
        Err(reason) if asked != Asked::Asperities => {
            (alike(statistics).map_err(document.refused("surface"))?, Some(reason.to_string()))
        }
        Err(reason) => return Err(refused(reason)),
    };
    surface.check().map_err(document.refused("surface"))?;
    let from = |at: &Place| {
        let at = at.to_string();
        move |found: Diagnostic| found.from_origin(at.clone())
    };
    let mut notes: Vec<Diagnostic> = statistics.warnings.iter().cloned().map(from(&at)).collect();
    let tilted = keys.level.and_then(|level| level.tilts(keys.periodic));
    notes.extend(tilted.map(from(&document.place("surface.level"))));
    let seam = scan.as_deref().and_then(open_seam);
    notes.extend(seam.map(from(&document.place("surface.periodic"))));
    let heights = density.map(|points| {
        TabulatedHeights::new("measured", &points).map_err(document.refused("surface"))
    });
    let (heights, measured) = (heights.transpose()?, Some(measured));
    let follows_from = &[];
    Ok(SurfaceDescription {
        surface,
        measured,
        heights,
        notes,
        scan,
        no_asperities,
        follows_from,
        roughness: None,
    })
}

/// A Gaussian surface with the rms height and slope of a scan without asperities.
fn alike(statistics: &Statistics) -> Result<Surface, ContactError> {
    let Statistics { m0, m2, .. } = *statistics;
    Surface::from_moments(&ProfileMoments { m0, m2, m4: BANDWIDTH * m2 * m2 / m0 })
}

/// The error without the name of the file, which only errors of reading have.
fn without_path(error: TopographyError) -> TopographyError {
    match error {
        TopographyError::File { source, .. } => *source,
        other => other,
    }
}

fn read_options(keys: &MeasuredKeys) -> ReadOptions {
    let pixel_size = keys.pixel_size.map(|size| match size {
        PixelSize::Square(side) => [side; 2],
        PixelSize::Rectangle(sides) => sides,
    });
    let max_missing = keys.max_missing.unwrap_or(ReadOptions::default().max_missing);
    ReadOptions { unit: keys.unit, pixel_size, max_missing, channel: keys.channel.clone() }
}

/// The density of the summits' heights above the mean plane.
fn density(topography: &Topography) -> Result<Vec<(f64, f64)>, TopographyError> {
    let summits = topography.summits()?;
    let offset = summits.mean() - topography.mean();
    let HeightDensity { heights_m, density_per_m, .. } = summits.height_density()?;
    Ok(heights_m.into_iter().map(|z| z + offset).zip(density_per_m).collect())
}

/// The scan, despiked, levelled, filled and filtered.
fn prepare(read: Topography, keys: &MeasuredKeys) -> Result<Topography, TopographyError> {
    let read = read.with_periodic(keys.periodic);
    let read = if keys.despike { read.despiked()? } else { read };
    let mut topography = read.levelled(keys.level)?;
    if keys.fill_missing {
        topography = topography.fill()?;
    }
    if let Some(cutoff) = keys.smooth {
        topography = topography.smooth(cutoff)?;
    }
    match keys.filter {
        Some(cutoff) => topography.filter(cutoff),
        None => Ok(topography),
    }
}

#[cfg(test)]
mod tests {
    use asperity_topography::Level;

    use super::*;

    /// Waves in many directions: nearly a Gaussian surface.
    fn topography(count: usize) -> Topography {
        let waves: Vec<[f64; 3]> = (0..60)
            .map(|k| {
                let (turn, size) = (2.399_963 * f64::from(k), 0.1 + 0.25 * f64::from(k % 7) / 7.0);
                [size * turn.cos(), size * turn.sin(), 5.1 * f64::from(k * k)]
            })
            .collect();
        let height = |k: usize| {
            let (x, y) = ((k % count) as f64, (k / count) as f64);
            let wave = |[a, b, c]: &[f64; 3]| (a * x + b * y + c).cos();
            1e-7 * waves.iter().map(wave).sum::<f64>() + 3e-7 * (0.01 * x - 0.02 * y + 5.0)
        };
        Topography::new((0..count * count).map(height).collect(), count, [1e-6; 2]).unwrap()
    }

    fn statistics(level: Level, filter: Option<f64>, estimator: Estimator) -> Statistics {
        let level = Some(level);
        let keys = MeasuredKeys { level, filter, estimator, ..MeasuredKeys::default() };
        prepare(topography(192), &keys).unwrap().statistics(estimator).unwrap()
    }

    #[test]
    fn every_choice_changes_the_surface() {
        let std = |level, filter, estimator| {
            statistics(level, filter, estimator).asperity_height_std.unwrap()
        };
        let plain = std(Level::Plane, None, Estimator::Moments);
        // 60 waves of 1e-7 have a variance of 30e-14, (0.548e-6)²; that of asperities is smaller.
        assert!((0.35e-6..0.54e-6).contains(&plain), "{plain}");
        assert!(std(Level::None, None, Estimator::Moments) > 1.1 * plain);
        assert!(std(Level::Plane, Some(30e-6), Estimator::Moments) < 0.95 * plain);
        let summits = std(Level::Plane, None, Estimator::Summits);
        assert!((summits / plain - 1.0).abs() > 1e-3 && (summits / plain - 1.0).abs() < 0.3);
    }

    #[test]
    fn the_mean_plane_offset_of_summits_agrees_with_theory() {
        for level in [Level::Plane, Level::Quadratic] {
            let [theory, counted] = [Estimator::Moments, Estimator::Summits]
                .map(|estimator| statistics(level, None, estimator).mean_plane_offset.unwrap());
            assert!(theory > 0.3e-6 && (counted / theory - 1.0).abs() < 0.3, "{theory} {counted}");
        }
    }
}
