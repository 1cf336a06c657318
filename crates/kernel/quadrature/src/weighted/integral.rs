//! The integral of one density over a weight, for any separation.

use std::sync::OnceLock;

use super::integrand::{Integrand, Sums};
use super::run::Run;
use super::strip::View;
use super::weight::Weight;
use crate::{Density, Moments, QuadratureError, WeightFault};

/// Rounding of the sums, and of the logarithms that weights come from.
const ROUNDING: f64 = 1e-14;
/// Errors up to this are accepted at any tolerance.
const ATTAINABLE: f64 = 1e-13;
/// The place of the first value of a density that begins at 0.
const NEXT_TO_ZERO: f64 = 1e-30;
/// Logarithms of weights as far from 0 as this need a scale.
pub(crate) const SCALED: f64 = 200.0;

/// A density at one unit, ready to be integrated over weights.
#[derive(Debug)]
pub struct Overlap {
    pub(crate) integrand: Integrand,
    /// The jump of the density at each kink.
    jumps: OnceLock<Result<Vec<f64>, QuadratureError>>,
}

impl Overlap {
    /// `density` over x = (z - d)/`unit`, to a relative `tolerance`.
    #[must_use]
    pub fn new(density: Density, unit: f64, tolerance: f64) -> Self {
        Self { integrand: Integrand::new(density, unit, tolerance), jumps: OnceLock::new() }
    }

    /// The same without jumps, for values alone.
    pub(crate) fn smooth(density: Density, unit: f64, tolerance: f64) -> Self {
        Self { jumps: OnceLock::from(Ok(vec![])), ..Self::new(density, unit, tolerance) }
    }

    /// I(d) and -dI/dd; the bound holds for the slope only if `slope` is true.
    ///
    /// # Errors
    /// A refusal of a sampler, [`QuadratureError::Weight`], and
    /// [`QuadratureError::NotConverged`] where the tolerance is missed.
    pub fn at(&self, weight: &Weight, d: f64, slope: bool) -> Result<Moments, QuadratureError> {
        self.answer(&self.find(weight, d, slope)?, slope)
    }

    /// The integral, unless it misses the tolerance.
    pub(crate) fn answer(&self, found: &Sums, slope: bool) -> Result<Moments, QuadratureError> {
        self.check(found.errors, found.evaluations, slope)?;
        Ok(Moments {
            value: found.sums[0],
            slope: found.sums[1],
            sizes: found.sizes,
            ln_scale: found.ln_scale,
            error: self.bound(found.errors, found.total()),
        })
    }

    /// The bound of value and slope, or of the value alone where the slope misses the tolerance.
    #[inline]
    pub(crate) fn bound(&self, reached: [f64; 2], total: [f64; 2]) -> f64 {
        let held = reached[1] <= self.integrand.tolerance.max(ATTAINABLE);
        if held { total[0].max(total[1]) } else { total[0] }
    }

    /// Refuses errors above the tolerance.
    pub(crate) fn check(
        &self,
        errors: [f64; 2],
        evaluations: usize,
        slope: bool,
    ) -> Result<(), QuadratureError> {
        let reached = if slope { errors[0].max(errors[1]) } else { errors[0] };
        if reached <= self.integrand.tolerance.max(ATTAINABLE) {
            return Ok(());
        }
        Err(QuadratureError::missed(reached, self.integrand.tolerance, evaluations))
    }

    /// The d above which the integral is 0: the top of the weight is below the density's beginning.
    pub(crate) fn end(&self, weight: &Weight) -> f64 {
        weight.top() - self.first() * self.integrand.unit
    }

    fn first(&self) -> f64 {
        self.integrand.kinks.first().copied().unwrap_or(0.0)
    }

    pub(crate) fn find(
        &self,
        weight: &Weight,
        d: f64,
        slope: bool,
    ) -> Result<Sums, QuadratureError> {
        let start = d + self.first() * self.integrand.unit;
        if start >= weight.top() || self.integrand.density.pieces.is_empty() {
            return Ok(Sums::default());
        }
        if let Some(above) = weight.faint.filter(|faint| start >= *faint) {
            return Err(weight.source.fault(WeightFault::Faint { above }));
        }
        let peak = weight.peak_above(start)?;
        let ln_scale = if peak.abs() > SCALED && peak.is_finite() { peak } else { 0.0 };
        let Integrand { density, unit, .. } = &self.integrand;
        let view = View { density, d, unit: *unit, ln_scale };
        let mut run = Run::new(&self.integrand, weight, view, start);
        run.everything()?;
        let places = self.jumps_over(weight, d, &mut run)?;
        run.refine(slope)?;
        let mut found = Sums { ln_scale, ..run.found };
        let unknown = found.sizes[0] == 0.0 || found.errors[0] > 0.5 * found.sizes[0];
        if unknown && run.nonzero && weight.top() == f64::INFINITY {
            return Err(weight.source.fault(WeightFault::Faint { above: start }));
        }
        let sizes = found.sizes;
        let relative = |n: usize, error: f64| if sizes[n] > 0.0 { error / sizes[n] } else { 0.0 };
        found.errors = [0, 1].map(|n| relative(n, found.errors[n]));
        // The rounding of places acts as a shift of the density.
        let shift = f64::EPSILON * (d.abs() + 2.0 * relative(1, sizes[0]));
        let steepness = relative(0, sizes[1]);
        let own = self.integrand.density.relative_error(&run.sampled);
        found.inputs = [0, 1].map(|_| 4.0 * shift * steepness + ROUNDING + own);
        found.inputs[1] += relative(1, places);
        // A weight as small as exp(-1e6) has lost digits, which finer panels do not restore.
        for (error, input) in found.errors.iter_mut().zip(&mut found.inputs) {
            let part = run.noise.min(*error);
            *error -= part;
            *input += part;
        }
        Ok(found)
    }

    /// Adds the jumps of the density to the slope; the error they have from rounded places.
    fn jumps_over(
        &self,
        weight: &Weight,
        d: f64,
        run: &mut Run<'_>,
    ) -> Result<f64, QuadratureError> {
        let jumps = self.jumps.get_or_init(|| self.jumps()).as_ref().map_err(Clone::clone)?;
        let mut rounding = 0.0;
        for (&kink, &jump) in self.integrand.kinks.iter().zip(jumps) {
            if jump == 0.0 {
                continue;
            }
            let z = d + kink * self.integrand.unit;
            let g = |z: f64| weight.at(z, run.view.ln_scale);
            let near = 2.0 * f64::EPSILON * z.abs().max(d.abs());
            let (here, below, above) = (g(z)?, g(z - near)?, g(z + near)?);
            run.found.sums[1] += jump * here;
            run.found.sizes[1] += (jump * here).abs();
            rounding += jump.abs() * (above - here).abs().max((here - below).abs());
        }
        Ok(rounding)
    }

    fn jumps(&self) -> Result<Vec<f64>, QuadratureError> {
        let side =
            |x: f64, inside: &dyn Fn(f64, f64) -> bool| self.integrand.density.value(x, inside);
        let jump = |&x: &f64| {
            let at = if x == 0.0 { NEXT_TO_ZERO } else { x };
            let holds = |from: f64, to: f64| from <= x && x < to;
            let mut above = side(at, &holds)?;
            if !f64::is_finite(above) {
                // Some formulas are NaN at the first place.
                above = side(at.next_up(), &holds)?;
            }
            let below = side(x.next_down(), &|from, to| from < x && x <= to)?;
            let jump: f64 = above - below;
            let rounding = 4.0 * f64::EPSILON * above.abs().max(below.abs());
            if !jump.is_finite() {
                return Err(QuadratureError::NotFinite { at: x, value: jump });
            }
            Ok(if jump.abs() > rounding { jump } else { 0.0 })
        };
        self.integrand.kinks.iter().map(jump).collect()
    }
}
