//! Force and slope for codes that step in time: one number of state, some tens of nanoseconds.
//!
//! The way back is a function of two numbers, the closest approach c and the separation d ≥ c. It is
//! tabulated in strips of c and cells of d - c as products of Chebyshev polynomials, halved until these
//! have converged; the virgin curve is the compiled contact itself.

use std::f64::consts::PI;

use asperity_core::{At, ContactError, QuadratureError, Quantity, positive};

use crate::Joint;
use crate::one::Asked;

/// Terms in each direction.
const TERMS: usize = 8;
/// Strips are this wide at first \[σ_z\].
const STRIP: f64 = 0.5;
/// A strip or cell is halved no more often than this.
const DEEPEST: u32 = 14;
/// No joint is tabulated over more than this \[σ_z\]: metres and multiples were mixed up.
const WIDEST: f64 = 1000.0;
/// Where contact is left after as long a retreat as this \[σ_z\], it never ends.
const FARTHEST: f64 = 1e8;
/// Retreats shorter than this part of σ_z leave no contact behind.
const NEGLIGIBLE: f64 = 1e-6;

/// A joint, tabulated for many steps.
#[derive(Debug, Clone)]
pub struct JointTable {
    joint: Joint,
    /// Ascending in c.
    strips: Vec<Strip>,
    /// The largest c that is tabulated \[m\].
    open: f64,
    /// 1/σ_z: multiples of σ_z are what the virgin curve is quickest at.
    per_metre: f64,
}

/// What a step answers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reply {
    /// The force \[N\].
    pub force: f64,
    /// -dF/dd \[N/m\], of the way that is being followed.
    pub stiffness: f64,
    /// The closest approach \[m\], this step included.
    pub closest: f64,
}

/// All closest approaches of a range.
#[derive(Debug, Clone)]
struct Strip {
    /// Where the range begins, and two over its length \[m, 1/m\].
    from: f64,
    scale: f64,
    /// Ascending in u.
    cells: Vec<Cell>,
}

/// Retreats from `from` to `to`.
#[derive(Debug, Clone)]
struct Cell {
    from: f64,
    to: f64,
    /// Of Tᵢ(c) Tⱼ(u), the j together.
    terms: [[f64; TERMS]; TERMS],
}

impl Joint {
    /// A table for closest approaches from `deepest` to `open` \[m from the mean of the asperity
    /// heights\]; forces on the way back are within `tolerance` (1e-6, say) of the force at the closest
    /// approach, and read 0 where they are smaller than that. Contacts that have come no closer than
    /// `open` answer as if nothing had ever yielded.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] naming a number that is none of these, and ends more than 1000 σ_z
    /// apart; [`ContactError::Integral`] with the error that was reached, where the tolerance cannot be
    /// met (one near that of the joint itself, jumps of the law under heights with an end); those of
    /// the evaluations.
    pub fn table(
        &self,
        (deepest, open): (f64, f64),
        tolerance: f64,
    ) -> Result<JointTable, ContactError> {
        let tolerance = positive("tolerance", tolerance)?;
        let width = positive("open, less deepest,", open - deepest)?;
        let sigma = self.scene().surface.asperity_height_std;
        if width > WIDEST * sigma {
            let (field, required) =
                ("open, less deepest,", "at most 1000 asperity_height_std, in m,");
            return Err(ContactError::OutOfRange { field, value: width, required });
        }
        let count = (width / (STRIP * sigma)).ceil().max(1.0) as usize;
        let mut strips = vec![];
        for k in 0..count {
            let end = |k: usize| deepest + width * k as f64 / count as f64;
            self.strips((end(k), end(k + 1)), tolerance, 0, &mut strips)?;
        }
        Ok(JointTable { joint: self.clone(), strips, open, per_metre: sigma.recip() })
    }

    /// The strips that serve a range of closest approaches \[m\].
    fn strips(
        &self,
        (from, to): (f64, f64),
        tolerance: f64,
        depth: u32,
        strips: &mut Vec<Strip>,
    ) -> Result<(), ContactError> {
        let sigma = self.scene().surface.asperity_height_std;
        let places: Vec<f64> =
            nodes().map(|v| (0.5 * (from + to) + 0.5 * (to - from) * v) / sigma).collect();
        let at = |u: f64| self.retreated(Asked::Force, u, &places);
        let whole = at(0.0)?.iter().fold(0.0, |m: f64, f| m.max(f.value()));
        // What is smaller than this at the largest c, too, is nothing.
        let nothing = |forces: &[f64; TERMS], start: &[f64; TERMS]| {
            forces.iter().zip(start).all(|(force, start)| *force <= 0.2 * tolerance * start)
        };
        let start = values(at(0.0)?);
        let mut last = sigma;
        while !nothing(&values(at(last)?), &start) {
            last *= 1.5;
            if last > FARTHEST * sigma {
                let required = "one that the force falls below within 1e8 asperity_height_std";
                return Err(ContactError::OutOfRange {
                    field: "tolerance",
                    value: tolerance,
                    required,
                });
            }
        }
        // Where nothing touches, nothing is left at any retreat.
        while last > NEGLIGIBLE * sigma && nothing(&values(at(0.5 * last)?), &start) {
            last *= 0.5;
        }
        // The smallest force of a strip is what its errors are held against.
        let smallest = start.iter().filter(|force| **force > 0.0);
        let aim = 0.3 * tolerance * smallest.fold(whole, |m: f64, f| m.min(*f));
        let mut cells = vec![];
        let mut pending = vec![(0.0, last, 0)];
        while let Some((low, high, halved)) = pending.pop() {
            let mut samples = [[0.0; TERMS]; TERMS];
            for (column, v) in samples.iter_mut().zip(nodes()) {
                *column = values(at(low + 0.5 * (high - low) * (1.0 + v))?);
            }
            let terms = transformed(&samples);
            let [by_closest, by_retreat] = tails(&terms);
            // As a part of the smallest force at a closest approach.
            let too_deep = |tail: f64| {
                let (asked, reached) = (tolerance, tolerance * tail / aim);
                let evaluations = TERMS * TERMS;
                let source = QuadratureError::NotConverged { reached, asked, evaluations };
                let (quantity, at) = (Quantity::Force, At::metres(0.5 * (from + to)));
                Err(ContactError::Integral { quantity, at, source })
            };
            if by_closest > aim {
                if depth == DEEPEST {
                    return too_deep(by_closest);
                }
                let middle = 0.5 * (from + to);
                self.strips((from, middle), tolerance, depth + 1, strips)?;
                return self.strips((middle, to), tolerance, depth + 1, strips);
            }
            if by_retreat > aim {
                if halved == DEEPEST {
                    return too_deep(by_retreat);
                }
                let middle = 0.5 * (low + high);
                pending.extend([(middle, high, halved + 1), (low, middle, halved + 1)]);
            } else {
                cells.push(Cell { from: low, to: high, terms });
            }
        }
        strips.push(Strip { from, scale: 2.0 / (to - from), cells });
        Ok(())
    }
}

/// cos(π (2k+1)/(2n)).
fn nodes() -> impl Iterator<Item = f64> {
    (0..TERMS).map(|k| (PI * (2 * k + 1) as f64 / (2 * TERMS) as f64).cos())
}

fn values(found: Vec<asperity_core::Evaluation>) -> [f64; TERMS] {
    let mut values = [0.0; TERMS];
    values.iter_mut().zip(found).for_each(|(value, found)| *value = found.value());
    values
}

/// From samples at the nodes, `samples[u][c]`, to the coefficients, `terms[c][u]`.
fn transformed(samples: &[[f64; TERMS]; TERMS]) -> [[f64; TERMS]; TERMS] {
    let term = |i: usize, k: usize| {
        let norm = if i == 0 { 1.0 } else { 2.0 } / TERMS as f64;
        norm * (PI * (i * (2 * k + 1)) as f64 / (2 * TERMS) as f64).cos()
    };
    let mut terms = [[0.0; TERMS]; TERMS];
    for (i, row) in terms.iter_mut().enumerate() {
        for (j, coefficient) in row.iter_mut().enumerate() {
            for (k, column) in samples.iter().enumerate() {
                let along: f64 = column.iter().enumerate().map(|(l, f)| term(i, l) * f).sum();
                *coefficient += term(j, k) * along;
            }
        }
    }
    terms
}

/// The size of the last two terms along c, and along u.
fn tails(terms: &[[f64; TERMS]; TERMS]) -> [f64; 2] {
    let of = |pick: &dyn Fn(usize, usize) -> f64| -> f64 {
        (TERMS - 2..TERMS)
            .flat_map(|i| (0..TERMS).map(move |j| (i, j)))
            .map(|(i, j)| pick(i, j))
            .sum()
    };
    [of(&|i, j| terms[i][j].abs()), of(&|i, j| terms[j][i].abs())]
}

impl JointTable {
    /// A contact that has never been closed.
    #[must_use]
    pub fn new_contact(&self) -> Memory<'_> {
        Memory { table: self, closest: f64::INFINITY }
    }

    /// Force and stiffness at a separation \[m\] of a contact that had come as close as `closest` \[m\],
    /// infinite for a new one: the next step's `closest` stands in the reply.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] for a separation or a closest approach below the deepest of the
    /// table, or none.
    #[inline]
    pub fn at(&self, separation: f64, closest: f64) -> Result<Reply, ContactError> {
        if separation < closest || closest >= self.open {
            let (force, tangent) =
                self.joint.virgin().force_and_tangent(At::sigmas(separation * self.per_metre))?;
            let closest = separation.min(closest);
            if closest < self.strips.first().map_or(closest, |strip| strip.from) {
                return Err(out_of_range(separation, closest));
            }
            return Ok(Reply { force: force.value(), stiffness: tangent.value(), closest });
        }
        let after = self.strips.partition_point(|strip| strip.from <= closest);
        let strip = after.checked_sub(1).map(|k| &self.strips[k]);
        let strip = strip.filter(|_| separation >= closest);
        let strip = strip.ok_or_else(|| out_of_range(separation, closest))?;
        let retreat = separation - closest;
        let cell = strip.cells.partition_point(|cell| cell.to <= retreat);
        let (force, stiffness) = match strip.cells.get(cell) {
            Some(cell) => cell.at((closest - strip.from) * strip.scale - 1.0, retreat),
            None => (0.0, 0.0),
        };
        Ok(Reply { force, stiffness, closest })
    }
}

/// Names the separation where it is the new closest approach, and else what came as that.
fn out_of_range(separation: f64, closest: f64) -> ContactError {
    let required = "a number, at least the deepest separation of the table,";
    let is_step = separation.is_nan() || separation <= closest;
    let (field, value) = if is_step { ("separation", separation) } else { ("closest", closest) };
    ContactError::OutOfRange { field, value, required }
}

impl Cell {
    /// The force and its fall with the retreat; c from -1 to 1.
    #[inline]
    fn at(&self, c: f64, retreat: f64) -> (f64, f64) {
        let mut along = self.terms[0];
        let (mut before, mut now) = (1.0, c);
        for row in &self.terms[1..] {
            along.iter_mut().zip(row).for_each(|(sum, term)| *sum += now * term);
            (before, now) = (now, 2.0 * c * now - before);
        }
        let scale = 2.0 / (self.to - self.from);
        let v = (retreat - self.from) * scale - 1.0;
        // T' is n U of one order less.
        let (mut value, mut slope) = (along[0], 0.0);
        let (mut t, mut u) = ([1.0, v], [0.0, 1.0]);
        for (n, term) in along.iter().enumerate().skip(1) {
            value += term * t[1];
            slope += n as f64 * term * u[1];
            t = [t[1], 2.0 * v * t[1] - t[0]];
            u = [u[1], 2.0 * v * u[1] - u[0]];
        }
        (value, -slope * scale)
    }
}

/// A contact with what it remembers: its closest approach.
///
/// A mass that falls on a rough surface, and bounces off with less energy each time:
/// ```
/// use asperity_core::{Interface, Scene, Surface, Tolerance};
/// use asperity_joints::{Joint, UnloadingLaw};
/// use asperity_ke::KogutEtsion;
///
/// let surface = Surface::new(3.6e-4, 1.11e8, 1e-6);
/// let scene = Scene::new(Interface::new(116e9, 0.31, 1.12e9), surface, 3e-5);
/// let joint = Joint::new(&KogutEtsion, &scene, UnloadingLaw::Hertz, Tolerance::default())?;
/// let table = joint.table((-0.5e-6, 4e-6), 1e-6)?;
/// let mut contact = table.new_contact();
/// let (mass, gravity, dt) = (0.1, 9.81, 1e-7);
/// let (mut separation, mut speed) = (8e-6, -0.01_f64); // m, m/s
/// let (mut energies, mut before) = (vec![], speed);
/// for _ in 0..200_000 {
///     let force = contact.step(separation)?.force;
///     speed += dt * (force / mass - gravity);
///     separation += dt * speed;
///     if before > 0.0 && speed <= 0.0 {
///         energies.push(mass * gravity * separation); // at rest, at the top
///     }
///     before = speed;
/// }
/// // Yielding takes its part at the first bounce; later ones are elastic, as they are no deeper.
/// let start = mass * (gravity * 8e-6 + 0.5 * 0.01 * 0.01);
/// assert!(energies.len() > 2 && energies[0] < 0.6 * start, "{energies:?}");
/// assert!((energies[1] / energies[0] - 1.0).abs() < 1e-2, "{energies:?}");
/// # Ok::<(), asperity_core::ContactError>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Memory<'t> {
    table: &'t JointTable,
    closest: f64,
}

impl Memory<'_> {
    /// Goes to a separation \[m\] from the mean of the asperity heights.
    ///
    /// # Errors
    /// Those of [`JointTable::at`]; the contact then stays as it was.
    #[inline]
    pub fn step(&mut self, separation: f64) -> Result<Reply, ContactError> {
        let reply = self.table.at(separation, self.closest)?;
        self.closest = reply.closest;
        Ok(reply)
    }

    /// The closest approach so far \[m\]; infinite for a new contact.
    #[must_use]
    pub fn closest(&self) -> f64 {
        self.closest
    }
}
