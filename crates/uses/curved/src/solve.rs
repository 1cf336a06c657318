//! Newton's method for the separations, with conjugate gradients.

use asperity_core::{ContactError, Quantity};

use crate::kernel::Deflection;
use crate::layer::Layer;
use crate::{Grid, Work, refused};

const MAX_STEPS: usize = 60;
/// What pressures may be off by after the last step, over the peak and the tolerance of numbers.
const DONE: f64 = 1e-7;
/// A step of Newton's method errs by at most this times its square, with both over the peak.
const SQUARE: f64 = 30.0;

/// What is given of a contact.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Given {
    /// Its load, of a line per length.
    Load(f64),
    /// Its approach, and how much larger than on the grid approaches are at a unit of load.
    Approach(f64, f64),
}

/// Separations on a grid with all that follows from them.
pub(crate) struct State {
    /// Parabolic part of the separations \[m\].
    shape: Vec<f64>,
    pub(crate) grid: Grid,
    /// Area, or length, of a point.
    pub(crate) weight: f64,
    /// The constant part of the separations \[m\].
    pub(crate) offset: f64,
    pub(crate) separations: Vec<f64>,
    pub(crate) pressures: Vec<f64>,
    /// -dp/dd \[Pa/m\].
    pub(crate) slopes: Vec<f64>,
    deflections: Vec<f64>,
    pub(crate) kernel: Deflection,
    pub(crate) work: Work,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl State {
    /// The start: separations under the deflections of these pressures, at a load, of a line per
    /// length.
    pub(crate) fn new(
        layer: &Layer,
        mut kernel: Deflection,
        grid: Grid,
        shape: Vec<f64>,
        pressures: &[f64],
        load: f64,
    ) -> Result<Self, ContactError> {
        let n = shape.len();
        let mut deflections = vec![0.0; n];
        kernel.product(pressures, &mut deflections);
        let (separations, slopes) = (vec![0.0; n], vec![0.0; n]);
        let work = Work { points: n, ..Work::default() };
        let mut state = Self {
            shape,
            grid,
            weight: grid.steps[0] * grid.steps[1],
            offset: 0.0,
            separations,
            pressures: vec![0.0; n],
            slopes,
            deflections,
            kernel,
            work,
        };
        let base: Vec<f64> =
            state.shape.iter().zip(&state.deflections).map(|(a, b)| a + b).collect();
        let least = base.iter().copied().fold(f64::INFINITY, f64::min);
        // The force falls with the offset: bisection to a part of sigma.
        let mut force = |offset: f64| {
            state.separations.iter_mut().zip(&base).for_each(|(d, base)| *d = base + offset);
            state.update(layer).map(|()| state.force())
        };
        let (mut low, mut high) = (-least, -least);
        let mut width = layer.sigma;
        while force(low)? < load {
            (high, low) = (low, low - width);
            width *= 2.0;
        }
        width = layer.sigma;
        while force(high)? > load {
            (low, high) = (high, high + width);
            width *= 2.0;
        }
        while high - low > 0.05 * layer.sigma {
            let middle = 0.5 * (low + high);
            if force(middle)? > load { low = middle } else { high = middle }
        }
        state.offset = 0.5 * (low + high);
        state.separations.iter_mut().zip(&base).for_each(|(d, base)| *d = base + state.offset);
        state.update(layer)?;
        Ok(state)
    }

    /// Load, of a line contact per length.
    pub(crate) fn force(&self) -> f64 {
        self.weight * self.pressures.iter().sum::<f64>()
    }

    pub(crate) fn peak(&self) -> f64 {
        self.pressures.iter().copied().fold(0.0, f64::max)
    }

    /// The largest pressure at the edge of the grid.
    pub(crate) fn edge(&self) -> f64 {
        let [n, rows] = self.grid.n;
        let first_row = if rows > 1 { n } else { 1 };
        let first_column = self.pressures.iter().step_by(n);
        first_column.chain(&self.pressures[..first_row]).copied().fold(0.0, f64::max)
    }

    /// dF/d(-d₀), of a line per length, with the slopes as they are.
    pub(crate) fn stiffness(&mut self, tolerance: f64) -> Result<f64, ContactError> {
        let ones = vec![1.0; self.slopes.len()];
        let moved = self.linear(&ones, 0.01 * tolerance)?;
        Ok(self.weight * dot(&self.slopes, &moved))
    }

    /// Pressures and slopes at the separations.
    fn update(&mut self, layer: &Layer) -> Result<(), ContactError> {
        let of = [Quantity::Force, Quantity::Tangent];
        layer.fill(of, &self.separations, [&mut self.pressures, &mut self.slopes])
    }

    /// d - d₀ - shape - M p.
    fn residual(&mut self) -> Vec<f64> {
        self.kernel.product(&self.pressures, &mut self.deflections);
        let rest = self.shape.iter().zip(&self.deflections).map(|(a, b)| a + b + self.offset);
        self.separations.iter().zip(rest).map(|(d, rest)| d - rest).collect()
    }

    /// Solves for the state in equilibrium, with pressures that suffice for this tolerance.
    pub(crate) fn solve(
        &mut self,
        layer: &Layer,
        given: Given,
        tolerance: f64,
    ) -> Result<(), ContactError> {
        let enough = DONE * tolerance;
        let mut residual = self.residual();
        let mut within = 1e-2;
        for _ in 0..MAX_STEPS {
            self.work.steps += 1;
            if self.slopes.iter().any(|slope| *slope < 0.0) {
                return refused("the pressure of the model rises with the separation here");
            }
            let against: Vec<f64> = residual.iter().map(|r| -r).collect();
            let mut step = self.linear(&against, within)?;
            // As much of a shift of all as is given.
            let unit = self.linear(&vec![1.0; step.len()], within)?;
            let force = self.force() - self.weight * dot(&self.slopes, &step);
            let stiffness = self.weight * dot(&self.slopes, &unit);
            let shift = match given {
                Given::Load(load) => (force - load) / stiffness,
                Given::Approach(approach, more) => {
                    (more * force - approach - self.offset) / (1.0 + more * stiffness)
                }
            };
            step.iter_mut().zip(&unit).for_each(|(step, unit)| *step += shift * unit);
            self.offset += shift;
            let (before, peak) = (self.pressures.clone(), self.peak());
            self.separations.iter_mut().zip(&step).for_each(|(d, step)| *d += step);
            self.update(layer)?;
            let changes = self.pressures.iter().zip(&before).map(|(a, b)| (a - b).abs());
            let change = changes.fold(0.0, f64::max) / peak.max(self.peak());
            let rest = (SQUARE * change * change).max(within * change);
            if rest < enough {
                self.work.products = self.kernel.products;
                return Ok(());
            }
            residual = self.residual();
            within = (enough / rest).max(change * change).min(1e-2);
        }
        refused("the pressures did not settle")
    }

    /// Solves (1 + M W) v = right, with W the slopes: by conjugate gradients on
    /// (1 + √W M √W) z = √W right, v = right - M √W z.
    fn linear(&mut self, right: &[f64], tolerance: f64) -> Result<Vec<f64>, ContactError> {
        let root: Vec<f64> = self.slopes.iter().map(|slope| slope.sqrt()).collect();
        let times = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).collect::<Vec<_>>();
        let mut rest = times(&root, right);
        let mut direction = rest.clone();
        let (mut deflected, mut product) = (vec![0.0; right.len()], vec![0.0; right.len()]);
        let first = dot(&rest, &rest);
        let mut square = first;
        for _ in 0..20 * right.len().max(100) {
            if square <= tolerance * tolerance * first {
                break;
            }
            self.kernel.product(&times(&root, &direction), &mut product);
            let turned = times(&root, &product);
            let along = square / (dot(&direction, &direction) + dot(&direction, &turned));
            for (k, rest) in rest.iter_mut().enumerate() {
                *rest -= along * (direction[k] + turned[k]);
                deflected[k] += along * product[k];
            }
            let next = dot(&rest, &rest);
            let ratio = next / square;
            square = next;
            direction.iter_mut().zip(&rest).for_each(|(d, r)| *d = r + ratio * *d);
        }
        // Rounding may end the fall of the rest above the tolerance, but far below this.
        if square > first * (tolerance * tolerance).max(1e-12) {
            return refused("the equations of the separations did not converge");
        }
        Ok(right.iter().zip(&deflected).map(|(right, deflected)| right - deflected).collect())
    }
}
