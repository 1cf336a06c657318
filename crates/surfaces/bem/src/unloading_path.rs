//! The path of unloading from a load or a gap: the contact shrinks on the surface that yielding has
//! left.

use std::ops::ControlFlow;

use asperity_core::{Finding, Quantity};

use crate::{BemError, BoundaryElements, ContactSummary, LoadCase, Progress};

/// The unloading of a contact from its greatest load.
#[derive(Debug, Clone)]
pub struct UnloadingPath {
    /// The surface that yielding has left.
    flattened: BoundaryElements,
    closest: ContactSummary,
    /// Separation of `closest` from the mean plane of the flattened surface \[m\].
    separation: f64,
    notes: Vec<Finding>,
}

impl BoundaryElements {
    /// Solves the greatest load, from which the contact unloads.
    ///
    /// # Errors
    /// The errors of [`solve`](Self::solve).
    pub fn unloading_from(&self, greatest: LoadCase) -> Result<UnloadingPath, BemError> {
        let solution = self.solve(greatest)?;
        Ok(UnloadingPath {
            flattened: self.flattened_by(&solution)?,
            closest: self.summary(&solution, &[Quantity::UnloadingStiffness]),
            separation: solution.separation + (solution.gap_volume - solution.mean_gap),
            notes: solution.notes,
        })
    }
}

impl UnloadingPath {
    /// The contact at the greatest load, with the stiffness at the start of unloading.
    #[must_use]
    pub fn closest(&self) -> &ContactSummary {
        &self.closest
    }

    /// Findings of the resolution at the greatest load.
    #[must_use]
    pub fn notes(&self) -> &[Finding] {
        &self.notes
    }

    /// The retreat at which the last pixel parts \[m\].
    #[must_use]
    pub fn last_contact(&self) -> f64 {
        (self.flattened.map.highest() - self.separation).max(0.0)
    }

    /// The contacts after retreats \[m\] from the greatest load, in their order: pressures, areas
    /// and stiffnesses on the surface that yielding has left, and mean gaps and separations from
    /// the mean plane of the first surface. Retreats are differences of
    /// [separations](crate::Solution::separation). `progress` is called at every iteration and may
    /// stop the run.
    ///
    /// # Errors
    /// Each contact has its own: [`BemError::OutOfRange`] for a retreat that is negative or no
    /// number, and the errors of [`BoundaryElements::solve`].
    pub fn at_retreats(
        &self,
        retreats: &[f64],
        progress: impl FnMut(&Progress) -> ControlFlow<()>,
    ) -> Vec<Result<ContactSummary, BemError>> {
        let mut found: Vec<Result<ContactSummary, BemError>> = vec![];
        let (mut given, mut places) = (vec![], vec![]);
        for &retreat in retreats {
            found.push(match retreat {
                0.0 => Ok(self.closest.clone()),
                _ if !(retreat > 0.0 && retreat.is_finite()) => {
                    let required = "a number that is not negative";
                    Err(BemError::OutOfRange { field: "retreat", found: retreat, required })
                }
                _ if retreat >= self.last_contact() => {
                    Ok(ContactSummary::open(self.separation + retreat))
                }
                _ => {
                    given.push(LoadCase::Separation(self.separation + retreat));
                    places.push(found.len());
                    Err(BemError::Cancelled)
                }
            });
        }
        self.flattened.solve_each(&given, progress, |index, solution| {
            let of = |solution| self.flattened.summary(&solution, &[Quantity::UnloadingStiffness]);
            found[places[index]] = solution.map(of);
        });
        for (retreat, found) in retreats.iter().zip(&mut found).filter(|(r, _)| **r > 0.0) {
            if let Ok(contact) = found {
                let deflection = contact.mean_gap - contact.separation;
                contact.separation = self.closest.separation + retreat;
                contact.mean_gap = contact.separation + deflection;
            }
        }
        found
    }
}
