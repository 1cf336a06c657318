//! Stiffnesses of a solved contact: of first loading, and at the start of unloading, while its
//! pixels stay in contact, which small vibrations and ultrasound measure; and the surface that
//! yielding has left.

use std::ops::ControlFlow;

use crate::half_space::{Compliance, Filter, HalfSpace};
use crate::parallel::{inside, number, sum, update};
use crate::solver::Run;
use crate::{BemError, Boundary, BoundaryElements, HeightMap, Solution};

/// Relative residual, root mean square over the contact, at which the iteration ends.
const TOLERANCE: f64 = 1e-11;
/// Ten to thirty are usual.
const MOST_ITERATIONS: usize = 1000;
/// Share of the pressure to either side of it between which the slope is a difference: enough for
/// some pixels to come into contact, each of which is a small step, and little for a gap that
/// falls nearly with the logarithm of the pressure.
const STEP: f64 = 0.05;

/// The response of a contact to a small approach that leaves the set of touching pixels unchanged.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct FixedContact {
    /// Change of the mean pressure on the area of the map over the approach \[Pa/m\]. Periodic: the
    /// approach of the mean planes; free: the approach of the rigid surface to distant points of
    /// the half-space, which deflects under the map as a whole. Divided by 1 -
    /// [`mean_deflection`](Self::mean_deflection) it is the change over the fall of the mean gap.
    pub stiffness: f64,
    /// Change of the mean deflection of the map over the approach: 0 if periodic.
    pub mean_deflection: f64,
    /// Changes of the pressures over the approach \[Pa/m\], row after row; 0 outside the contact.
    pub pressures: Vec<f64>,
    /// Root mean square over the contact of the deviation from an even approach, over the approach.
    pub residual: f64,
    /// Iterations it took.
    pub iterations: usize,
}

impl BoundaryElements {
    /// The stiffness of `solution` at fixed contact: pixels that touch, elastic or plastic, respond
    /// elastically, and all of them deflect by the same approach.
    ///
    /// For elastic periodic contacts it is the slope of load over mean gap. For yielded ones it is
    /// the slope at the start of unloading, which exceeds the slope of loading. By Barber's analogy
    /// the constriction conductance of the same contacts is k_s/E times the stiffness. \[derived\]
    ///
    /// # Errors
    /// [`BemError::Count`] for the solution of a map of another size, [`BemError::FullContact`]
    /// where every pixel of a periodic map touches, [`BemError::NotConverged`].
    pub fn fixed_contact(&self, solution: &Solution) -> Result<FixedContact, BemError> {
        let pixels = self.pixels_of(solution)? as f64;
        let mut space = HalfSpace::new(&self.map, self.modulus, self.boundary_condition());
        let contact: Vec<f64> = solution.pressures.iter().map(|p| number(*p > 0.0)).collect();
        inside(|| {
            let mut fixed = even_approach(&contact, pixels, &mut space)?;
            if self.boundary_condition() == Boundary::Free {
                let mut deflections = fixed.pressures.clone();
                space.apply(Filter::Deflect, &mut deflections);
                let [total] = sum([&deflections], |[deflection]| [deflection]);
                fixed.mean_deflection = total / pixels;
            }
            Ok(fixed)
        })
    }

    /// The number of pixels of a solution of this map.
    pub(crate) fn pixels_of(&self, solution: &Solution) -> Result<usize, BemError> {
        let ([rows, columns], found) = (self.map.shape(), solution.pressures.len());
        let fits = found == rows * columns && solution.gaps.len() == found;
        if fits { Ok(found) } else { Err(BemError::Count { found, rows, columns }) }
    }

    /// -dp/d(mean gap) of first loading \[Pa/m\].
    ///
    /// Where nothing yields it is the slope of the [fixed contact](BoundaryElements::fixed_contact)
    /// over the mean gap, which with a free boundary exceeds that over the approach. Otherwise it
    /// is the chord between pressures up to 5 % to either side of the pressure of `solution`,
    /// nearer where the hardness carries less: of a gap that falls with the logarithm of the
    /// pressure that difference is 0.1 % off; where few pixels touch it is a mean over that range.
    ///
    /// # Errors
    /// [`BemError::Count`] for the solution of a map of another size, [`BemError::FullContact`]
    /// where every pixel touches, [`BemError::FullContactBeside`] where every pixel does at one of
    /// those pressures, [`BemError::Slope`] where the gap does not fall, and the errors of
    /// [`solve`](Self::solve).
    pub fn loading_stiffness(&self, solution: &Solution) -> Result<f64, BemError> {
        self.pixels_of(solution)?;
        if solution.pressures.iter().all(|pressure| *pressure > 0.0) {
            return Err(BemError::FullContact);
        }
        if solution.pressures.iter().all(|pressure| *pressure < self.cap()) {
            // Differences of light loads vanish in the rounding of the gaps.
            let fixed = self.fixed_contact(solution)?;
            return Ok(fixed.stiffness / (1.0 - fixed.mean_deflection));
        }
        let middle = solution.mean_pressure;
        // At most half of what is left to the hardness.
        let step = STEP.min(0.5 * (self.cap() / middle - 1.0));
        let [lighter, heavier] = [(1.0 - step) * middle, (1.0 + step) * middle];
        let mut run = Run::after(self, solution);
        let mut gap = |pressure: f64| -> Result<f64, BemError> {
            let fields = run.press(pressure, &mut |_, _| ControlFlow::Continue(()))?;
            match fields.pressures.iter().all(|pressure| *pressure > 0.0) {
                true => Err(BemError::FullContactBeside { pressure: middle, neighbour: pressure }),
                false => Ok(fields.mean_gap()),
            }
        };
        let (less, more) = (gap(heavier)?, gap(lighter)?);
        let slope = (heavier - lighter) / (more - less);
        match slope.is_finite() && slope > 0.0 {
            true => Ok(slope),
            false => Err(BemError::Slope { pressure: middle }),
        }
    }

    /// The same contact with the surface that `solution` leaves: its plastic depths are taken off
    /// the heights. The load of `solution` gives the same pressures again; smaller loads, or larger
    /// mean gaps, are the path of unloading, elastic as far as no pixel reaches the hardness again.
    ///
    /// Mean gaps count from the mean plane of the new heights, and the mean gap of `solution`
    /// becomes its [`gap_volume`](Solution::gap_volume): of a periodic map the difference to it is
    /// the retreat. \[derived\]
    ///
    /// # Errors
    /// [`BemError::Count`] for the solution of a map of another size.
    pub fn flattened_by(&self, solution: &Solution) -> Result<Self, BemError> {
        self.pixels_of(solution)?;
        let depths = solution.gaps.iter().zip(&solution.pressures);
        let cap = self.cap();
        let depths = depths.map(|(gap, pressure)| if *pressure < cap { 0.0 } else { gap.min(0.0) });
        let heights = self.map.heights().iter().zip(depths).map(|(height, depth)| height + depth);
        let mut flattened = self.clone();
        flattened.map = HeightMap::new(heights.collect(), self.map.shape(), self.map.pixel())?;
        Ok(flattened)
    }
}

/// The pressures that deflect the contact by 1 m everywhere, by preconditioned conjugate gradients.
/// `contact` is 1 on it and 0 elsewhere; `pixels` is the number of pixels of the map.
pub(crate) fn even_approach(
    contact: &[f64],
    pixels: f64,
    space: &mut impl Compliance,
) -> Result<FixedContact, BemError> {
    let [touching] = sum([contact], |[touches]| [touches]);
    let mut pressures = vec![0.0; contact.len()];
    let mut remainder = contact.to_vec();
    let mut direction = vec![0.0; contact.len()];
    let mut response = vec![0.0; contact.len()];
    let (mut residual, mut product, mut iterations) = (1.0, f64::INFINITY, 0);
    while iterations <= MOST_ITERATIONS {
        if residual <= TOLERANCE {
            let [total] = sum([&pressures], |[pressure]| [pressure]);
            let (stiffness, mean_deflection) = (total / pixels, 0.0);
            let fixed =
                FixedContact { stiffness, mean_deflection, pressures, residual, iterations };
            return Ok(fixed);
        }
        // The preconditioned remainder.
        response.copy_from_slice(&remainder);
        space.apply(Filter::Undo, &mut response);
        let before = product;
        [product] = sum([&remainder, &response], |[left, preconditioned]| [left * preconditioned]);
        let turn = if before.is_finite() { product / before } else { 0.0 };
        update(&mut direction, [&response, contact], |direction, [preconditioned, touches]| {
            *direction = touches * (preconditioned + turn * *direction);
            []
        });
        response.copy_from_slice(&direction);
        space.apply(Filter::Deflect, &mut response);
        let [curvature] =
            sum([&direction, &response], |[direction, response]| [direction * response]);
        let length = product / curvature;
        if !(curvature > 0.0 && length.is_finite()) {
            break;
        }
        update(&mut pressures, [&direction], |pressure, [direction]| {
            *pressure += length * direction;
            []
        });
        let [squares] =
            update(&mut remainder, [&response, contact], |left, [response, touches]| {
                *left -= length * touches * response;
                [left.powi(2)]
            });
        residual = (squares / touching).sqrt();
        iterations += 1;
    }
    if touching >= pixels {
        return Err(BemError::FullContact);
    }
    Err(BemError::NotConverged { residual, iterations, required: TOLERANCE })
}
