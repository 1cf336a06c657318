//! Correlations of thermal contact conductance per nominal area of nominally flat rough surfaces,
//! for comparison with the models.
//!
//! ```text
//! Cooper, Mikic & Yovanovich 1969, plastic    h = 1.25 k (m/σ) (p/H)^0.95            [seen]
//! Mikic 1974, elastic                         h = 1.55 k (m/σ) (√2 p/(E m))^0.94     [seen; 1.54 elsewhere]
//! gas in the gap                              h = k_g/(Y + M)                        [seen]
//! constriction factor                         ψ = (1 - √(A/A_n))^1.5                 [recalled]
//! ```
//! σ and m are combined values: root sum squares of both surfaces' standard deviations of heights
//! and mean absolute slopes; m = √(2 m₂/π) for Gaussian slopes of profiles. \[derived\]
//!
//! Both power laws are fits to the contact of two Gaussian surfaces (bearing area at λσ;
//! conductance e^(-λ²/2) k (m/σ)/(2√(2π) ψ)). The plastic law is within 1.6 % of this theory for
//! p/H = 10⁻⁶ to 0.023, the elastic law within 2.1 % for √2 p/(E m) = 10⁻⁵ to 0.012 (5 % at 10⁻⁶).
//! \[derived\]
//!
//! Provenance of equations: \[seen\] in the source, \[recalled\] from memory, \[derived\] here.

use std::f64::consts::PI;
use std::ops::RangeInclusive;

use asperity_core::{ContactError, ProfileMoments, positive, require};
use serde::{Deserialize, Serialize};

/// The combined roughness of a gap, input of the correlations.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct GapRoughness {
    /// σ \[m\], > 0: standard deviation of the surface heights.
    pub height_std: f64,
    /// m, > 0: mean absolute slope of profiles.
    pub mean_slope: f64,
}

impl GapRoughness {
    /// The roughness of Gaussian profiles with these moments, of one surface or combined
    /// ([`ProfileMoments::plus`]).
    #[must_use]
    pub fn of(moments: &ProfileMoments) -> Self {
        Self { height_std: moments.m0.sqrt(), mean_slope: (2.0 * moments.m2 / PI).sqrt() }
    }

    /// m/σ \[1/m\].
    fn ratio(&self) -> Result<f64, ContactError> {
        let slope = positive("mean_slope", self.mean_slope)?;
        Ok(slope / positive("height_std", self.height_std)?)
    }
}

/// The result of a correlation.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct CorrelationValue {
    /// h \[W/(m² K)\], per nominal area.
    pub conductance: f64,
    /// The base of the power law: p/H or √2 p/(E m).
    pub relative_pressure: f64,
    /// Whether the power law is valid: within 1.6 % (plastic) or 2.1 % (elastic) of the theory it
    /// is fitted to and, [for a scene](crate::Correlation::at), with contacts of
    /// [its kind](crate::Correlation::foreign).
    pub holds: bool,
}

/// Relative pressures at which the power laws are valid: plastic and elastic.
pub(crate) const PLASTIC: RangeInclusive<f64> = 1e-6..=0.023;
pub(crate) const ELASTIC: RangeInclusive<f64> = 1e-5..=0.012;

fn correlated(
    factor: f64,
    conductivity: f64,
    roughness: &GapRoughness,
    (relative_pressure, exponent, fitted): (f64, f64, RangeInclusive<f64>),
) -> Result<CorrelationValue, ContactError> {
    let conductivity = positive("thermal_conductivity", conductivity)?;
    let conductance = factor * conductivity * roughness.ratio()? * relative_pressure.powf(exponent);
    let holds = fitted.contains(&relative_pressure);
    Ok(CorrelationValue { conductance, relative_pressure, holds })
}

/// Plastic contacts, Cooper, Mikic & Yovanovich: `conductivity` is 2k₁k₂/(k₁+k₂) \[W/(m K)\],
/// `pressure` p and `hardness` H of the softer body (micro-hardness if available) \[Pa\].
///
/// # Errors
/// [`ContactError::OutOfRange`] for an input that is not above 0.
pub fn cooper_mikic_yovanovich(
    conductivity: f64,
    roughness: &GapRoughness,
    pressure: f64,
    hardness: f64,
) -> Result<CorrelationValue, ContactError> {
    let relative = positive("pressure", pressure)? / positive("hardness", hardness)?;
    correlated(1.25, conductivity, roughness, (relative, 0.95, PLASTIC))
}

/// Elastic contacts, Mikic: `conductivity` is 2k₁k₂/(k₁+k₂) \[W/(m K)\], with `pressure` p and the
/// equivalent `modulus` E \[Pa\].
///
/// # Errors
/// [`ContactError::OutOfRange`] for an input that is not above 0.
pub fn mikic_elastic(
    conductivity: f64,
    roughness: &GapRoughness,
    pressure: f64,
    modulus: f64,
) -> Result<CorrelationValue, ContactError> {
    let slope = positive("mean_slope", roughness.mean_slope)?;
    let stiffness = positive("equivalent_modulus", modulus)? * slope;
    let relative = 2f64.sqrt() * positive("pressure", pressure)? / stiffness;
    correlated(1.55, conductivity, roughness, (relative, 0.94, ELASTIC))
}

/// The conductance h_g \[W/(m² K)\] of a gas of `conductivity` k_g \[W/(m K)\] in a gap of mean
/// width `gap` Y \[m\], the separation of the mean planes of the surfaces, with gas parameter M
/// \[m\], the temperature-jump distance: about 0.37 µm for air at 1 bar, 0 for liquids.
///
/// # Errors
/// [`ContactError::OutOfRange`] for a negative number, or where Y + M is 0.
pub fn gap_conductance(
    conductivity: f64,
    gap: f64,
    gas_parameter: f64,
) -> Result<f64, ContactError> {
    for (field, value) in [("gap", gap), ("gas_parameter", gas_parameter)] {
        let is_finite = value >= 0.0 && value.is_finite();
        require(is_finite, field, value, "a finite number, at least 0,")?;
    }
    let width = positive("gap with gas_parameter", gap + gas_parameter)?;
    Ok(positive("thermal_conductivity", conductivity)? / width)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The constriction factor ψ, by which the conductance of isolated contacts is divided, at
    /// real over nominal area.
    fn constriction(area_fraction: f64) -> f64 {
        (1.0 - area_fraction.sqrt()).powf(1.5)
    }

    /// ½ erfc(λ/√2) as a sum of the Gaussian density, independent of the fits.
    fn bearing(lambda: f64) -> f64 {
        let steps = 20_000;
        let width = 10.0 / f64::from(steps);
        let term = |k: i32| {
            let z = lambda + (f64::from(k) + 0.5) * width;
            (-0.5 * z * z).exp() * width
        };
        (0..steps).map(term).sum::<f64>() / (2.0 * PI).sqrt()
    }

    #[test]
    fn power_laws_are_within_the_stated_errors_of_their_theories() {
        let one = GapRoughness { height_std: 1.0, mean_slope: 1.0 };
        let mut worst = [0.0_f64; 2];
        for k in 0..=60 {
            let lambda = 2.0 + 2.74 * f64::from(k) / 60.0;
            let (bears, falls) = (bearing(lambda), (-0.5 * lambda * lambda).exp());
            let plastic = falls / (2.0 * (2.0 * PI).sqrt() * constriction(bears));
            // Elastic contacts have half the bearing area, and radii smaller by √2.
            let half = constriction(0.5 * bears);
            let elastic = falls / (4.0 * PI.sqrt() * half);
            let found = [
                cooper_mikic_yovanovich(1.0, &one, bears, 1.0).unwrap(),
                mikic_elastic(1.0, &one, 0.5 * bears / 2f64.sqrt(), 1.0).unwrap(),
            ];
            for ((found, theory), worst) in found.iter().zip([plastic, elastic]).zip(&mut worst) {
                if found.holds {
                    *worst = worst.max((found.conductance / theory - 1.0).abs());
                }
            }
        }
        assert!(
            (0.015..0.016).contains(&worst[0]) && (0.02..0.021).contains(&worst[1]),
            "{worst:?}"
        );
    }

    #[test]
    fn conductance_of_a_metal_pair_equals_the_published_value() {
        let one = GapRoughness { height_std: 1e-6, mean_slope: 0.1 };
        let both = GapRoughness {
            height_std: 2f64.sqrt() * one.height_std,
            mean_slope: 2f64.sqrt() * one.mean_slope,
        };
        let conductivity = 2.0 * 50.0 * 100.0 / 150.0;
        let found = cooper_mikic_yovanovich(conductivity, &both, 1e6, 1e9).unwrap();
        assert!((found.conductance / 1.17711e4 - 1.0).abs() < 4e-6 && found.holds, "{found:?}");
        // 1.55 (200/3) 1e5 (√2 1e6/(1.1e11 · 0.1 √2))^0.94, by mpmath.
        let found = mikic_elastic(conductivity, &both, 1e6, 1.1e11).unwrap();
        assert!((found.conductance / 1_641.841_825_705_397 - 1.0).abs() < 1e-12, "{found:?}");
        let moments = ProfileMoments { m0: 2e-12, m2: 0.02 * PI / 2.0, m4: 1.0 };
        let of = GapRoughness::of(&moments);
        assert!((of.height_std / both.height_std - 1.0).abs() < 1e-14);
        assert!((of.mean_slope / both.mean_slope - 1.0).abs() < 1e-14);
        // Air between: k_g 0.026 W/(m K), Y 3 µm, M 0.37 µm.
        let gap = gap_conductance(0.026, 3e-6, 0.37e-6).unwrap();
        assert!((gap / 7_715.133_531_157_27 - 1.0).abs() < 1e-12, "{gap}");
    }

    #[test]
    fn inputs_out_of_range_are_refused_and_extrapolation_is_marked_invalid() {
        let one = GapRoughness { height_std: 1e-6, mean_slope: 0.1 };
        let far = cooper_mikic_yovanovich(50.0, &one, 1e8, 1e9).unwrap();
        assert!(!far.holds && (far.relative_pressure - 0.1).abs() < 1e-15);
        let message = |error: ContactError| error.to_string();
        let of =
            |r: &GapRoughness, p, h| message(cooper_mikic_yovanovich(50.0, r, p, h).unwrap_err());
        assert!(of(&one, -1.0, 1e9).starts_with("pressure is -1"));
        assert!(of(&one, 1e6, 0.0).starts_with("hardness is 0"));
        let flat = GapRoughness { mean_slope: 0.0, ..one };
        assert!(
            message(mikic_elastic(50.0, &flat, 1e6, 1e11).unwrap_err()).starts_with("mean_slope")
        );
        assert!(message(gap_conductance(0.026, -1e-6, 0.0).unwrap_err()).starts_with("gap is"));
        assert!(message(gap_conductance(0.026, 0.0, 0.0).unwrap_err()).contains("gas_parameter"));
    }
}
