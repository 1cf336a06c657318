//! The area fraction at a pressure: a closed form, or the root of one equation.

use std::f64::consts::{FRAC_2_SQRT_PI, SQRT_2};

use libm::erf;
use serde::{Deserialize, Serialize};

/// The form of the theory: the variance V' of the pressure, and whether the hardness limits it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PerssonVariance {
    /// The variance at full contact, V: Persson 2001.
    #[default]
    Full,
    /// (γ + (1-γ) A/A_n) V, γ = 0.45: smaller at small areas. Xu and others 2024.
    Fudge,
    /// `Fudge` with no pressure above the hardness: after Xu, Li & Mulvihill 2022.
    Plastic,
}

/// γ of `Fudge` and `Plastic`, as in the program of Xu and others (2024). \[seen\]
pub(crate) const GAMMA: f64 = 0.45;
/// Newton steps: the first estimate is within 20 %, and each step doubles the correct digits.
const STEPS: usize = 8;

impl PerssonVariance {
    /// All three, the simplest first.
    pub const ALL: [Self; 3] = [Self::Full, Self::Fudge, Self::Plastic];

    /// A/A_n at the pressure p = `over_std` √V > 0, without a hardness.
    pub(crate) fn area_fraction(self, over_std: f64) -> f64 {
        let p = over_std / SQRT_2;
        match self {
            Self::Full => erf(p),
            Self::Fudge | Self::Plastic => erf(argument(p)),
        }
    }

    /// γ of the elastic energy.
    pub(crate) fn gamma(self) -> f64 {
        match self {
            Self::Full => 1.0,
            Self::Fudge | Self::Plastic => GAMMA,
        }
    }
}

/// The root y of y √(γ + (1-γ) erf y) = p, for which A/A_n = erf y.
fn argument(p: f64) -> f64 {
    // The root lies between p and p/√γ.
    let (low, high) = (p, p / GAMMA.sqrt());
    let mut y = high / (1.0 + (1.0 - GAMMA) * p).min(1.0 / GAMMA.sqrt());
    for _ in 0..STEPS {
        let variance = GAMMA + (1.0 - GAMMA) * erf(y);
        let rise = (1.0 - GAMMA) * FRAC_2_SQRT_PI * (-y * y).exp();
        let root = variance.sqrt();
        let slope = root + 0.5 * y * rise / root;
        y = (y - (y * root - p) / slope).clamp(low, high);
    }
    y
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity_quadrature::gauss_kronrod;

    /// p/(E g), `persson`, `persson-fudge`, as printed by the programs of Xu and others, 2024.
    const PUBLISHED: [[f64; 3]; 7] = [
        [1e-3, 0.001_595_768_057_76, 0.002_375_382_979_56],
        [3e-3, 0.004_787_278_641_13, 0.007_105_613_985_89],
        [1e-2, 0.015_956_627_433_8, 0.023_451_184_866_7],
        [3e-2, 0.047_844_365_308_2, 0.068_469_848_967_3],
        [0.1, 0.158_519_418_878, 0.209_753_318_605],
        [0.3, 0.451_493_764_5, 0.516_291_131_029],
        [1.0, 0.954_499_736_104, 0.957_035_768_564],
    ];

    #[test]
    fn areas_are_those_of_other_programs() {
        for [p, full, fudge] in PUBLISHED {
            // √V = E g/2.
            let found = |variance: PerssonVariance| variance.area_fraction(2.0 * p);
            for (found, wanted) in
                [(found(PerssonVariance::Full), full), (found(PerssonVariance::Fudge), fudge)]
            {
                // All digits printed.
                assert!((found / wanted - 1.0).abs() < 5e-12, "{p}: {found} {wanted}");
            }
        }
    }

    /// The area by its definition: the share of the surface under a pressure σ > 0, whose density
    /// equals full contact less its mirror image.
    #[test]
    fn areas_are_the_integral_of_the_pressure_density() {
        for variance in [PerssonVariance::Full, PerssonVariance::Fudge] {
            for p in [1e-6, 1e-3, 0.03, 0.2, 0.7, 1.5, 3.0] {
                let found = variance.area_fraction(p);
                let reduced = match variance {
                    PerssonVariance::Full => 1.0,
                    _ => 0.45 + 0.55 * found,
                };
                // exp(-(s-p)²/2V') - exp(-(s+p)²/2V'), without cancellation.
                let density = |s: f64| {
                    let bell = (-0.5 * (s - p).powi(2) / reduced).exp();
                    -bell * (-2.0 * s * p / reduced).exp_m1()
                        / (2.0 * std::f64::consts::PI * reduced).sqrt()
                };
                let breaks = [0.0, 1.0, 2.0, 4.0, 8.0, 16.0];
                let integral = gauss_kronrod(density, &breaks, 1e-13, 100_000).unwrap().value;
                assert!((found / integral - 1.0).abs() < 1e-13, "{p}: {found} {integral}");
            }
        }
    }

    #[test]
    fn small_loads_give_proportional_areas_and_large_ones_full_contact() {
        let asymptote = |variance: PerssonVariance| match variance {
            PerssonVariance::Full => (2.0 / std::f64::consts::PI).sqrt(),
            _ => (2.0 / std::f64::consts::PI / 0.45).sqrt(),
        };
        for variance in [PerssonVariance::Full, PerssonVariance::Fudge] {
            for p in [1e-300, 1e-30, 1e-15] {
                let ratio = variance.area_fraction(p) / p;
                assert!((ratio / asymptote(variance) - 1.0).abs() < 1e-14, "{p} {ratio}");
            }
            let mut before = 0.0;
            for k in 0..4000 {
                let area = variance.area_fraction(1e-8 * 1.01f64.powi(k));
                assert!(area >= before && area <= 1.0, "{k} {area}");
                before = area;
            }
            for p in [10.0, 1e3, 1e300] {
                assert!((variance.area_fraction(p) - 1.0).abs() < f64::EPSILON, "{p}");
            }
        }
    }
}
