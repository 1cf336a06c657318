//! Newton's method for the separations, with conjugate gradients.

use asperity_bem::HalfSpace;
use asperity_core::{ContactError, Quantity};

use crate::layer::Layer;
use crate::{Grid, refused};

const MAX_STEPS: usize = 60;
/// What pressures may be off by after the last step, over the peak and the tolerance of numbers.
const DONE: f64 = 1e-3;
/// How well the sum of the pressures is the load.
const BALANCED: f64 = 1e-13;
/// A step of Newton's method errs by at most this times its square, with both over the peak.
const SQUARE: f64 = 30.0;

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
    kernel: HalfSpace,
    /// Of Newton's method.
    pub(crate) steps: usize,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl State {
    /// The start: separations under the deflections of these pressures, at a load, of a line per
    /// length.
    pub(crate) fn new(
        layer: &Layer,
        mut kernel: HalfSpace,
        grid: Grid,
        shape: Vec<f64>,
        pressures: &[f64],
        load: f64,
    ) -> Result<Self, ContactError> {
        let n = shape.len();
        let mut deflections = vec![0.0; n];
        kernel.deflect(pressures, &mut deflections);
        let (separations, slopes) = (vec![0.0; n], vec![0.0; n]);
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
            steps: 0,
        };
        let base: Vec<f64> =
            state.shape.iter().zip(&state.deflections).map(|(a, b)| a + b).collect();
        let least = base.iter().copied().fold(f64::INFINITY, f64::min);
        // The force falls with the offset, ever more slowly: Newton's method from nearer bodies.
        let mut offset = -least;
        let mut nearer = layer.sigma;
        for step in 0.. {
            state.separations.iter_mut().zip(&base).for_each(|(d, base)| *d = base + offset);
            state.update(layer)?;
            if state.force() >= load {
                break;
            }
            if step > MAX_STEPS {
                return refused("no approach carries the load");
            }
            offset -= nearer;
            nearer *= 2.0;
        }
        state.offset = offset;
        state.balance(layer, load)?;
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
        let moved = self.linear(&vec![1.0; self.slopes.len()], 0.01 * tolerance, None)?.0;
        Ok(self.weight * dot(&self.slopes, &moved))
    }

    /// Pressures and slopes at the separations.
    fn update(&mut self, layer: &Layer) -> Result<(), ContactError> {
        let of = [Quantity::Force, Quantity::Tangent];
        layer.fill(of, &self.separations, [&mut self.pressures, &mut self.slopes])
    }

    /// d - d₀ - shape - M p.
    fn residual(&mut self) -> Vec<f64> {
        self.kernel.deflect(&self.pressures, &mut self.deflections);
        let rest = self.shape.iter().zip(&self.deflections).map(|(a, b)| a + b + self.offset);
        self.separations.iter().zip(rest).map(|(d, rest)| d - rest).collect()
    }

    /// Solves for the state in equilibrium with a load, of a line per length, with pressures that
    /// suffice for this tolerance.
    pub(crate) fn solve(
        &mut self,
        layer: &Layer,
        load: f64,
        tolerance: f64,
    ) -> Result<(), ContactError> {
        let enough = DONE * tolerance;
        let mut residual = self.residual();
        let mut within = 1e-2;
        for _ in 0..MAX_STEPS {
            self.steps += 1;
            if self.slopes.iter().any(|slope| *slope < 0.0) {
                return refused("the pressure of the model rises with the separation here");
            }
            let right: Vec<f64> = residual.iter().map(|r| -r).collect();
            let falls = (self.force() - load) / self.weight;
            let (step, shift) = self.linear(&right, within, Some(falls))?;
            self.offset += shift;
            let (before, peak) = (self.pressures.clone(), self.peak());
            self.separations.iter_mut().zip(&step).for_each(|(d, step)| *d += step);
            self.update(layer)?;
            let changes = self.pressures.iter().zip(&before).map(|(a, b)| (a - b).abs());
            let change = changes.fold(0.0, f64::max) / peak.max(self.peak());
            let rest = (SQUARE * change * change).max(within * change);
            if rest < enough {
                return self.balance(layer, load);
            }
            residual = self.residual();
            within = (enough / rest).max(change * change).min(1e-2);
        }
        refused("the pressures did not settle")
    }

    /// Moves the bodies by what is missing in the load, far less than is solved for.
    fn balance(&mut self, layer: &Layer, load: f64) -> Result<(), ContactError> {
        for _ in 0..MAX_STEPS {
            let off = self.force() - load;
            let slope = self.weight * self.slopes.iter().sum::<f64>();
            if off.abs() <= BALANCED * load || slope <= 0.0 {
                break;
            }
            let shift = off / slope;
            self.separations.iter_mut().for_each(|d| *d += shift);
            self.offset += shift;
            self.update(layer)?;
        }
        // Rounding may leave more than is aimed at.
        match (self.force() / load - 1.0).abs() <= 1e-6 {
            true => Ok(()),
            false => refused("the load was not reached"),
        }
    }

    /// Solves (1 + M W) v = right + shift, with W the slopes: v, and the shift with which the sum
    /// of W v is the `total`, or 0. By conjugate gradients on (1 + √W M √W) z = √W (right + shift),
    /// v = right + shift - M √W z, among the z with that sum.
    fn linear(
        &mut self,
        right: &[f64],
        tolerance: f64,
        total: Option<f64>,
    ) -> Result<(Vec<f64>, f64), ContactError> {
        let n = right.len();
        let root: Vec<f64> = self.slopes.iter().map(|slope| slope.sqrt()).collect();
        let sum = dot(&root, &root);
        if total.is_some() && sum <= 0.0 {
            return refused("the pressures do not change with the separation");
        }
        let keep_sum = |rest: &mut [f64]| {
            if total.is_some() {
                let off = dot(rest, &root) / sum;
                rest.iter_mut().zip(&root).for_each(|(rest, root)| *rest -= off * root);
            }
        };
        let (mut deflected, mut product, mut scaled) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
        if let Some(total) = total {
            let first: Vec<f64> = self.slopes.iter().map(|slope| slope * total / sum).collect();
            self.kernel.deflect(&first, &mut deflected);
        }
        let rest = right.iter().zip(&deflected).zip(&root);
        let mut rest: Vec<f64> = rest.map(|((right, own), root)| root * (right - own)).collect();
        keep_sum(&mut rest);
        let mut direction = rest.clone();
        let first = dot(&rest, &rest);
        let mut square = first;
        for _ in 0..20 * n.max(100) {
            if square <= tolerance * tolerance * first {
                break;
            }
            for (k, scaled) in scaled.iter_mut().enumerate() {
                *scaled = root[k] * direction[k];
            }
            self.kernel.deflect(&scaled, &mut product);
            let along = square / (dot(&direction, &direction) + dot(&scaled, &product));
            for (k, rest) in rest.iter_mut().enumerate() {
                *rest -= along * (direction[k] + root[k] * product[k]);
                deflected[k] += along * product[k];
            }
            keep_sum(&mut rest);
            let next = dot(&rest, &rest);
            let ratio = next / square;
            square = next;
            direction.iter_mut().zip(&rest).for_each(|(d, r)| *d = r + ratio * *d);
        }
        // Rounding may end the fall of the rest above the tolerance, but far below this.
        if square.is_nan() || square > first * (tolerance * tolerance).max(1e-12) {
            return refused("the equations of the separations did not converge");
        }
        let mut moved: Vec<f64> = right.iter().zip(&deflected).map(|(a, b)| a - b).collect();
        let shift = total.map_or(0.0, |total| (total - dot(&self.slopes, &moved)) / sum);
        moved.iter_mut().for_each(|moved| *moved += shift);
        Ok((moved, shift))
    }
}
