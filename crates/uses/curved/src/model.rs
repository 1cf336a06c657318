//! Curved bodies behind the traits of models: whatever asks a model of flat surfaces asks the same
//! model between curved bodies.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use asperity_core::{
    At, Code, Contact, ContactEngine, ContactError, ContactModel, Datum, Described, Evaluation,
    Finding, HARDNESS_OVER_YIELD, Interface, Quantity, Request, Scene, Separation, SeparationUnit,
    Wraps, map_runs,
};

use crate::{Curved, Shape, Solution};

const FEW_ASPERITIES: &str = "the patch holds too few asperities for an average over them";
const LARGE_PATCH: &str =
    "bodies are taken as half spaces with parabolic surfaces, which needs a small patch";
const YIELDS_BELOW: &str = "the bodies yield below the surface, and here they stay elastic";
const MERGE: &str = "contacts merge in the middle of the patch";
const FULL: &str = "the real area exceeds the patch in its middle, which no contact does: check hardness, modulus and load";
const NEEDS_LENGTH: &str = "set reference_length, on which it depends";

/// A model of rough surfaces between curved bodies, under its own name.
///
/// Loads are totals \[N\], and areas, contacts and stiffnesses are those of the whole patch. The
/// separation of the bodies is the approach with the other sign: where undeformed surfaces would
/// have their least distance. Bodies have no nominal area, whatever the scene says, and pressures
/// on one and shares of one are refused. Numbers are right to the tolerance, from 1e-8, lengths
/// relative to the larger of value and σ_z; to 1e-6 where the default tolerance is asked for, as a
/// finer one takes longer here.
///
/// ```
/// use asperity_core::{ContactModel, Interface, Quantity, Request, Scene, Surface};
/// use asperity_curved::{BetweenCurved, Shape};
/// use asperity_ke::KogutEtsion;
///
/// let ball = Shape::Point { radius_x: 6.35e-3, radius_y: 6.35e-3 };
/// let model = BetweenCurved::new(KogutEtsion, ball);
/// let surface = Surface::new(1e-4, 1e9, 0.5e-6);
/// let scene = Scene::new(Interface::new(115.4e9, 0.3, 4e9), surface, 1.0);
/// let asked = [Quantity::PeakPressureRatio, Quantity::Approach];
/// let answer = model.solve(&scene, &Request::new(asked).at_loads([30.0]))?;
/// assert!((answer.values(Quantity::PeakPressureRatio)?[0] - 0.66).abs() < 0.1);
/// # Ok::<(), asperity_core::ContactError>(())
/// ```
#[derive(Debug, Clone)]
pub struct BetweenCurved {
    model: Arc<dyn ContactModel>,
    shape: Shape,
    /// Another id.
    pub id: Option<&'static str>,
    /// The strength \[Pa\] at which the weaker body yields before it hardens, if it is known;
    /// asperities yield by the numbers of the interface.
    pub strength: Option<f64>,
}

impl BetweenCurved {
    /// This model between these bodies.
    #[must_use]
    pub fn new(model: impl ContactModel + 'static, shape: Shape) -> Self {
        Self { model: Arc::new(model), shape, id: None, strength: None }
    }
}

impl Wraps for BetweenCurved {
    fn inner(&self) -> &dyn Described {
        &*self.model
    }

    fn other_id(&self) -> Option<&str> {
        self.id
    }
}

/// Whether curved bodies have a quantity.
fn known(quantity: Quantity) -> bool {
    let of_layer = [Quantity::Force, Quantity::Area, Quantity::Contacts, Quantity::Tangent];
    let per_area = [Quantity::ThermalConductancePerArea, Quantity::ElectricalConductancePerArea];
    let of_patch = quantity.is_of_joint() && !per_area.contains(&quantity);
    of_layer.contains(&quantity) || quantity.is_of_bodies() || of_patch
}

/// The quantity of the layer from which one of the bodies follows.
fn of_layer(quantity: Quantity) -> Option<Quantity> {
    match quantity {
        Quantity::Area | Quantity::CentralAreaFraction => Some(Quantity::Area),
        Quantity::Contacts => Some(Quantity::Contacts),
        of_joint if of_joint.is_of_joint() => Some(Quantity::UnloadingStiffness),
        _ => None,
    }
}

impl BetweenCurved {
    fn on(&self, scene: &Scene, request: &Request) -> Result<OfBodies, ContactError> {
        let mut layer: Vec<Quantity> =
            request.quantities.iter().copied().filter_map(of_layer).collect();
        layer.sort_unstable();
        layer.dedup();
        // No pressure on it is a load, and no area is above it.
        let mut of_bodies = scene.clone();
        of_bodies.nominal_area = f64::INFINITY;
        let found = OfBodies {
            curved: Curved::new(&*self.model, scene, self.shape, &layer, request.tolerance)?,
            id: self.id().into(),
            strength: self.strength,
            scene: of_bodies,
            quantities: request.quantities.clone(),
            solved: Mutex::default(),
        };
        request.quantities.iter().try_for_each(|quantity| found.check(*quantity))?;
        Ok(found)
    }
}

impl ContactModel for BetweenCurved {
    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        Ok(Box::new(self.on(scene, request)?))
    }

    /// The places are solved at once, on all cores.
    fn contact(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        let found = self.on(scene, request)?;
        // A place that is refused is refused again, with its reason.
        map_runs(&request.at, 1, |at| at.iter().map(|at| found.solve(*at).is_ok()).collect());
        Ok(Box::new(found))
    }
}

/// What is kept of a solved contact: a value for each quantity, the approach, and what is noted.
type Solved = Arc<(Vec<Result<Evaluation, ContactError>>, Option<f64>, Vec<Finding>)>;

#[derive(Debug)]
struct OfBodies {
    curved: Curved,
    strength: Option<f64>,
    id: String,
    scene: Scene,
    quantities: Vec<Quantity>,
    /// By the number, and whether it is a load.
    solved: Mutex<HashMap<(bool, u64), Solved>>,
}

impl OfBodies {
    fn check(&self, quantity: Quantity) -> Result<(), ContactError> {
        self.check_asked(quantity, known)?;
        Evaluation::of_contact_radii(quantity, 0.0, &self.scene, 0.0).map(drop)
    }

    /// The load \[N\], or the approach \[m\].
    fn given(&self, at: At) -> Result<(bool, f64), ContactError> {
        match at {
            At::Load(load) => Ok((true, load)),
            At::Separation(separation) => {
                let metres = SeparationUnit::Metres;
                let from = separation.measured_in(metres, Datum::AsperityMean, &self.scene)?;
                Ok((false, -from.value))
            }
            _ => {
                Err(self.unsupported("an answer at a pressure: curved bodies have no nominal area"))
            }
        }
    }

    fn solve(&self, at: At) -> Result<Solved, ContactError> {
        let (is_load, given) = self.given(at)?;
        let key = (is_load, given.to_bits());
        let known = || self.solved.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(found) = known().get(&key) {
            return Ok(found.clone());
        }
        let mut found = match is_load {
            true => self.curved.at_load(given)?,
            false => self.curved.at_approach(given)?,
        };
        let values = self.quantities.iter().map(|q| self.value(*q, at, &mut found)).collect();
        let solved = Arc::new((values, found.approach(), self.noted(&found)));
        known().insert(key, solved.clone());
        Ok(solved)
    }

    /// A number of a solution, with its error: of lengths relative to the larger of value and σ_z.
    fn value(
        &self,
        quantity: Quantity,
        at: At,
        found: &mut Solution<'_>,
    ) -> Result<Evaluation, ContactError> {
        let none = || ContactError::NoValue { quantity, at };
        let no_length =
            || self.unsupported(&format!("{quantity} of a line contact: {NEEDS_LENGTH}"));
        let has_length = found.approach().is_some();
        let sigma = self.scene.surface.asperity_height_std;
        let (value, size) = match quantity {
            Quantity::Force => (found.load, 0.0),
            Quantity::Area | Quantity::Contacts => (found.sum(quantity)?, 0.0),
            Quantity::Tangent if has_length => (found.tangent()?, 0.0),
            Quantity::Approach => match self.given(at)? {
                (false, approach) => (approach, sigma),
                _ => (found.approach().ok_or_else(no_length)?, sigma),
            },
            Quantity::ApproachBeyondHertz => (found.approach_beyond_hertz(), sigma),
            Quantity::PeakPressure => (found.peak_pressure(), 0.0),
            Quantity::PeakPressureRatio => (found.peak_pressure() / found.hertz.peak_pressure, 0.0),
            Quantity::AxisX => (found.axes()[0], 0.0),
            Quantity::AxisY => (found.axes()[1], 0.0),
            Quantity::EffectiveRadius => {
                let what = "effective-radius: the patch is no circle (axis-x, axis-y)";
                (found.effective_radius().ok_or_else(|| self.unsupported(what))?, 0.0)
            }
            Quantity::CentralSeparation => (found.central_separation(), sigma),
            Quantity::CentralAreaFraction => (found.central_area_fraction()?, 0.0),
            _ if !has_length => return Err(no_length()),
            of_joint => {
                let radii =
                    found.unloading_stiffness()? / (2.0 * self.scene.interface.equivalent_modulus);
                let value = Evaluation::of_contact_radii(
                    of_joint,
                    radii,
                    &self.scene,
                    self.curved.tolerance,
                )?;
                return value.ok_or_else(none);
            }
        };
        if !value.is_finite() {
            return Err(none());
        }
        let error = self.curved.tolerance * (size / value.abs()).max(1.0);
        Ok(Evaluation::new(value, error))
    }

    /// What limits an average over asperities, Hertz' half spaces or the strength of the bodies.
    fn noted(&self, found: &Solution<'_>) -> Vec<Finding> {
        let Interface { yield_strength, .. } = self.scene.interface;
        let hardness = self.scene.interface.softer_hardness();
        let hardened = hardness.map(|hardness| hardness / HARDNESS_OVER_YIELD);
        let strength = self.strength.or(yield_strength).or(hardened);
        let spacing = self.scene.surface.asperity_density.sqrt().recip();
        let [a, b] = found.axes();
        let of_radius = match self.curved.shape {
            Shape::Point { radius_x, radius_y } => a.max(b) / radius_x.min(radius_y),
            Shape::Line { radius, .. } => a / radius,
        };
        let mut notes = vec![];
        let mut limit = |code, field, [value, most]: [f64; 2], unit, meaning| {
            if value > most {
                let found = Finding::warning(code, field, value).usual([0.0, most]).unit(unit);
                notes.push(found.advice(meaning));
            }
        };
        let few = "asperity_spacing_over_patch";
        limit(Code::FewContacts, few, [spacing / a.min(b), 1.0 / 3.0], "", FEW_ASPERITIES);
        limit(Code::Patch, "patch_over_radius", [of_radius, 0.1], "", LARGE_PATCH);
        if let Some(strength) = strength {
            let peak = [found.peak_pressure(), 1.6 * strength];
            limit(Code::Patch, "peak_pressure", peak, "Pa", YIELDS_BELOW);
        }
        if let Ok(central) = found.central_area_fraction() {
            let (code, most, meaning) = match central > 1.0 {
                true => (Code::AreaAboveNominal, 1.0, FULL),
                false => (Code::Crowded, 0.3, MERGE),
            };
            limit(code, "central_area_fraction", [central, most], "", meaning);
        }
        if let Some(contacts) = found.sum(Quantity::Contacts).ok().filter(|n| *n < 10.0) {
            let few = Finding::warning(Code::FewContacts, "contacts", contacts);
            let meaning = "a single contact of few asperities scatters";
            notes.push(few.usual([10.0, f64::INFINITY]).advice(meaning));
        }
        notes.into_iter().map(|note: Finding| note.at(At::Load(found.load))).collect()
    }
}

impl ContactEngine for OfBodies {
    fn model(&self) -> &str {
        &self.id
    }

    fn scene(&self) -> &Scene {
        &self.scene
    }

    fn quantities(&self) -> &[Quantity] {
        &self.quantities
    }

    fn notes(&self, at: &[At]) -> Vec<Finding> {
        at.iter().filter_map(|at| self.solve(*at).ok()).flat_map(|found| found.2.clone()).collect()
    }

    fn evaluate_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        self.check(quantity)?;
        let k = self.quantities.iter().position(|one| *one == quantity);
        let found = self.solve(at)?;
        let value = k.and_then(|k| found.0.get(k).cloned());
        value.unwrap_or(Err(ContactError::NotRequested { quantity }))
    }

    fn separations_at(&self, load: f64) -> Result<Vec<Separation>, ContactError> {
        match self.solve(At::Load(load))?.1 {
            Some(approach) => Ok(vec![Separation::metres(-approach)]),
            None => {
                Err(self.unsupported(&format!("the approach of a line contact: {NEEDS_LENGTH}")))
            }
        }
    }
}
