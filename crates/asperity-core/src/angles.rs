//! Contact normals spread over angles: what averages an oblique contact into an ordinary law.

use std::ops::Range;
use std::sync::Arc;

use asperity_quadrature::{Point, QuadratureError, Tabulated, TanhSinh};
use serde::{Deserialize, Serialize};

use crate::{ContactError, Form, FunctionKey, Power};

/// How contact normals are spread, over u = |cos φ| in 0..1 (1: upright, 0: grazing).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum AngleDensity {
    /// 4π ψ = 1 + a₂₀ P₂(cos φ) + (a₂₁ cos θ + b₂₁ sin θ) P₂¹(cos φ).
    ///
    /// A normal and its opposite are the same contact, so the density is folded to
    /// 1 + a₂₀ (3u² - 1)/2; the P₂¹ terms average out of every law. \[derived\]
    Harmonic {
        /// a₂₀, from -1 to 2.
        a20: f64,
        /// a₂₁; changes no result.
        a21: f64,
        /// b₂₁; changes no result.
        b21: f64,
    },
    /// All normals upright: u = 1.
    Upright,
}

impl Default for AngleDensity {
    /// The AT paper's: a₂₀ = -0.5, a₂₁ = b₂₁ = 1. \[seen\]
    fn default() -> Self {
        Self::Harmonic { a20: -0.5, a21: 1.0, b21: 1.0 }
    }
}

impl AngleDensity {
    /// # Errors
    /// [`ContactError::OutOfRange`] when the folded density would be negative, or an input is not
    /// finite.
    pub fn check(&self) -> Result<(), ContactError> {
        let Self::Harmonic { a20, a21, b21 } = *self else {
            return Ok(());
        };
        if !(-1.0..=2.0).contains(&a20) {
            let required = "from -1 to 2, or the density is negative,";
            return Err(ContactError::OutOfRange { field: "a20", value: a20, required });
        }
        for (field, value) in [("a21", a21), ("b21", b21)] {
            if !value.is_finite() {
                return Err(ContactError::OutOfRange { field, value, required: "a finite number" });
            }
        }
        Ok(())
    }

    /// Smallest value of 4π ψ over the sphere, all terms in.
    ///
    /// With P₂¹ = -3 cos φ sin φ it is 1 + a₂₀/4 - √((3a₂₀/4)² + (9/4)(a₂₁² + b₂₁²)). \[derived\]
    #[must_use]
    pub fn minimum(&self) -> f64 {
        match *self {
            Self::Upright => 0.0,
            Self::Harmonic { a20, a21, b21 } => {
                1.0 + 0.25 * a20 - (0.75 * a20).hypot(1.5 * a21.hypot(b21))
            }
        }
    }

    /// 4π ψ at polar angle φ and azimuth θ \[rad\], all terms in; 0 for upright normals, whose
    /// density is no function.
    #[must_use]
    pub fn printed(&self, phi: f64, theta: f64) -> f64 {
        let Self::Harmonic { a20, a21, b21 } = *self else {
            return 0.0;
        };
        let (s, u) = phi.sin_cos();
        // P₂¹ = -3 cos φ sin φ.
        1.0 + 0.5 * a20 * (3.0 * u * u - 1.0)
            - 3.0 * u * s * (a21 * theta.cos() + b21 * theta.sin())
    }

    /// c₀ and c₂ of the folded density c₀ + c₂ u²; `None` for upright normals.
    #[must_use]
    pub fn folded(&self) -> Option<(f64, f64)> {
        match *self {
            Self::Upright => None,
            Self::Harmonic { a20, .. } => Some((1.0 - 0.5 * a20, 1.5 * a20)),
        }
    }
}

/// An oblique contact, already averaged over the azimuth θ.
///
/// A pair approached vertically by x has the contact-normal interference y = x u.
pub trait ObliqueContact: Send + Sync {
    /// The average over θ at contact-normal interference `y` of a pair approached by `x` ≥ y.
    fn mean(&self, y: f64, x: f64) -> f64;

    /// Where, for this x, the average has branch points as a function of y inside `range`.
    fn breaks(&self, x: f64, range: &Range<f64>) -> Vec<f64>;

    /// At which x the angle average over y in `range` has kinks, the ends of the range apart.
    fn kinks(&self, range: &Range<f64>) -> Vec<f64>;

    /// What tells this contact from all others, if anything does: laws that recur in a sweep are
    /// then tabulated once.
    fn key(&self) -> Option<String> {
        None
    }
}

/// q(x) = (1/x) ∫ (c₀ + c₂ y²/x²) m(y, x) dy over y in `range`, y ≤ x, as a form with its kinks.
///
/// The integral runs between the branch points by tanh-sinh; q is tabulated when first needed.
#[must_use]
pub fn angle_average(
    contact: Arc<dyn ObliqueContact>,
    range: Range<f64>,
    density: AngleDensity,
    tolerance: f64,
) -> (Form, Vec<f64>) {
    let Some((c0, c2)) = density.folded() else {
        let of = contact.key();
        let form = Form::function(move |x| contact.mean(x, x));
        let key =
            of.map(|of| FunctionKey { name: "upright contact".into(), of, parameters: vec![] });
        return (key.into_iter().fold(form, Form::with_key), vec![]);
    };
    let of = contact.key();
    let mut kinks: Vec<f64> = contact.kinks(&range);
    kinks.extend([range.start, range.end]);
    kinks.retain(|x| x.is_finite() && *x > 0.0);
    // The table's claim is up to five times its tolerance, and the rules need a quarter of what is
    // asked; below 2e-13 rounding would be fitted.
    let tolerance = (0.15 * tolerance).max(2e-13);
    let parameters = vec![c0, c2, range.start, range.end, tolerance];
    let function = move |x: f64| -> Result<f64, QuadratureError> {
        let end = range.end.min(x);
        if end <= range.start {
            return Ok(0.0);
        }
        let mut ends = contact.breaks(x, &(range.start..end));
        ends.extend([range.start, end]);
        ends.sort_by(f64::total_cmp);
        let integrand = |y: f64| (c0 + c2 * (y / x) * (y / x)) * contact.mean(y, x);
        // From the right, where responses are largest: what is left need only be good beside them.
        let mut total = 0.0f64;
        for pair in ends.windows(2).rev().filter(|pair| pair[1] > pair[0]) {
            let (goal, integrand) = (0.5 * tolerance, |p: Point| integrand(p.x));
            let rules = TanhSinh::shared();
            total += rules.integrate_beside(pair[0], pair[1], goal, total.abs(), integrand).value;
        }
        Ok(total / x)
    };
    let table = Tabulated::new(Arc::new(function), &kinks, tolerance);
    let kinks = table.kinks().to_vec();
    let key = of.map(|of| FunctionKey { name: "angle average, tabulated".into(), of, parameters });
    (key.into_iter().fold(Form::sampled(Arc::new(table)), Form::with_key), kinks)
}

/// The angle average of a sum of powers of y on `range`, in closed form. Every origin must be 0
/// or the beginning of the range.
#[must_use]
pub fn angle_average_of_powers(powers: &[Power], range: Range<f64>, density: AngleDensity) -> Form {
    let powers = powers.to_vec();
    let Some((c0, c2)) = density.folded() else {
        return Form::Powers(powers);
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
    Form::function(average).known_as("angle average in closed form", parameters)
}

/// (high^n - low^n)/n without cancellation.
fn power_difference(low: f64, high: f64, n: f64) -> f64 {
    if low > 0.0 { low.powf(n) * (n * (high / low).ln()).exp_m1() / n } else { high.powf(n) / n }
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity_quadrature::Sampler;

    fn value(form: &Form, x: f64) -> f64 {
        let mut out = [0.0];
        form.sample(&[x], &mut out).unwrap();
        out[0]
    }

    #[test]
    fn the_printed_density_is_negative_as_the_sheet_says() {
        assert!((AngleDensity::default().minimum() + 1.27921).abs() < 1e-5);
        let limit = AngleDensity::Harmonic { a20: -0.5, a21: 0.37268, b21: 0.37268 };
        assert!(limit.minimum().abs() < 1e-5);
        for (a20, ok) in [(-1.0, true), (2.0, true), (-1.01, false), (f64::NAN, false)] {
            assert_eq!(AngleDensity::Harmonic { a20, a21: 0.0, b21: 0.0 }.check().is_ok(), ok);
        }
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
        fn mean(&self, y: f64, _: f64) -> f64 {
            1.0 + 1.32 * (y - 1.0).powf(1.27)
        }
        fn breaks(&self, _: f64, _: &Range<f64>) -> Vec<f64> {
            vec![]
        }
        fn kinks(&self, _: &Range<f64>) -> Vec<f64> {
            vec![]
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
