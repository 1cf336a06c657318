//! Correlations of conductance on scenes, and the contacts that they describe.

use asperity_core::{
    At, Citation, Code, Contact, ContactEngine, ContactError, ContactModel, Described, Evaluation,
    Finding, Provenance, Quantity, Request, Scene, Validity, short,
};
use serde::{Deserialize, Serialize};

use crate::conductance::{
    CorrelationValue, ELASTIC, GapRoughness, PLASTIC, cooper_mikic_yovanovich, mikic_elastic,
};

/// Plasticity index from which contacts count as plastic; Greenwood & Williamson 1966 give a
/// transition between 0.6 and 1.
const PLASTIC_FROM: f64 = 1.0;

/// A correlation between nominally flat rough surfaces in vacuum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
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
        self.source().id
    }

    fn source(self) -> &'static Citation {
        match self {
            Self::CooperMikicYovanovich => &PLASTIC_CONTACTS,
            Self::MikicElastic => &ELASTIC_CONTACTS,
        }
    }

    /// The plasticity index of a scene with contacts of the other kind: below 1 for the plastic
    /// correlation, at least 1 for the elastic one. `None` for contacts that the correlation
    /// describes, or without a hardness.
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
        let (field, reason) = ("thermal_conductivity", format!("{} needs it", self.id()));
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

/// A correlation as a model: it has the thermal conductance per area at loads, and warns where it
/// does not hold.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Correlated {
    /// The correlation.
    pub correlation: Correlation,
    /// The roughness of the gap, if it does not follow from the asperities of the scene.
    pub roughness: Option<GapRoughness>,
}

const CONDUCTANCE: Quantity = Quantity::ThermalConductancePerArea;

const PLASTIC_CONTACTS: Citation = Citation {
    id: "cmy",
    name: "CMY",
    authors: "Cooper, Mikic & Yovanovich",
    year: 1969,
    title: "Thermal contact conductance",
    provenance: Provenance::Seen,
    published: &[
        ("author", "Cooper, M. G. and Mikic, B. B. and Yovanovich, M. M."),
        ("journal", "International Journal of Heat and Mass Transfer"),
    ],
};

const ELASTIC_CONTACTS: Citation = Citation {
    id: "mikic",
    name: "Mikic",
    authors: "Mikic",
    year: 1974,
    title: "Thermal contact conductance; theoretical considerations",
    provenance: Provenance::Seen,
    published: &[
        ("author", "Mikic, B. B."),
        ("journal", "International Journal of Heat and Mass Transfer"),
    ],
};

impl Described for Correlated {
    fn citation(&self) -> &Citation {
        self.correlation.source()
    }

    fn validity(&self) -> Validity {
        let valid_for = match self.correlation {
            Correlation::CooperMikicYovanovich => {
                "conductance of plastic contacts, p/H of 1e-6 to 0.023; nothing else"
            }
            Correlation::MikicElastic => {
                "conductance of elastic contacts, sqrt(2) p/(E m) of 1e-5 to 0.012; nothing else"
            }
        };
        Validity { asperities: false, hertz_limit: None, valid_for, ..Validity::default() }
    }
}

impl ContactModel for Correlated {
    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        let moments = || match scene.pair {
            Some(pair) => pair.moments(),
            None => scene.surface.moments(),
        };
        let roughness = self.roughness.unwrap_or_else(|| GapRoughness::of(&moments()));
        let (scene, quantities) = (scene.clone(), request.quantities.clone());
        let contact = Correlating { model: *self, roughness, scene, quantities };
        for quantity in &contact.quantities {
            contact.check_asked(*quantity, |one| one == CONDUCTANCE)?;
        }
        self.correlation.at(&contact.scene, &roughness, 1.0)?;
        Ok(Box::new(contact))
    }
}

/// A correlation on a scene.
#[derive(Debug)]
struct Correlating {
    model: Correlated,
    roughness: GapRoughness,
    scene: Scene,
    quantities: Vec<Quantity>,
}

impl Correlating {
    /// A warning of contacts of another kind, and of the first place outside the range.
    fn warnings(&self, places: &[At]) -> impl Iterator<Item = Finding> {
        let of = self.model.correlation;
        let found =
            |field, value| Finding::warning(Code::Correlation, field, value).of_model(of.id());
        // The base of the power law, its range, and the contacts that it does not describe.
        let (base, range, kind) = match of {
            Correlation::CooperMikicYovanovich => ("p/H", PLASTIC, "elastic"),
            Correlation::MikicElastic => ("sqrt(2) p/(E m)", ELASTIC, "plastic"),
        };
        let foreign = of.foreign(&self.scene).map(|index| {
            let fact = format!("plasticity_index is {}: the contacts are {kind}", short(index));
            found("plasticity_index", index).fact(fact).advice("use the other correlation, or ke")
        });
        let relative = |at: &At| {
            let pressure = at.pressure(&self.scene)?;
            Some((*at, of.at(&self.scene, &self.roughness, pressure).ok()?.relative_pressure))
        };
        let mut outside = places.iter().filter_map(relative);
        let outside = outside.find(|(_, relative)| !range.contains(relative));
        let outside = outside.map(|(at, relative)| {
            let fact = format!(
                "{base} is {} at {at}, outside the range of the correlation, {:e} to {}",
                short(relative),
                range.start(),
                range.end()
            );
            found("pressure", relative).fact(fact)
        });
        foreign.into_iter().chain(outside)
    }
}

impl ContactEngine for Correlating {
    fn model(&self) -> &str {
        self.model.correlation.id()
    }

    fn scene(&self) -> &Scene {
        &self.scene
    }

    fn quantities(&self) -> &[Quantity] {
        &self.quantities
    }

    fn evaluate_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        self.check_asked(quantity, |one| one == CONDUCTANCE)?;
        let Some(pressure) = at.pressure(&self.scene) else {
            return Err(self.unsupported("a conductance at a separation: use a load"));
        };
        let found = self.model.correlation.at(&self.scene, &self.roughness, pressure)?;
        Ok(Evaluation::new(found.conductance, f64::EPSILON))
    }

    fn notes(&self, at: &[At]) -> Vec<Finding> {
        self.warnings(at).collect()
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
