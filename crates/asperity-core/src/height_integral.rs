//! I(s) = ∫₀^∞ q(t/c) g(s + t) dt for each kind of heights g: one door for the engine.

use std::sync::{Arc, OnceLock};

use asperity_quadrature::{
    Curvature, Density, Discretised, Moments, QuadratureError, ShiftedGaussian, discretise,
};

use crate::{HeightDistribution, Heights};

/// Densities are followed down to exp(-CUT) of their largest value: 1e-20.
const CUT: f64 = 46.0;
/// Rounding of a sum of masses; 9e-15 was seen at s = -30, where z - s is taken of large numbers.
const ROUNDING: f64 = 2e-14;

/// The integral of one density over one kind of heights, for all s.
#[derive(Debug)]
pub(crate) enum HeightIntegral {
    Gaussian(ShiftedGaussian),
    Exponential(Exponential),
    Other(Other),
}

impl HeightIntegral {
    /// `scale` is c, the interference unit over σ_z.
    pub(crate) fn new(
        density: Density,
        scale: f64,
        heights: &HeightDistribution,
        tolerance: f64,
    ) -> Self {
        match heights {
            HeightDistribution::Gaussian => {
                Self::Gaussian(ShiftedGaussian::new(density, scale, tolerance))
            }
            HeightDistribution::Exponential => {
                Self::Exponential(Exponential { density, scale, tolerance, above: OnceLock::new() })
            }
            HeightDistribution::Other(heights) => {
                Self::Other(Other { density, scale, tolerance, heights: heights.clone() })
            }
        }
    }

    /// Nodes of the rule for s; `None` where there are no rules.
    pub(crate) fn nodes(&self, s: f64) -> Result<Option<usize>, QuadratureError> {
        match self {
            Self::Gaussian(integral) => integral.nodes(s).map(Some),
            _ => Ok(None),
        }
    }

    /// How often the density has been sampled for rules.
    pub(crate) fn samples(&self) -> usize {
        match self {
            Self::Gaussian(integral) => integral.evaluations(),
            _ => 0,
        }
    }

    /// I(s) alone; only what is asked is summed where that saves work.
    pub(crate) fn value(&self, s: f64) -> Result<Moments, QuadratureError> {
        match self {
            Self::Gaussian(integral) => integral.value(s),
            _ => self.at(s),
        }
    }

    /// d²I/ds², where it comes of the nodes.
    pub(crate) fn curvature(&self, s: f64) -> Option<Result<Curvature, QuadratureError>> {
        match self {
            Self::Gaussian(integral) => Some(integral.curvature(s)),
            _ => None,
        }
    }

    /// I(s) and -dI/ds.
    pub(crate) fn at(&self, s: f64) -> Result<Moments, QuadratureError> {
        match self {
            Self::Gaussian(integral) => integral.at(s),
            Self::Exponential(integral) => integral.at(s),
            Self::Other(integral) => integral.at(s),
        }
    }
}

fn sum(masses: &Discretised) -> (f64, f64) {
    (masses.masses.iter().sum(), masses.masses.iter().map(|m| m.abs()).sum())
}

fn relative(masses: &Discretised, size: f64, density: &Density) -> f64 {
    let error = if size > 0.0 { 4.0 * masses.error / size } else { 0.0 };
    error + ROUNDING + density.relative_error(&masses.points)
}

/// Exponential heights: for s ≥ 0 one integral serves all s, I(s) = I(0) exp(-s).
#[derive(Debug)]
pub(crate) struct Exponential {
    density: Density,
    scale: f64,
    tolerance: f64,
    above: OnceLock<Result<Moments, QuadratureError>>,
}

impl Exponential {
    fn at(&self, s: f64) -> Result<Moments, QuadratureError> {
        if s < 0.0 {
            return self.integrate(s);
        }
        let at_zero =
            self.above.get_or_init(|| self.integrate(0.0)).as_ref().map_err(Clone::clone)?;
        Ok(Moments { ln_scale: -s, ..*at_zero })
    }

    /// s ≤ 0: heights begin at ζ = 0, interferences at -s; moving the surface by ds also moves
    /// that beginning, so -dI/ds = I - q(-s).
    fn integrate(&self, s: f64) -> Result<Moments, QuadratureError> {
        let window = (-s / self.scale, (CUT - s) / self.scale);
        let edges = [0.02, 0.07, 0.2, 0.45, 0.7].map(|share| (share * CUT - s) / self.scale);
        let weight = |x: f64| (-(s + x * self.scale)).exp() * self.scale;
        // s + x c is a difference of large numbers: far below, the weight is known no better.
        let rounding = f64::EPSILON * s.abs();
        let tolerance = (0.1 * self.tolerance).max(16.0 * rounding);
        let masses = discretise(&self.density, window, &edges, &weight, tolerance)?;
        let (value, size) = sum(&masses);
        let lowest = if s < 0.0 { point(&self.density, -s / self.scale)? } else { 0.0 };
        Ok(Moments {
            value,
            slope: value - lowest,
            sizes: [size, size + lowest.abs()],
            ln_scale: 0.0,
            error: relative(&masses, size, &self.density) + rounding,
        })
    }
}

/// The density at one point.
fn point(density: &Density, x: f64) -> Result<f64, QuadratureError> {
    let mut total = 0.0;
    for piece in density.pieces.iter().filter(|p| p.from <= x && x < p.to) {
        let mut value = [0.0];
        piece.sampler.sample(&[x], &mut value)?;
        total += piece.sign * value[0];
    }
    Ok(total)
}

/// The heights that count for one s.
struct Window {
    low: f64,
    high: f64,
    /// Logarithm of the largest density.
    peak: f64,
    /// Variation of the density over its integral.
    steepness: f64,
}

/// Where a density on an interval is looked at, beside its breaks.
const STEPS: u32 = 64;

/// Any other heights: each s is integrated anew, on panels that end at the kinks of the law and
/// at the breaks of the density.
#[derive(Debug)]
pub(crate) struct Other {
    density: Density,
    scale: f64,
    tolerance: f64,
    heights: Arc<dyn Heights>,
}

impl Other {
    fn at(&self, s: f64) -> Result<Moments, QuadratureError> {
        let Some(Window { low, high, peak: ln_scale, steepness }) = self.window(s) else {
            // No asperity is as high as the flat: there is no contact, and that is exact.
            let none =
                Moments { value: 0.0, slope: 0.0, sizes: [0.0; 2], ln_scale: 0.0, error: 0.0 };
            return Ok(none);
        };
        let mut edges: Vec<f64> = self.heights.breaks().to_vec();
        let width = high - low;
        edges.extend([0.004, 0.02, 0.06, 0.15, 0.3, 0.5, 0.75].map(|share| low + share * width));
        edges.sort_by(f64::total_cmp);
        edges.iter_mut().for_each(|z| *z = (*z - s) / self.scale);
        let weight =
            |x: f64| (self.heights.ln_density(s + x * self.scale) - ln_scale).exp() * self.scale;
        let window = ((low - s) / self.scale, (high - s) / self.scale);
        // Heights are rounded against zero: that counts next to the top, and in steep densities.
        let unit = f64::EPSILON * s.abs().max(high.abs());
        let rounding = 16.0 * unit * steepness;
        let tolerance = (0.1 * self.tolerance).max(rounding).max(1e-15);
        let masses = discretise(&self.density, window, &edges, &weight, tolerance)?;
        let (value, size) = sum(&masses);
        let (slope, slope_size) = self.slope(s, ln_scale, &masses)?;
        Ok(Moments {
            value,
            slope,
            sizes: [size, slope_size],
            ln_scale,
            error: relative(&masses, size, &self.density)
                + self.heights.error()
                + if size > 0.0 { unit * slope_size / size } else { 0.0 },
        })
    }

    /// -dI/ds = -∫ q g' - Σ (jump of g at z) q(z - s), with the size of its terms.
    fn slope(
        &self,
        s: f64,
        ln_scale: f64,
        masses: &Discretised,
    ) -> Result<(f64, f64), QuadratureError> {
        let (mut slope, mut size) = (0.0, 0.0);
        for (x, mass) in masses.points.iter().zip(&masses.masses) {
            let term = -mass * self.heights.ln_density_slope(s + x * self.scale);
            slope += term;
            size += term.abs();
        }
        let (low, high) = self.heights.support();
        let ends = [low, high].into_iter().chain(self.heights.breaks().iter().copied());
        for z in ends.filter(|z| z.is_finite() && *z > s) {
            let side = |z: f64| (self.heights.ln_density(z) - ln_scale).exp();
            let jump = side(z.next_up()) - side(z.next_down());
            if jump != 0.0 {
                let term = -jump * point(&self.density, (z - s) / self.scale)?;
                slope += term;
                size += term.abs();
            }
        }
        Ok((slope, size))
    }

    /// The heights that count.
    fn window(&self, s: f64) -> Option<Window> {
        let (bottom, top) = self.heights.support();
        let low = s.max(bottom);
        if low >= top {
            return None;
        }
        let ln = |z: f64| self.heights.ln_density(z);
        if top.is_finite() {
            return self.interval(low, top);
        }
        // Steps that double from a small one find the largest density, and where it has fallen by
        // exp(-CUT); refinement makes up for their coarseness.
        let mut seen = vec![];
        let mut peak = f64::NEG_INFINITY;
        let mut high = low;
        let mut step = 1e-3 / (1.0 + low.abs());
        for _ in 0..1000 {
            let reached = high;
            high += step;
            let here = ln(high);
            peak = peak.max(here);
            seen.push((reached, high, here));
            if here < peak - CUT && high > 1.0 {
                break;
            }
            // From far below, steps shrink again on the way to the mean, or would miss all of it.
            step = (1.25 * step).min(0.5 + 0.1 * high.abs());
        }
        // What lies as far below the peak counts as little.
        let low =
            seen.iter().find(|(.., ln)| *ln >= peak - CUT).map_or(low, |(before, ..)| *before);
        let (mut variation, mut area, mut last) = (0.0, 0.0, 0.0f64);
        for (from, to, ln) in seen {
            let here = (ln - peak).exp();
            variation += (here - last).abs();
            area += here * (to - from);
            last = here;
        }
        let steepness = if area > 0.0 { variation / area } else { 0.0 };
        peak.is_finite().then_some(Window { low, high, peak, steepness })
    }

    /// A density on an interval may fall and rise again, as measured ones do: nothing of it is left
    /// out.
    fn interval(&self, low: f64, high: f64) -> Option<Window> {
        let steps = (0..=STEPS).map(|k| low + (high - low) * f64::from(k) / f64::from(STEPS));
        let beside = self.heights.breaks().iter().flat_map(|z| [z.next_down(), *z]);
        let end = high.next_down();
        let mut inside: Vec<f64> =
            steps.map(|z| z.min(end)).chain(beside.filter(|z| *z >= low && *z <= end)).collect();
        // Two ascending runs: that is quick.
        inside.sort_by(f64::total_cmp);
        let ln: Vec<f64> = inside.iter().map(|z| self.heights.ln_density(*z)).collect();
        let peak = ln.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let (mut variation, mut area) = (0.0, 0.0);
        for (z, ln) in inside.windows(2).zip(ln.windows(2)) {
            let (a, b) = ((ln[0] - peak).exp(), (ln[1] - peak).exp());
            variation += (b - a).abs();
            area += 0.5 * (a + b) * (z[1] - z[0]);
        }
        let steepness = if area > 0.0 { variation / area } else { 0.0 } + 1.0 / (high - low);
        peak.is_finite().then_some(Window { low, high, peak, steepness })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Law, Power, StandardisedHeights};
    use statrs::distribution::Normal;

    /// ∫ t g(s + t) dt far below is the mean of z - s.
    fn linear(heights: HeightDistribution, s: f64) -> Moments {
        let law = Law::in_units(1.0, 1.0).elastic(0.0..f64::INFINITY, [Power::new(1.0, 1.0)]);
        HeightIntegral::new(law.density(), 1.0, &heights, 1e-13).at(s).unwrap()
    }

    #[test]
    fn no_heights_are_missed_from_far_below_them() {
        let normal = StandardisedHeights::new("normal", Normal::new(0.0, 1.0).unwrap()).unwrap();
        let normal = HeightDistribution::other(normal);
        for s in [-10.0, -100.0, -1e3, -1e4, -1e6] {
            for (heights, mean) in [(&normal, 0.0), (&HeightDistribution::Exponential, 1.0)] {
                let found = linear(heights.clone(), s);
                let error = (found.value * found.ln_scale.exp() / (mean - s) - 1.0).abs();
                assert!(error < found.error && found.error < 1e-7, "{s}: {found:?}");
            }
        }
    }
}
