//! The unloading force as a table over the closest approach c and the separation d ≥ c: strips of c
//! and cells of d - c with products of Chebyshev polynomials, halved until these converge.

use asperity_core::{At, ContactError, QuadratureError, Quantity, Tolerance, positive, require};
use asperity_quadrature::{chebyshev_roots, chebyshev_terms};

use crate::asperity_laws::UnloadingQuantity;
use crate::joint::Joint;
use crate::table::{JointTable, Strip, StripCell, TERMS};

/// Initial width of strips \[σ_z\].
const STRIP: f64 = 0.5;
/// Largest number of times that a strip or cell is halved.
const MAX_HALVINGS: u32 = 14;
/// Largest width of a table \[σ_z\]; wider ranges probably mix up metres and multiples of σ_z.
const MAX_WIDTH: f64 = 1000.0;
/// Largest retreat searched for the end of contact \[σ_z\].
const MAX_DISTANCE: f64 = 1e8;
/// Tolerance of the integrals over the table's.
const ERROR_SHARE: f64 = 0.1;
/// Retreat \[σ_z\] below which the search for the end of contact stops.
const NEGLIGIBLE: f64 = 1e-6;

impl Joint {
    /// A table for closest approaches from `deepest` to `open` \[m from the mean of the asperity
    /// heights\]. Errors of unloading forces are within `tolerance` (for example 1e-6) times the
    /// force at the closest approach; smaller forces are 0, and forces are below 0 only where the
    /// model's are. Contacts that stay more open than `open` are elastic. Beyond the highest
    /// asperity of bounded heights the force is exactly 0.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] for a number out of range and for ends more than 1000 σ_z
    /// apart; [`ContactError::Integral`] with the error reached where the tolerance cannot be met
    /// (a tolerance close to the joint's, or jumps of the law with bounded heights); the errors of
    /// the evaluations.
    pub fn table(
        &self,
        (deepest, open): (f64, f64),
        tolerance: f64,
    ) -> Result<JointTable, ContactError> {
        let tolerance = positive("tolerance", tolerance)?;
        let width = positive("open - deepest", open - deepest)?;
        let sigma = self.scene().surface.asperity_height_std;
        let required = "at most 1000 asperity_height_std, in m,";
        require(width <= MAX_WIDTH * sigma, "open - deepest", width, required)?;
        // All contacts are elastic within the elastic limit of the highest asperity.
        let highest = self.scene().heights.support(sigma).1;
        let open = open.min(highest - self.loading.elastic_limit());
        let width = (open - deepest).max(0.0);
        let count = (width / (STRIP * sigma)).ceil() as usize;
        let mut strips = vec![];
        for k in 0..count {
            let end = |k: usize| deepest + width * k as f64 / count as f64;
            self.strips((end(k), end(k + 1)), tolerance, 0, &mut strips)?;
        }
        Ok(JointTable::new(self.clone(), strips, (deepest, open, highest)))
    }

    /// Appends the strips of a range of closest approaches \[m\].
    fn strips(
        &self,
        (from, to): (f64, f64),
        tolerance: f64,
        depth: u32,
        strips: &mut Vec<Strip>,
    ) -> Result<(), ContactError> {
        let sigma = self.scene().surface.asperity_height_std;
        let place = |v: f64| (0.5 * (from + to) + 0.5 * (to - from) * v) / sigma;
        let places: Vec<f64> = chebyshev_roots(TERMS).map(place).collect();
        let between = between_roots();
        let checked: Vec<f64> = between.iter().map(|v| place(*v)).collect();
        // Small remaining forces need only the tolerance of the table.
        let rough = self.with_tolerance_at_least(Tolerance::new(ERROR_SHARE * tolerance)?);
        let at_places =
            |u: f64, places: &[f64]| match self.retreated(UnloadingQuantity::Force, u, places) {
                Err(ContactError::Integral { .. }) => {
                    rough.retreated(UnloadingQuantity::Force, u, places)
                }
                found => found,
            };
        let at = |u: f64| at_places(u, &places);
        // Forces below this share at every c are negligible.
        let nothing = |forces: &[f64; TERMS], start: &[f64; TERMS]| {
            forces.iter().zip(start).all(|(force, start)| *force <= 0.2 * tolerance * start)
        };
        let start = values(at(0.0)?);
        let whole = start.iter().fold(0.0, |m: f64, f| m.max(*f));
        let mut last = sigma;
        while !nothing(&values(at(last)?), &start) {
            last *= 1.5;
            let required = "larger, as the force stays above it up to 1e8 asperity_height_std,";
            require(last <= MAX_DISTANCE * sigma, "tolerance", tolerance, required)?;
        }
        // Without contact at the closest approach, the last retreat shrinks to the limit.
        while last > NEGLIGIBLE * sigma && nothing(&values(at(0.5 * last)?), &start) {
            last *= 0.5;
        }
        // Errors are measured against the smallest force of the strip.
        let smallest = start.iter().filter(|force| **force > 0.0);
        let aim = 0.3 * tolerance * smallest.fold(whole, |m: f64, f| m.min(*f));
        let mut cells = vec![];
        let mut pending = vec![(0.0, last, 0)];
        while let Some((low, high, halved)) = pending.pop() {
            let mut samples = [[0.0; TERMS]; TERMS];
            for (column, v) in samples.iter_mut().zip(chebyshev_roots(TERMS)) {
                *column = values(at(low + 0.5 * (high - low) * (1.0 + v))?);
            }
            let is_positive = samples.iter().flatten().all(|force| *force >= 0.0);
            let least = if is_positive { 0.0 } else { f64::NEG_INFINITY };
            let cell = StripCell { from: low, to: high, terms: transformed(&samples), least };
            let [mut by_closest, mut by_retreat] = tails(&cell.terms);
            if by_closest <= aim && by_retreat <= aim {
                // A kink between the nodes need not show in the last terms.
                let mut off: f64 = 0.0;
                for v in between.into_iter().step_by(2) {
                    let u = low + 0.5 * (high - low) * (1.0 + v);
                    // Next to the end of bounded heights there may be too little to compare with.
                    let found = match at_places(u, &checked) {
                        Err(ContactError::Integral { .. }) => continue,
                        found => found?,
                    };
                    for (c, found) in between.iter().zip(found) {
                        off = off.max((cell.at(*c, u).0 - found.value()).abs());
                    }
                }
                if off > aim {
                    let worse =
                        if by_closest > by_retreat { &mut by_closest } else { &mut by_retreat };
                    *worse = off;
                }
            }
            // Relative to the smallest force at a closest approach.
            let too_deep = |tail: f64| {
                let (asked, reached) = (tolerance, tolerance * tail / aim);
                let evaluations = TERMS * TERMS;
                let source = QuadratureError::NotConverged { reached, asked, evaluations };
                let (quantity, at) = (Quantity::Force, At::metres(0.5 * (from + to)));
                Err(ContactError::Integral { quantity, at, source })
            };
            if by_closest > aim {
                if depth == MAX_HALVINGS {
                    return too_deep(by_closest);
                }
                let middle = 0.5 * (from + to);
                self.strips((from, middle), tolerance, depth + 1, strips)?;
                return self.strips((middle, to), tolerance, depth + 1, strips);
            }
            if by_retreat > aim {
                if halved == MAX_HALVINGS {
                    return too_deep(by_retreat);
                }
                let middle = 0.5 * (low + high);
                pending.extend([(middle, high, halved + 1), (low, middle, halved + 1)]);
            } else {
                cells.push(cell);
            }
        }
        strips.push(Strip { from, scale: 2.0 / (to - from), cells });
        Ok(())
    }
}

fn values(found: Vec<asperity_core::Evaluation>) -> [f64; TERMS] {
    let mut values = [0.0; TERMS];
    values.iter_mut().zip(found).for_each(|(value, found)| *value = found.value());
    values
}

/// Places between the Chebyshev roots, and both ends, where polynomials err most.
fn between_roots() -> [f64; TERMS + 1] {
    std::array::from_fn(|k| (std::f64::consts::PI * k as f64 / TERMS as f64).cos())
}

/// Coefficients `terms[c][u]` from samples at the nodes, `samples[u][c]`.
fn transformed(samples: &[[f64; TERMS]; TERMS]) -> [[f64; TERMS]; TERMS] {
    let along: Vec<Vec<f64>> = samples.iter().map(|column| chebyshev_terms(column)).collect();
    let mut terms = [[0.0; TERMS]; TERMS];
    for (i, row) in terms.iter_mut().enumerate() {
        let column: Vec<f64> = along.iter().map(|terms| terms[i]).collect();
        row.copy_from_slice(&chebyshev_terms(&column));
    }
    terms
}

/// Sums of the last two terms along c and along u.
fn tails(terms: &[[f64; TERMS]; TERMS]) -> [f64; 2] {
    let of = |pick: &dyn Fn(usize, usize) -> f64| -> f64 {
        (TERMS - 2..TERMS)
            .flat_map(|i| (0..TERMS).map(move |j| (i, j)))
            .map(|(i, j)| pick(i, j))
            .sum()
    };
    [of(&|i, j| terms[i][j].abs()), of(&|i, j| terms[j][i].abs())]
}

impl StripCell {
    /// The force and its negative slope by the retreat; c from -1 to 1.
    #[inline]
    pub(crate) fn at(&self, c: f64, retreat: f64) -> (f64, f64) {
        let mut along = self.terms[0];
        let (mut before, mut now) = (1.0, c);
        for row in &self.terms[1..] {
            along.iter_mut().zip(row).for_each(|(sum, term)| *sum += now * term);
            (before, now) = (now, 2.0 * c * now - before);
        }
        let scale = 2.0 / (self.to - self.from);
        let v = (retreat - self.from) * scale - 1.0;
        // Tₙ' = n Uₙ₋₁.
        let (mut value, mut slope) = (along[0], 0.0);
        let (mut t, mut u) = ([1.0, v], [0.0, 1.0]);
        for (n, term) in along.iter().enumerate().skip(1) {
            value += term * t[1];
            slope += n as f64 * term * u[1];
            t = [t[1], 2.0 * v * t[1] - t[0]];
            u = [u[1], 2.0 * v * u[1] - u[0]];
        }
        // Interpolation errors may take the polynomial below the limit.
        if value <= self.least { (self.least, 0.0) } else { (value, -slope * scale) }
    }
}
