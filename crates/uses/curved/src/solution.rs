//! Numbers of a solved contact.

use std::f64::consts::PI;

use asperity_core::{ContactError, Quantity};

use crate::solve::State;
use crate::{Curved, Grid, Hertz, Shape};

/// A solved contact of curved bodies.
pub struct Solution<'c> {
    pub(crate) of: &'c Curved,
    pub(crate) state: State,
    /// The load \[N\].
    pub load: f64,
    /// The contact of the same smooth bodies at this load.
    pub hertz: Hertz,
}

impl Solution<'_> {
    /// The steps of Newton's method.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.state.steps
    }

    /// Approach of the bodies \[m\] from where their undeformed surfaces touch, the rough one at
    /// the mean of its asperity heights; `None` of a line without a reference length.
    #[must_use]
    pub fn approach(&self) -> Option<f64> {
        let more = self.of.beyond_grid(&self.state.grid)?;
        Some(more * self.load / self.of.shape.length() - self.state.offset)
    }

    /// Approach less the approach of smooth bodies at the same load \[m\].
    #[must_use]
    pub fn approach_beyond_hertz(&self) -> f64 {
        let mut shape = self.of.shape;
        if let Shape::Line { reference_length, .. } = &mut shape {
            *reference_length = Some(self.state.grid.reference());
        }
        let smooth = Hertz::new(&shape, self.of.layer.modulus, self.load).approach;
        -self.state.offset - smooth.unwrap_or(f64::NAN)
    }

    /// Peak pressure \[Pa\].
    #[must_use]
    pub fn peak_pressure(&self) -> f64 {
        self.state.peak()
    }

    /// Pressures \[Pa\] on the grid, row by row.
    #[must_use]
    pub fn pressures(&self) -> &[f64] {
        &self.state.pressures
    }

    /// Separations \[m\] on the grid, from the mean of the asperity heights.
    #[must_use]
    pub fn separations(&self) -> &[f64] {
        &self.state.separations
    }

    /// Points along x and y, and their distances \[m\]; of a line one row, with the distance 1. The
    /// middle of the patch is at half of both numbers of points, rounded down.
    #[must_use]
    pub fn grid(&self) -> ([usize; 2], [f64; 2]) {
        (self.state.grid.n, self.state.grid.steps)
    }

    /// Separation in the middle of the patch \[m\], from the mean of the asperity heights.
    #[must_use]
    pub fn central_separation(&self) -> f64 {
        self.state.separations[self.state.grid.centre()]
    }

    /// Half axes of the patch along x and y \[m\], √(5⟨x²⟩) with the pressure as weight (of a line
    /// 2√⟨x²⟩ and half the length): Hertz' axes for smooth bodies.
    #[must_use]
    pub fn axes(&self) -> [f64; 2] {
        let total: f64 = self.state.pressures.iter().sum();
        let mean = |axis: usize| {
            let square = |(k, p): (usize, &f64)| p * self.state.grid.place(k, axis).powi(2);
            self.state.pressures.iter().enumerate().map(square).sum::<f64>() / total
        };
        match self.of.shape {
            Shape::Line { length, .. } => [2.0 * mean(0).sqrt(), 0.5 * length],
            Shape::Point { .. } => [0, 1].map(|axis| (5.0 * mean(axis)).sqrt()),
        }
    }

    /// Effective radius of Greenwood and Tripp \[m\], (3π/4) ∫ p r dr/∫ p dr; `None` unless the
    /// patch is a circle.
    #[must_use]
    pub fn effective_radius(&self) -> Option<f64> {
        let Grid { n: [n, _], steps: [step, _] } = self.state.grid;
        match self.of.shape {
            Shape::Point { radius_x, radius_y } if (radius_x / radius_y - 1.0).abs() < 1e-12 => {
                let row = &self.state.pressures[n / 2 * n..n / 2 * n + n];
                let along = 0.5 * step * row.iter().sum::<f64>();
                Some(0.75 * PI * self.state.force() / (2.0 * PI) / along)
            }
            _ => None,
        }
    }

    /// The sum of a quantity over the patch: real area \[m²\], contacts.
    ///
    /// # Errors
    /// [`ContactError::NotRequested`] for a quantity that was not asked for.
    pub fn sum(&self, quantity: Quantity) -> Result<f64, ContactError> {
        Ok(self.per_area(quantity)?.iter().sum::<f64>()
            * self.state.weight
            * self.of.shape.length())
    }

    /// The area fraction in the middle of the patch.
    ///
    /// # Errors
    /// [`ContactError::NotRequested`] if the area was not asked for.
    pub fn central_area_fraction(&self) -> Result<f64, ContactError> {
        self.of.layer.at(Quantity::Area, self.central_separation())
    }

    /// Place of a point of the grid from the middle of the patch \[m\]; 0 across a line.
    #[must_use]
    pub fn place(&self, point: usize) -> [f64; 2] {
        let across = if self.state.grid.n[1] == 1 { 0.0 } else { self.state.grid.place(point, 1) };
        [self.state.grid.place(point, 0), across]
    }

    /// The values of a quantity per nominal area on the grid.
    ///
    /// # Errors
    /// [`ContactError::NotRequested`] for a quantity that was not asked for.
    pub fn per_area(&self, quantity: Quantity) -> Result<Vec<f64>, ContactError> {
        let mut values = vec![0.0; self.state.separations.len()];
        self.of.layer.fill([quantity], &self.state.separations, [&mut values])?;
        Ok(values)
    }

    /// dF over d(approach) in further loading \[N/m\]; of a line with its reference length, or that
    /// of the grid without one.
    ///
    /// # Errors
    /// [`ContactError::Refused`] where its equations do not converge.
    pub fn tangent(&mut self) -> Result<f64, ContactError> {
        self.tangent_within(self.of.tolerance)
    }

    pub(crate) fn tangent_within(&mut self, tolerance: f64) -> Result<f64, ContactError> {
        let own = self.state.stiffness(tolerance)?;
        Ok(self.with_reference(own))
    }

    /// From a stiffness with the reference length of the grid, of a line per length.
    fn with_reference(&self, stiffness: f64) -> f64 {
        let more = self.of.beyond_grid(&self.state.grid).unwrap_or(0.0);
        self.of.shape.length() / (1.0 / stiffness + more)
    }

    /// dF over d(approach) of small vibrations \[N/m\]: the asperities respond with their unloading
    /// stiffness.
    ///
    /// # Errors
    /// [`ContactError::NotRequested`] if the unloading stiffness was not asked for.
    pub fn unloading_stiffness(&mut self) -> Result<f64, ContactError> {
        let values = self.per_area(Quantity::UnloadingStiffness)?;
        let loading = std::mem::replace(&mut self.state.slopes, values);
        let own = self.state.stiffness(self.of.tolerance);
        self.state.slopes = loading;
        Ok(self.with_reference(own?))
    }
}
