//! Evidence from boundary elements for a scene: its scan has a skewness and a lay.

use std::sync::Arc;

use asperity::{ContactError, SurfaceShape};
use asperity_topography::{PowerLaw, Spectra, Statistics};

use crate::measured::Scan;
use crate::scene_file::SceneFile;
use crate::spec::SurfaceSpec;

/// The range of the kurtosis of nearly Gaussian heights.
pub(crate) const KURTOSIS: [f64; 2] = [2.0, 5.0];

impl SceneFile {
    /// The skewness, the ratio of slopes and the Hurst exponent of the scan, for evidence from
    /// solved surfaces; `None` without a scan.
    ///
    /// # Errors
    /// [`ContactError::Refused`] with the reason why no solved surface is like the scan.
    pub fn surface_shape(&self) -> Result<Option<SurfaceShape>, ContactError> {
        let Some(measured) = &self.measured else { return Ok(None) };
        let statistics = &measured.statistics;
        let Statistics { ssk, sku, .. } = *statistics;
        // Solved surfaces are skewed by an exponential of Gaussian heights.
        let [from, to] = [KURTOSIS[0], 2.0f64.mul_add(ssk * ssk, KURTOSIS[1])];
        if !(from..=to).contains(&sku) {
            let reason = format!(
                "measured_kurtosis is {sku:.3}; solved surfaces with a skewness of {:.1} have {from} to {to:.1}; compare with boundary elements on the scan",
                (10.0 * ssk).round() / 10.0 + 0.0
            );
            return Err(ContactError::NoEvidence { property: "kurtosis", reason });
        }
        let slopes = statistics.moments.texture();
        let slopes = slopes.map_or([1.0; 2], |lay| [lay.slope_along, lay.slope_across]);
        let mut shape = SurfaceShape::new(ssk, slopes);
        shape.slope_skewness = statistics.moments.slope_skewness();
        shape.hurst = self.hurst();
        Ok(Some(shape))
    }

    /// The Hurst exponent of the scan (of two surfaces, the rougher one); if its spectrum follows
    /// no power law, the given one: an option of `persson` does not change the scan. Fitted once:
    /// of 1024 x 1024 points it takes a tenth of a second, and each answer asks for it.
    fn hurst(&self) -> Option<f64> {
        let fit = |scan: &Scan| {
            let Spectra { radial, .. } = scan.topography.spectra().ok()?;
            Some(PowerLaw::fit(&radial?).ok()?.hurst)
        };
        let scan = self.spec.single_scan().or_else(|| self.rougher());
        let own = scan.and_then(|scan| *scan.hurst.get_or_init(|| fit(scan)));
        own.or(self.spec.options.hurst_exponent)
    }

    /// Of two surfaces, the scan of the one with the larger m4, if it has one.
    fn rougher(&self) -> Option<&Arc<Scan>> {
        let m4 = |one: &SurfaceSpec| {
            one.moments(&self.scene.interface).map_or(f64::INFINITY, |moments| moments.m4)
        };
        let (first, second) = (&self.spec.surface, self.spec.counterface.as_ref()?);
        if m4(first) < m4(second) { second.scan() } else { first.scan() }
    }
}

#[cfg(test)]
mod tests {
    use asperity::{At, Compared, Known, Tolerance};
    use asperity_topography::Topography;

    use super::*;
    use crate::measured::Measured;

    /// Waves in many directions, with slopes along columns smaller by the factor `lengthened`.
    fn scan(lengthened: f64) -> Topography {
        turned(lengthened, 0.0, f64::INFINITY)
    }

    /// The part within `radius` points of the middle, turned about it.
    fn turned(lengthened: f64, degrees: f64, radius: f64) -> Topography {
        let waves: Vec<[f64; 3]> = (0..60)
            .map(|k| {
                let wide = (f64::from(k % 7) / 7.0).powi(2);
                let (turn, size) = (2.399_963 * f64::from(k), 0.04 + 0.4 * wide);
                [size * turn.cos(), size * turn.sin(), 5.1 * f64::from(k * k)]
            })
            .collect();
        let (sin, cos) = degrees.to_radians().sin_cos();
        let height = |k: usize| {
            let [x, y] = [k % 128, k / 128].map(|at| at as f64 - 63.5);
            if x.hypot(y) > radius {
                return f64::NAN;
            }
            let (u, v) = (cos * x + sin * y + 63.5, cos * y - sin * x + 63.5);
            let wave = |[a, b, c]: &[f64; 3]| (a * u + b * v / lengthened + c).cos();
            1e-8 * waves.iter().map(wave).sum::<f64>()
        };
        Topography::new((0..128 * 128).map(height).collect(), 128, [1e-6; 2]).unwrap()
    }

    fn measured(statistics: Statistics) -> Arc<Measured> {
        Measured { statistics, pixel_size: 1e-6 }.into()
    }

    fn of_scan(scan: &Topography) -> SceneFile {
        let mut file = crate::parse(crate::template(), std::path::Path::new(".")).unwrap();
        let statistics = scan.statistics(asperity_topography::Estimator::Moments).unwrap();
        file.scene.surface = statistics.surface().unwrap();
        file.measured = Some(measured(statistics));
        file
    }

    /// What stands behind an answer, or the shape beyond that of the solved surfaces.
    fn summary(scan: &Topography) -> String {
        let file = of_scan(scan);
        let best = file.best().on(&file.scene, Tolerance::default()).unwrap();
        best.basis(At::Pressure(1e6)).unwrap_or_else(|reason| reason.to_string())
    }

    #[test]
    fn scans_are_compared_with_solved_surfaces_of_their_skewness_and_lay() {
        let whole = scan(1.0);
        let dug = |z: &f64| if z.abs() > 8e-8 { 5.0 * z } else { *z };
        let dug = whole.heights().iter().map(dug).collect();
        let dug = Topography::new(dug, 128, [1e-6; 2]).unwrap();
        let summaries = [whole, scan(3.0), scan(12.0), dug].map(|scan| summary(&scan));
        insta::assert_snapshot!(summaries.join("\n\n"));
    }

    #[test]
    fn a_turned_scan_has_the_evidence_of_the_scan() {
        let known = |degrees: f64| {
            let file = of_scan(&turned(3.0, degrees, 64.0));
            let best = file.best().on(&file.scene, Tolerance::default()).unwrap();
            [Compared::Area, Compared::UnloadingStiffness, Compared::MeanGap].map(|of| {
                let Known { value, ends, .. } = best.known(of, At::Pressure(1e6)).unwrap();
                let [low, high] = ends.unwrap();
                [value, low, high]
            })
        };
        let wanted = known(0.0);
        for degrees in [17.0, 30.0, 45.0, 90.0] {
            let pairs = known(degrees).into_iter().flatten().zip(wanted.iter().flatten());
            for (found, wanted) in pairs {
                assert!((found / wanted - 1.0).abs() < 0.01, "{degrees}: {found:e} {wanted:e}");
            }
        }
    }

    /// An option of `persson` does not state that stiffnesses of a rough scan are known.
    #[test]
    fn the_hurst_exponent_is_that_of_the_scan() {
        let file = |fitted: Option<f64>| {
            let mut file = crate::parse(crate::template(), std::path::Path::new(".")).unwrap();
            let statistics = scan(1.0).statistics(asperity_topography::Estimator::Moments).unwrap();
            file.measured = Some(measured(statistics));
            file.spec.options.hurst_exponent = Some(0.9);
            let file = file.pressing_scan(scan(1.0));
            file.spec.single_scan().unwrap().hurst.set(fitted).unwrap();
            file.surface_shape().unwrap().unwrap().hurst
        };
        assert_eq!((file(Some(0.3)), file(None)), (Some(0.3), Some(0.9)));
    }
}
