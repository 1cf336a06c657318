//! The laws of one asperity that a request needs.

use std::sync::{Arc, Mutex, PoisonError};

use asperity_quadrature::Sampler;

use crate::engine::inverse::force_at::{CachedFalls, Falls};
use crate::{Asperity, At, ContactError, ContactModel, Law, Quantity, Scene, Tolerance, Validity};

/// The laws of one asperity that quantities follow from.
#[derive(Debug)]
pub(crate) struct Laws {
    pub(crate) asperity: Asperity,
    /// Whether they depend on the density of the surface.
    density: bool,
    /// Whether the model has a law for the stiffness; false if no stiffness is asked for.
    pub(crate) own_stiffness: bool,
    /// Whether loads may be tensions.
    pub(crate) adhesive: bool,
    pub(crate) laws: Vec<(Quantity, Arc<Law>)>,
    pub(crate) tolerance: Tolerance,
    by_load: bool,
    cached_falls: Mutex<CachedFalls>,
}

impl Laws {
    /// Those that these quantities need, and the force's if any place is a load.
    pub(crate) fn new(
        model: &dyn ContactModel,
        asperity: Asperity,
        quantities: &[Quantity],
        by_load: bool,
        tolerance: Tolerance,
    ) -> Result<Self, ContactError> {
        let Validity { adhesive, density, .. } = model.validity();
        let asperity = asperity.seen_by(density);
        let mut found = Self {
            asperity,
            density,
            own_stiffness: false,
            adhesive,
            laws: vec![],
            tolerance,
            by_load,
            cached_falls: Mutex::default(),
        };
        for &quantity in quantities.iter().chain(by_load.then_some(&Quantity::Force)) {
            if quantity == Quantity::Stiffness && !found.own_stiffness {
                match model.law(&asperity, quantity, tolerance) {
                    Err(ContactError::NoLaw { .. }) => {}
                    own => {
                        found.own_stiffness = true;
                        found.laws.push((quantity, Arc::new(own?)));
                    }
                }
            }
            for base in quantity.laws(found.own_stiffness) {
                if found.law(base).is_none() {
                    let law = model.law(&asperity, base, tolerance)?;
                    found.laws.push((base, Arc::new(law)));
                }
            }
        }
        // Without any work of adhesion no load is a tension.
        found.adhesive &= found.law(Quantity::Force).is_some_and(|law| law.is_signed());
        Ok(found)
    }

    /// The law of this quantity.
    pub(crate) fn law(&self, base: Quantity) -> Option<&Arc<Law>> {
        self.laws.iter().find(|(known, _)| *known == base).map(|(_, law)| law)
    }

    /// The law of the force.
    pub(crate) fn force(&self) -> Result<&Law, ContactError> {
        let law = self.law(Quantity::Force);
        Ok(law.ok_or(ContactError::NotRequested { quantity: Quantity::Force })?.as_ref())
    }

    /// Whether, from a separation on, the heights of a scene meet only a rising part of the law of
    /// the force.
    pub(crate) fn rises_above(&self, scene: &Scene, s: f64) -> Result<bool, ContactError> {
        let law = self.force()?;
        // Unless parts of an angle average are subtracted it rises, as scenes that are compiled
        // verify.
        if !law.is_signed() && is_costly(law) {
            return Ok(true);
        }
        let mut cached = self.cached_falls.lock().unwrap_or_else(PoisonError::into_inner);
        Ok(cached.rises_above(law, scene, s))
    }

    /// Where the law of the force falls on a scene, if it does.
    pub(crate) fn falls(&self, scene: &Scene) -> Result<Option<Arc<Falls>>, ContactError> {
        let mut cached = self.cached_falls.lock().unwrap_or_else(PoisonError::into_inner);
        Ok(cached.on(self.force()?, scene, self.tolerance))
    }

    /// Whether a case takes milliseconds.
    pub(crate) fn are_costly(&self) -> bool {
        self.laws.iter().any(|(_, law)| is_costly(law))
    }

    /// Whether they belong to this asperity and suffice.
    pub(crate) fn serve(&self, asperity: &Asperity, by_load: bool) -> bool {
        self.are_of(asperity) && (self.by_load || !by_load)
    }

    /// Whether they are the laws of this asperity.
    pub(crate) fn are_of(&self, asperity: &Asperity) -> bool {
        self.asperity == asperity.seen_by(self.density)
    }
}

/// Whether a sample of some part is an integral itself, as in angle averages.
fn is_costly(law: &Law) -> bool {
    law.parts.iter().any(|part| part.form.unprepared((0.0, f64::INFINITY)).is_some())
}

/// Whether any of these places is a load or a pressure.
pub(crate) fn any_load(places: &[At]) -> bool {
    places.iter().any(|at| !matches!(at, At::Separation(_)))
}
