//! The integral of a function from the start of its range, made as far as it is asked for.

use std::f64::consts::PI;
use std::sync::{OnceLock, PoisonError, RwLock};

use asperity_core::{Formula, Part, QuadratureError, Sampler};
use asperity_quadrature::chebyshev_terms;

/// Samples of a piece.
const NODES: usize = 16;
/// The last two terms of a converged piece over its integral; rounding is below.
const TOLERANCE: f64 = 4e-15;
/// Pieces of an octave: next to a cusp, and where a function is noisy, halving would not end.
const MOST: usize = 64;
/// Length of a piece over its high end below which it is not halved.
const SHORTEST: f64 = 1e-9;
/// Start of a range from 0, in units of the interference: the integral below is negligible, and
/// pieces that double do not start at 0.
const LEAST: f64 = 1e-30;

/// ∫ f dx from the start of a part, plus a value: Chebyshev series on pieces each of which ends at
/// twice its start, halved where they do not converge; next to the start in the root of the
/// distance from it, of which f may have odd powers.
pub(crate) struct Antiderivative {
    form: Formula,
    start: f64,
    end: f64,
    kinks: Vec<f64>,
    before: f64,
    pieces: RwLock<Vec<Piece>>,
}

/// The integral on a range.
struct Piece {
    low: f64,
    high: f64,
    in_root: bool,
    terms: [f64; NODES + 1],
    /// At the high end.
    value: f64,
    /// Of all pieces up to this one, relative.
    error: f64,
}

impl Antiderivative {
    pub(crate) fn new(part: &Part, before: f64) -> Self {
        Self {
            form: part.form.clone(),
            start: part.range.start.max(LEAST),
            end: part.range.end,
            kinks: part.kinks.clone(),
            before,
            pieces: RwLock::default(),
        }
    }

    /// The rise up to x; NaN where the function has no value.
    pub(crate) fn rise(&self, x: f64) -> f64 {
        let mut value = [0.0];
        self.sample(&[x], &mut value).map_or(f64::NAN, |()| value[0] - self.before)
    }

    /// Makes the pieces up to x.
    fn extend(&self, x: f64) -> Result<(), QuadratureError> {
        let reached = |pieces: &[Piece]| pieces.last().map_or(self.start, |piece| piece.high);
        if reached(&self.pieces.read().unwrap_or_else(PoisonError::into_inner)) >= x.min(self.end) {
            return Ok(());
        }
        let mut pieces = self.pieces.write().unwrap_or_else(PoisonError::into_inner);
        while reached(&pieces) < x.min(self.end) {
            let low = reached(&pieces);
            let kink = self.kinks.iter().copied().find(|kink| *kink > low);
            let high = (2.0 * low).min(self.end).min(kink.unwrap_or(f64::INFINITY));
            let most = pieces.len() + MOST;
            if self.add((low, high, false), most, &mut pieces)? {
                continue;
            }
            let quarter = 0.75 * low + 0.25 * high;
            let is_first = low <= self.start;
            let is_root = is_first && self.add((low, quarter, true), most, &mut pieces)?;
            self.halve(if is_root { quarter } else { low }, high, most, &mut pieces)?;
        }
        Ok(())
    }

    /// Adds the piece of a range, or returns false if its series does not converge and there may be
    /// more pieces.
    fn add(
        &self,
        (low, high, in_root): (f64, f64, bool),
        most: usize,
        pieces: &mut Vec<Piece>,
    ) -> Result<bool, QuadratureError> {
        let (rule, length) = (rule(), high - low);
        let share = |u: f64| 0.5 + 0.5 * u;
        let x = |u: f64| low + length * if in_root { share(u) * share(u) } else { share(u) };
        let mut samples = [0.0; NODES];
        self.form.sample(&rule.nodes.map(x), &mut samples)?;
        let mut terms = [0.0; NODES + 1];
        for ((sample, row), node) in samples.iter().zip(&rule.rows).zip(rule.nodes) {
            let slope = if in_root { length * share(node) } else { 0.5 * length };
            terms.iter_mut().zip(row).for_each(|(term, share)| *term += slope * sample * share);
        }
        let gained: f64 = terms.iter().sum();
        let own = (terms[NODES].abs() + terms[NODES - 1].abs()) / gained.abs();
        // NaN: the integral is 0 or overflows, and halving does not help.
        let converges = own.is_nan() || own <= TOLERANCE;
        if converges || pieces.len() >= most || length < SHORTEST * high {
            let (value, error) =
                pieces.last().map_or((self.before, 0.0), |before| (before.value, before.error));
            terms[0] += value;
            let error = if converges { error } else { error.max(own) };
            pieces.push(Piece { low, high, in_root, terms, value: value + gained, error });
            return Ok(true);
        }
        Ok(false)
    }

    /// Adds the pieces of both halves of a range.
    fn halve(
        &self,
        low: f64,
        high: f64,
        most: usize,
        pieces: &mut Vec<Piece>,
    ) -> Result<(), QuadratureError> {
        let middle = 0.5 * (low + high);
        for (low, high) in [(low, middle), (middle, high)] {
            if !self.add((low, high, false), most, pieces)? {
                self.halve(low, high, most, pieces)?;
            }
        }
        Ok(())
    }
}

impl Sampler for Antiderivative {
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        self.extend(x.last().copied().unwrap_or(0.0))?;
        let pieces = self.pieces.read().unwrap_or_else(PoisonError::into_inner);
        for (out, x) in out.iter_mut().zip(x) {
            let piece = pieces.get(pieces.partition_point(|piece| piece.high < *x));
            let is_above = |_: &&Piece| *x > self.start;
            *out = piece.filter(is_above).map_or(self.before, |piece| piece.at(*x));
        }
        Ok(())
    }

    fn slope(&self, x: &[f64], out: &mut [f64]) -> bool {
        self.form.sample(x, out).is_ok()
    }

    fn relative_error(&self, x: &[f64]) -> f64 {
        let last = x.last().copied().unwrap_or(0.0);
        let pieces = self.pieces.read().unwrap_or_else(PoisonError::into_inner);
        let piece = pieces.get(pieces.partition_point(|piece| piece.high < last));
        TOLERANCE + piece.map_or(0.0, |piece| piece.error) + self.form.relative_error(x)
    }
}

impl Piece {
    /// By Clenshaw's recurrence.
    fn at(&self, x: f64) -> f64 {
        let share = (x - self.low) / (self.high - self.low);
        let u = 2.0 * if self.in_root { share.sqrt() } else { share } - 1.0;
        let (mut one, mut two) = (0.0, 0.0);
        for term in self.terms[1..].iter().rev() {
            (one, two) = (term + 2.0 * u * one - two, one);
        }
        self.terms[0] + u * one - two
    }
}

/// From samples on [-1, 1] to the series of their integral from -1.
struct Rule {
    /// Ascending.
    nodes: [f64; NODES],
    rows: [[f64; NODES + 1]; NODES],
}

fn rule() -> &'static Rule {
    static RULE: OnceLock<Rule> = OnceLock::new();
    RULE.get_or_init(|| {
        let node = |k: usize| -(PI * (k as f64 + 0.5) / NODES as f64).cos();
        let row = |k: usize| {
            // Roots descend.
            let one: Vec<f64> = (0..NODES).map(|j| f64::from(j + k + 1 == NODES)).collect();
            let mut of = chebyshev_terms(&one);
            of[0] *= 2.0;
            of.extend([0.0, 0.0]);
            let mut terms = [0.0; NODES + 1];
            let mut sign = 1.0;
            for j in 1..=NODES {
                terms[j] = (of[j - 1] - of[j + 1]) / (2.0 * j as f64);
                terms[0] += sign * terms[j];
                sign = -sign;
            }
            terms
        };
        Rule { nodes: std::array::from_fn(node), rows: std::array::from_fn(row) }
    })
}
