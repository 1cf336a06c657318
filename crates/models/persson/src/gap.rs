//! The mean gap at a pressure and how it falls: integrals over the spectrum.

use asperity_quadrature::{QuadratureError, gauss_kronrod};
use libm::erf;

use crate::Spectrum;
use crate::inverse::Falling;

/// Relative error of the integrals.
const TOLERANCE: f64 = 1e-12;
const EVALUATIONS: usize = 1_000_000;
/// exp(-49) is negligible in an integral.
const EXPONENT: f64 = 49.0;
/// Bound on the relative error of a gap or a stiffness: the errors of the error function and of the
/// wave numbers add to the error of the integral.
pub(crate) const ERROR: f64 = 1e-11;

/// The inputs of mean gaps.
#[derive(Debug)]
pub(crate) struct Gap<'a> {
    pub(crate) spectrum: &'a Spectrum,
    /// γ of the elastic energy.
    pub(crate) gamma: f64,
}

/// ln b of the pressures whose mean gaps are representable and above 0; b = √2 p/(E g), and the
/// upper end is p = 17 E g.
pub(crate) const LN_PRESSURES: [f64; 2] = [-700.0, 3.2];

/// ln u of the mean gap u \[m\], in x = ln b.
impl Falling for Gap<'_> {
    type Error = QuadratureError;

    fn ends(&self) -> [f64; 2] {
        LN_PRESSURES
    }

    fn ln_u(&self, x: f64) -> Result<f64, QuadratureError> {
        Ok(self.mean_gap(x.exp())?.ln())
    }

    fn slope(&self, x: f64, ln_u: f64) -> Result<f64, QuadratureError> {
        let (fall, ln_scale) = self.fall(x.exp())?;
        Ok(-fall * (ln_scale - ln_u).exp())
    }
}

impl Gap<'_> {
    /// The mean gap \[m\] at b = √2 p/(E g) > 0: √(2/π) g ∫ f(b e^v) R(e^-v) dv, R(y) being the
    /// integral of dy/q from y to 1; the outer integral is that over pressures above p.
    pub(crate) fn mean_gap(&self, b: f64) -> Result<f64, QuadratureError> {
        let scale = std::f64::consts::FRAC_2_PI.sqrt() * self.spectrum.gradient() * (-b * b).exp();
        Ok(scale * self.integral(b, |y| self.spectrum.from(y))?)
    }

    /// -du/d(ln p) \[m\], √(2/π) g ∫ f(b/y) dy/q, as a factor and the logarithm -b² of the other.
    pub(crate) fn fall(&self, b: f64) -> Result<(f64, f64), QuadratureError> {
        let scale = std::f64::consts::FRAC_2_PI.sqrt() * self.spectrum.gradient();
        Ok((scale * self.integral(b, |y| y * self.spectrum.wave(y))?, -b * b))
    }

    /// exp(b²) ∫ f(b e^v) of(e^-v) dv from 0 on, with f(t) = (γ + 3(1-γ) erf² t) exp(-t²).
    fn integral(&self, b: f64, of: impl Fn(f64) -> f64) -> Result<f64, QuadratureError> {
        let last = (EXPONENT.sqrt().hypot(b) / b).ln();
        let mut breaks: Vec<f64> = self.spectrum.ends().iter().map(|y| -y.ln()).collect();
        // The range over which the exponential falls.
        breaks.extend([-b.ln(), 0.0, last]);
        breaks.retain(|v| (0.0..=last).contains(v));
        breaks.sort_by(f64::total_cmp);
        let integrand = |v: f64| {
            let t = b * v.exp();
            let touching = erf(t);
            let energy = self.gamma + 3.0 * (1.0 - self.gamma) * touching * touching;
            // b² - t², without cancellation.
            energy * (-(b * v.exp_m1()) * (t + b)).exp() * of((-v).exp())
        };
        Ok(gauss_kronrod(integrand, &breaks, TOLERANCE, EVALUATIONS)?.value)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use asperity_core::{
        At, ContactModel, Datum, Interface, ProfileMoments, Quantity, Request, Scene,
        SeparationUnit, Surface,
    };

    use crate::{Persson, PerssonVariance, Spectrum};

    const MODULUS: f64 = 1e11;
    const QUANTITIES: [Quantity; 4] =
        [Quantity::Force, Quantity::Stiffness, Quantity::Tangent, Quantity::AreaFraction];

    fn scene(alpha: f64) -> Scene {
        let moments = ProfileMoments { m0: 1e-12, m2: 1e-4, m4: alpha * 1e4 };
        let surface = Surface::from_moments(&moments).unwrap();
        Scene::new(Interface::elastic(MODULUS, 0.3), surface, 2.0)
    }

    /// Gap over √m₀ and stiffness √m₀/(E g A), at p/(E g).
    fn found(scene: &Scene, persson: &Persson, load: f64) -> [f64; 2] {
        let contact = persson.compile(scene, &Request::new(QUANTITIES)).unwrap();
        let moments = scene.surface.moments();
        let (sq, unit) = (moments.m0.sqrt(), MODULUS * (2.0 * moments.m2).sqrt());
        let at = At::Pressure(load * unit);
        let gap = contact.separation(at).unwrap();
        let metres = gap.measured_in(SeparationUnit::Metres, Datum::SurfaceMean, scene).unwrap();
        let stiffness = contact.evaluate(Quantity::Tangent, at).unwrap();
        assert!(stiffness.relative_error() < 1e-9);
        // The load follows back from the gap.
        let back = contact.evaluate(Quantity::Force, gap).unwrap();
        let off = back.value() / (load * unit * 2.0) - 1.0;
        assert!(off.abs() < back.relative_error() && off.abs() < 1e-8, "{off:e} {back:?}");
        [metres.value / sq, stiffness.value() * sq / (unit * 2.0)]
    }

    fn power_law(variance: PerssonVariance, hurst: f64) -> Persson {
        Persson { variance, hurst_exponent: Some(hurst), ..Persson::default() }
    }

    /// For waves of one length q is constant: with f(t) = exp(-t²) the gap is √(2/π) (g/q)
    /// (E1(b²)/2 - s), and -du/d(ln p) = √(2/π) (g/q) s, with s = exp(-b²) - √π b erfc(b).
    #[test]
    fn a_scan_of_one_wave_length_has_one_gradient() {
        let (q, sq) = (2e5, 1e-8);
        let spectrum = std::sync::Arc::new(Spectrum::of_waves([(q, sq * sq)]).unwrap());
        assert!((spectrum.gradient() / (q * sq) - 1.0).abs() < 1e-15);
        let persson = Persson { spectrum: Some(Ok(spectrum)), ..Persson::default() };
        let pressure = 0.01 * MODULUS * q * sq;
        let b = 0.01 * std::f64::consts::SQRT_2;
        // E1(b²) by its series.
        let (x, mut term, mut series) = (b * b, 1.0, 0.0);
        for k in 1..20 {
            term *= -x / f64::from(k);
            series -= term / f64::from(k);
        }
        const EULER: f64 = 0.577_215_664_901_532_9;
        let s = (-x).exp() - std::f64::consts::PI.sqrt() * b * libm::erfc(b);
        let factor = std::f64::consts::FRAC_2_PI.sqrt();
        let wanted = factor * (0.5 * (series - x.ln() - EULER) - s);
        // Differences of neighbouring points see less of the slopes: the answers are the same.
        for points in [4.0, 8.0, 16.0, 64.0_f64] {
            let turn = std::f64::consts::PI / points;
            let flattened = turn.sin() / turn;
            let m2 = 0.5 * (q * sq * flattened).powi(2);
            let moments = ProfileMoments { m0: sq * sq, m2, m4: 2.0 * m2 * m2 / (sq * sq) };
            let surface = Surface::from_moments(&moments).unwrap();
            let scene = Scene::new(Interface::elastic(MODULUS, 0.3), surface, 1.0);
            let contact = persson.compile(&scene, &Request::new(QUANTITIES)).unwrap();
            let gap = contact.separation(At::Pressure(pressure)).unwrap();
            let gap = gap.measured_in(SeparationUnit::Metres, Datum::SurfaceMean, &scene).unwrap();
            assert!((gap.value / sq / wanted - 1.0).abs() < 1e-9, "{points}: {}", gap.value / sq);
            let slope = factor * sq * s;
            let stiffness = contact.evaluate(Quantity::Tangent, At::Pressure(pressure)).unwrap();
            assert!((stiffness.value() * slope / pressure - 1.0).abs() < 1e-9, "{points}");
            // b = p/√(2 V) of the area.
            let area = contact.evaluate(Quantity::AreaFraction, At::Pressure(pressure)).unwrap();
            assert!((area.value() / libm::erf(b) - 1.0).abs() < 1e-12, "{points}");
        }
    }

    #[test]
    fn gaps_and_stiffnesses_are_those_of_mpmath() {
        let text = include_str!("../../../../tests/reference/persson_gaps.csv");
        let mut rows = 0;
        for line in text.lines().skip(1) {
            let row: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
            let variance =
                if row[3] < 1.0 { PerssonVariance::Fudge } else { PerssonVariance::Full };
            let found = found(&scene(row[1]), &power_law(variance, row[0]), row[2]);
            for (found, wanted) in found.iter().zip(&row[4..]) {
                assert!((found / wanted - 1.0).abs() < super::ERROR, "{line}: {found}");
            }
            rows += 1;
        }
        assert_eq!(rows, 32);
    }

    /// As printed by another program, whose error is about 1e-3 at light loads.
    #[test]
    fn gaps_are_those_of_another_program() {
        let loads = [1e-3, 3e-3, 1e-2, 3e-2, 1e-1];
        for (load, wanted) in
            loads.into_iter().zip([2.811_49, 2.312_52, 1.750_18, 1.220_32, 0.614_59])
        {
            let [gap, _] = found(&scene(8.0), &power_law(PerssonVariance::Fudge, 0.8), load);
            assert!((gap / wanted - 1.0).abs() < 1e-3, "{gap} {wanted}");
        }
    }

    /// The same surface as a sum of waves: each ring of them is a step of the law.
    #[test]
    fn waves_of_a_power_law_give_its_gaps_and_stiffnesses() {
        let scene = scene(8.0);
        let moments = scene.surface.moments();
        let (hurst, ratio) = (0.8, 11.727_716_f64);
        let count = 4000;
        let waves: Vec<(f64, f64)> = (0..count)
            .map(|k| ratio.powf((f64::from(k) + 0.5) / f64::from(count)))
            .map(|q| (q, q.powf(-2.0 * hurst)))
            .collect();
        let [heights, gradients] =
            [0, 2].map(|n| waves.iter().map(|(q, square)| q.powi(n) * square).sum::<f64>());
        let scale = (2.0 * moments.m2 / moments.m0 * heights / gradients).sqrt();
        let waves = waves.iter().map(|(q, h)| (q * scale, h / heights * moments.m0));
        let spectrum = Some(Ok(Arc::new(Spectrum::of_waves(waves).unwrap())));
        for variance in [PerssonVariance::Full, PerssonVariance::Fudge] {
            let of_waves = Persson { variance, spectrum: spectrum.clone(), ..Persson::default() };
            for load in [1e-4, 1e-2, 0.3] {
                let waves = found(&scene, &of_waves, load);
                let law = found(&scene, &power_law(variance, hurst), load);
                for (found, wanted) in waves.iter().zip(law) {
                    assert!((found / wanted - 1.0).abs() < 1e-3, "{load}: {found} {wanted}");
                }
            }
        }
    }

    #[test]
    fn single_wavelengths_and_extreme_loads_have_gaps_and_stiffnesses() {
        for (alpha, hurst) in
            [(1.5 + 1e-12, 0.8), (1.5 + 1e-9, 0.5), (1.6, 1.0), (1e6, 0.1), (1e6, 1.0)]
        {
            let persson = power_law(PerssonVariance::Fudge, hurst);
            let mut before = f64::INFINITY;
            for load in [1e-290, 1e-100, 1e-10, 0.1, 1.0, 10.0] {
                let [gap, stiffness] = found(&scene(alpha), &persson, load);
                assert!(gap < before && gap > 0.0 && stiffness > 0.0, "{alpha} {hurst} {load}");
                before = gap;
            }
        }
        let one_length = ProfileMoments { m0: 1.0, m2: 2.0, m4: 6.0 };
        let spectrum = Spectrum::power_law(&one_length, 0.8).unwrap();
        assert!((spectrum.wave(0.3) - 0.5).abs() < 1e-15, "{spectrum:?}");
        let contact = power_law(PerssonVariance::Full, 0.8);
        let contact = contact.compile(&scene(8.0), &Request::new(QUANTITIES)).unwrap();
        let heavy = contact.evaluate(Quantity::Tangent, At::Pressure(1e13)).unwrap_err();
        assert!(heavy.to_string().contains("tangent is inf"), "{heavy}");
        let closed = contact.evaluate(Quantity::Force, At::metres(-1.0)).unwrap_err().to_string();
        assert!(closed.starts_with("separation in m"), "{closed}");
        let refused = Spectrum::power_law(&ProfileMoments { m0: 1.0, m2: 1.0, m4: 1.4 }, 0.8);
        assert!(refused.unwrap_err().to_string().starts_with("bandwidth (m0 m4/m2^2) is 1.4"));
        for waves in [[(0.0, 1.0), (1.0, 1.0)], [(1.0, 0.0), (2.0, 0.0)], [(1.0, -1.0), (2.0, 1.0)]]
        {
            assert!(Spectrum::of_waves(waves).is_err());
        }
    }
}
