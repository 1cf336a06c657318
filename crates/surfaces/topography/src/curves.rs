//! The curves of a scan for a picture: a csv, and a map of fewer points.

use std::f64::consts::TAU;
use std::fmt::Write;

use crate::{Glance, Parameters, PowerSpectrum, Topography};

/// Bins of the histogram.
const BINS: usize = 60;

impl Topography {
    /// The curves of a scan as csv text with the columns `panel,curve,x,y`, in SI units; y is blank
    /// where a bin of the histogram is empty:
    ///
    /// | panel | curves | x | y |
    /// |---|---|---|---|
    /// | histogram | heights, gaussian | height \[m\] | density \[1/m\] |
    /// | radial | radial, law | wave number \[rad/m\] | C \[m⁴\] |
    /// | axial | rows, columns | wave number \[rad/m\] | C \[m³\] |
    /// | slope | rows, columns | distance \[m\] | rms slope |
    /// | curvature | rows, columns | distance \[m\] | rms curvature \[1/m\] |
    #[must_use]
    pub fn curves_csv(&self, glance: &Glance) -> String {
        let mut csv = String::from("panel,curve,x,y\n");
        let mut add = |panel: &str, curve: &str, x: f64, y: Option<f64>| {
            let y = y.map_or(String::new(), |y| format!("{y:.8e}"));
            // A String takes all.
            let _ = writeln!(csv, "{panel},{curve},{x:.8e},{y}");
        };
        let (mean, Parameters { sq, sv, sz, .. }) = (self.mean(), glance.parameters);
        let measured = || self.heights().iter().filter(|z| !z.is_nan()).map(|z| z - mean);
        let (low, width) = (-sv, sz / BINS as f64);
        let mut counts = [0_usize; BINS];
        measured().for_each(|z| counts[(((z - low) / width) as usize).min(BINS - 1)] += 1);
        let one = 1.0 / (self.measured() as f64 * width);
        for (bin, count) in counts.iter().enumerate() {
            let density = Some(*count as f64 * one).filter(|density| *density > 0.0);
            add("histogram", "heights", low + width * (bin as f64 + 0.5), density);
        }
        for k in -60..=60 {
            let z = sq * f64::from(k) / 10.0;
            let density = (-0.5 * (z / sq).powi(2)).exp() / (sq * TAU.sqrt());
            if density > 0.5 * one {
                add("histogram", "gaussian", z, Some(density));
            }
        }
        let mut spectrum = |panel: &str, curve: &str, found: &PowerSpectrum| {
            let each = found.wave_number.iter().zip(&found.density);
            each.for_each(|(q, c)| add(panel, curve, *q, Some(*c)));
        };
        if let Some(spectra) = &glance.spectra {
            if let Some(radial) = &spectra.radial {
                spectrum("radial", "radial", radial);
            }
            spectrum("axial", "rows", &spectra.along_rows);
            if let Some(columns) = &spectra.along_columns {
                spectrum("axial", "columns", columns);
            }
        }
        if let Ok(law) = &glance.power_law {
            law.range.iter().for_each(|q| add("radial", "law", *q, Some(law.density(*q))));
        }
        for (step, at) in self.scale_dependence() {
            for (panel, values) in ["slope", "curvature"].into_iter().zip(at) {
                let pixels = ["rows", "columns"].into_iter().zip(self.pixel_size());
                for ((curve, pixel), value) in pixels.zip(values) {
                    if let Some(value) = value.filter(|value| *value > 0.0) {
                        add(panel, curve, step as f64 * pixel, Some(value));
                    }
                }
            }
        }
        csv
    }

    /// Heights \[m\] for a map of at most `most` points on a side, row by row, and their number in
    /// a row: means of squares of points, NaN where none is measured.
    #[must_use]
    pub fn coarse(&self, most: usize) -> (Vec<f64>, usize) {
        let step = self.columns().max(self.rows()).div_ceil(most.max(1));
        let [columns, rows] = [self.columns(), self.rows()].map(|n| n.div_ceil(step));
        let mut sums = vec![(0.0, 0.0); columns * rows];
        for (k, z) in self.heights().iter().enumerate().filter(|(_, z)| !z.is_nan()) {
            let (x, y) = (k % self.columns() / step, k / self.columns() / step);
            let sum = &mut sums[y * columns + x];
            *sum = (sum.0 + z, sum.1 + 1.0);
        }
        (sums.into_iter().map(|(sum, n)| sum / n).collect(), columns)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Level;

    #[test]
    fn the_histogram_has_area_one_and_every_panel_has_rows() {
        let height = |k: usize| {
            let (x, y) = ((k % 96) as f64, (k / 96) as f64);
            1e-7 * ((0.7 * x + 0.2 * y).sin() + 0.5 * (1.3 * y - 0.4 * x).cos())
        };
        let surface = Topography::new((0..96 * 96).map(height).collect(), 96, [1e-6; 2]).unwrap();
        let glance = Glance::new(&surface, Level::None, [None; 2], &surface).unwrap();
        let csv = surface.curves_csv(&glance);
        let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
        let of = |panel: &str, curve: &str| -> Vec<[f64; 2]> {
            let rows = rows.iter().filter(|row| row[0] == panel && row[1] == curve);
            rows.map(|row| [row[2].parse().unwrap(), row[3].parse().unwrap_or(0.0)]).collect()
        };
        for curve in ["heights", "gaussian"] {
            let found = of("histogram", curve);
            let step = found.windows(2).map(|p| p[1][0] - p[0][0]).fold(f64::INFINITY, f64::min);
            let area: f64 = found.iter().map(|[_, density]| density * step).sum();
            assert!((area - 1.0).abs() < 1e-3, "{curve} {area}");
        }
        for (panel, curve) in
            [("radial", "radial"), ("axial", "rows"), ("axial", "columns"), ("slope", "columns")]
        {
            assert!(of(panel, curve).len() > 3, "{panel} {curve}");
        }
        assert!(of("curvature", "rows").len() > 3);
    }

    #[test]
    fn a_coarse_map_keeps_means_and_missing_points() {
        let mut heights: Vec<f64> = (0..30).map(f64::from).collect();
        heights[25..].fill(f64::NAN);
        let surface = Topography::new(heights, 5, [1.0; 2]).unwrap();
        let (map, columns) = surface.coarse(3);
        assert_eq!((map.len(), columns), (9, 3));
        assert!((map[0] - 3.0).abs() < 1e-12 && (map[2] - 6.5).abs() < 1e-12, "{map:?}");
        assert!((map[6] - 20.5).abs() < 1e-12);
        assert_eq!(surface.coarse(100).0.len(), 30);
    }
}
