//! Tangential force against shift at a constant separation.

use asperity_core::{ContactError, Evaluation, positive, require};

use crate::Unloading;
use crate::asperity_laws::UnloadingQuantity;
use crate::unloading::{MAX_DISTANCE, falling_root};

/// Retreat \[σ_z\] beyond which the integrals may overflow.
const MAX_RETREAT: f64 = 1e100;

/// Largest coefficient of friction; larger numbers are probably in per cent.
const MAX_FRICTION: f64 = 10.0;

/// Returns a coefficient of friction if it is in range.
///
/// # Errors
/// [`ContactError::OutOfRange`] unless it is above 0 and at most 10.
pub fn coefficient_of_friction(friction: f64) -> Result<f64, ContactError> {
    let field = "friction";
    let required = "a coefficient of friction, at most 10 (one of 20 % is 0.2),";
    require(positive(field, friction)? <= MAX_FRICTION, field, friction, required)
}

/// Relative rounding error of a tangential force.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Relative error of an amplitude that rounding alone may cause.
const LEAST_ERROR: f64 = 1e-10;

/// Partial slip of a closed joint, on first shearing or in cycles.
#[derive(Debug, Clone)]
pub struct PartialSlip {
    normal: Unloading,
    friction: f64,
    /// s/u = 4 G/(μ E).
    retreat_per_shift: f64,
}

impl PartialSlip {
    /// A joint with coefficient of friction μ, whose asperities respond elastically to tangential
    /// forces, as in unloading.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] unless μ > 0 and at most 10, [`ContactError::Missing`] without
    /// an equivalent shear modulus.
    pub fn new(normal: &Unloading, friction: f64) -> Result<Self, ContactError> {
        let friction = coefficient_of_friction(friction)?;
        if normal.joint.loading.sum.is_some() {
            let what = "partial slip: contacts beside the tops of asperities are inclined, which counts under friction; use a model without -pairs";
            let (model, what) = (normal.joint.name.clone(), what.into());
            return Err(ContactError::Unsupported { model, what });
        }
        let asperity = normal.scene().asperity()?;
        let shear = asperity.shear_modulus(&format!("partial slip by {}", normal.joint.name))?;
        let retreat_per_shift = 4.0 * shear / (friction * asperity.equivalent_modulus);
        Ok(Self { normal: normal.clone(), friction, retreat_per_shift })
    }

    /// The tangential force Q \[N\] at a first shift \[m\], at least 0.
    ///
    /// # Errors
    /// The errors of [`Unloading::force`].
    pub fn force(&self, shift: f64) -> Result<Evaluation, ContactError> {
        self.scaled(self.friction, UnloadingQuantity::Released, ("shift", shift))
    }

    /// The tangential force \[N\] in a steady cycle between ±`amplitude` \[m\] at `shift` \[m\]:
    /// from -amplitude if `forth`, otherwise back from +amplitude.
    ///
    /// # Errors
    /// The errors of [`force`](Self::force); [`ContactError::OutOfRange`] for a shift beyond the
    /// amplitude.
    pub fn loop_force(&self, shift: f64, amplitude: f64, forth: bool) -> Result<f64, ContactError> {
        let amplitude = positive("amplitude", amplitude)?;
        let required = "between -amplitude and amplitude";
        require(shift.abs() <= amplitude, "shift", shift, required)?;
        // Both branches are point-symmetric.
        let turned = if forth { -shift } else { shift };
        let end = self.force(amplitude)?.value();
        let back = end - 2.0 * self.force(0.5 * (amplitude - turned))?.value();
        Ok(if forth { -back } else { back })
    }

    /// The energy \[J\] dissipated by a cycle between ±`amplitude` \[m\].
    ///
    /// # Errors
    /// The errors of [`force`](Self::force).
    pub fn loss(&self, amplitude: f64) -> Result<Evaluation, ContactError> {
        let factor = self.friction / self.retreat_per_shift;
        self.scaled(factor, UnloadingQuantity::Loss, ("amplitude", amplitude))
    }

    /// The loss factor of a cycle between ±`amplitude` D \[m\]: the energy
    /// [dissipated](Self::loss)/(π Q D), from 0 for small amplitudes to 4/π in gross slip.
    ///
    /// # Errors
    /// The errors of [`force`](Self::force), and [`ContactError::OutOfRange`] unless the amplitude
    /// is above 0 and the loss at least 2.2e-308 J.
    pub fn loss_factor(&self, amplitude: f64) -> Result<f64, ContactError> {
        let amplitude = positive("amplitude", amplitude)?;
        let (loss, force) = (self.loss(amplitude)?.value(), self.force(amplitude)?.value());
        let spring = std::f64::consts::PI * force * amplitude;
        let required = "an amplitude with a loss of at least 2.2e-308 J";
        require(loss.min(spring) >= f64::MIN_POSITIVE, "amplitude", amplitude, required)?;
        Ok(loss / spring)
    }

    /// The smallest shift \[m\] at which the tangential force reaches a `share`, above 0 and below
    /// 1, of its limit μ F. With unbounded heights some asperities stick at any shift; a share of
    /// 0.99 is nearly gross slip.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] for a share out of range or a joint without force; the errors
    /// of [`force`](Self::force).
    pub fn shift_at(&self, share: f64) -> Result<f64, ContactError> {
        require(share > 0.0 && share < 1.0, "share", share, "a number above 0 and below 1")?;
        let whole = self.normal.force(0.0)?.value();
        let slope = self.normal.stiffness(0.0)?.value() * self.retreat_per_shift;
        // The force is concave: its initial slope bounds the shift from below.
        let low = 0.5 * share * whole / slope;
        let required = "a force above 0 at the closest approach";
        require(low > 0.0 && low.is_finite(), "force", whole, required)?;
        let wanted = share * self.friction * whole;
        let missing = |shift: f64| Ok(wanted - self.force(shift)?.value());
        let sigma = self.normal.scene().surface.asperity_height_std;
        let farthest = MAX_DISTANCE * sigma / self.retreat_per_shift;
        let found = falling_root(missing, (low, 4.0 * low), farthest)?;
        // Close to 1 the share is within the errors of the integrals.
        let required = "a smaller share, reached within a retreat of 1e4 asperity_height_std,";
        found.ok_or(ContactError::OutOfRange { field: "share", value: share, required })
    }

    /// The force μ F \[N\] at which the joint slides.
    ///
    /// # Errors
    /// The errors of [`Unloading::force`].
    pub fn limit(&self) -> Result<f64, ContactError> {
        Ok(self.friction * self.normal.force(0.0)?.value())
    }

    /// The amplitude of shift \[m\] of a cycle with this amplitude of the tangential force \[N\]:
    /// the inverse of [`force`](Self::force).
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] unless the force is above 0 and below the
    /// [`limit`](Self::limit), at which the joint slides, by more than the tolerance, and where
    /// rounding of a force so near the limit changes the amplitude by more than the tolerance or
    /// 1e-10; the errors of [`shift_at`](Self::shift_at).
    pub fn amplitude_at(&self, force: f64) -> Result<f64, ContactError> {
        let (field, force) = ("tangential_force", positive("tangential_force", force)?);
        let (limit, tolerance) = (self.limit()?, self.normal.joint.tolerance.relative());
        let required = "less than friction times the normal force, within the tolerance of which the joint slides,";
        let slides = ContactError::OutOfRange { field, value: force, required };
        if force >= limit * (1.0 - tolerance) {
            return Err(slides);
        }
        let amplitude = self.shift_at(force / limit)?;
        let retreat = self.retreat_per_shift * amplitude;
        let stiffness = self.normal.stiffness(retreat)?.value();
        let slope = self.friction * self.retreat_per_shift * stiffness;
        // Near the limit the force hardly changes with the shift.
        let error = ROUNDING * force / (slope * amplitude);
        if error.is_nan() || error > tolerance.max(LEAST_ERROR) {
            return Err(slides);
        }
        Ok(amplitude)
    }

    fn scaled(
        &self,
        factor: f64,
        quantity: UnloadingQuantity,
        (field, shift): (&'static str, f64),
    ) -> Result<Evaluation, ContactError> {
        let is_finite = shift >= 0.0 && shift.is_finite();
        require(is_finite, field, shift, "a finite number, at least 0,")?;
        let retreat = self.retreat_per_shift * shift;
        let most = MAX_RETREAT * self.normal.scene().surface.asperity_height_std;
        let required = "a smaller one, with a retreat 4 G/(mu E) times it of at most 1e100 asperity_height_std,";
        require(retreat <= most, field, shift, required)?;
        let mut found = self.normal.of(quantity, retreat)?;
        found.scaled *= factor;
        found.size *= factor;
        Ok(found)
    }
}
