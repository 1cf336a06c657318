//! Unloading of a rough contact from its closest approach.

use asperity_core::{
    At, ContactError, ContactModel, Datum, Evaluation, Quantity, Scene, Separation, SeparationUnit,
    Tolerance, positive, require,
};
use asperity_quadrature::{bracketed_root, fallible};

use crate::asperity_laws::UnloadingQuantity;
use crate::joint::Joint;
use crate::unloading_law::UnloadingLaw;

/// Largest retreat searched \[σ_z\].
pub(crate) const MAX_DISTANCE: f64 = 1e4;
/// Tolerance of searches where the integrals do not reach the joint's.
const ROUGH: f64 = 1e-6;

/// Unloading of a contact from its closest approach.
#[derive(Debug, Clone)]
pub struct Unloading {
    pub(crate) joint: Joint,
    closest: Separation,
    /// In σ_z from the mean of the asperity heights.
    pub(crate) place: f64,
}

impl Joint {
    /// Unloading from a closest approach; for a load, from the largest separation that carries it.
    ///
    /// # Errors
    /// The errors of finding a load.
    pub fn unloading(&self, closest: At) -> Result<Unloading, ContactError> {
        let closest = self.virgin().separation(closest)?;
        let (sigmas, mean) = (SeparationUnit::Sigma, Datum::AsperityMean);
        let place = closest.measured_in(sigmas, mean, self.scene())?.value;
        Ok(Unloading { joint: self.clone(), closest, place })
    }
}

impl Unloading {
    /// A model's contact on a scene, first closed to `closest`; for a load, to the largest
    /// separation that carries it.
    ///
    /// # Errors
    /// The errors of [`Joint::new`] and [`Joint::unloading`].
    pub fn new(
        model: &(impl ContactModel + ?Sized),
        scene: &Scene,
        closest: At,
        law: UnloadingLaw,
        tolerance: Tolerance,
    ) -> Result<Self, ContactError> {
        Joint::new(model, scene, law, tolerance)?.unloading(closest)
    }

    /// The closest approach.
    #[must_use]
    pub fn closest(&self) -> Separation {
        self.closest
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        self.joint.scene()
    }

    /// The unloading law.
    #[must_use]
    pub fn law(&self) -> UnloadingLaw {
        self.joint.law()
    }

    /// The force \[N\] after a `retreat` \[m\] of at least 0; 0 where the number of contacts
    /// underflows.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`], [`ContactError::Integral`].
    pub fn force(&self, retreat: f64) -> Result<Evaluation, ContactError> {
        self.of(UnloadingQuantity::Force, retreat)
    }

    /// The real contact area \[m²\] after a `retreat` \[m\].
    ///
    /// # Errors
    /// The errors of [`force`](Self::force), and [`ContactError::Unsupported`] for Etsion's law.
    pub fn area(&self, retreat: f64) -> Result<Evaluation, ContactError> {
        if self.law() == UnloadingLaw::Etsion {
            let what = "an area in unloading by etsion: use hertz or brake".into();
            return Err(ContactError::Unsupported { model: self.joint.name.clone(), what });
        }
        self.of(UnloadingQuantity::Area, retreat)
    }

    /// The average number of asperities in contact after a `retreat` \[m\]; below 1, most
    /// realisations have lost contact.
    ///
    /// # Errors
    /// The errors of [`force`](Self::force).
    pub fn contacts(&self, retreat: f64) -> Result<Evaluation, ContactError> {
        self.of(UnloadingQuantity::Contacts, retreat)
    }

    /// The retreat \[m\] at which one asperity is in contact on average, the end of contact; 0
    /// where no more than one is in contact at the closest approach. Integrals that do not reach
    /// the tolerance are accepted to 1e-6.
    ///
    /// # Errors
    /// The errors of [`force`](Self::force); [`ContactError::OutOfRange`] where more than one
    /// asperity is in contact after 1e4 σ_z.
    pub fn last_contact(&self) -> Result<f64, ContactError> {
        let sigma = self.scene().surface.asperity_height_std;
        // Logarithms, as the number falls faster than any power.
        let contacts = self.at_least_roughly(UnloadingQuantity::Contacts)?;
        let over_one = |u: f64| Ok(contacts(u)?.ln_value());
        let found = falling_root(over_one, (0.0, 0.1 * sigma), MAX_DISTANCE * sigma)?;
        match found {
            Some(retreat) => Ok(retreat),
            None => Err(ContactError::OutOfRange {
                field: "contacts",
                value: contacts(0.0)?.value(),
                required: "at most 1 within a retreat of 1e4 asperity_height_std",
            }),
        }
    }

    /// A quantity as a function of the retreat, to the tolerance of the joint or, where its
    /// integral does not reach that, to 1e-6.
    fn at_least_roughly(
        &self,
        quantity: UnloadingQuantity,
    ) -> Result<impl Fn(f64) -> Result<Evaluation, ContactError>, ContactError> {
        let rough = Self {
            joint: self.joint.with_tolerance_at_least(Tolerance::new(ROUGH)?),
            ..self.clone()
        };
        Ok(move |u| match self.of(quantity, u) {
            Err(ContactError::Integral { .. }) => rough.of(quantity, u),
            found => found,
        })
    }

    /// The retreat \[m\] with a remaining force \[N\] below that at the closest approach. Integrals
    /// that do not reach the tolerance are accepted to 1e-6.
    pub(crate) fn retreat_to(&self, load: f64) -> Result<f64, ContactError> {
        let load = positive("load", load)?;
        let sigma = self.scene().surface.asperity_height_std;
        let force = self.at_least_roughly(UnloadingQuantity::Force)?;
        let over = |u: f64| Ok(force(u)?.ln_value() - load.ln());
        let found = falling_root(over, (0.0, 0.1 * sigma), MAX_DISTANCE * sigma)?;
        let required = "a load reached within a retreat of 1e4 asperity_height_std";
        found.ok_or(ContactError::OutOfRange { field: "load", value: load, required })
    }

    /// -dF/du \[N/m\] after a `retreat` \[m\]; at 0 with Hertz' law, the sum of 2 E a.
    ///
    /// # Errors
    /// The errors of [`force`](Self::force).
    pub fn stiffness(&self, retreat: f64) -> Result<Evaluation, ContactError> {
        self.of(UnloadingQuantity::Stiffness, retreat)
    }

    /// The force \[N\] released by a retreat \[m\], without cancellation for small retreats.
    ///
    /// # Errors
    /// The errors of [`force`](Self::force).
    pub fn released(&self, retreat: f64) -> Result<Evaluation, ContactError> {
        self.of(UnloadingQuantity::Released, retreat)
    }

    /// The work \[J\] returned by a `retreat` \[m\], which may be infinite.
    ///
    /// # Errors
    /// The errors of [`force`](Self::force).
    pub fn returned(&self, retreat: f64) -> Result<Evaluation, ContactError> {
        self.of(UnloadingQuantity::Returned, retreat)
    }

    pub(crate) fn of(
        &self,
        quantity: UnloadingQuantity,
        retreat: f64,
    ) -> Result<Evaluation, ContactError> {
        let is_finite = retreat.is_finite() || quantity == UnloadingQuantity::Returned;
        let required = "a finite number, at least 0,";
        require(retreat >= 0.0 && is_finite, "retreat", retreat, required)?;
        if retreat == 0.0 && quantity.sums_up() {
            return Ok(Evaluation::new(0.0, 0.0));
        }
        let found = self.joint.retreated(quantity, retreat, &[self.place])?.into_iter().next();
        found.ok_or(ContactError::NotRequested { quantity: Quantity::Force })
    }
}

/// The root of a falling `f`, searched from `low` in steps that double up to `farthest`; `low`
/// where `f` is not positive there, `None` where `f` is still positive at the end.
pub(crate) fn falling_root(
    f: impl Fn(f64) -> Result<f64, ContactError>,
    (mut low, mut high): (f64, f64),
    farthest: f64,
) -> Result<Option<f64>, ContactError> {
    if f(low)? <= 0.0 {
        return Ok(Some(low));
    }
    while f(high)? > 0.0 {
        (low, high) = (high, 2.0 * high);
        if high > farthest {
            return Ok(None);
        }
    }
    // Minus infinity, the logarithm of 0, is replaced by a finite value.
    fallible(|x| Ok(f(x)?.max(-f64::MAX)), |f| bracketed_root(f, low, high))
}
