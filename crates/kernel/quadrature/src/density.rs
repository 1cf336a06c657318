//! Densities: signed sums of pieces, each smooth between its declared kinks.

use std::fmt;
use std::sync::Arc;

use crate::QuadratureError;

/// A function sampled many points at a time.
pub trait Sampler: Send + Sync {
    /// Writes the values at `x` (ascending, inside the piece) to `out`, of the same length.
    ///
    /// # Errors
    /// [`QuadratureError::Refused`] with the reason when the function has no value there.
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError>;

    /// Writes the derivative at `x` to `out` and returns true, if there is a formula for it.
    fn slope(&self, _x: &[f64], _out: &mut [f64]) -> bool {
        false
    }

    /// Error of the values at the sampled `x`, relative to the function's size nearby, if they are
    /// approximations. It must not depend on other samples.
    fn relative_error(&self, _x: &[f64]) -> f64 {
        0.0
    }

    /// Whether a sample costs so much that those who need thousands of single values should
    /// tabulate the function first.
    fn is_costly(&self) -> bool {
        false
    }

    /// The same function without preparation, for a single integral over this range, if that
    /// saves work: nothing is kept between samples.
    fn unprepared(&self, _range: (f64, f64)) -> Option<Arc<dyn Sampler>> {
        None
    }

    /// The same function to a relative `tolerance`, for a single integral, if this one is an
    /// approximation that may be coarser.
    fn finer(&self, _tolerance: f64) -> Option<Arc<dyn Sampler>> {
        None
    }

    /// The function times a weight as point masses, where they cost less than samples: a function
    /// that is itself an average can be averaged in another order.
    fn masses(&self, _against: &WeightFunction<'_>) -> Option<PointMasses> {
        None
    }
}

impl fmt::Debug for dyn Sampler {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a function")
    }
}

/// Point masses that replace a density times a weight.
#[derive(Debug, Clone, Default)]
pub struct PointMasses {
    /// Places of the masses, ascending within each panel.
    pub points: Vec<f64>,
    /// The masses; their sum is the integral.
    pub masses: Vec<f64>,
    /// Estimate of the absolute error of that sum.
    pub error: f64,
    /// How often the density was sampled.
    pub evaluations: usize,
}

/// The weight of an integral, and the wanted accuracy.
#[derive(Clone, Copy)]
pub struct WeightFunction<'a> {
    /// Range of the integral.
    pub range: (f64, f64),
    /// Panel ends that suit the weight, ascending.
    pub edges: &'a [f64],
    /// The weight.
    pub weight: &'a dyn Fn(f64) -> f64,
    /// Wanted error of the integral, relative to its size
    pub aim: f64,
    /// or to the size of the other integrals of the same sum.
    pub beside: f64,
}

impl WeightFunction<'_> {
    /// The edge at which x² times the weight is largest: about the place of most of the integral of
    /// a growing function.
    #[must_use]
    pub fn likely(&self) -> f64 {
        let at = |x: &f64| x * x * (self.weight)(*x);
        let largest = self.edges.iter().max_by(|a, b| at(a).total_cmp(&at(b)));
        largest.copied().unwrap_or(self.range.1)
    }
}

impl<F> Sampler for F
where
    F: Fn(&[f64], &mut [f64]) -> Result<(), QuadratureError> + Send + Sync,
{
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        self(x, out)
    }
}

/// One piece of a density, on `[from, to)`.
#[derive(Debug, Clone)]
pub struct Piece {
    /// The lower end, ≥ 0.
    pub from: f64,
    /// The upper end; may be infinite.
    pub to: f64,
    /// Factor of the values in the sum, mostly 1 or -1.
    pub sign: f64,
    /// Declared kinks inside the piece. An undeclared kink costs time, and the error stays below
    /// the tolerance; the bound may miss an undeclared jump.
    pub kinks: Vec<f64>,
    /// The origin o if the piece is a sum of powers (x-o)^p: one panel then spans any ratio of
    /// scales.
    pub origin: Option<f64>,
    /// The values.
    pub sampler: Arc<dyn Sampler>,
}

/// A density on [0, ∞): the sum of its pieces.
#[derive(Debug, Clone, Default)]
pub struct Density {
    /// The pieces, in any order; they may overlap.
    pub pieces: Vec<Piece>,
}

impl Density {
    /// The same density for a single integral over a range: see [`Sampler::unprepared`].
    #[must_use]
    pub fn unprepared(&self, range: (f64, f64)) -> Self {
        self.with(|sampler| sampler.unprepared(range))
    }

    /// The same density to a relative `tolerance`, for a single integral: see [`Sampler::finer`].
    #[must_use]
    pub fn finer(&self, tolerance: f64) -> Self {
        self.with(|sampler| sampler.finer(tolerance))
    }

    /// With other samplers, where there are any.
    fn with(&self, other: impl Fn(&dyn Sampler) -> Option<Arc<dyn Sampler>>) -> Self {
        let piece = |piece: &Piece| {
            let sampler = other(&*piece.sampler).unwrap_or_else(|| piece.sampler.clone());
            Piece { sampler, ..piece.clone() }
        };
        Self { pieces: self.pieces.iter().map(piece).collect() }
    }

    /// The ends and kinks of all pieces strictly inside `(low, high)`, ascending, each once.
    #[must_use]
    pub fn breaks(&self, low: f64, high: f64) -> Vec<f64> {
        let mut breaks: Vec<f64> = self
            .pieces
            .iter()
            .flat_map(|p| [p.from, p.to].into_iter().chain(p.kinks.iter().copied()))
            .filter(|x| *x > low && *x < high)
            .collect();
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        breaks
    }

    /// The beginning of the first piece; infinite if there is none.
    pub(crate) fn begin(&self) -> f64 {
        self.pieces.iter().map(|piece| piece.from).fold(f64::INFINITY, f64::min)
    }

    /// The largest relative error of the pieces' values at the sampled points `x`.
    #[must_use]
    pub fn relative_error(&self, x: &[f64]) -> f64 {
        let of = |p: &Piece| {
            let inside: Vec<f64> =
                x.iter().copied().filter(|x| p.from <= *x && *x < p.to).collect();
            p.sampler.relative_error(&inside)
        };
        self.pieces.iter().map(of).fold(0.0, f64::max)
    }

    /// The pieces that cover all of `[low, high]`, which must not straddle a break.
    pub(crate) fn active(&self, low: f64, high: f64) -> impl Iterator<Item = &Piece> {
        self.pieces.iter().filter(move |p| p.from <= low && p.to >= high)
    }

    /// The value at one point; at a jump, that above it.
    ///
    /// # Errors
    /// What a sampler refuses.
    pub fn value_at(&self, x: f64) -> Result<f64, QuadratureError> {
        self.value(x, |from, to| from <= x && x < to)
    }

    /// Whether there are formulas for the derivatives of all pieces.
    #[must_use]
    pub fn knows_slope(&self) -> bool {
        self.pieces.iter().all(|piece| piece.sampler.slope(&[], &mut []))
    }

    /// The sum of the pieces whose ends suit, at one point.
    pub(crate) fn value(
        &self,
        x: f64,
        suits: impl Fn(f64, f64) -> bool,
    ) -> Result<f64, QuadratureError> {
        let mut total = 0.0;
        for piece in self.pieces.iter().filter(|p| suits(p.from, p.to)) {
            let mut value = [0.0];
            piece.sampler.sample(&[x], &mut value)?;
            total += piece.sign * value[0];
        }
        Ok(total)
    }

    /// Whether all pieces active on `[low, high]` have a formula for the derivative.
    pub(crate) fn has_slope(&self, (low, high): (f64, f64)) -> bool {
        self.active(low, high).all(|piece| piece.sampler.slope(&[], &mut []))
    }

    /// Adds up the derivatives of the pieces active on `[low, high]`, which all have formulas.
    pub(crate) fn slope(
        &self,
        (low, high): (f64, f64),
        x: &[f64],
        scratch: &mut [f64],
        out: &mut [f64],
    ) {
        out.fill(0.0);
        for piece in self.active(low, high) {
            piece.sampler.slope(x, scratch);
            for (total, value) in out.iter_mut().zip(scratch.iter()) {
                *total += piece.sign * value;
            }
        }
    }

    /// Adds up the pieces active on `[low, high]` at the points `x`.
    pub(crate) fn sample(
        &self,
        (low, high): (f64, f64),
        x: &[f64],
        scratch: &mut [f64],
        out: &mut [f64],
    ) -> Result<usize, QuadratureError> {
        out.fill(0.0);
        let mut evaluations = 0;
        for piece in self.active(low, high) {
            piece.sampler.sample(x, scratch)?;
            evaluations += x.len();
            for (total, value) in out.iter_mut().zip(scratch.iter()) {
                *total += piece.sign * value;
            }
        }
        for (&at, &value) in x.iter().zip(out.iter()) {
            if !value.is_finite() {
                return Err(QuadratureError::NotFinite { at, value });
            }
        }
        Ok(evaluations)
    }
}
