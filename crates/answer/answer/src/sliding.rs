//! What partial slip asks of a joint, by a model of asperities or by boundary elements.

use asperity::joints::PartialSlip;

use crate::subject::Outcome;

/// A joint at one preload: forces \[N\] and energies \[J\] of shifts \[m\].
pub(crate) trait Sliding {
    /// The tangential force of a first shift.
    fn force(&self, shift: f64) -> Outcome<f64>;

    /// The energy that a cycle of this amplitude dissipates.
    fn loss(&self, amplitude: f64) -> Outcome<f64>;

    /// The force at which all slides.
    fn limit(&self) -> Outcome<f64>;

    /// The shift at which the force reaches a share of the limit.
    fn shift_at(&self, share: f64) -> Outcome<f64>;

    /// The shift of a force.
    fn amplitude_at(&self, force: f64) -> Outcome<f64>;

    /// The force in a steady cycle on the way back or `forth`.
    fn loop_force(&self, shift: f64, amplitude: f64, forth: bool) -> Outcome<f64> {
        // Both branches are point-symmetric.
        let turned = if forth { -shift } else { shift };
        let back = self.force(amplitude)? - 2.0 * self.force(0.5 * (amplitude - turned))?;
        Ok(if forth { -back } else { back })
    }

    /// The loss factor of a cycle, as [`PartialSlip::loss_factor`].
    fn loss_factor(&self, amplitude: f64) -> Outcome<f64> {
        let spring = std::f64::consts::PI * self.force(amplitude)? * amplitude;
        Ok(self.loss(amplitude)? / spring)
    }

    /// Computes what these shifts need.
    fn prepare(&self, shifts: &[f64]) -> Outcome {
        let _ = shifts;
        Ok(())
    }

    /// The pixels of a scan that stick (2) and slip (1) at this amplitude, row after row; none by a
    /// model of asperities.
    fn states(&self, amplitude: f64) -> Outcome<Vec<f64>> {
        let _ = amplitude;
        Ok(vec![])
    }
}

impl Sliding for PartialSlip {
    fn force(&self, shift: f64) -> Outcome<f64> {
        Ok(PartialSlip::force(self, shift)?.value())
    }

    fn loss(&self, amplitude: f64) -> Outcome<f64> {
        Ok(PartialSlip::loss(self, amplitude)?.value())
    }

    fn limit(&self) -> Outcome<f64> {
        Ok(PartialSlip::limit(self)?)
    }

    fn shift_at(&self, share: f64) -> Outcome<f64> {
        Ok(PartialSlip::shift_at(self, share)?)
    }

    fn amplitude_at(&self, force: f64) -> Outcome<f64> {
        Ok(PartialSlip::amplitude_at(self, force)?)
    }

    fn loss_factor(&self, amplitude: f64) -> Outcome<f64> {
        Ok(PartialSlip::loss_factor(self, amplitude)?)
    }
}
