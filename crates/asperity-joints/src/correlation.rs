//! Correlations of conductance on scenes, and the contacts that they describe.

use asperity_core::{ContactError, Scene, short};

use crate::conductance::{
    CorrelationValue, ELASTIC, GapRoughness, PLASTIC, cooper_mikic_yovanovich, mikic_elastic,
};

/// Plasticity index from which contacts count as plastic; Greenwood & Williamson 1966 give a
/// transition between 0.6 and 1.
const PLASTIC_FROM: f64 = 1.0;

/// A correlation between nominally flat rough surfaces in vacuum.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Correlation {
    /// [`cooper_mikic_yovanovich`]: plastic contacts.
    CooperMikicYovanovich,
    /// [`mikic_elastic`]: elastic contacts.
    MikicElastic,
}

impl Correlation {
    /// All correlations.
    pub const ALL: [Self; 2] = [Self::CooperMikicYovanovich, Self::MikicElastic];

    /// Short name in lower case.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::CooperMikicYovanovich => "cmy",
            Self::MikicElastic => "mikic",
        }
    }

    /// Authors, year and kind of contacts.
    #[must_use]
    pub fn citation(self) -> &'static str {
        match self {
            Self::CooperMikicYovanovich => "Cooper, Mikic & Yovanovich 1969, plastic contacts",
            Self::MikicElastic => "Mikic 1974, elastic contacts",
        }
    }

    /// The base of the power law, [`CorrelationValue::relative_pressure`].
    #[must_use]
    pub fn relative_pressure(self) -> &'static str {
        match self {
            Self::CooperMikicYovanovich => "p/H",
            Self::MikicElastic => "sqrt(2) p/(E m)",
        }
    }

    /// Range of [`relative_pressure`](Self::relative_pressure) in which the power law is
    /// [valid](CorrelationValue::holds).
    #[must_use]
    pub fn range(self) -> [f64; 2] {
        let range = if self == Self::MikicElastic { ELASTIC } else { PLASTIC };
        [*range.start(), *range.end()]
    }

    /// The contacts that the correlation does not describe, `elastic` or `plastic`.
    #[must_use]
    pub fn other_contacts(self) -> &'static str {
        match self {
            Self::CooperMikicYovanovich => "elastic",
            Self::MikicElastic => "plastic",
        }
    }

    /// The reason why the correlation does not hold for a scene of
    /// [other contacts](Self::other_contacts).
    #[must_use]
    pub fn reason_against(self, scene: &Scene) -> Option<String> {
        self.foreign(scene).map(|index| {
            format!(
                "plasticity_index is {}, so that the contacts are {} and this correlation does not hold ({})",
                short(index),
                self.other_contacts(),
                self.citation()
            )
        })
    }

    /// The plasticity index of a scene with [other contacts](Self::other_contacts): below 1 for the
    /// plastic correlation, at least 1 for the elastic one. `None` for contacts that the
    /// correlation describes, or without a hardness.
    #[must_use]
    pub fn foreign(self, scene: &Scene) -> Option<f64> {
        let index = scene.plasticity_index().ok()?;
        let plastic = self == Self::CooperMikicYovanovich;
        ((index >= PLASTIC_FROM) != plastic).then_some(index)
    }

    /// The conductance of a scene under a mean `pressure` \[Pa\] on the nominal area, with the
    /// roughness of its gap; not [valid](CorrelationValue::holds) where the scene's contacts are
    /// [of the other kind](Self::foreign).
    ///
    /// # Errors
    /// [`ContactError::Missing`] without a thermal conductivity or, for plastic contacts, a
    /// hardness; [`ContactError::OutOfRange`] for an input that is not above 0.
    pub fn at(
        self,
        scene: &Scene,
        roughness: &GapRoughness,
        pressure: f64,
    ) -> Result<CorrelationValue, ContactError> {
        let (field, reason) = ("thermal_conductivity", format!("{} needs it", self.citation()));
        let conductivity = scene.interface.thermal_conductivity;
        let conductivity = conductivity.ok_or(ContactError::Missing { field, reason })?;
        let asperity = scene.asperity()?;
        let found = match self {
            Self::CooperMikicYovanovich => {
                cooper_mikic_yovanovich(conductivity, roughness, pressure, asperity.hardness()?)
            }
            Self::MikicElastic => {
                mikic_elastic(conductivity, roughness, pressure, asperity.equivalent_modulus)
            }
        }?;
        Ok(CorrelationValue { holds: found.holds && self.foreign(scene).is_none(), ..found })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn correlations_are_invalid_for_contacts_of_the_other_kind() {
        use asperity_core::{Interface, Surface};
        let mut interface = Interface::new(1.1e11, 0.3, 2e9);
        interface.thermal_conductivity = Some(50.0);
        let holds = |index: f64| {
            let surface = Surface::from_plasticity_index(index, 0.04, 1e-6, &interface).unwrap();
            let scene = Scene::new(interface, surface, 1e-4);
            let roughness = GapRoughness::of(&surface.moments());
            Correlation::ALL.map(|of| {
                let found = of.at(&scene, &roughness, 1e4).unwrap();
                assert_eq!(found.holds, of.foreign(&scene).is_none(), "{found:?}");
                found.holds
            })
        };
        assert_eq!(holds(0.13), [false, true]);
        assert_eq!(holds(6.7), [true, false]);
        // Without a hardness there is no plasticity index.
        let surface = Surface::from_plasticity_index(6.7, 0.04, 1e-6, &interface).unwrap();
        interface.hardness = None;
        let scene = Scene::new(interface, surface, 1e-4);
        assert!(Correlation::ALL.iter().all(|of| of.foreign(&scene).is_none()));
    }
}
