//! The formula of a part of a law: a sum of powers, or any function.

use std::borrow::Cow;
use std::sync::Arc;

use asperity_quadrature::{QuadratureError, Sampler};

/// One term c (x - o)^p.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Power {
    /// c.
    pub coefficient: f64,
    /// o, at most the start of the part.
    pub origin: f64,
    /// p ≥ 0.
    pub exponent: f64,
}

impl Power {
    /// c x^p.
    #[must_use]
    pub fn new(coefficient: f64, exponent: f64) -> Self {
        Self { coefficient, origin: 0.0, exponent }
    }

    /// c (x - o)^p.
    #[must_use]
    pub fn from_origin(coefficient: f64, origin: f64, exponent: f64) -> Self {
        Self { coefficient, origin, exponent }
    }

    /// The value at x.
    #[must_use]
    pub fn value(&self, x: f64) -> f64 {
        let base = x - self.origin;
        self.coefficient
            * match self.exponent {
                0.0 => 1.0,
                1.0 => base,
                1.5 => base * base.sqrt(),
                p => base.powf(p),
            }
    }

    /// The derivative at x.
    pub(crate) fn slope(&self, x: f64) -> f64 {
        let base = x - self.origin;
        self.coefficient
            * match self.exponent {
                0.0 => 0.0,
                1.0 => 1.0,
                1.5 => 1.5 * base.sqrt(),
                p => p * base.powf(p - 1.0),
            }
    }
}

/// The formula of a part.
#[derive(Debug, Clone)]
pub enum Formula {
    /// A sum of powers.
    Powers(Vec<Power>),
    /// Any function, sampled many points at a time.
    Function {
        /// The function.
        sampler: Arc<dyn Sampler>,
        /// Identity of the function, if known.
        key: Option<FunctionKey>,
    },
}

/// Two functions with the same key are the same function: a sweep then integrates it once.
#[derive(Debug, Clone, PartialEq)]
pub struct FunctionKey {
    /// Description of the function, shown in plans.
    pub name: Cow<'static, str>,
    /// Its ingredients, if the name is not sufficient.
    pub of: String,
    /// All its parameters.
    pub parameters: Vec<f64>,
}

impl Formula {
    /// A function given point by point.
    pub fn function(f: impl Fn(f64) -> f64 + Send + Sync + 'static) -> Self {
        Self::sampled(Arc::new(move |x: &[f64], out: &mut [f64]| {
            out.iter_mut().zip(x).for_each(|(out, &x)| *out = f(x));
            Ok(())
        }))
    }

    /// A function sampled many points at a time.
    pub fn sampled(sampler: Arc<dyn Sampler>) -> Self {
        Self::Function { sampler, key: None }
    }

    /// Identifies a function by its name and parameters.
    #[must_use]
    pub fn known_as(self, name: impl Into<Cow<'static, str>>, parameters: Vec<f64>) -> Self {
        self.with_key(FunctionKey { name: name.into(), of: String::new(), parameters })
    }

    /// Identifies a function by a key; sums of powers need none.
    #[must_use]
    pub fn with_key(self, key: FunctionKey) -> Self {
        match self {
            Self::Powers(powers) => Self::Powers(powers),
            Self::Function { sampler, .. } => Self::Function { sampler, key: Some(key) },
        }
    }

    /// The function; `None` for a sum of powers.
    fn sampler(&self) -> Option<&dyn Sampler> {
        match self {
            Self::Powers(_) => None,
            Self::Function { sampler, .. } => Some(&**sampler),
        }
    }

    /// A short description of the formula.
    #[must_use]
    pub fn describe(&self) -> &str {
        match self {
            Self::Powers(_) => "sum of powers",
            Self::Function { key: Some(key), .. } => &key.name,
            Self::Function { key: None, .. } => "function",
        }
    }
}

impl<const N: usize> From<[Power; N]> for Formula {
    fn from(powers: [Power; N]) -> Self {
        Self::Powers(powers.to_vec())
    }
}

impl Sampler for Formula {
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        match self {
            Self::Powers(powers) => {
                for (out, &x) in out.iter_mut().zip(x) {
                    *out = powers.iter().map(|p| p.value(x)).sum();
                }
                Ok(())
            }
            Self::Function { sampler, .. } => sampler.sample(x, out),
        }
    }

    fn slope(&self, x: &[f64], out: &mut [f64]) -> bool {
        match self {
            Self::Powers(powers) => {
                for (out, &x) in out.iter_mut().zip(x) {
                    *out = powers.iter().map(|p| p.slope(x)).sum();
                }
                true
            }
            Self::Function { sampler, .. } => sampler.slope(x, out),
        }
    }

    fn relative_error(&self, x: &[f64]) -> f64 {
        self.sampler().map_or(0.0, |sampler| sampler.relative_error(x))
    }

    fn is_costly(&self) -> bool {
        self.sampler().is_some_and(|sampler| sampler.is_costly())
    }

    fn finer(&self, tolerance: f64) -> Option<Arc<dyn Sampler>> {
        self.sampler()?.finer(tolerance)
    }

    fn unprepared(&self, range: (f64, f64)) -> Option<Arc<dyn Sampler>> {
        self.sampler()?.unprepared(range)
    }
}
