//! I(s) = ∫₀^∞ q(t/c) φ(s + t) dt for many s: rules built on demand, one for each short range of s.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::segment::{self, Segment, Sums};
use crate::{Density, QuadratureError};

/// Below this s each evaluation integrates anew: rules would be needed for every unit of s.
const LOWEST: f64 = -64.0;
/// Beyond this s the window is so short that only the first power of the density counts, and
/// s² no longer fits a multiple of the height's rounding; nothing physical lies there.
const HIGHEST: f64 = 1e9;
/// Rules below zero, one for each unit.
const NEGATIVE: usize = 64;
/// Rules above zero, four for each octave of s + 4.5.
const POSITIVE: usize = 112;

/// I(s) with its derivatives, scaled against underflow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moments {
    /// I(s) = value · exp(`ln_scale`).
    pub value: f64,
    /// -dI/ds = slope · exp(`ln_scale`).
    pub slope: f64,
    /// -max(s, 0)²/2.
    pub ln_scale: f64,
    /// Integrals of the absolute value, for value and slope: larger than those where the density
    /// changes its sign (and, for the slope, where s < 0).
    pub sizes: [f64; 2],
    /// Bound on the error of value and slope relative to `sizes`, for the s given (the rounding of
    /// s itself apart).
    pub error: f64,
}

/// The rule of one range of s, if it has been built.
type Cell = OnceLock<Result<Box<Segment>, QuadratureError>>;

/// The integral of one density at one scale c against φ(s + t), for all s.
#[derive(Debug)]
pub struct ShiftedGaussian {
    density: Density,
    scale: f64,
    tolerance: f64,
    segments: Box<[Cell]>,
    evaluations: AtomicUsize,
}

impl ShiftedGaussian {
    /// Prepares the integral of `density(t/scale)`; nothing is sampled before the first
    /// evaluation. `scale` must be positive and finite, `tolerance` is relative.
    #[must_use]
    pub fn new(density: Density, scale: f64, tolerance: f64) -> Self {
        let segments = (0..NEGATIVE + POSITIVE).map(|_| OnceLock::new()).collect();
        Self { density, scale, tolerance, segments, evaluations: AtomicUsize::new(0) }
    }

    /// I(s) and -dI/ds at a finite s ≤ 1e9.
    ///
    /// # Errors
    /// Those of [`crate::discretise`].
    pub fn at(&self, s: f64) -> Result<Moments, QuadratureError> {
        let (sums, error) = match self.segment(s)? {
            Some(segment) => (segment.sums(s), segment.error),
            None => self.directly(s)?,
        };
        Ok(moments(sums, 1.0, ln_scale(s), error))
    }

    /// I(s) alone, with `slope` and its size left at 0: about half the work of [`at`](Self::at).
    ///
    /// # Errors
    /// Those of [`crate::discretise`].
    #[inline]
    pub fn value(&self, s: f64) -> Result<Moments, QuadratureError> {
        let Some(segment) = self.segment(s)? else { return self.at(s) };
        let (value, size) = segment.value(s);
        let (ln_scale, error) = (ln_scale(s), segment.error);
        Ok(Moments { value, slope: 0.0, ln_scale, sizes: [size, 0.0], error })
    }

    /// Nodes of the rule that serves s; 0 where each evaluation integrates anew.
    ///
    /// # Errors
    /// Those of [`crate::discretise`].
    pub fn nodes(&self, s: f64) -> Result<usize, QuadratureError> {
        Ok(self.segment(s)?.map_or(0, Segment::nodes))
    }

    /// How often the density has been sampled so far, over all rules built.
    #[must_use]
    pub fn evaluations(&self) -> usize {
        self.evaluations.load(Ordering::Relaxed)
    }

    #[inline]
    fn segment(&self, s: f64) -> Result<Option<&Segment>, QuadratureError> {
        match locate(s) {
            Some(index) => self.built(index).map(Some),
            None => Ok(None),
        }
    }

    #[inline]
    fn built(&self, index: usize) -> Result<&Segment, QuadratureError> {
        let cell = &self.segments[index];
        match cell.get().unwrap_or_else(|| cell.get_or_init(|| self.build(index))) {
            Ok(segment) => Ok(segment),
            Err(error) => Err(error.clone()),
        }
    }

    #[cold]
    fn build(&self, index: usize) -> Result<Box<Segment>, QuadratureError> {
        let segment = Segment::new(&self.density, self.scale, range(index), self.tolerance)?;
        self.evaluations.fetch_add(segment.evaluations, Ordering::Relaxed);
        Ok(Box::new(segment))
    }

    /// One s outside the ranges that have rules.
    fn directly(&self, s: f64) -> Result<(Sums, f64), QuadratureError> {
        // Below, s + t is a difference of large numbers, and the weight is known no better.
        let rounding = if s < LOWEST { 100.0 * f64::EPSILON * s.abs() } else { 1e-15 };
        let tolerance = rounding.max(0.1 * self.tolerance);
        let masses =
            segment::masses(&self.density, self.scale, s, segment::window(s, s), tolerance)?;
        self.evaluations.fetch_add(masses.evaluations, Ordering::Relaxed);
        let sums = segment::sums(&masses.points, &masses.masses, s, s);
        let [size, _] = sums.sizes;
        let error = if size > 0.0 { 4.0 * masses.error / size } else { 0.0 };
        Ok((sums, error + rounding + segment::ROUNDING + self.density.relative_error()))
    }
}

pub(crate) fn moments(sums: Sums, factor: f64, ln_scale: f64, error: f64) -> Moments {
    Moments {
        value: sums.value * factor,
        slope: sums.slope * factor,
        sizes: sums.sizes.map(|size| size * factor),
        ln_scale,
        error,
    }
}

/// -max(s, 0)²/2.
pub(crate) fn ln_scale(s: f64) -> f64 {
    if s > 0.0 { -0.5 * s * s } else { 0.0 }
}

/// The index of the rule for s.
#[inline]
fn locate(s: f64) -> Option<usize> {
    if !(LOWEST..=HIGHEST).contains(&s) {
        return None;
    }
    Some(if s < 0.0 {
        // -64 itself belongs to the last range.
        NEGATIVE - 1 - ((-s) as usize).min(NEGATIVE - 1)
    } else {
        NEGATIVE + ((s + OFFSET).to_bits() >> 50) as usize - first()
    })
}

/// Ranges above zero are quarter octaves of s + OFFSET: as wide as the tilt of a rule allows.
const OFFSET: f64 = 4.5;

fn first() -> usize {
    (OFFSET.to_bits() >> 50) as usize
}

fn range(index: usize) -> (f64, f64) {
    if index < NEGATIVE {
        let low = index as f64 - NEGATIVE as f64;
        return (low, low + 1.0);
    }
    let quarter = |k: usize| f64::from_bits(((first() + k) as u64) << 50) - OFFSET;
    let k = index - NEGATIVE;
    (quarter(k).max(0.0), quarter(k + 1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Piece;
    use std::sync::Arc;

    fn power(p: f64) -> Density {
        let sampler = move |x: &[f64], out: &mut [f64]| {
            for (out, x) in out.iter_mut().zip(x) {
                *out = x.powf(p);
            }
            Ok(())
        };
        let sampler = Arc::new(sampler);
        let piece = Piece {
            from: 0.0,
            to: f64::INFINITY,
            sign: 1.0,
            kinks: vec![],
            origin: Some(0.0),
            sampler,
        };
        Density { pieces: vec![piece] }
    }

    #[test]
    fn every_s_falls_inside_its_range() {
        for k in -640..8000 {
            let s = f64::from(k) * 0.1;
            let (low, high) = range(locate(s).unwrap());
            assert!(
                low <= s && s <= high && high - low <= 0.26 * (s.abs() + 5.0),
                "{s} {low} {high}"
            );
        }
        assert!(locate(HIGHEST).unwrap() < NEGATIVE + POSITIVE);
        assert!(locate(-64.5).is_none() && locate(2e9).is_none());
        assert_eq!(locate(LOWEST).unwrap(), 0);
    }

    #[test]
    fn linear_density_has_the_recurrence_of_parabolic_cylinders() {
        // F₁ = ∫ t φ = φ(s) - s Q(s), F₁' = -Q: 0.3989 and 1/2 at s = 0.
        let integral = ShiftedGaussian::new(power(1.0), 1.0, 1e-14);
        let at = integral.at(0.0).unwrap();
        assert!((at.value / segment::INV_SQRT_2PI - 1.0).abs() < 1e-14);
        assert!((at.slope / 0.5 - 1.0).abs() < 1e-14);
    }

    #[test]
    fn direct_and_compiled_agree_at_the_seam() {
        let integral = ShiftedGaussian::new(power(1.5), 0.3, 1e-14);
        for s in [-64.0, -63.2] {
            let compiled = integral.at(s).unwrap();
            let (direct, _) = integral.directly(s).unwrap();
            assert!((compiled.value / direct.value - 1.0).abs() < 1e-14);
            assert!((compiled.slope / direct.slope - 1.0).abs() < 2e-12, "{s}");
        }
    }

    #[test]
    fn looser_tolerances_need_fewer_nodes_and_samples() {
        let [tight, loose] = [1e-13, 1e-4].map(|t| ShiftedGaussian::new(power(1.425), 1e-3, t));
        for s in [-3.0, 0.0, 2.0, 40.0] {
            assert!(loose.nodes(s).unwrap() < tight.nodes(s).unwrap());
            let (a, b) = (tight.at(s).unwrap(), loose.at(s).unwrap());
            assert!((a.value / b.value - 1.0).abs() < b.error && b.error < 1e-4);
        }
    }
}
