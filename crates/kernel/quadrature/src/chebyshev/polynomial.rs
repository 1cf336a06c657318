//! Polynomials in one and in two variables in [-1, 1], through samples at Chebyshev's points.

use std::sync::OnceLock;

use super::extremes;

/// Coefficients evaluated together: their products are independent.
const LANES: usize = 4;
/// Numbers of points to try, fewest first. With more points, powers lose digits.
const POINTS: [usize; 6] = [8, 12, 16, 20, 24, 32];
/// The number of last terms that must vanish for the others to be resolved.
const GUARDS: usize = 3;
/// The number of last terms from which the size of the missing ones is estimated.
const UNSEEN: usize = 2;
/// Terms below this share of the largest sample are rounding.
const NOISE: f64 = 5e-16;

/// Chebyshev's points in [-1, 1], and the matrix from samples to terms.
#[derive(Debug)]
pub(crate) struct Chebyshev {
    pub(crate) points: Vec<f64>,
    /// Row k gives the term of degree k.
    rows: Vec<Vec<f64>>,
}

impl Chebyshev {
    /// Sets of points, fewest first; made once per process.
    pub(crate) fn ladder() -> &'static [Self] {
        static LADDER: OnceLock<Vec<Chebyshev>> = OnceLock::new();
        LADDER.get_or_init(|| POINTS.into_iter().map(Self::new).collect())
    }

    /// The one point 0, for a function that does not depend on the variable.
    pub(crate) fn single() -> &'static Self {
        static SINGLE: OnceLock<Chebyshev> = OnceLock::new();
        SINGLE.get_or_init(|| Self { points: vec![0.0], rows: vec![vec![1.0]] })
    }

    fn new(count: usize) -> Self {
        let (points, rows) = extremes(count);
        Self { points, rows }
    }

    fn terms(&self, samples: &[f64]) -> Vec<f64> {
        let term = |row: &Vec<f64>| row.iter().zip(samples).map(|(r, f)| r * f).sum();
        self.rows.iter().map(term).collect()
    }

    /// The number of terms that may be used.
    fn usable(&self) -> usize {
        self.points.len().saturating_sub(GUARDS).max(1)
    }
}

/// Σ cᵢⱼ uⁱ vʲ, with fewer powers of u for higher ones of v.
#[derive(Debug, Clone, Default)]
pub(crate) struct Series {
    /// Coefficients of four powers of u each, the even ones first: highest powers first, and among
    /// those of the same powers of u the highest power of v first.
    fours: Box<[[f64; LANES]]>,
    /// The number of pairs of powers of v for each four powers of u; empty without v.
    rows: Box<[u8]>,
}

/// A series, and a bound on its truncation.
#[derive(Debug)]
pub(crate) struct FittedSeries {
    pub(crate) series: Series,
    /// Bound on the terms left out.
    pub(crate) left: f64,
    /// Whether the points of u and of v suffice.
    pub(crate) resolved: [bool; 2],
}

impl Series {
    /// The shortest series, through samples at all points of u for each of v, that leaves out less
    /// than `allowed`; samples are sums of terms of size `size`, whose rounding they contain.
    pub(crate) fn fit(
        (u, v): (&Chebyshev, &Chebyshev),
        samples: &[f64],
        allowed: f64,
        size: f64,
    ) -> FittedSeries {
        let largest = samples.iter().fold(size, |m: f64, f| m.max(f.abs()));
        let of_u: Vec<_> = samples.chunks(u.points.len()).map(|row| u.terms(row)).collect();
        // terms[j][i] belongs to Tᵢ(u) Tⱼ(v).
        let mut terms = vec![vec![0.0; u.points.len()]; v.points.len()];
        for i in 0..u.points.len() {
            let column: Vec<f64> = of_u.iter().map(|row| row[i]).collect();
            for (row, term) in terms.iter_mut().zip(v.terms(&column)) {
                row[i] = term;
            }
        }
        let noise = NOISE * largest;
        let mut threshold = allowed.max(noise);
        loop {
            let mut lengths: Vec<usize> = terms
                .iter()
                .map(|row| row.iter().rposition(|term| term.abs() > threshold).map_or(0, |i| i + 1))
                .collect();
            for j in (1..lengths.len()).rev() {
                lengths[j - 1] = lengths[j - 1].max(lengths[j]);
            }
            let used = lengths.iter().take_while(|n| **n > 0).count().max(1);
            let resolved = [lengths[0] <= u.usable(), used <= v.usable()];
            for length in &mut lengths[..used] {
                *length = length.next_multiple_of(LANES).max(LANES);
            }
            let above = |term: &f64| (term.abs() - noise).max(0.0);
            let dropped = |(row, n): (&Vec<f64>, &usize)| {
                // The terms beyond the points are smaller than the last ones.
                row[*n..]
                    .iter()
                    .chain(&row[row.len().saturating_sub(UNSEEN)..])
                    .map(above)
                    .sum::<f64>()
            };
            let mut left: f64 = terms.iter().zip(&lengths).map(dropped).sum();
            if terms.len() > 1 {
                left += terms[terms.len() - UNSEEN..].iter().flatten().map(above).sum::<f64>();
            }
            if left <= allowed || threshold <= noise || resolved != [true; 2] {
                terms.truncate(used);
                terms.iter_mut().zip(&lengths).for_each(|(row, n)| row.truncate(*n));
                return FittedSeries { series: Self::of_terms(&terms), left, resolved };
            }
            threshold = noise.max(0.5 * threshold);
        }
    }

    /// Powers in place of Chebyshev's polynomials: without loss of digits for the few terms of
    /// smooth functions.
    fn of_terms(terms: &[Vec<f64>]) -> Self {
        let of_u: Vec<_> = terms.iter().map(|row| powers(row)).collect();
        let blocks = of_u[0].len() / LANES;
        let (mut fours, mut rows) = (vec![], vec![]);
        for block in (0..blocks).rev() {
            let height = of_u.iter().take_while(|row| row.len() > LANES * block).count();
            let columns: [Vec<f64>; LANES] = std::array::from_fn(|lane| {
                let column: Vec<f64> =
                    of_u[..height].iter().map(|row| row[LANES * block + lane]).collect();
                powers(&column)
            });
            // Even powers first: both odd powers times u are then added to them at once.
            let [a, b, c, d] = &columns;
            let four = |j: usize| [a, c, b, d].map(|column| column.get(j).copied().unwrap_or(0.0));
            let height = if terms.len() == 1 { 1 } else { height.next_multiple_of(2) };
            fours.extend((0..height).rev().map(four));
            rows.push((height / 2) as u8);
        }
        if terms.len() == 1 {
            rows.clear();
        }
        Self { fours: fours.into(), rows: rows.into() }
    }

    /// The value at u and v.
    #[inline]
    pub(crate) fn at(&self, (u, v): (f64, f64)) -> f64 {
        let powers = Powers::new(u);
        let square = v * v;
        let (mut sum, mut fours) = (0.0, &self.fours[..]);
        for &pairs in &self.rows {
            let (block, rest) = fours.split_at(2 * usize::from(pairs));
            let mut four = [0.0; LANES];
            for pair in block.chunks_exact(2) {
                for (k, c) in four.iter_mut().enumerate() {
                    *c = *c * square + (pair[1][k] + pair[0][k] * v);
                }
            }
            (sum, fours) = (powers.add(sum, &four), rest);
        }
        fours.iter().fold(sum, |sum, four| powers.add(sum, four))
    }

    pub(crate) fn coefficients(&self) -> usize {
        LANES * self.fours.len()
    }
}

/// u, u² and u⁴.
#[derive(Clone, Copy)]
struct Powers(f64, f64, f64);

impl Powers {
    #[inline]
    fn new(u: f64) -> Self {
        let square = u * u;
        Self(u, square, square * square)
    }

    /// u⁴ sum + a + b u + c u² + d u³.
    #[inline]
    fn add(self, sum: f64, &[a, c, b, d]: &[f64; LANES]) -> f64 {
        sum * self.2 + ((a + b * self.0) + (c + d * self.0) * self.1)
    }
}

/// Σ tₖ Tₖ(u) as Σ cₖ uᵏ.
pub(crate) fn powers(terms: &[f64]) -> Vec<f64> {
    let mut sum = vec![0.0; terms.len()];
    let (mut before, mut now) = (vec![0.0; terms.len()], vec![0.0; terms.len()]);
    for (k, term) in terms.iter().enumerate() {
        match k {
            0 => now[0] = 1.0,
            1 => (before[0], now[0], now[1]) = (1.0, 0.0, 1.0),
            _ => {
                for i in (0..=k).rev() {
                    let raised = if i > 0 { 2.0 * now[i - 1] } else { 0.0 };
                    before[i] = raised - before[i];
                }
                std::mem::swap(&mut before, &mut now);
            }
        }
        for (sum, now) in sum.iter_mut().zip(&now[..=k]) {
            *sum += term * now;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Samples of f at the points of u for each of v.
    fn samples(u: &Chebyshev, v: &Chebyshev, f: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        v.points
            .iter()
            .flat_map(|&v| u.points.iter().map(|&u| f(u, v)).collect::<Vec<_>>())
            .collect()
    }

    #[test]
    fn entire_functions_are_fitted_to_the_allowed_error_with_few_terms() {
        let u = &Chebyshev::ladder()[2];
        let samples = samples(u, Chebyshev::single(), |u, _| (-0.5 * u).exp());
        let mut before = usize::MAX;
        for allowed in [1e-14, 1e-8, 1e-3] {
            let fit = Series::fit((u, Chebyshev::single()), &samples, allowed, 0.0);
            assert!(
                fit.resolved == [true; 2]
                    && fit.left <= allowed
                    && fit.series.coefficients() < before
            );
            before = fit.series.coefficients();
            for k in -50..=50 {
                let u = f64::from(k) / 50.0;
                let error = (fit.series.at((u, 0.0)) - (-0.5 * u).exp()).abs();
                assert!(error < fit.left + 2e-14, "{allowed} {u} {error:e}");
            }
        }
    }

    #[test]
    fn two_variables_have_a_triangle_of_coefficients() {
        let points = &Chebyshev::ladder()[2];
        let f = |u: f64, v: f64| 1.0 / (9.0 + u + 0.5 * v) + (0.3 * u * v).exp();
        for (allowed, most) in [(1e-13, 140), (1e-6, 48)] {
            let fit = Series::fit((points, points), &samples(points, points, f), allowed, 0.0);
            assert!(
                fit.resolved == [true; 2] && fit.series.coefficients() <= most,
                "{}",
                fit.series.coefficients()
            );
            for k in 0..2500 {
                let [u, v] = [k / 50, k % 50].map(|k| f64::from(k) / 24.5 - 1.0);
                let error = (fit.series.at((u, v)) - f(u, v)).abs();
                assert!(error < allowed + 4e-15, "{u} {v} {error:e}");
            }
        }
    }

    #[test]
    fn too_few_points_are_detected() {
        let u = &Chebyshev::ladder()[2];
        let single = Chebyshev::single();
        let kink = samples(u, single, |u, _| (u - 0.3).abs());
        assert!(!Series::fit((u, single), &kink, 1e-6, 0.0).resolved[0]);
        // A constant is resolved, even if only rounding is allowed.
        assert!(Series::fit((u, single), &samples(u, single, |_, _| 0.7), 0.0, 0.0).resolved[0]);
        assert!(Series::fit((u, single), &samples(u, single, |_, _| 0.0), 0.0, 0.0).resolved[0]);
    }
}
