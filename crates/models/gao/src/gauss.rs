//! A Gauss rule with an estimate of its error, in arrays of fixed length for vector registers.

use asperity_quadrature::legendre;

/// An integral and an estimate of its error.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sum {
    pub(crate) value: f64,
    pub(crate) error: f64,
}

impl Sum {
    /// A lower estimate of the size of the integral, relative to which its pieces must be accurate.
    #[inline(always)]
    pub(crate) fn likely(&self) -> f64 {
        (self.value.abs() - self.error).max(0.0)
    }
}

/// The rule of N nodes on [0, 1].
pub(crate) struct Gauss<const N: usize> {
    pub(crate) nodes: [f64; N],
    pub(crate) weights: [f64; N],
    /// Rows that give the Legendre coefficients of the last three degrees, and of two in the
    /// middle, from samples at the nodes.
    degrees: [[f64; N]; 5],
}

impl<const N: usize> Gauss<N> {
    pub(crate) fn new() -> Self {
        let rule = legendre(N);
        let [nodes, weights] = [&rule.nodes, &rule.weights].map(|v| std::array::from_fn(|k| v[k]));
        let coefficient = |degree: usize, k: usize| {
            let x = 2.0 * rule.nodes[k] - 1.0;
            let (mut before, mut now) = (0.0, 1.0);
            for n in 1..=degree {
                let n = n as f64;
                (before, now) = (now, ((2.0 * n - 1.0) * x * now - (n - 1.0) * before) / n);
            }
            (2.0 * degree as f64 + 1.0) * rule.weights[k] * now
        };
        let degrees = [N - 1, N - 2, N - 3, N / 2, N / 2 - 1];
        let degrees = degrees.map(|d| std::array::from_fn(|k| coefficient(d, k)));
        Self { nodes, weights, degrees }
    }

    /// The integral of a function with these samples, smooth up to the ends. The fall of its series
    /// from degree N/2 to N is geometric; the error starts at degree 2N, after twice that fall.
    #[inline(always)]
    pub(crate) fn sum(&self, samples: &[f64; N]) -> Sum {
        self.estimate(samples, |fall| 10.0 * fall * fall)
    }

    /// The same for a function with a fractional power of the distance to an end: its series falls
    /// as a power of the degree.
    #[inline(always)]
    pub(crate) fn sum_from_power(&self, samples: &[f64; N]) -> Sum {
        self.estimate(samples, |fall| 20.0 * fall)
    }

    #[inline(always)]
    fn estimate(&self, samples: &[f64; N], again: impl Fn(f64) -> f64) -> Sum {
        let [one, two, three, four, five] = &self.degrees;
        let value = dot(&self.weights, samples);
        let tail =
            dot(one, samples).abs().max(dot(two, samples).abs()).max(dot(three, samples).abs());
        let middle = dot(four, samples).abs().max(dot(five, samples).abs());
        // A tail at the level of rounding: the function is resolved.
        if tail <= 1e-15 * value.abs() {
            return Sum { value, error: 0.0 };
        }
        let fall = (tail / middle.max(f64::MIN_POSITIVE)).min(1.0);
        Sum { value, error: tail * again(fall) }
    }
}

/// Largest number of bisections of a piece, and of pieces: beyond these only rounding is left.
const DEEPEST: usize = 40;
const MOST: usize = 100;

/// Calls `step` with the start and length of pieces of [0, 1], from left to right, and bisects a
/// piece where `step` returns false. The third argument is true for a piece that is not bisected
/// any further.
#[inline(always)]
pub(crate) fn bisect(mut step: impl FnMut(f64, f64, bool) -> bool) {
    // Right ends of the pieces left to do, the next one last.
    let mut ends = [1.0; DEEPEST + 1];
    let (mut low, mut depth, mut count) = (0.0, 0, 0);
    loop {
        count += 1;
        let span = ends[depth] - low;
        let last = depth == DEEPEST || count >= MOST;
        if step(low, span, last) || last {
            low = ends[depth];
            if depth == 0 {
                return;
            }
            depth -= 1;
        } else {
            depth += 1;
            ends[depth] = low + 0.5 * span;
        }
    }
}

/// c₁, c₂ and c₃ of a variable c₁ v + c₂ v² + c₃ v³ on [0, 1] in which half powers of the distance
/// to the marked ends become whole powers of v.
pub(crate) const fn whole_powers(half: [bool; 2]) -> [f64; 3] {
    match half {
        [false, false] => [1.0, 0.0, 0.0],
        [true, false] => [0.0, 1.0, 0.0],
        [false, true] => [2.0, -1.0, 0.0],
        [true, true] => [0.0, 3.0, -2.0],
    }
}

#[inline(always)]
pub(crate) fn dot<const N: usize>(row: &[f64; N], samples: &[f64; N]) -> f64 {
    let mut sums = [0.0; 4];
    for k in 0..N {
        sums[k % 4] += row[k] * samples[k];
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_estimate_bounds_the_error() {
        let rule = Gauss::<12>::new();
        for k in 1..400 {
            // A pole and a half power beyond an end, at any distance.
            let beyond = 1e-4 * 1.03f64.powi(k);
            let pole = rule.sum(&rule.nodes.map(|x| 1.0 / (beyond + x)));
            let exact = (beyond.recip()).ln_1p();
            assert!((pole.value - exact).abs() <= pole.error + 1e-14 * exact, "{beyond}: {pole:?}");
            let root = rule.sum(&rule.nodes.map(|x| (beyond + x).sqrt()));
            let exact = ((1.0 + beyond).powf(1.5) - beyond.powf(1.5)) / 1.5;
            assert!((root.value - exact).abs() <= root.error + 1e-14 * exact, "{beyond}: {root:?}");
            // A power at the end itself, of the exponents that occur, alone and as a small term
            // beside a smooth function.
            let p = 2.5 + 0.02 * f64::from(k);
            for share in [1.0, 1e-3, 1e-6] {
                let power = rule.nodes.map(|x| share * x.powf(p) + 1.0 / (1.5 + x));
                let power = rule.sum_from_power(&power);
                let exact = share / (p + 1.0) + (2.5f64 / 1.5).ln();
                let off = (power.value - exact).abs();
                assert!(off <= power.error + 1e-14 * exact, "x^{p} {share}: {off:e} {power:?}");
            }
        }
    }
}
