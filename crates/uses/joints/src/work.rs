//! The work of first closing a joint, and the work returned by opening.

use asperity_core::{At, ContactError, Evaluation, Quantity};
use asperity_quadrature::{Estimate, fallible, gauss_kronrod};

use crate::Joint;
use crate::asperity_laws::MAX_SAMPLES;

/// Largest separation integrated \[σ_z\].
const MAX_DISTANCE: f64 = 1e8;

/// The work of first closing to a closest approach, and the work returned by opening.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Work {
    /// The work \[J\] of first closing from no contact.
    pub spent: Evaluation,
    /// The work \[J\] returned by opening.
    pub returned: Evaluation,
}

impl Work {
    /// The energy \[J\] dissipated by plastic deformation: work spent minus work returned, with an
    /// error bound relative to both. A cycle between fixed separations dissipates it in the first
    /// cycle only. 0 for elastic models.
    ///
    /// Below 0 where the pair of loading and unloading laws creates energy, which
    /// [`Joint::energy_gain`] reports as an [`EnergyGain`](crate::EnergyGain).
    #[must_use]
    pub fn lost(&self) -> Evaluation {
        self.spent.less(&self.returned)
    }

    /// The loss factor: energy [dissipated](Self::lost)/(2π × work spent).
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] where the work spent is below 2.2e-308 J.
    pub fn loss_factor(&self) -> Result<f64, ContactError> {
        let spent = self.spent.value();
        if spent < f64::MIN_POSITIVE {
            let (field, required) =
                ("work of closing", "at least 2.2e-308 J, at a closer approach,");
            return Err(ContactError::OutOfRange { field, value: spent, required });
        }
        Ok(self.lost().value() / (2.0 * std::f64::consts::PI * spent))
    }
}

impl Joint {
    /// The work of first closing from no contact to `closest`, and the work returned by opening.
    ///
    /// # Errors
    /// The errors of the contact's evaluations, [`ContactError::Integral`], and
    /// [`ContactError::OutOfRange`] for heights with so heavy a tail that separations beyond 1e8
    /// σ_z contribute to the work.
    pub fn work(&self, closest: At) -> Result<Work, ContactError> {
        let way = self.unloading(closest)?;
        let spent = self.spent(way.place())?;
        // Elastic contacts return all of the work.
        let returned = if self.yields() { way.returned(f64::INFINITY)? } else { spent };
        Ok(Work { spent, returned })
    }

    /// The work of first closing to a separation \[σ_z from the mean of the asperity heights\].
    fn spent(&self, place: f64) -> Result<Evaluation, ContactError> {
        let sigma = self.scene().surface.asperity_height_std;
        // Panels double in length until their work is negligible.
        let (mut from, mut step) = (sigma * place, sigma);
        let (mut work, mut error) = (0.0, 0.0);
        loop {
            let panel = self.closing(from + step, from)?;
            (work, error) = (work + panel.value, error + panel.error);
            (from, step) = (from + step, 2.0 * step);
            if panel.value <= 1e-3 * self.tolerance().relative() * work {
                // The rest is less than the last panel; forces have the error of the tolerance.
                let relative = if work > 0.0 { (error + panel.value) / work } else { 0.0 };
                return Ok(Evaluation::new(work, relative + self.tolerance().relative()));
            }
            if from > MAX_DISTANCE * sigma {
                let field = "share of the work beyond 1e8 asperity_height_std";
                let required = "about 0, for which the heights need a lighter tail,";
                return Err(ContactError::OutOfRange {
                    field,
                    value: panel.value / work,
                    required,
                });
            }
        }
    }

    /// The work \[J\] of first closing from one separation \[m\] to another, both from the mean of
    /// the asperity heights.
    pub(crate) fn closing(&self, from: f64, to: f64) -> Result<Estimate, ContactError> {
        let quantity = Quantity::Force;
        let force =
            |d| Ok::<_, ContactError>(self.virgin().evaluate(quantity, At::metres(d))?.value());
        let goal = self.tolerance().relative();
        let work = fallible(force, |force| gauss_kronrod(force, &[to, from], goal, MAX_SAMPLES))?;
        let at = At::metres(to);
        work.map_err(|source| ContactError::Integral { quantity, at, source })
    }
}
