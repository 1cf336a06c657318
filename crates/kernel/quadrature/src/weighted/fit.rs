//! Panels of a weight from its logarithm, by bisection between its breaks.

use super::panel::{Panel, RANGE, Series, Shape, end_shares};
use super::source::Source;
use crate::chebyshev::extent;
use crate::chebyshev::lobatto::{NODES, Samples, lobatto};
use crate::{QuadratureError, WeightFault};

/// Largest error of a logarithm, apart from rounding.
const GOOD: f64 = 1e-13;
/// Rounding of logarithms, and of places at steep ones, in units of the last place.
const ROUNDED: f64 = 16.0;
/// The share of the truncated terms that affects integrals: polynomials of degree 16 and more
/// change sign often.
const SEEN: f64 = 0.125;
/// Panels far out, smaller than exp(-SMALL) of the largest value, may vary by more than RANGE.
const SMALL: f64 = 60.0;
/// The logarithm of a panel far out varies by no more than this multiple of its largest value, or
/// the rounding of its smallest one hides the digits of the largest.
const FALL: f64 = 4.0;
/// The share of an interval that is too short for a kink inside to matter,
const SLIVER: f64 = 1e-15;
/// and its width in units of the last place.
const ULPS: f64 = 64.0;
/// After this number of halvings in a row that do not help, the error is taken for noise,
const STALLED: u32 = 2;
/// if it is below this, or if the weight is small.
const NOISE: f64 = 1e-6;
/// A weight that needs more samples is refused.
const MOST: usize = 400_000;
/// A weight smaller than exp(-FAINT) of its largest value is left out next to an end, and may be
/// noisy elsewhere, as the logarithms of densities that underflow are.
pub(crate) const FAINT: f64 = 600.0;
/// With lower powers of the distance, too much of the weight is at distances below the rounding of
/// places.
const LOWEST_POWER: f64 = -0.95;
/// The largest uncertain mass of a sliver.
const HIDDEN: f64 = 1e-12;

/// The panels and kinks of a weight found so far.
pub(crate) struct Fitter<'s> {
    source: &'s Source,
    pub(crate) panels: Vec<Panel>,
    /// Undeclared kinks and jumps.
    pub(crate) kinks: Vec<f64>,
    /// The place above which the weight was left out.
    pub(crate) faint: Option<f64>,
    /// Whether this is the bulk of the weight.
    near: bool,
    samples: usize,
    peak: f64,
}

/// Samples on a panel, with their series.
struct PanelFit {
    low: f64,
    high: f64,
    samples: Samples,
    series: Series,
    error: f64,
    /// The error is not much above rounding.
    resolved: bool,
    /// The weight varies too much over the panel.
    steep: bool,
}

impl PanelFit {
    /// The logarithm at a place.
    fn ln(&self, z: f64) -> f64 {
        self.series.ln((z - self.low) / (self.high - self.low))
    }
}

impl<'s> Fitter<'s> {
    /// `peak` is the largest logarithm so far.
    pub(crate) fn new(source: &'s Source, near: bool, peak: f64) -> Self {
        Self { source, panels: vec![], kinks: vec![], faint: None, near, samples: 0, peak }
    }

    fn ln(&mut self, z: f64) -> Result<f64, QuadratureError> {
        self.samples += 1;
        if self.samples > MOST {
            return Err(self.source.fault(WeightFault::Wild { at: z }));
        }
        let value = (self.source.ln)(z);
        if value.is_nan() {
            return Err(self.source.fault(WeightFault::Value { at: z, value }));
        }
        if value < f64::INFINITY {
            self.peak = self.peak.max(value);
        }
        Ok(value)
    }

    /// Between two neighbouring breaks or ends.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> Result<(), QuadratureError> {
        if !self.linear(low, high)? {
            let middle = 0.5 * (low + high);
            self.beside(low, middle)?;
            self.beside(high, middle)?;
        }
        Ok(())
    }

    /// Whether the weight is linear, and then its panel.
    fn linear(&mut self, low: f64, high: f64) -> Result<bool, QuadratureError> {
        const AT: [f64; 4] = [0.125, 0.375, 0.625, 0.875];
        let mut g = [0.0; 4];
        for (g, share) in g.iter_mut().zip(AT) {
            *g = self.ln(low + (high - low) * share)?.exp();
        }
        let largest = g.iter().copied().fold(0.0, f64::max);
        let slope = (g[3] - g[0]) / 0.75;
        let at = |share: f64| g[0] + slope * (share - AT[0]);
        // Rounding of large logarithms, and of places in a steep panel.
        let size = 1.0 + (g[0] / largest).ln().abs().min(1.0) + largest.ln().abs();
        let place = low.abs().max(high.abs()) / (high - low);
        let rounding = 4.0 * f64::EPSILON * (size + place * (g[3] - g[0]).abs() / largest);
        let mut off = (g[1] - at(AT[1])).abs().max((g[2] - at(AT[2])).abs());
        // A kink next to an end affects samples at the end alone.
        for (end, other) in [(low, high), (high, low)] {
            let place = next_to(end, other);
            off = off.max((self.ln(place)?.exp() - at((place - low) / (high - low))).abs());
        }
        if largest == 0.0
            || !largest.is_finite()
            || off.is_nan()
            || off > rounding.min(1e-9) * largest
        {
            return Ok(false);
        }
        let end = |g: f64| if g < 8.0 * rounding * largest { 0.0 } else { g };
        let ends = [end(at(0.0)), end(at(1.0))];
        // Distances start at the smaller weight, which differences would round.
        let panel = if ends[0] <= ends[1] {
            Panel::new(low, high, Shape::Linear(ends), off / largest)
        } else {
            let shape = Shape::Linear([ends[1], ends[0]]);
            Panel { anchor: high, side: -1.0, ..Panel::new(low, high, shape, off / largest) }
        };
        self.panels.push(panel);
        Ok(true)
    }

    /// From a break or an end to a place below or above it: panels get shorter until a power of the
    /// distance times a series fits the one at the end.
    pub(crate) fn beside(&mut self, end: f64, far: f64) -> Result<(), QuadratureError> {
        let top = (far - end).abs();
        let mut far = far;
        // Kinks between the end and the nearest sample affect samples at the end alone.
        let place = next_to(end, far);
        let nearest = Nearest { distance: (place - end).abs(), ln: self.ln(place)? };
        loop {
            let width = (far - end).abs();
            let fit = self.fit(end.min(far), end.max(far), true)?;
            if fit.resolved && (fit.steep || nearest.agrees(fit.ln(place), 0.0, self.peak)) {
                return self.plain(fit, top, 0);
            }
            let (_, most) = range(&fit.samples);
            let faint = most < self.peak - FAINT;
            if faint || width <= ULPS * f64::EPSILON * end.abs() || width <= 1e-36 * top {
                let ln = self.ln(far)?;
                return self.last(end, far, ln, faint);
            }
            if let Some(panel) = self.at_end(end, far, nearest)? {
                self.panels.push(panel);
                return Ok(());
            }
            let nearer = end + 0.25 * (far - end);
            let rest = self.fit(nearer.min(far), nearer.max(far), false)?;
            self.plain(rest, top, 0)?;
            far = nearer;
        }
    }

    /// The interval left between an end and a place next to it.
    fn last(&mut self, end: f64, far: f64, ln: f64, faint: bool) -> Result<(), QuadratureError> {
        let width = (far - end).abs();
        let mut shape = Shape::Zero;
        if faint {
            if end > far && ln > f64::NEG_INFINITY {
                self.faint = Some(self.faint.unwrap_or(far).min(far));
            }
        } else if ln.exp() * width > HIDDEN {
            return Err(self.source.fault(WeightFault::Pole { at: end }));
        } else {
            shape = Shape::Linear([ln.exp(); 2]);
        }
        self.panels.push(Panel::new(end.min(far), end.max(far), shape, 0.0));
        Ok(())
    }

    /// A panel with a power of the distance to an end, if the weight has one there.
    fn at_end(
        &mut self,
        end: f64,
        far: f64,
        nearest: Nearest,
    ) -> Result<Option<Panel>, QuadratureError> {
        let (mut samples, mut moved) = ([0.0; NODES], [0.0; NODES]);
        for ((sample, moved), share) in samples.iter_mut().zip(&mut moved).zip(end_shares()) {
            let place = end + (far - end) * share;
            *sample = self.ln(place)?;
            // Next to an end, rounding moves a place by a known share of the distance.
            *moved = (share / ((place - end) / (far - end))).ln();
            if sample.is_infinite() || !moved.is_finite() {
                return Ok(None);
            }
        }
        let power = Series::beside_an_end(&samples).0.power;
        samples.iter_mut().zip(moved).for_each(|(sample, moved)| *sample += power * moved);
        let (series, error) = Series::beside_an_end(&samples);
        // The nearest sample is a thousandth of the panel away from the end.
        let width = (far - end).abs();
        let place = 4e3 * f64::EPSILON * end.abs() / width * series.power.abs();
        let smooth = |k: usize| samples[k] - series.power * end_shares()[k].ln();
        let (least, most) = extent((0..NODES).map(smooth));
        let largest = samples.iter().fold(0.0, |m: f64, s| m.max(s.abs()));
        let allowed = 10.0 * GOOD + place + ROUNDED * f64::EPSILON * largest;
        // A negligible mass matters only where the density sees nothing else; its error is kept.
        let mass = samples[NODES - 1].exp() * width / (1.0 + series.power);
        let good = (error <= allowed || error < NOISE && error * mass <= SLIVER)
            && series.power > LOWEST_POWER
            && most - least <= RANGE;
        let power = series.power;
        let panel = Panel {
            low: end.min(far),
            high: end.max(far),
            anchor: end,
            side: if far > end { 1.0 } else { -1.0 },
            shape: Shape::Series(series),
            error,
        };
        let agrees = nearest.agrees(panel.ln(nearest.distance), power, self.peak);
        Ok((good && agrees).then_some(panel))
    }

    /// Samples of a panel and their series; beside an end, infinite samples are accepted.
    fn fit(&mut self, low: f64, high: f64, beside: bool) -> Result<PanelFit, QuadratureError> {
        let mut samples = [0.0; NODES];
        for (sample, share) in samples.iter_mut().zip(&lobatto().nodes) {
            let at = low + (high - low) * share;
            let value = self.ln(at)?;
            if value == f64::INFINITY && !beside {
                return Err(self.source.fault(WeightFault::Value { at, value }));
            }
            *sample = value;
        }
        let (series, mut error) = Series::plain(&samples);
        let (least, most) = range(&samples);
        let largest = least.abs().max(most.abs());
        let place = low.abs().max(high.abs()) / (high - low);
        let rounding = ROUNDED * f64::EPSILON * (largest + place * (most - least));
        let zero = most == f64::NEG_INFINITY;
        if zero {
            error = 0.0;
        } else if !(error <= 1.0 && most < f64::INFINITY && least > f64::NEG_INFINITY) {
            error = 1.0;
        }
        // In a short panel a pole may look like rounding, but its mass is large.
        let hidden = error > NOISE && error * most.exp() * (high - low) > HIDDEN;
        let resolved = zero || error < 1.0 && error <= GOOD + rounding && !hidden;
        let steep = self.near && most - least > RANGE && most > self.peak - SMALL
            || most - least > FALL * most.abs().max(SMALL) && most > f64::NEG_INFINITY;
        Ok(PanelFit { low, high, samples, series, error, resolved, steep })
    }

    /// A panel without a power at its ends, halved until it is resolved.
    fn plain(&mut self, fit: PanelFit, top: f64, stalled: u32) -> Result<(), QuadratureError> {
        let width = fit.high - fit.low;
        let (least, most) = range(&fit.samples);
        let small = fit.error < NOISE || most < self.peak - FAINT;
        let noise = small && stalled >= STALLED;
        if !fit.steep && (fit.resolved || noise) {
            let shape = match (most == f64::NEG_INFINITY, least == f64::NEG_INFINITY) {
                (true, _) => Shape::Zero,
                // Next to the underflow, where the values have no digits.
                (false, true) => Shape::Linear([most.exp(); 2]),
                _ => Shape::Series(fit.series),
            };
            self.panels.push(Panel::new(fit.low, fit.high, shape, SEEN * fit.error));
            return Ok(());
        }
        let short = width <= ULPS * f64::EPSILON * fit.low.abs().max(fit.high.abs());
        // A kink needs no better place than its effect on integrals requires.
        let doubt = fit.error * width;
        let (narrow, light) = (doubt <= SLIVER * top, doubt * most.exp() <= SLIVER);
        if short || !fit.resolved && narrow && light {
            if doubt * most.exp() > HIDDEN {
                return Err(self.source.fault(WeightFault::Pole { at: fit.low }));
            }
            // A series, if there is one, sets the error; a line may be far worse.
            let ends = [fit.samples[0].exp(), fit.samples[NODES - 1].exp()];
            let one = fit.error < 1.0;
            let shape = if one { Shape::Series(fit.series) } else { Shape::Linear(ends) };
            self.panels.push(Panel::new(fit.low, fit.high, shape, fit.error));
            self.kinks.push(0.5 * (fit.low + fit.high));
            return Ok(());
        }
        let middle = 0.5 * (fit.low + fit.high);
        let halves = [self.fit(fit.low, middle, false)?, self.fit(middle, fit.high, false)?];
        // A kink or a jump remains in one half, noise in both, where halving does not help.
        let noisy =
            !fit.resolved && halves.iter().map(|half| half.error).sum::<f64>() > 1.5 * fit.error;
        for half in halves {
            self.plain(half, top, if noisy { stalled + 1 } else { 0 })?;
        }
        Ok(())
    }

    /// Between two places without a break, in any order.
    pub(crate) fn octave(&mut self, a: f64, b: f64) -> Result<(), QuadratureError> {
        let fit = self.fit(a.min(b), a.max(b), false)?;
        self.plain(fit, (a - b).abs(), 0)
    }
}

/// A place so near to an end of an interval that the part between them is negligible, but far
/// enough for its distance to have digits.
fn next_to(end: f64, other: f64) -> f64 {
    let width = other - end;
    end + width.signum() * (ULPS * f64::EPSILON * end.abs()).max(SLIVER * width.abs())
}

/// The sample next to an end.
#[derive(Clone, Copy)]
struct Nearest {
    distance: f64,
    ln: f64,
}

impl Nearest {
    /// Whether a logarithm fitted farther away agrees with this one, up to the rounding of the
    /// distance of which the weight is a power, or both are below exp(-FAINT) of the peak.
    fn agrees(&self, fitted: f64, power: f64, peak: f64) -> bool {
        let faint = self.ln.max(fitted) < peak - FAINT;
        faint || (self.ln - fitted).abs() <= NOISE * (1.0 + fitted.abs()) + 0.05 * power.abs()
    }
}

fn range(samples: &Samples) -> (f64, f64) {
    extent(samples.iter().copied())
}
