//! The work of closing a joint for the first time, and what opening gives back of it.

use asperity_core::{At, ContactError, Evaluation, Quantity};
use asperity_quadrature::{Estimate, fallible, gauss_kronrod};

use crate::Joint;
use crate::asperity_laws::MAX_SAMPLES;

/// No force is looked at beyond this separation \[σ_z\].
const MAX_DISTANCE: f64 = 1e8;

/// What closing as far as some place for the first time takes, and what opening gives back.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Work {
    /// The work \[J\] of first closing, from no contact on.
    pub spent: Evaluation,
    /// The work \[J\] that opening gives back.
    pub returned: Evaluation,
}

impl Work {
    /// The work \[J\] that yielding has taken for good: what is spent less what comes back, with a
    /// bound relative to both. A cycle between fixed separations loses it once; after that, it
    /// retraces. 0 where nothing can yield.
    ///
    /// Below 0 where the pair of loading and unloading laws creates energy; no such value goes
    /// without an [`EnergyGain`](crate::EnergyGain) by [`Joint::energy_gain`].
    #[must_use]
    pub fn lost(&self) -> Evaluation {
        self.spent.less(&self.returned)
    }

    /// What is [lost](Self::lost) over 2π times what was spent.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] where no work that a double holds is spent.
    pub fn loss_factor(&self) -> Result<f64, ContactError> {
        let spent = self.spent.value();
        if spent < f64::MIN_POSITIVE {
            let (field, required) =
                ("work of closing", "a closest approach at which a double holds it (2.2e-308 J)");
            return Err(ContactError::OutOfRange { field, value: spent, required });
        }
        Ok(self.lost().value() / (2.0 * std::f64::consts::PI * spent))
    }
}

impl Joint {
    /// The work of first closing, from no contact to `closest`, and of opening again.
    ///
    /// # Errors
    /// Those of the contact's evaluations, [`ContactError::Integral`], and
    /// [`ContactError::OutOfRange`] under heights with a tail so heavy that work is left beyond 1e8
    /// σ_z.
    pub fn work(&self, closest: At) -> Result<Work, ContactError> {
        let way = self.unloading(closest)?;
        let spent = self.spent(way.place())?;
        // What never yields goes back as it came.
        let returned = if self.yields() { way.returned(f64::INFINITY)? } else { spent };
        Ok(Work { spent, returned })
    }

    /// The work of first closing to a place \[σ_z from the mean of the asperity heights\].
    fn spent(&self, place: f64) -> Result<Evaluation, ContactError> {
        let sigma = self.scene().surface.asperity_height_std;
        // Twice as far each time, until nothing is left.
        let (mut from, mut step) = (sigma * place, sigma);
        let (mut work, mut error) = (0.0, 0.0);
        loop {
            let panel = self.closing(from + step, from)?;
            (work, error) = (work + panel.value, error + panel.error);
            (from, step) = (from + step, 2.0 * step);
            if panel.value <= 1e-3 * self.tolerance().relative() * work {
                // What is left is less than the last panel; forces are known to the tolerance.
                let relative = if work > 0.0 { (error + panel.value) / work } else { 0.0 };
                return Ok(Evaluation::new(work, relative + self.tolerance().relative()));
            }
            if from > MAX_DISTANCE * sigma {
                let field = "share of the work beyond 1e8 asperity_height_std";
                let required = "next to none, as heights with a lighter tail leave it,";
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
