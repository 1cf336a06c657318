//! Scans of rough surfaces: the keys by which they are read and prepared, and what a scene keeps.

use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use asperity::{Code, Finding, Spectrum};
use asperity_bem::{BemError, HeightMap};
use asperity_topography::{
    Alignment, Estimator, Level, ReadOptions, Statistics, Topography, TopographyError,
};
use serde::Deserialize;
use toml::Table;

use crate::document::Document;
use crate::error::SceneError;
use crate::keys::{KEYS, Key, Subject};

/// The keys for measured files of `[surface]` or its counterface.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(default)]
pub struct MeasuredKeys {
    pub(crate) file: Option<PathBuf>,
    /// How asperities are estimated.
    pub estimator: Estimator,
    /// The form removed; the usual one by default.
    pub level: Option<Level>,
    /// Long-wavelength cut-off \[m\].
    pub filter: Option<f64>,
    /// Short-wavelength cut-off \[m\].
    pub smooth: Option<f64>,
    /// Whether the scan is periodic.
    pub periodic: bool,
    aligned: Option<Aligned>,
    /// Whether missing points are filled.
    pub fill_missing: bool,
    /// Whether outliers are replaced.
    pub despike: bool,
    /// What the scan file may leave out.
    #[serde(flatten)]
    pub options: ReadOptions,
}

/// `aligned`: whether points of two scans meet, and which.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(untagged, expecting = "true, false or \"mirrored\"")]
enum Aligned {
    Known(bool),
    Turned(Alignment),
}

impl MeasuredKeys {
    /// The keys of a section.
    pub(crate) fn read(document: &Document<'_>, section: &str) -> Result<Self, SceneError> {
        let is_scan = |key: &&Key| key.subject == Subject::Scan;
        let names: Vec<&str> = KEYS.iter().filter(is_scan).map(|key| key.name).collect();
        document.read_over(section, &names, Table::new())
    }

    /// How the points of two scans meet, if they do.
    pub(crate) fn alignment(&self) -> Option<Alignment> {
        match self.aligned? {
            Aligned::Known(known) => known.then_some(Alignment::AsRead),
            Aligned::Turned(alignment) => Some(alignment),
        }
    }

    /// The scan without outliers, if they are replaced.
    ///
    /// # Errors
    /// The errors of [`Topography::despiked`].
    pub fn clean(&self, read: Topography) -> Result<Topography, TopographyError> {
        let read = read.with_periodic(self.periodic);
        if self.despike { read.despiked() } else { Ok(read) }
    }

    /// A clean scan levelled, filled and filtered.
    ///
    /// # Errors
    /// The errors of these steps.
    pub fn prepare(&self, clean: Topography) -> Result<Topography, TopographyError> {
        let mut topography = clean.levelled(self.level)?;
        if self.fill_missing {
            topography = topography.fill()?;
        }
        if let Some(cutoff) = self.smooth {
            topography = topography.smooth(cutoff)?;
        }
        match self.filter {
            Some(cutoff) => topography.filter(cutoff),
            None => Ok(topography),
        }
    }
}

/// Statistics of a scan beyond its asperities.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Measured {
    /// Heights, moments, asperities.
    pub statistics: Statistics,
    /// The longer side of a pixel \[m\].
    pub pixel_size: f64,
}

/// The spectrum of a scan, or the reason why there is none.
pub(crate) type ScanSpectrum = Result<Arc<Spectrum>, String>;

/// What was written of a scan.
#[derive(Debug)]
pub(crate) struct Source {
    /// Its file, by the name that was written.
    pub(crate) path: PathBuf,
    pub(crate) keys: MeasuredKeys,
    /// The same for a scene elsewhere.
    pub(crate) written: Table,
}

/// A scan, levelled and filtered.
#[derive(Debug)]
pub struct Scan {
    pub(crate) topography: Topography,
    /// Its statistics, where its asperities are asked for.
    pub(crate) measured: Option<Arc<Measured>>,
    /// What was written of it.
    pub(crate) source: Option<Source>,
    /// Its spectrum, computed on first use.
    pub(crate) spectrum: OnceLock<ScanSpectrum>,
    /// Its Hurst exponent, fitted on first use.
    pub(crate) hurst: OnceLock<Option<f64>>,
}

impl Scan {
    pub(crate) fn new(topography: Topography, measured: Option<Measured>) -> Self {
        let (spectrum, hurst) = (OnceLock::new(), OnceLock::new());
        Self { topography, measured: measured.map(Arc::new), source: None, spectrum, hurst }
    }
}

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

#[cfg(test)]
mod tests {
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
        keys.prepare(topography(192)).unwrap().statistics(estimator).unwrap()
    }

    #[test]
    fn every_choice_changes_the_surface() {
        let std = |level, filter, estimator| {
            statistics(level, filter, estimator).surface().unwrap().asperity_height_std
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
