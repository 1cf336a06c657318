#![doc = include_str!("../README.md")]

use std::f64::consts::PI;
use std::ops::Range;
use std::sync::Arc;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Formula, Law, Power, Provenance,
    QuadratureError, Sampler, Tolerance, Validity, require,
};
use serde::{Deserialize, Serialize};

/// How the limiting mean pressure H_G depends on the contact radius a.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum GeometricHardness {
    /// H_G/S_y = 2.84 [1 - exp(-0.82 (a/R)^-0.7)], from the paper of 2005.
    #[default]
    #[serde(rename = "2005")]
    Original,
    /// H_G/S_y = 2.84 - 0.92 [1 - cos(π min(1, a/R))], from later papers.
    #[serde(rename = "cosine")]
    Cosine,
}

impl GeometricHardness {
    /// H_G/S_y at a/R > 0.
    #[must_use]
    pub fn over_yield(self, radius_ratio: f64) -> f64 {
        match self {
            Self::Original => self.over_yield_at(radius_ratio.ln()),
            Self::Cosine => 2.84 - 0.92 * (1.0 - (PI * radius_ratio.min(1.0)).cos()),
        }
    }

    /// H_G/S_y at ln(a/R).
    fn over_yield_at(self, ln_ratio: f64) -> f64 {
        match self {
            Self::Original => -2.84 * (-0.82 * (-0.7 * ln_ratio).exp()).exp_m1(),
            Self::Cosine => self.over_yield(ln_ratio.exp()),
        }
    }
}

/// The model of Jackson and Green.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct JacksonGreen {
    /// How the limiting mean pressure H_G depends on the contact radius.
    pub hardness: GeometricHardness,
}

const SOURCE: Citation = Citation {
    id: "jg",
    name: "JG",
    authors: "Jackson & Green",
    year: 2005,
    title: "A finite element study of elasto-plastic hemispherical contact against a rigid flat",
    provenance: Provenance::Seen,
    published: &[
        ("author", "Jackson, R. L. and Green, I."),
        ("journal", "Journal of Tribology"),
        ("volume", "127"),
        ("number", "2"),
        ("doi", "10.1115/1.1866166"),
    ],
};

const COSINE: Citation = Citation { id: "jg-cosine", name: "JG cosine", ..SOURCE };

/// End of the elastic range, in units of w_c' (seen in text that quotes the paper).
const ELASTIC_END: f64 = 1.9;
const BEYOND: Range<f64> = ELASTIC_END..f64::INFINITY;

/// The exponent of the area beyond x = 1.9, B = 0.14 exp(23 S_y/E)
/// (seen in text that quotes the paper).
///
/// # Errors
/// [`ContactError::Missing`] without a yield strength or hardness.
pub fn area_exponent(asperity: &Asperity) -> Result<f64, ContactError> {
    Ok(0.14 * (23.0 * asperity.yield_strength()? / asperity.equivalent_modulus).exp())
}

/// What the rounding of B adds to the relative error of the area, over ln(x/1.9): the rounding of
/// 23 S_y/E is multiplied by the exponential.
fn area_exponent_error(asperity: &Asperity, b: f64) -> Result<f64, ContactError> {
    let argument = 23.0 * asperity.yield_strength()? / asperity.equivalent_modulus;
    Ok(f64::EPSILON * b * (3.0 + 2.0 * argument))
}

/// Errors of B that powers are evaluated with in any case: of S_y/E below 0.03.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// A/A_c' beyond x = 1.9, with the error of its exponent: for yield strengths near the modulus,
/// where that is the largest of all.
struct AreaFit {
    b: f64,
    /// Of the area, over ln(x/1.9).
    error: f64,
}

impl Sampler for AreaFit {
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        for (out, x) in out.iter_mut().zip(x) {
            *out = x * (self.b * (x / ELASTIC_END).ln()).exp();
        }
        Ok(())
    }

    fn relative_error(&self, x: &[f64]) -> f64 {
        let largest = x.iter().map(|x| (x / ELASTIC_END).ln()).fold(0.0, f64::max);
        // 1.9 is rounded, too.
        self.error * largest + f64::EPSILON * (4.0 + 2.0 * self.b)
    }
}

/// F/F_c' beyond x = 1.9 with the error of the exponent B, for the same yield strengths.
struct ForceFit {
    fit: FittedLaw,
    /// Of the area, over ln(x/1.9).
    error: f64,
}

impl Sampler for ForceFit {
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        out.iter_mut().zip(x).for_each(|(out, x)| *out = self.fit.force(*x));
        Ok(())
    }

    fn relative_error(&self, x: &[f64]) -> f64 {
        let error = |x: &f64| {
            let ln_x = x.ln();
            let [elastic, plastic] = self.fit.terms(ln_x, *x);
            // Each exponential adds the rounding of its argument.
            let decay = 0.25 * (5.0 / 12.0 * ln_x).exp();
            let of_elastic = f64::EPSILON * (4.0 + decay * (3.0 + ln_x));
            let growth = self.error * (x / ELASTIC_END).ln() + f64::EPSILON * 2.0 * self.fit.b;
            let ln_ratio = 0.5 * growth + 2.0 * f64::EPSILON * self.fit.ln_ratio(ln_x).abs();
            let of_plastic = f64::EPSILON * (8.0 + 2.0 * ln_x.abs()) + STEEPEST * ln_ratio;
            (of_elastic * elastic + of_plastic * plastic) / (elastic + plastic)
        };
        x.iter().map(error).fold(f64::EPSILON * (4.0 + 2.0 * self.fit.b), f64::max)
    }
}

/// Largest |d ln H_G/d ln(a/R)|: 0.7 for the hardness of 2005, 1.2 for the cosine.
const STEEPEST: f64 = 1.2;

/// C, the strain √(w_c'/R) = π C S_y/(2E), and the exponent B of the area.
fn constants(asperity: &Asperity) -> Result<[f64; 3], ContactError> {
    let c = 1.295 * (0.736 * asperity.poissons_ratio).exp();
    let value = asperity.yield_strength()?;
    let strain = 0.5 * PI * c * value / asperity.equivalent_modulus;
    let required = "a yield strength below 2E/(pi C), so that the critical interference is smaller than the radius,";
    require(strain < 1.0, "yield_strength", value, required)?;
    Ok([c, strain, area_exponent(asperity)?])
}

impl Described for JacksonGreen {
    fn citation(&self) -> &Citation {
        match self.hardness {
            GeometricHardness::Original => &SOURCE,
            GeometricHardness::Cosine => &COSINE,
        }
    }

    fn variant(&self) -> Vec<&'static str> {
        match self.hardness {
            GeometricHardness::Original => vec![],
            GeometricHardness::Cosine => {
                vec!["the hardness falls with the cosine of a/R, as in later papers"]
            }
        }
    }

    fn validity(&self) -> Validity {
        Validity {
            force_monotone: false,
            valid_for: "w_c' < R; fitted to finite elements; the mean pressure has no plastic limit",
            ..Validity::default()
        }
    }
}

impl AsperityModel for JacksonGreen {
    fn force(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        let [c, strain, b] = constants(asperity)?;
        // F/F_c' = x^1.5, then the fit; F_c' = (4/3)(R/E)² (π C S_y/2)³ = (4/3) E R² strain³
        let (r, hardness) = (asperity.radius, self.hardness);
        let unit = 4.0 / 3.0 * asperity.equivalent_modulus * r * r * strain.powi(3);
        let fit = FittedLaw { c, strain, b, hardness };
        let error = area_exponent_error(asperity, b)?;
        let form = if error > ROUNDING {
            Formula::sampled(Arc::new(ForceFit { fit, error }))
        } else {
            Formula::function(move |x| fit.force(x))
        };
        let form = form.known_as(format!("JG force, {hardness:?}"), vec![c, strain, b]);
        let mut law = Law::in_units(strain * strain * r, unit)
            .elastic(0.0..ELASTIC_END, [Power::new(1.0, 1.5)])
            .elastic_plastic(BEYOND, form);
        if hardness == GeometricHardness::Cosine {
            // At a = R the cosine reaches its minimum and H_G becomes constant.
            let full = (ELASTIC_END.powf(b) / (strain * strain)).powf(1.0 / (1.0 + b));
            law.parts[1].kinks.extend((full > ELASTIC_END).then_some(full));
        }
        Ok(law)
    }

    fn area(&self, asperity: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        let [_, strain, b] = constants(asperity)?;
        let error = area_exponent_error(asperity, b)?;
        // A/A_c' = x; x (x/1.9)^B
        let power = [Power::new(ELASTIC_END.powf(-b), 1.0 + b)];
        let fit = match error > ROUNDING {
            true => Formula::sampled(Arc::new(AreaFit { b, error })).known_as("JG area", vec![b]),
            false => power.into(),
        };
        let unit = strain * strain * asperity.radius;
        Ok(Law::in_units(unit, PI * asperity.radius * unit)
            .elastic(0.0..ELASTIC_END, [Power::new(1.0, 1.0)])
            .elastic_plastic(BEYOND, fit))
    }
}

/// The fit of the force beyond x = 1.9. Powers as exponentials of one logarithm: half the time of
/// `powf`, and the scenes of a sweep, whose laws do not recur, are little but this.
#[derive(Debug, Clone, Copy)]
struct FittedLaw {
    c: f64,
    strain: f64,
    b: f64,
    hardness: GeometricHardness,
}

impl FittedLaw {
    /// F/F_c'.
    fn force(self, x: f64) -> f64 {
        let [elastic, plastic] = self.terms(x.ln(), x);
        elastic + plastic
    }

    /// The two terms of the sum, both positive.
    fn terms(self, ln_x: f64, x: f64) -> [f64; 2] {
        let plastic = 4.0 / self.c * self.hardness.over_yield_at(self.ln_ratio(ln_x));
        let share = -(-(5.0 / 9.0 * ln_x).exp() / 25.0).exp_m1();
        let elastic = (-(5.0 / 12.0 * ln_x).exp() / 4.0).exp() * x * x.sqrt();
        [elastic, plastic * share * x]
    }

    /// a/R = √(A/π)/R with A = π R w_c' x (x/1.9)^B, as a logarithm.
    fn ln_ratio(self, ln_x: f64) -> f64 {
        self.strain.ln() + 0.5 * (ln_x + self.b * (ln_x - ELASTIC_END.ln()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_force_jumps_by_half_a_percent_at_the_start_of_the_fit() {
        // ν = 0.3, small S_y/E: 1.9^1.5 against the fit, +0.47 %.
        let c = 1.295 * (0.736f64 * 0.3).exp();
        let (strain, b, hardness) = (1e-4, 0.14, GeometricHardness::Original);
        let fit = FittedLaw { c, strain, b, hardness }.force(1.9);
        assert!((fit / 1.9f64.powf(1.5) - 1.0047).abs() < 1e-4);
    }

    #[test]
    fn both_hardnesses_start_at_2_84_yield_strengths() {
        for hardness in [GeometricHardness::Original, GeometricHardness::Cosine] {
            assert!((hardness.over_yield(1e-4) - 2.84).abs() < 1e-6);
        }
        assert!((GeometricHardness::Cosine.over_yield(3.0) - 1.0).abs() < 1e-12);
    }

    /// `tests/reference/jg_areas.csv`, by mpmath.
    #[test]
    fn bounds_count_the_rounding_of_the_exponent() {
        use asperity_core::{
            ContactModel, HeightDistribution, Interface, Quantity, Request, Scene, Surface,
        };
        let rows = include_str!("../../../../tests/reference/jg_areas.csv").lines().skip(1);
        for row in rows {
            let numbers: Vec<f64> = row.split(',').map(|n| n.parse().unwrap()).collect();
            let [strength, sigma, area, force] = numbers[..] else { panic!("{row}") };
            let mut interface = Interface::new(1e11, 0.3, 2.8 * strength);
            interface.yield_strength = Some(strength);
            let mut scene = Scene::new(interface, Surface::new(1e-4, 1e9, sigma), 1e-4);
            scene.heights = HeightDistribution::Exponential;
            for (tolerance, (quantity, wanted)) in [1e-10, 1e-14]
                .into_iter()
                .flat_map(|t| [(Quantity::Area, area), (Quantity::Force, force)].map(|q| (t, q)))
            {
                // Its law overflows a double.
                if quantity == Quantity::Area && strength > 0.25 * 1e11 {
                    continue;
                }
                let asked = Request::new([quantity]).within(Tolerance::new(tolerance).unwrap());
                let contact = JacksonGreen::default().compile(&scene, &asked).unwrap();
                let found = contact.evaluate(quantity, 1.0).unwrap();
                let off = (found.value() / wanted - 1.0).abs();
                let bound = found.relative_error();
                assert!(off <= bound && bound < 1e-10, "{row} at {tolerance:e}: {off:e} {bound:e}");
            }
        }
    }

    /// `tests/reference/jg_force_law.csv`, by mpmath.
    #[test]
    fn the_error_of_the_force_of_one_asperity_is_below_its_bound() {
        use asperity_core::Interface;
        for row in include_str!("../../../../tests/reference/jg_force_law.csv").lines().skip(1) {
            let numbers: Vec<f64> = row.split(',').map(|n| n.parse().unwrap()).collect();
            let [strength, x, wanted] = numbers[..] else { panic!("{row}") };
            let mut interface = Interface::new(1e11, 0.3, 2.8 * strength);
            interface.yield_strength = Some(strength);
            let asperity = Asperity::new(&interface, 1e-4).unwrap();
            let law = JacksonGreen::default().force(&asperity, Tolerance::default()).unwrap();
            let form = &law.parts[1].form;
            let mut found = [0.0];
            form.sample(&[x], &mut found).unwrap();
            let off = (found[0] - wanted).abs();
            // Integrals add 1e-14 to the error of any law.
            let bound = form.relative_error(&[x]).max(1e-14);
            assert!(off <= bound * wanted && bound < 2e-12, "{row}: {off:e} {bound:e}");
        }
    }
}
