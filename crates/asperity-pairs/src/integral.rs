//! The integral of a law from its onset, part by part.

use std::sync::Arc;

use asperity_core::{Formula, FunctionKey, Law, Part, Power, QuadratureError, Sampler};
use asperity_quadrature::{Estimate, FunctionTable, TanhSinh};

/// Tolerance of the tables: close to rounding.
const TOLERANCE: f64 = 1e-14;

/// ∫ q dw from the onset of a law, in the units of the law and with its parts: each one grows on
/// its own range and keeps its value beyond, so that shares stay those of the contacts.
pub(crate) fn integral(law: &Law) -> Law {
    let value_unit = law.value_unit * law.interference_unit;
    let parts = law.parts.iter().flat_map(grown).collect();
    Law { value_unit, parts, ..*law }
}

/// The integral of a part on its range and, unless that is endless, beyond it.
fn grown(part: &Part) -> Vec<Part> {
    let end = part.range.end;
    let (form, whole) = match &part.form {
        Formula::Powers(powers) => primitive(powers, part.range.start, end),
        Formula::Function { key, .. } => {
            let integral = Integral::new(part);
            let whole = if end.is_finite() { integral.until(end - integral.start).value } else { end };
            let key = key.as_ref().map(|key| FunctionKey {
                name: format!("integral of {}", key.name).into(),
                of: format!("{key:?}"),
                parameters: [&[part.range.start], &*part.kinks].concat(),
            });
            let form = Formula::sampled(Arc::new(Tabulated::new(integral)));
            (key.into_iter().fold(form, Formula::with_key), whole)
        }
    };
    let kept = Part {
        range: end..f64::INFINITY,
        kinks: vec![],
        form: [Power::new(whole, 0.0)].into(),
        ..part.clone()
    };
    let grown = Part { form, ..part.clone() };
    [grown, kept].into_iter().filter(|part| part.range.start.is_finite()).collect()
}

/// The integral of a sum of powers from the start of a range, and its value at the end.
fn primitive(powers: &[Power], start: f64, end: f64) -> (Formula, f64) {
    let integral = |power: &Power| {
        let exponent = power.exponent + 1.0;
        Power { coefficient: power.coefficient / exponent, exponent, ..*power }
    };
    let mut grown: Vec<Power> = powers.iter().map(integral).collect();
    let at = |x: f64| grown.iter().map(|power| power.value(x)).sum::<f64>();
    let (first, last) = (at(start), at(end));
    if first != 0.0 {
        grown.push(Power::new(-first, 0.0));
    }
    (Formula::Powers(grown), last - first)
}

/// The integral of a function from the start of its part.
struct Integral {
    form: Formula,
    start: f64,
    /// Kinks beyond the start.
    kinks: Vec<f64>,
}

impl Integral {
    fn new(part: &Part) -> Self {
        let (form, start) = (part.form.clone(), part.range.start);
        Self { form, start, kinks: part.kinks.iter().map(|x| x - start).collect() }
    }

    /// The integral up to t beyond the start.
    fn until(&self, t: f64) -> Estimate {
        let inner = self.kinks.iter().copied().filter(|kink| *kink < t);
        let ends: Vec<f64> = [0.0].into_iter().chain(inner).chain([t]).collect();
        let value = |t: f64| {
            let mut value = [0.0];
            let sampled = self.form.sample(&[self.start + t], &mut value);
            sampled.map_or(f64::NAN, |()| value[0])
        };
        let mut total = Estimate { value: 0.0, error: 0.0, evaluations: 0 };
        for pair in ends.windows(2) {
            let rules = TanhSinh::shared();
            let found = rules.integrate_beside(pair[0], pair[1], 1e-15, total.value, |p| value(p.x));
            total.value += found.value;
            total.error += found.error;
            total.evaluations += found.evaluations;
        }
        total
    }
}

/// An [`Integral`], tabulated over the distance t from the start: over t it is a mean of f, which
/// has as many digits next to the start as far from it.
struct Tabulated {
    of: Arc<Integral>,
    table: FunctionTable,
}

impl Tabulated {
    fn new(integral: Integral) -> Self {
        let of = Arc::new(integral);
        let source = of.clone();
        let table =
            FunctionTable::new(Arc::new(move |t| source.until(t)), &of.kinks, TOLERANCE);
        Self { of, table }
    }
}

impl Sampler for Tabulated {
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        for (out, x) in out.iter_mut().zip(x) {
            let t = x - self.of.start;
            *out = if t > 0.0 { self.table.value(t)? } else { 0.0 };
        }
        Ok(())
    }

    fn slope(&self, x: &[f64], out: &mut [f64]) -> bool {
        self.of.form.sample(x, out).is_ok()
    }

    fn relative_error(&self, x: &[f64]) -> f64 {
        let beyond: Vec<f64> = x.iter().map(|x| x - self.of.start).collect();
        self.table.relative_error(&beyond) + self.of.form.relative_error(x)
    }
}
