//! The average over contact angles as an ordinary law: tabulated, or in closed form.

use std::ops::Range;
use std::sync::Arc;

use asperity_core::{Formula, FunctionKey, Power};
use asperity_quadrature::{FunctionTable, PointMasses, QuadratureError, Sampler, WeightFunction};

use crate::oblique::AngleAverage;
use crate::{AngleDensity, ObliqueContact, nested};

/// The average of an oblique contact over the contact angles: a formula of x, and its kinks.
///
/// The integral over y is split at its branch points and computed by tanh-sinh quadrature; it is
/// tabulated at first use.
#[must_use]
pub fn angle_average(
    contact: Arc<dyn ObliqueContact>,
    range: Range<f64>,
    density: AngleDensity,
    tolerance: f64,
) -> (Formula, Vec<f64>) {
    let of = contact.key();
    let tolerance = table_tolerance(tolerance);
    let with_key = |formula: Formula, name: &'static str, parameters: Vec<f64>| {
        let key = of.map(|of| FunctionKey { name: name.into(), of, parameters });
        key.into_iter().fold(formula, Formula::with_key)
    };
    let Some(density) = density.folded() else {
        let upright = move |x: f64| {
            let mut mean = [0.0];
            contact.means(x, &[0.0], tolerance, &mut mean);
            mean[0]
        };
        return (with_key(Formula::function(upright), "upright contact", vec![]), vec![]);
    };
    let parameters = vec![density.0, density.1, range.start, range.end, tolerance];
    let tabulated = TabulatedAverage::new(AngleAverage::new(contact, range, density, tolerance));
    let kinks = tabulated.table.kinks().to_vec();
    let formula = Formula::sampled(Arc::new(tabulated));
    (with_key(formula, "angle average, tabulated", parameters), kinks)
}

/// The error of the table is up to five times its tolerance, and the quadrature rules need a
/// quarter of the `tolerance` of the law; below 2e-13 rounding errors would be tabulated.
fn table_tolerance(tolerance: f64) -> f64 {
    (0.15 * tolerance).max(2e-13)
}

/// An angle average, tabulated at first use.
struct TabulatedAverage {
    average: Arc<AngleAverage>,
    table: FunctionTable,
}

impl TabulatedAverage {
    fn new(average: AngleAverage) -> Self {
        let (tolerance, average) = (average.tolerance, Arc::new(average));
        let sampled = average.clone();
        let table =
            FunctionTable::new(Arc::new(move |x| sampled.value(x)), &average.kinks(), tolerance);
        Self { average, table }
    }
}

impl Sampler for TabulatedAverage {
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        self.table.sample(x, out)
    }

    fn relative_error(&self, x: &[f64]) -> f64 {
        self.table.relative_error(x)
    }

    /// Far below the heights the range is short and begins far above 0. There the integral over x
    /// falls, as a function of y, from all to nothing next to the end of y, where no node of a
    /// panel may lie, while the average itself is so smooth that the table needs few samples.
    fn unprepared(&self, (start, _): (f64, f64)) -> Option<Arc<dyn Sampler>> {
        (start <= 0.0).then(|| self.average.clone() as Arc<dyn Sampler>)
    }

    fn finer(&self, tolerance: f64) -> Option<Arc<dyn Sampler>> {
        Some(Arc::new(Self::new(self.average.within(table_tolerance(tolerance)))))
    }
}

impl Sampler for AngleAverage {
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        out.iter_mut().zip(x).for_each(|(out, x)| *out = self.value(*x).value);
        Ok(())
    }

    fn relative_error(&self, _: &[f64]) -> f64 {
        self.azimuth_tolerance()
    }

    fn masses(&self, against: &WeightFunction<'_>) -> Option<PointMasses> {
        Some(nested::masses(self, against))
    }
}

/// The angle average of a sum of powers of y on `range`, in closed form. Every origin must be 0
/// or the start of the range.
#[must_use]
pub fn angle_average_of_powers(
    powers: &[Power],
    range: Range<f64>,
    density: AngleDensity,
) -> Formula {
    let powers = powers.to_vec();
    let Some((c0, c2)) = density.folded() else {
        return Formula::Powers(powers);
    };
    let mut parameters = vec![c0, c2, range.start, range.end];
    parameters.extend(powers.iter().flat_map(|p| [p.coefficient, p.origin, p.exponent]));
    let average = move |x: f64| {
        let end = range.end.min(x);
        let mut total = 0.0;
        for Power { coefficient, origin, exponent } in &powers {
            // v = y - o, and y² = v² + 2 o v + o².
            let primitive =
                |n: f64| power_difference(range.start - origin, end - origin, exponent + n);
            let c2 = c2 / (x * x);
            let squares =
                primitive(3.0) + 2.0 * origin * primitive(2.0) + origin * origin * primitive(1.0);
            total += coefficient * (c0 * primitive(1.0) + c2 * squares);
        }
        total / x
    };
    Formula::function(average).known_as("angle average in closed form", parameters)
}

/// (high^n - low^n)/n without cancellation.
fn power_difference(low: f64, high: f64, n: f64) -> f64 {
    if low > 0.0 { low.powf(n) * (n * (high / low).ln()).exp_m1() / n } else { high.powf(n) / n }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(formula: &Formula, x: f64) -> f64 {
        let mut out = [0.0];
        formula.sample(&[x], &mut out).unwrap();
        out[0]
    }

    #[test]
    fn elastic_limits_are_those_of_the_readme() {
        // Relative to x^p: 1/3 for the Hertz force, 7/16 for the area.
        for (p, ratio) in [(1.5, 1.0 / 3.0), (1.0, 7.0 / 16.0)] {
            let formula = angle_average_of_powers(
                &[Power::new(1.0, p)],
                0.0..f64::INFINITY,
                AngleDensity::default(),
            );
            for x in [1e-6f64, 1.0, 1e6] {
                assert!((value(&formula, x) / x.powf(p) / ratio - 1.0).abs() < 1e-14);
            }
        }
    }

    /// N of the elastic-plastic range, without tangential forces.
    struct Frictionless;

    impl ObliqueContact for Frictionless {
        fn means(&self, y: f64, _: &[f64], _: f64, out: &mut [f64]) -> f64 {
            out.fill(1.0 + 1.32 * (y - 1.0).powf(1.27));
            0.0
        }
        fn corners(&self, _: f64) -> [f64; 3] {
            [f64::INFINITY; 3]
        }
    }

    #[test]
    fn quadrature_and_closed_form_agree() {
        let density = AngleDensity::Harmonic { a20: 0.7, a21: 0.0, b21: 0.0 };
        let powers = [Power::new(1.0, 0.0), Power::from_origin(1.32, 1.0, 1.27)];
        let closed = angle_average_of_powers(&powers, 1.0..110.0, density);
        let (table, kinks) = angle_average(Arc::new(Frictionless), 1.0..110.0, density, 1e-14);
        assert_eq!(kinks, [1.0, 110.0]);
        for x in [1.01, 1.3, 7.0, 109.9, 110.1, 1e4] {
            let (a, b) = (value(&closed, x), value(&table, x));
            assert!((a / b - 1.0).abs() < 2e-13, "{x}: {a} {b}");
        }
    }
}
