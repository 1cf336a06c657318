//! What averages an oblique contact over the contact angles into an ordinary law.

use std::ops::Range;
use std::sync::Arc;

use asperity_core::{Formula, FunctionKey, Power};
use asperity_quadrature::{
    Discretised, Estimate, Point, QuadratureError, Sampler, Tabulated, TanhSinh, Weighted,
    bracketed_root, highest, last_place,
};

use crate::{AngleDensity, nested};

/// An oblique contact, already averaged over the azimuth θ.
///
/// A pair approached vertically by x has the contact-normal interference y = x u.
pub trait ObliqueContact: Send + Sync {
    /// Writes the averages over θ at contact-normal interference `y` of pairs approached by
    /// x = y + gap to `out`, to a relative tolerance. Returns the largest relative error there is.
    fn means(&self, y: f64, gaps: &[f64], tolerance: f64, out: &mut [f64]) -> f64;

    /// At which gaps the average has branch points as a function of x, for this y; infinite where
    /// at none.
    fn corners(&self, y: f64) -> [f64; 3];

    /// Up to about which gap the average turns, as the size of a sum of squares does, if that may
    /// be much less than y; infinite where it does not.
    fn layer(&self, _y: f64) -> f64 {
        f64::INFINITY
    }

    /// What tells this contact from all others, if anything does: laws that recur in a sweep are
    /// then tabulated once.
    fn key(&self) -> Option<String> {
        None
    }
}

/// q(x) = (1/x) ∫ (c₀ + c₂ y²/x²) m(y, x) dy over y in `range`, y ≤ x.
#[derive(Clone)]
pub(crate) struct Average {
    pub(crate) contact: Arc<dyn ObliqueContact>,
    pub(crate) range: Range<f64>,
    /// c₀ and c₂.
    pub(crate) density: (f64, f64),
    branches: Vec<Branch>,
    /// Where corners come from infinity or leave for it as y grows: next to these y the integral
    /// over x has an essential singularity.
    pub(crate) comings: Vec<f64>,
    tolerance: f64,
}

/// A range of y on which a corner rises or falls: for each x it is crossed once at most.
#[derive(Debug, Clone, Copy)]
struct Branch {
    corner: usize,
    y: (f64, f64),
    /// 1/x of the corner at the ends.
    inverse: (f64, f64),
}

/// The azimuth average is wanted this much better than the angle average.
const AZIMUTHS: f64 = 0.05;

impl Average {
    /// Where a corner passes x as y grows: there the integrand over y has a branch point.
    fn breaks(&self, x: f64) -> impl Iterator<Item = f64> {
        let crossing = move |branch: &Branch| {
            let off = |y: f64| x * inverses(&*self.contact, y)[branch.corner] - 1.0;
            let (from, to) = (x * branch.inverse.0 - 1.0, x * branch.inverse.1 - 1.0);
            (from * to < 0.0).then(|| bracketed_root(off, branch.y.0, branch.y.1)).flatten()
        };
        self.branches.iter().filter_map(crossing)
    }

    /// Where q has kinks: at the ends of the range, and where a corner of `breaks` comes or goes.
    fn kinks(&self) -> Vec<f64> {
        let Range { start, end } = self.range;
        let inside = |y: f64| y > FIRST && y < LAST;
        let ends = self.branches.iter().flat_map(|b| [(b.y.0, b.inverse.0), (b.y.1, b.inverse.1)]);
        let kinks = ends.filter(|(y, _)| inside(*y)).map(|(_, inverse)| inverse.recip());
        kinks.chain([start, end]).filter(|x| x.is_finite() && *x > 0.0).collect()
    }

    fn value(&self, x: f64) -> Estimate {
        let end = self.range.end.min(x);
        if end <= self.range.start {
            return Estimate { value: 0.0, error: 0.0, evaluations: 0 };
        }
        let mut ends: Vec<f64> = self.breaks(x).collect();
        ends.retain(|y| *y > self.range.start && *y < end);
        ends.extend([self.range.start, end]);
        ends.sort_by(f64::total_cmp);
        let (c0, c2) = self.density;
        // From the right, where responses are largest: what is left need only be good beside them.
        let (mut total, mut error, mut evaluations, mut worst) = (0.0f64, 0.0, 0, 0.0f64);
        for pair in ends.windows(2).rev().filter(|pair| pair[1] > pair[0]) {
            let integrand = |p: Point| {
                let mut mean = [0.0];
                let gap = (x - pair[1]) + p.right;
                worst = worst.max(self.contact.means(
                    p.x,
                    &[gap],
                    AZIMUTHS * self.tolerance,
                    &mut mean,
                ));
                (c0 + c2 * (p.x / x).powi(2)) * mean[0]
            };
            let goal = 0.2 * self.tolerance;
            let rules = TanhSinh::shared();
            let found = rules.integrate_beside(pair[0], pair[1], goal, total.abs(), integrand);
            total += found.value;
            error += found.error;
            evaluations += found.evaluations;
        }
        Estimate { value: total / x, error: (error + worst * total.abs()) / x, evaluations }
    }
}

/// 1/x of the corners for a y: 0 where there is none.
fn inverses(contact: &dyn ObliqueContact, y: f64) -> [f64; 3] {
    contact.corners(y).map(|gap| (y + gap).recip())
}

/// Points of y, evenly spaced in the logarithm of the distance from the beginning of a range, by
/// which branches are told apart.
const SCAN: i32 = 48;
/// Where the scan of a range that begins at 0 or never ends begins and ends.
const FIRST: f64 = 1e-80;
const LAST: f64 = 1e40;

fn branches(contact: &dyn ObliqueContact, range: &Range<f64>) -> (Vec<Branch>, Vec<f64>) {
    let nearest = if range.start > 0.0 { 1e-15 * range.start } else { FIRST };
    let farthest = (range.end - range.start).min(LAST);
    let step = (farthest / nearest).ln() / f64::from(SCAN);
    let y = |k: f64| match k {
        k if k <= 0.0 && range.start > 0.0 => range.start,
        k if k >= f64::from(SCAN) => range.end.min(LAST),
        k => range.start + nearest * (k * step).exp(),
    };
    let seen: Vec<[f64; 3]> = (0..=SCAN).map(|k| inverses(contact, y(f64::from(k)))).collect();
    let (mut branches, mut comings) = (vec![], vec![]);
    for corner in (0..3).filter(|corner| seen.iter().any(|at| at[*corner] > 0.0)) {
        let at = |k: f64| inverses(contact, y(k))[corner];
        // Ends of branches, as places on the scan.
        let mut ends = vec![0.0];
        for (k, three) in seen.windows(3).enumerate() {
            let [before, here, after] = [three[0], three[1], three[2]].map(|at| at[corner]);
            if (here - before) * (after - here) < 0.0 {
                let sign = (here - before).signum();
                ends.push(highest(|k| sign * at(k), k as f64, k as f64 + 2.0));
            }
        }
        for (k, two) in seen.windows(2).enumerate() {
            let there = two[0][corner] > 0.0;
            if there != (two[1][corner] > 0.0) {
                comings.push(y(last_place(|k| (at(k) > 0.0) == there, k as f64, k as f64 + 1.0)));
            }
        }
        ends.push(f64::from(SCAN));
        for pair in ends.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            branches.push(Branch { corner, y: (y(from), y(to)), inverse: (at(from), at(to)) });
        }
    }
    (branches, comings)
}

/// The average over the density of contact angles, as a form with its kinks.
///
/// The integral over y runs between branch points by tanh-sinh; q is tabulated when first needed.
#[must_use]
pub fn angle_average(
    contact: Arc<dyn ObliqueContact>,
    range: Range<f64>,
    density: AngleDensity,
    tolerance: f64,
) -> (Formula, Vec<f64>) {
    let of = contact.key();
    let tolerance = table_tolerance(tolerance);
    let named = |form: Formula, name: &'static str, parameters: Vec<f64>| {
        let key = of.map(|of| FunctionKey { name: name.into(), of, parameters });
        key.into_iter().fold(form, Formula::with_key)
    };
    let Some(density) = density.folded() else {
        let upright = move |x: f64| {
            let mut mean = [0.0];
            contact.means(x, &[0.0], tolerance, &mut mean);
            mean[0]
        };
        return (named(Formula::function(upright), "upright contact", vec![]), vec![]);
    };
    let parameters = vec![density.0, density.1, range.start, range.end, tolerance];
    let (branches, comings) = branches(&*contact, &range);
    let average = Average { contact, range, density, branches, comings, tolerance };
    let average = Arc::new(average);
    let sampled = average.clone();
    let table = Tabulated::new(Arc::new(move |x| sampled.value(x)), &average.kinks(), tolerance);
    let kinks = table.kinks().to_vec();
    let form = Formula::sampled(Arc::new(Prepared { average, table }));
    (named(form, "angle average, tabulated", parameters), kinks)
}

/// The bound of a table is up to five times its tolerance, and the rules need a quarter of the
/// `tolerance` of the law; below 2e-13 rounding would be fitted.
fn table_tolerance(tolerance: f64) -> f64 {
    (0.15 * tolerance).max(2e-13)
}

/// An angle average, tabulated when first sampled.
struct Prepared {
    average: Arc<Average>,
    table: Tabulated,
}

impl Sampler for Prepared {
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        self.table.sample(x, out)
    }

    fn relative_error(&self, x: &[f64]) -> f64 {
        self.table.relative_error(x)
    }

    fn unprepared(&self) -> Option<Arc<dyn Sampler>> {
        Some(self.average.clone())
    }

    fn finer(&self, tolerance: f64) -> Option<Arc<dyn Sampler>> {
        let tolerance = table_tolerance(tolerance).min(self.average.tolerance);
        Some(Arc::new(Average { tolerance, ..(*self.average).clone() }))
    }
}

impl Sampler for Average {
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        out.iter_mut().zip(x).for_each(|(out, x)| *out = self.value(*x).value);
        Ok(())
    }

    fn relative_error(&self, _: &[f64]) -> f64 {
        AZIMUTHS * self.tolerance
    }

    fn masses(&self, against: &Weighted<'_>) -> Option<Discretised> {
        Some(nested::masses(self, against, AZIMUTHS * self.tolerance))
    }
}

/// The angle average of a sum of powers of y on `range`, in closed form. Every origin must be 0
/// or the beginning of the range.
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

    fn value(form: &Formula, x: f64) -> f64 {
        let mut out = [0.0];
        form.sample(&[x], &mut out).unwrap();
        out[0]
    }

    #[test]
    fn elastic_limits_are_those_of_the_sheet() {
        // Against x^p: 1/3 for Hertz' force, 7/16 for the area. [the equations sheet, section 5]
        for (p, ratio) in [(1.5, 1.0 / 3.0), (1.0, 7.0 / 16.0)] {
            let form = angle_average_of_powers(
                &[Power::new(1.0, p)],
                0.0..f64::INFINITY,
                AngleDensity::default(),
            );
            for x in [1e-6f64, 1.0, 1e6] {
                assert!((value(&form, x) / x.powf(p) / ratio - 1.0).abs() < 1e-14);
            }
        }
    }

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
