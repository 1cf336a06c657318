//! The course of the force between two separations, from its values and slopes at both ends and its
//! variation.

use asperity_quadrature::Moments;

/// Bound on the error of a cubic, in units of its deviation in the middle.
const TRUST: f64 = 4.0;

/// The integral of the force, and of its variation, at s.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sample {
    pub(crate) s: f64,
    pub(crate) force: Moments,
    pub(crate) variation: Moments,
}

/// A force: its sign (0 for no force) and the logarithm of its integral's absolute value.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Level {
    pub(crate) sign: f64,
    pub(crate) ln: f64,
}

impl Level {
    /// In units of exp(`ln_scale`), limited to the range of f64.
    pub(crate) fn over(self, ln_scale: f64) -> f64 {
        self.sign * (self.ln - ln_scale).min(690.0).exp()
    }
}

impl Sample {
    pub(crate) fn ln_scale(&self) -> f64 {
        self.force.ln_scale.max(self.variation.ln_scale)
    }

    /// Whether no height reaches the law.
    pub(crate) fn is_nothing(&self) -> bool {
        self.variation.value == 0.0
    }

    /// The force as a level.
    pub(crate) fn level(&self) -> Level {
        let Moments { value, ln_scale, .. } = self.force;
        Level {
            sign: if value == 0.0 { 0.0 } else { value.signum() },
            ln: value.abs().ln() + ln_scale,
        }
    }

    /// Whether the force is at least the level, with any other sample.
    pub(crate) fn reaches(&self, level: Level) -> bool {
        self.force.value >= level.over(self.force.ln_scale)
    }

    /// In units of exp(`ln_scale`).
    fn over(&self, ln_scale: f64) -> [Curve; 2] {
        self.tilted(ln_scale, 0.0, self.s)
    }

    /// Times exp(`tilt` · (s - `from`)), in units of exp(`ln_scale`).
    fn tilted(&self, ln_scale: f64, tilt: f64, from: f64) -> [Curve; 2] {
        [&self.force, &self.variation].map(|m| {
            let unit = (m.ln_scale - ln_scale + tilt * (self.s - from)).exp();
            let [values, slopes] = m.sizes.map(|size| m.error * size * unit);
            Curve {
                value: m.value * unit,
                slope: (tilt * m.value - m.slope) * unit,
                errors: [values, slopes + tilt.abs() * values],
            }
        })
    }
}

/// A curve at one place: value and slope, and the bounds of their errors.
#[derive(Debug, Clone, Copy)]
struct Curve {
    value: f64,
    slope: f64,
    errors: [f64; 2],
}

impl Curve {
    fn less(self, level: f64) -> Self {
        Self { value: self.value - level, ..self }
    }
}

/// f + t (c₁ + t (c₂ + t c₃)), t from 0 to 1.
#[derive(Debug, Clone, Copy)]
struct Cubic {
    ends: [f64; 2],
    c: [f64; 3],
}

impl Cubic {
    /// Through values and slopes at two places `h` apart.
    fn new(low: Curve, high: Curve, h: f64) -> Self {
        let rise = high.value - low.value;
        let c2 = 3.0 * rise - h * (2.0 * low.slope + high.slope);
        let c3 = h * (low.slope + high.slope) - 2.0 * rise;
        Self { ends: [low.value, high.value], c: [h * low.slope, c2, c3] }
    }

    /// The course of a function with at most this deviation, a slope off by at most four times and
    /// a second derivative off by at most 24 times as much.
    fn course(&self, off: f64) -> Course {
        let [c1, c2, c3] = self.c;
        let slope = |t: f64| c1 + t * (2.0 * c2 + 3.0 * t * c3);
        let least = |a: f64, b: f64| if a * b > 0.0 { a.abs().min(b.abs()) } else { 0.0 };
        let vertex = (-c2 / (3.0 * c3)).clamp(0.0, 1.0);
        let vertex = if vertex.is_nan() { 0.0 } else { vertex };
        let [start, end] = [slope(0.0), slope(1.0)];
        let straight = least(start, end).min(least(start, slope(vertex))) > 4.0 * off;
        let bends = least(c2, c2 + 3.0 * c3) > 12.0 * off;
        // The deviation from the chord is t (t - 1) (c₂ + c₃ (1 + t)).
        let beside = 0.25 * (c2 + c3).abs().max((c2 + 2.0 * c3).abs());
        let apart = least(self.ends[0], self.ends[1]) > beside + off;
        match (straight, bends) {
            _ if apart => Course::Apart,
            (false, false) => Course::Unknown,
            (true, _) => Course::Monotone,
            _ => Course::OneTurn,
        }
    }
}

/// The force between two separations.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Interval {
    pub(crate) low: Sample,
    pub(crate) high: Sample,
}

/// The course of the force between two separations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Course {
    /// The force does not reach the level.
    Apart,
    /// The force is monotone.
    Monotone,
    /// The force turns at most once.
    OneTurn,
    /// Unknown.
    Unknown,
}

impl Interval {
    /// The parts below and above a sample in it.
    pub(crate) fn parts(self, middle: Sample) -> [Self; 2] {
        [Self { high: middle, ..self }, Self { low: middle, ..self }]
    }

    pub(crate) fn width(&self) -> f64 {
        self.high.s - self.low.s
    }

    /// Too narrow to be halved.
    pub(crate) fn is_narrow(&self) -> bool {
        self.width() <= 8.0 * f64::EPSILON * (1.0 + self.low.s.abs().max(self.high.s.abs()))
    }

    fn ln_scale(&self) -> f64 {
        self.low.ln_scale().max(self.high.ln_scale())
    }

    /// The force less a level at both ends.
    pub(crate) fn ends(&self, level: Level) -> [f64; 2] {
        let (ln_scale, at) = (self.ln_scale(), level.over(self.ln_scale()));
        [self.low, self.high].map(|sample| sample.over(ln_scale)[0].value - at)
    }

    /// Whether the load lies between the forces at both ends.
    pub(crate) fn crosses(&self, level: Level) -> bool {
        self.low.reaches(level) != self.high.reaches(level)
    }

    /// Whether the force at either end equals the level within its error.
    pub(crate) fn touches(&self, level: Level) -> bool {
        let (ln_scale, ends) = (self.ln_scale(), self.ends(level));
        let known =
            |(sample, excess): (&Sample, f64)| excess.abs() <= sample.over(ln_scale)[0].errors[0];
        [&self.low, &self.high].into_iter().zip(ends).any(known)
    }

    /// Bounds of the force less a level, from its variation.
    pub(crate) fn bounds(&self, level: Level) -> [f64; 2] {
        let (ln_scale, at) = (self.ln_scale(), level.over(self.ln_scale()));
        let [[f, v], [g, w]] = [self.low, self.high].map(|sample| sample.over(ln_scale));
        let errors: f64 = [f, v, g, w].iter().map(|curve| curve.errors[0]).sum();
        let middle = 0.5 * (f.value + g.value) - at;
        let reach = 0.5 * (v.value - w.value).max(0.0) + errors;
        [middle - reach, middle + reach]
    }

    /// The course by cubics through both ends, if force and variation in the middle agree with
    /// them. The variation rises at every bump of the force, so that none cancels in a difference.
    pub(crate) fn course(&self, middle: &Sample, level: Level) -> Course {
        self.tilted(middle, level, 0.0)
    }

    /// Whether the force has this sign all along: it keeps it times an exponential that levels the
    /// variation, of which little is left to follow in the tail of the heights.
    pub(crate) fn keeps(&self, sign: f64, middle: &Sample) -> bool {
        let [low, high] =
            [self.low, self.high].map(|s| s.variation.value.ln() + s.variation.ln_scale);
        let none = Level { sign: 0.0, ln: f64::NEG_INFINITY };
        sign * self.low.force.value > 0.0
            && self.tilted(middle, none, (low - high) / self.width()) == Course::Apart
    }

    /// The course of the force times exp(`tilt` · s).
    fn tilted(&self, middle: &Sample, level: Level, tilt: f64) -> Course {
        let (ln_scale, h) = (self.ln_scale(), self.width());
        let at = level.over(ln_scale);
        let [low, high, middle] =
            [&self.low, &self.high, middle].map(|s| s.tilted(ln_scale, tilt, self.low.s));
        let mut off: f64 = 0.0;
        for (a, b, m) in [(low[0], high[0], middle[0]), (low[1], high[1], middle[1])] {
            let value = 0.5 * (a.value + b.value) + h / 8.0 * (a.slope - b.slope);
            let slope = 1.5 * (b.value - a.value) / h - 0.25 * (a.slope + b.slope);
            let [values, slopes] = [0, 1].map(|k| a.errors[k] + b.errors[k] + m.errors[k]);
            let values_off = (m.value - value).abs() - values - h * slopes;
            let slopes_off = 0.25 * h * ((m.slope - slope).abs() - slopes) - values;
            if !(values_off.is_finite() && slopes_off.is_finite()) {
                return Course::Unknown;
            }
            off = off.max(values_off).max(slopes_off);
        }
        Cubic::new(low[0].less(at), high[0].less(at), h).course(TRUST * off)
    }

    /// The force and its slope at a place, both in the scale of the interval.
    pub(crate) fn scaled(&self, moments: &Moments) -> [f64; 2] {
        let unit = (moments.ln_scale - self.ln_scale()).exp();
        [moments.value * unit, -moments.slope * unit]
    }

    pub(crate) fn level(&self, level: Level) -> f64 {
        level.over(self.ln_scale())
    }

    /// Whether the slopes at both ends have different signs.
    pub(crate) fn turns(&self) -> bool {
        self.low.force.slope * self.high.force.slope < 0.0
    }
}
