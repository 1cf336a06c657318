//! Scans of rough surfaces, as a scene keeps them.

use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use asperity::Spectrum;
use asperity_topography::{Statistics, Topography};
use toml::Table;

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

/// A scan, levelled and filtered.
#[derive(Debug)]
pub struct Scan {
    pub(crate) topography: Topography,
    /// Its statistics, where its asperities are asked for.
    pub(crate) measured: Option<Arc<Measured>>,
    /// Its file, and the keys by which it was read and prepared.
    pub(crate) source: Option<(PathBuf, Table)>,
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
