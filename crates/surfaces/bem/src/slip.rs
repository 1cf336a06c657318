//! Partial slip of an elastic contact under a constant load, from its normal solutions.
//!
//! With friction μ and bodies of like materials, the tractions are μ (p(P) - p(P*)): pressures of
//! the contact less pressures of the same contact under the smaller load P*, whose pixels stick.
//! Hence the tangential force Q = μ (P - P*), and the shift u = μ E/(4 G) (δ(P) - δ(P*)) with the
//! approach δ (Ciavarella 1998, Jaeger 1998 \[recalled\]; \[derived\] from the ratio of the
//! compliances). It is exact for circular contacts and for ν = 0; otherwise the ratio E/(4 G)
//! depends on the shape: at ν = 0.3 contacts of 5 to 1 have 4 G/E of 0.77 to 0.88, circles 0.82.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use crate::half_space::HalfSpace;
use crate::parallel::sum;
use crate::{BemError, BoundaryElements, LoadCase, Progress, Solution};

/// Relative difference of shifts that are the same.
const SAME: f64 = 1e-9;
/// Relative distance from the limit within which a traction slides: the error of pressures.
const SLIDES: f64 = 1e-8;

/// The partial slip of a solved contact under a constant load.
#[derive(Debug)]
pub struct ContactSlip {
    elements: BoundaryElements,
    friction: f64,
    /// 4 G/(μ E).
    retreat_per_shift: f64,
    closest: Normal,
    /// Pressures of `closest` \[Pa\].
    pressures: Vec<f64>,
    /// Shifts \[m\], and the contacts that stick after them.
    known: Mutex<Vec<(f64, Normal)>>,
}

/// A normal solution, per area of the map.
#[derive(Debug, Clone, Copy, Default)]
struct Normal {
    pressure: f64,
    separation: f64,
    /// Elastic energy \[J/m²\].
    energy: f64,
    /// Pixels that touch.
    touching: usize,
}

impl ContactSlip {
    /// The slip of an elastic `solution`, with the coefficient of friction μ and the ratio 4 G/E of
    /// the stiffnesses in shear and under load, 2 (1-ν)/(2-ν) for like bodies.
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] for a number that is not above 0, and for a solution with pixels at
    /// the hardness.
    pub fn new(
        elements: BoundaryElements,
        solution: &Solution,
        friction: f64,
        stiffness_ratio: f64,
    ) -> Result<Self, BemError> {
        let friction = crate::height_map::positive("friction", friction)?;
        let ratio = crate::height_map::positive("stiffness ratio", stiffness_ratio)?;
        if solution.plastic_area > 0.0 {
            let required =
                "0, as slip of a scan is elastic (use a smaller load, or leave out the hardness),";
            let (field, found) = (
                "share of the contact at the hardness",
                solution.plastic_area / solution.pixel_area,
            );
            return Err(BemError::OutOfRange { field, found, required });
        }
        let closest = normal(&elements, solution);
        let (pressures, known) = (solution.pressures.clone(), Mutex::default());
        let retreat_per_shift = ratio / friction;
        Ok(Self { elements, friction, retreat_per_shift, closest, pressures, known })
    }

    /// The tangential force over the area of the map \[Pa\] after a first shift \[m\].
    ///
    /// # Errors
    /// The errors of [`BoundaryElements::solve`], as for all that follow.
    pub fn traction(&self, shift: f64) -> Result<f64, BemError> {
        Ok(self.friction * (self.closest.pressure - self.after(shift)?.pressure))
    }

    /// The energy that a cycle between ±`amplitude` \[m\] dissipates, over the area of the map
    /// \[J/m²\]. The integral of the traction follows from the elastic energies of both contacts.
    ///
    /// # Errors
    /// The errors of [`traction`](Self::traction), and an amplitude at which no pixel slips.
    pub fn loss(&self, amplitude: f64) -> Result<f64, BemError> {
        let Normal { pressure, energy, separation, touching, .. } = self.closest;
        let after = self.after(amplitude)?;
        if amplitude > 0.0 && after.touching >= touching {
            let required = "one at which pixels slip, as a narrower slip has no known loss,";
            return Err(BemError::OutOfRange { field: "amplitude", found: amplitude, required });
        }
        // Not from the amplitude, whose error would remain in the small differences that follow.
        let retreat = after.separation - separation;
        let area = pressure * retreat - energy + after.energy;
        let triangle = 0.5 * (pressure - after.pressure) * retreat;
        Ok((8.0 * self.friction / self.retreat_per_shift * (area - triangle)).max(0.0))
    }

    /// The traction at which all slides, over the area of the map \[Pa\].
    #[must_use]
    pub fn limit(&self) -> f64 {
        self.friction * self.closest.pressure
    }

    /// The shift \[m\] of a traction over the area of the map \[Pa\].
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] unless it is above 0 and below the [`limit`](Self::limit).
    pub fn shift_at(&self, traction: f64) -> Result<f64, BemError> {
        if !(traction > 0.0 && traction < self.limit() * (1.0 - SLIDES)) {
            let required = "a traction above 0 and below friction times the pressure";
            return Err(BemError::OutOfRange { field: "traction", found: traction, required });
        }
        let rest = self.closest.pressure - traction / self.friction;
        let after = normal(&self.elements, &self.elements.solve(LoadCase::MeanPressure(rest))?);
        let shift = (after.separation - self.closest.separation) / self.retreat_per_shift;
        self.keep(shift, after);
        Ok(shift)
    }

    /// The tractions of all pixels \[Pa\] after a first shift \[m\], and which of them stick.
    ///
    /// # Errors
    /// The errors of [`traction`](Self::traction).
    pub fn tractions(&self, shift: f64) -> Result<(Vec<f64>, Vec<bool>), BemError> {
        let rest = match self.after(shift)?.pressure {
            0.0 => vec![0.0; self.pressures.len()],
            rest => self.elements.solve(LoadCase::MeanPressure(rest))?.pressures,
        };
        let pairs = self.pressures.iter().zip(&rest);
        let tractions = pairs.map(|(p, rest)| self.friction * (p - rest)).collect();
        Ok((tractions, rest.iter().map(|rest| *rest > 0.0).collect()))
    }

    /// Solves the contact that sticks after a shift \[m\], for later calls; `progress` may stop it.
    ///
    /// # Errors
    /// [`BemError::Cancelled`], and the errors of [`traction`](Self::traction).
    pub fn solve(
        &self,
        shift: f64,
        progress: impl FnMut(&Progress) -> ControlFlow<()>,
    ) -> Result<(), BemError> {
        let separation = self.closest.separation + self.retreat_per_shift * shift;
        if shift > 0.0 && separation < self.elements.map.highest() {
            let given = [LoadCase::Separation(separation)];
            let found = self.elements.solve_all(&given, progress).remove(0)?;
            self.keep(shift, normal(&self.elements, &found));
        }
        Ok(())
    }

    fn keep(&self, shift: f64, normal: Normal) {
        self.known.lock().unwrap_or_else(PoisonError::into_inner).push((shift, normal));
    }

    /// The contact that sticks after a shift, under P*.
    fn after(&self, shift: f64) -> Result<Normal, BemError> {
        if !(shift >= 0.0 && shift.is_finite()) {
            let required = "a finite number, at least 0,";
            return Err(BemError::OutOfRange { field: "shift", found: shift, required });
        }
        if shift == 0.0 {
            return Ok(self.closest);
        }
        let separation = self.closest.separation + self.retreat_per_shift * shift;
        if separation >= self.elements.map.highest() {
            return Ok(Normal { separation, ..Normal::default() });
        }
        let found = || {
            let known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
            let same = |(other, _): &&(f64, Normal)| (other - shift).abs() <= SAME * shift;
            known.iter().find(same).map(|(_, normal)| *normal)
        };
        if found().is_none() {
            self.solve(shift, |_| ControlFlow::Continue(()))?;
        }
        found().ok_or(BemError::Cancelled)
    }
}

/// The numbers of a solution that slip needs.
fn normal(elements: &BoundaryElements, solution: &Solution) -> Normal {
    let mut space = HalfSpace::new(&elements.map, elements.modulus, elements.boundary_condition());
    let mut deflections = vec![0.0; solution.pressures.len()];
    space.deflect(&solution.pressures, &mut deflections);
    let [work] = sum([&deflections, &solution.pressures], |[u, p]| [p * u]);
    let pixels = deflections.len() as f64;
    Normal {
        pressure: solution.mean_pressure,
        separation: solution.separation,
        energy: 0.5 * work / pixels,
        touching: solution.pressures.iter().filter(|pressure| **pressure > 0.0).count(),
    }
}
