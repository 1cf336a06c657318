//! Statistics of a scan that are unusual by themselves.

use asperity_core::{Code, Finding};

use crate::Statistics;

/// Range of rms slopes of scans, from polished to blasted surfaces.
const SLOPE: [f64; 2] = [5e-4, 1.0];
/// Kurtosis above which a few points dominate: exponential heights have 9, honed ones up to 20.
const FAT: f64 = 30.0;

impl Statistics {
    /// An unusual rms slope of a scan with this pixel size \[m\], most often by a wrong unit.
    #[must_use]
    pub fn unusual_slope(&self, pixel_size: f64) -> Option<Finding> {
        let slope = (2.0 * self.m2).sqrt();
        let found = Finding::warning(Code::UnusualSize, "measured_slope", slope)
            .implausible(slope > SLOPE[1])
            .usual(SLOPE)
            .advice(format!("check unit and pixel_size ({pixel_size:e} m)"));
        (!(SLOPE[0]..=SLOPE[1]).contains(&slope)).then_some(found)
    }

    /// A kurtosis that a few points far from the others make, where these are no outliers of
    /// single points.
    #[must_use]
    pub fn unusual_kurtosis(&self) -> Option<Finding> {
        let found = Finding::warning(Code::NotGaussian, "sku", self.sku).usual([0.0, FAT]);
        let found = found.advice(
            "a few points far from the others dominate sq and sku, in groups that despike leaves as features; mark them as missing in the file",
        );
        (self.sku > FAT && !self.outliers.matter()).then_some(found)
    }
}
