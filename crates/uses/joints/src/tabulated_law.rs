//! Laws whose values cost so much that a table pays: unloading needs some hundred thousand single
//! values of force and area, at places that depend on each other.

use std::sync::Arc;

use asperity_core::{Formula, Law, Part, QuadratureError, Regime, Sampler};
use asperity_quadrature::{Estimate, FunctionTable};

/// Tolerance of the table: close to rounding, as unloading asks for differences of values.
const TOLERANCE: f64 = 1e-14;

/// A law of one asperity in its units, as a table where that converges.
struct TabulatedLaw {
    law: Arc<Law>,
    table: FunctionTable,
}

impl Sampler for TabulatedLaw {
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        for (out, x) in out.iter_mut().zip(x) {
            // Next to a kink that is not declared, and for the error of a law without a value.
            let known = self.table.value(*x).ok().filter(|value| value.is_finite());
            *out = known.map_or_else(|| shape(&self.law, *x), Ok)?;
        }
        Ok(())
    }
}

/// The same law with a table of its values if they are [costly](Sampler::is_costly); its parts are
/// then one.
pub(crate) fn tabulated(law: Law) -> Law {
    if !law.parts.iter().any(|part| part.form.is_costly()) {
        return law;
    }
    let (kinks, law) = (law.kinks(), Arc::new(law));
    let source = law.clone();
    let value = move |x: f64| {
        let value = shape(&source, x).unwrap_or(f64::NAN);
        Estimate { value, error: 0.0, evaluations: 1 }
    };
    let table = FunctionTable::new(Arc::new(value), &kinks, TOLERANCE);
    let mut whole = Law::in_units(law.interference_unit, law.value_unit);
    let form = Formula::sampled(Arc::new(TabulatedLaw { law, table }));
    let (name, regime, range) = ("law".into(), Regime::ElasticPlastic, 0.0..f64::INFINITY);
    whole.parts.push(Part { name, regime, sign: 1.0, range, kinks, form });
    whole
}

/// The value over the value unit at x.
fn shape(law: &Law, x: f64) -> Result<f64, QuadratureError> {
    Ok(law.value(x * law.interference_unit)? / law.value_unit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// x^1.5 with a declared jump at 3 and, if asked, one at 7 that is not.
    struct Costly {
        calls: Arc<AtomicUsize>,
        hidden: bool,
    }

    impl Sampler for Costly {
        fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
            for (out, &x) in out.iter_mut().zip(x) {
                self.calls.fetch_add(1, Ordering::Relaxed);
                if x > 1e6 {
                    return Err(QuadratureError::Refused { reason: "too deep".into() });
                }
                let jump = if x < 3.0 { 1.0 } else { 1.1 };
                *out = x.powf(1.5) * jump * if self.hidden && x > 7.0 { 1.01 } else { 1.0 };
            }
            Ok(())
        }

        fn is_costly(&self) -> bool {
            true
        }
    }

    #[test]
    fn costly_laws_are_sampled_some_thousand_times_and_keep_their_values_and_errors() {
        for hidden in [false, true] {
            let calls = Arc::new(AtomicUsize::new(0));
            let sampler = Arc::new(Costly { calls: calls.clone(), hidden });
            let mut law = Law::in_units(1e-6, 2.0);
            let (name, regime, range) = ("law".into(), Regime::ElasticPlastic, 0.0..f64::INFINITY);
            let (kinks, form) = (vec![3.0], Formula::sampled(sampler));
            law.parts.push(Part { name, regime, sign: 1.0, range, kinks, form });
            let table = tabulated(law.clone());
            assert_eq!(table.kinks(), law.kinks());
            for k in 0..100_000 {
                let w = 1e-9 * 1.0002f64.powi(k);
                let (found, wanted) = (table.value(w).unwrap(), law.value(w).unwrap());
                assert!((found / wanted - 1.0).abs() < 2e-13, "{w}: {found} {wanted}");
            }
            let sampled = calls.load(Ordering::Relaxed) - 100_000;
            assert!(hidden || sampled < 5000, "{sampled}");
            let error = table.value(2.0).unwrap_err();
            assert_eq!(error, QuadratureError::Refused { reason: "too deep".into() });
        }
        let cheap =
            Law::in_units(1.0, 1.0).elastic(0.0..2.0, [asperity_core::Power::new(1.0, 1.5)]);
        assert_eq!(tabulated(cheap.clone()).parts.len(), cheap.parts.len());
    }
}
