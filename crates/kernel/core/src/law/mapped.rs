//! A formula behind another function.

use std::sync::Arc;

use asperity_quadrature::{QuadratureError, Sampler};

use crate::Formula;

/// f of the values of a formula.
pub(crate) struct Mapped<F> {
    pub(crate) inner: Formula,
    pub(crate) f: F,
}

/// Relative step by which the sensitivity of f is measured.
const STEP: f64 = 1e-3;

impl<F: Fn(f64) -> f64 + Clone + Send + Sync + 'static> Mapped<F> {
    fn around(&self, inner: Arc<dyn Sampler>) -> Arc<dyn Sampler> {
        let inner = Formula::sampled(inner);
        Arc::new(Mapped { inner, f: self.f.clone() })
    }
}

impl<F: Fn(f64) -> f64 + Clone + Send + Sync + 'static> Sampler for Mapped<F> {
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        self.inner.sample(x, out)?;
        out.iter_mut().for_each(|q| *q = (self.f)(*q));
        Ok(())
    }

    /// The error of the formula times the largest sensitivity of f, d ln f/d ln q.
    fn relative_error(&self, x: &[f64]) -> f64 {
        let error = self.inner.relative_error(x);
        let mut values = vec![0.0; x.len()];
        if error == 0.0 || self.inner.sample(x, &mut values).is_err() {
            return error;
        }
        let sensitivity = |q: &f64| {
            let moved = (self.f)(q * (1.0 + STEP)) / (self.f)(*q);
            if moved.is_finite() { (moved - 1.0).abs() / STEP } else { 1.0 }
        };
        error * values.iter().map(sensitivity).fold(0.0, f64::max)
    }

    fn unprepared(&self, range: (f64, f64)) -> Option<Arc<dyn Sampler>> {
        self.inner.unprepared(range).map(|inner| self.around(inner))
    }

    fn finer(&self, tolerance: f64) -> Option<Arc<dyn Sampler>> {
        self.inner.finer(tolerance).map(|inner| self.around(inner))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x², known to 1e-6.
    struct Square;

    impl Sampler for Square {
        fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
            out.iter_mut().zip(x).for_each(|(out, x)| *out = x * x);
            Ok(())
        }

        fn relative_error(&self, _: &[f64]) -> f64 {
            1e-6
        }
    }

    #[test]
    fn a_root_halves_the_error_of_a_formula_and_a_cube_triples_it() {
        let inner = Formula::sampled(Arc::new(Square));
        let error =
            |f: fn(f64) -> f64| Mapped { inner: inner.clone(), f }.relative_error(&[0.5, 2.0, 7.0]);
        assert!((error(f64::sqrt) / 0.5e-6 - 1.0).abs() < 1e-3);
        assert!((error(|q| q.powi(3)) / 3e-6 - 1.0).abs() < 2e-3);
    }
}
