//! The slope of first loading.

use std::ops::ControlFlow;

use crate::solver::Run;
use crate::{BemError, BoundaryElements, Solution};

/// Share of the pressure to either side of it between which the slope is a difference: enough for
/// some pixels to come into contact, each of which is a small step, and little for a gap that
/// falls nearly with the logarithm of the pressure.
const STEP: f64 = 0.05;

impl BoundaryElements {
    /// The number of pixels of a solution of this map.
    pub(crate) fn pixels_of(&self, solution: &Solution) -> Result<usize, BemError> {
        let ([rows, columns], found) = (self.map().shape(), solution.pressures.len());
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
}
