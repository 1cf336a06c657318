//! The asperities of a random surface, and the law of one averaged over their curvatures, part by
//! part.

use std::f64::consts::{PI, SQRT_2};
use std::ops::Range;
use std::sync::Arc;

use asperity_core::{
    Asperity, AsperityModel, ContactError, Described, Formula, HeightDistribution, Law, Part,
    Scene, Surface, Tolerance, Variant, Wraps,
};
use asperity_quadrature::{Estimate, FunctionTable, QuadratureError, Sampler, TanhSinh};

use crate::kernel::{Kernel, highest};

/// Tolerance of the tables, relative to the envelope of the law, over the tolerance of its values;
/// rounding errors are just below the least.
const TABLE: f64 = 2e-3;
const LEAST: f64 = 2e-13;
/// Tolerance of the integrals over the tolerance of a table, whose errors include theirs.
const EXACT: f64 = 0.05;
/// Fraction of a range of y, next to 0, on which G is taken as constant: it changes there by less
/// than √y, and its contribution is as small.
const STILL: f64 = 1e-10;

/// A share of the law that is none.
const NOTHING: f64 = 1e-100;

/// Parts that begin or end below this y are kinks for a table.
const THIN: f64 = 1e-4;

/// A model of one asperity, averaged over the curvatures of a population.
#[derive(Debug)]
pub(crate) struct Average<'m> {
    pub(crate) model: &'m dyn AsperityModel,
    pub(crate) variant: &'m Variant,
    pub(crate) population: Population,
    /// Interferences \[m\] at which parts of the force are cut in two, so that each has a share of
    /// its own.
    pub(crate) cuts: &'m [f64],
    /// Of the values.
    pub(crate) tolerance: Tolerance,
}

impl Wraps for Average<'_> {
    fn inner(&self) -> &dyn Described {
        self.variant
    }
}

impl Average<'_> {
    /// The law with its parts in two at each cut.
    pub(crate) fn cut(&self, mut law: Law) -> Law {
        for cut in self.cuts {
            let x = cut / law.interference_unit - law.onset;
            let halves = |part: Part| {
                if !(part.range.start < x && x < part.range.end) {
                    return vec![part];
                }
                let half = |range: Range<f64>| {
                    let kinks = part.kinks.iter().copied();
                    let kinks = kinks.filter(|x| range.start < *x && *x < range.end).collect();
                    Part { range, kinks, ..part.clone() }
                };
                vec![half(part.range.start..x), half(x..part.range.end)]
            };
            law.parts = law.parts.into_iter().flat_map(halves).collect();
        }
        law
    }

    /// The average of κ^(-n) law(κ w), of interferences counted from [`Population::begin`] below
    /// u = 0.
    fn average(&self, law: &Law, power: i32) -> Law {
        let tolerance = (TABLE * self.tolerance.relative()).max(LEAST);
        let unit = self.population.unit;
        let scale = unit / law.interference_unit;
        let average = |part: &Part| {
            let mut breaks = vec![part.range.start, part.range.end];
            breaks.extend(&part.kinks);
            breaks.sort_by(f64::total_cmp);
            let form = part.form.clone();
            // Most of the contribution of larger interferences comes from those near this one.
            let deep = (part.range.start / scale).max(SQRT_2);
            // A thin layer of interferences is nearly a kink at u = 0, about √y wide.
            let is_thin = breaks.iter().any(|x| *x > 0.0 && *x < THIN * scale);
            let kinks: &[f64] = if is_thin { &[BEGIN] } else { &[] };
            let integral = Integral { form, scale, breaks, power, deep, tolerance };
            let table =
                FunctionTable::new(Arc::new(move |x| integral.enveloped(x)), kinks, tolerance);
            let form = Formula::sampled(Arc::new(Averaged { table, deep }));
            let (range, kinks) = (FIRST..f64::INFINITY, vec![BEGIN]);
            Part { range, kinks, form, ..part.clone() }
        };
        let parts = law.parts.iter().map(average).collect();
        Law { parts, ..Law::in_units(unit, law.value_unit) }
    }
}

/// The laws of force, area and stiffness go with the square of the radius.
const WITH_SQUARE: i32 = 2;

impl AsperityModel for Average<'_> {
    fn force(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        Ok(self.average(&self.cut(self.model.force(asperity, tolerance)?), WITH_SQUARE))
    }

    fn area(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        Ok(self.average(&self.model.area(asperity, tolerance)?, WITH_SQUARE))
    }

    fn stiffness(
        &self,
        asperity: &Asperity,
        tolerance: Tolerance,
    ) -> Result<Option<Law>, ContactError> {
        let law = self.model.stiffness(asperity, tolerance)?;
        Ok(law.map(|law| self.average(&law, WITH_SQUARE)))
    }

    fn contacts(&self, _: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        let one = Formula::function(|_| 1.0);
        let law = Law::in_units(self.population.unit, 1.0).elastic(0.0..f64::INFINITY, one);
        Ok(self.average(&law, 0))
    }

    fn contact_radius(&self, _: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        // The root of the average area is not the average of the contact radii.
        let advice = self.variant.advice();
        let what = format!("contact radii, which need asperities of one radius; {advice}");
        Err(ContactError::Unsupported { model: self.id().into(), what })
    }
}

/// A smooth function of u that varies as the average does: for y = √2 as exp(-u²/2) below 0 and as
/// u^(3/2) above; for larger y as exp(-κ*²/4).
fn envelope(u: f64, deep: f64) -> f64 {
    let above = SQRT_2 / highest(u, SQRT_2);
    above * above.sqrt() * (-0.25 * highest(u, deep).powi(2)).exp()
}

/// A table of x M/envelope, x = u + `BEGIN`.
struct Averaged {
    table: FunctionTable,
    deep: f64,
}

impl Averaged {
    /// The envelope; none where nothing is left of it beside that of the whole law: so deep, its
    /// exponent is a small difference of large numbers.
    fn envelope(&self, x: f64) -> Option<f64> {
        let [own, whole] = [self.deep, SQRT_2].map(|deep| envelope(x - BEGIN, deep));
        (own > NOTHING * whole).then_some(own)
    }
}

impl Sampler for Averaged {
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        for (out, &x) in out.iter_mut().zip(x) {
            *out = match self.envelope(x) {
                Some(envelope) => self.table.value(x)? / x * envelope,
                None => 0.0,
            };
        }
        Ok(())
    }

    fn relative_error(&self, x: &[f64]) -> f64 {
        let first = x.iter().position(|x| self.envelope(*x).is_some());
        first.map_or(0.0, |first| self.table.relative_error(&x[first..]))
    }
}

/// With κ = k/√(m₄/3) and y = κ w/v, in which the law has its kinks wherever w has them,
/// ```text
/// M(u) = √(3/(2π)) ∫ f(v y) G(u, y) dy
/// ```
/// for q = κ^(-n) f(κ w), u in units of v; G is the [`Kernel`].
struct Integral {
    form: Formula,
    /// v over the interference unit of the form.
    scale: f64,
    /// Ends and kinks, in interference units.
    breaks: Vec<f64>,
    /// n.
    power: i32,
    /// The y of the envelope.
    deep: f64,
    /// Of the table.
    tolerance: f64,
}

impl Integral {
    /// x M(u)/envelope(u), u = x - `BEGIN`.
    fn enveloped(&self, x: f64) -> Estimate {
        let u = x - BEGIN;
        let kernel = Kernel::shared(u, self.power);
        let (rules, tolerance) = (TanhSinh::shared(), EXACT * self.tolerance);
        let mut total = Estimate { value: 0.0, error: 0.0, evaluations: 0 };
        for pair in self.breaks.windows(2) {
            let first = pair[0] / self.scale;
            let last = kernel.last(first).min(pair[1] / self.scale);
            // In √y, because y is near κ u: small y contribute most where u is large.
            let (low, high) = (first.sqrt(), last.sqrt());
            let still = STILL * last;
            let found = rules.integrate(low, high, tolerance, total.value.abs(), |p| {
                let beyond = p.left * (p.left + 2.0 * low);
                let (x, y) = (pair[0] + beyond * self.scale, first + beyond);
                let mut value = [0.0];
                let sampled = self.form.sample(&[x], &mut value);
                // Powers and closed forms have no errors; an error would become NaN.
                sampled.map_or(f64::NAN, |()| {
                    2.0 * p.x * value[0] * kernel.value(y.max(still), y.max(still) - self.deep)
                })
            });
            total.value += found.value;
            total.error += found.error;
            total.evaluations += found.evaluations;
        }
        // The rest of the envelope.
        let above = SQRT_2 / highest(u, SQRT_2);
        let factor = (1.5 / PI).sqrt() * x / (above * above.sqrt());
        Estimate { value: factor * total.value, error: factor * total.error, ..total }
    }
}

/// Distance below u = 0 of the origin of interferences, in standard deviations of μ k_m.
const BEGIN: f64 = 11.5;
/// Start of the averaged law on that scale, in the first cell of its tables. At a separation of
/// [`FARTHEST`](crate::FARTHEST) √m₀ and a correlation ρ of height and curvature, contacts come
/// from 6ρ ± 8√(1-ρ²), at most 10 below u = 0.
const FIRST: f64 = 1.0;

/// The constants of the summit density of a scene's surface.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Population {
    /// √m₀ \[m\].
    pub(crate) surface_std: f64,
    /// √(m₄/3) \[1/m\], the unit of curvatures.
    pub(crate) curvature: f64,
    /// v = μ √(2 m₄/3) \[m\], the standard deviation of μ k_m: the unit of interferences.
    pub(crate) unit: f64,
    /// σ_c \[m\].
    pub(crate) height_std: f64,
}

impl Population {
    pub(crate) fn new(scene: &Scene) -> Result<Self, ContactError> {
        scene.asperity()?;
        let moments = scene.surface.moments();
        // Refuses bandwidths below 1.5.
        Surface::from_moments(&moments)?;
        let curvature = (moments.m4 / 3.0).sqrt();
        let unit = 1.5 * moments.m2 / moments.m4 * SQRT_2 * curvature;
        // v² = (3/2) m₂²/m₄ is the part of m₀ that is correlated with the curvature.
        let height_std = (moments.m0 - unit * unit).max(0.0).sqrt();
        Ok(Self { surface_std: moments.m0.sqrt(), curvature, unit, height_std })
    }

    /// Asperities of the radius 1/√(m₄/3), under heights independent of the curvature.
    pub(crate) fn scene(&self, scene: &Scene) -> Scene {
        let density = scene.surface.asperity_density;
        let surface = Surface::new(1.0 / self.curvature, density, self.height_std);
        let mut own = Scene::new(scene.interface, surface, scene.nominal_area);
        own.heights = HeightDistribution::Gaussian;
        own
    }

    /// The separation from the mean plane of the surface, less that from the mean of those heights,
    /// at the same place \[m\].
    pub(crate) fn begin(&self) -> f64 {
        BEGIN * self.unit
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity_core::Power;
    use asperity_quadrature::gauss_kronrod;

    fn integral(exponent: f64, power: i32) -> Integral {
        let (form, breaks) = ([Power::new(1.0, exponent)].into(), vec![0.0, f64::INFINITY]);
        Integral { form, scale: 1.0, breaks, power, deep: SQRT_2, tolerance: LEAST }
    }

    fn value(integral: &Integral, u: f64) -> f64 {
        integral.enveloped(u + BEGIN).value / (u + BEGIN) * envelope(u, SQRT_2)
    }

    #[test]
    fn all_summits_are_counted_and_the_mean_area_is_in_closed_form() {
        for u in [0.0, 0.7, 20.0] {
            let all = value(&integral(0.0, 0), 12.0 + u);
            assert!((all - 1.0).abs() < 1e-12, "{u} {all}");
        }
        // At u = 0 areas are (K/√2)/κ, whose mean is √(2/3).
        let area = value(&integral(1.0, 2), 0.0);
        assert!((area / (2.0f64 / 3.0).sqrt() - 1.0).abs() < 1e-14, "{area}");
    }

    /// In the variables of the density, k and k_m, one within the other.
    #[test]
    fn averages_are_those_of_the_density_itself() {
        for (exponent, power) in [(1.5, 2), (1.0, 2)] {
            for u in [-4.0, -1.0, 0.5, 6.0] {
                let first = (-SQRT_2 * u).max(0.0);
                // K = first + t², κ = K r².
                let outer = |t: f64| {
                    let k_m = first + t * t;
                    let w = if u < 0.0 { t * t / SQRT_2 } else { u + k_m / SQRT_2 };
                    let inner = |r: f64| {
                        let k = k_m * r * r;
                        let weight = (0.5 * k * k - 0.75 * k_m * k_m).exp();
                        2.0 * k_m * r * k.powi(3 - power) * weight * (k * w).powf(exponent)
                    };
                    let inner = gauss_kronrod(inner, &[0.0, 0.5, 1.0], 1e-12, 50_000).unwrap();
                    2.0 * t * inner.value
                };
                let found =
                    gauss_kronrod(outer, &[0.0, 0.5, 1.0, 2.0, 4.0], 1e-11, 50_000).unwrap();
                let direct = (0.75 / PI).sqrt() * found.value;
                let ours = value(&integral(exponent, power), u);
                assert!((ours / direct - 1.0).abs() < 1e-11, "{exponent} {u}: {ours} {direct}");
            }
        }
    }
}
