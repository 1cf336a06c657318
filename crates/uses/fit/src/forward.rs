//! Predicted values: a model on a scene, as the rig reads it.

use std::cell::OnceCell;

use asperity_core::{
    At, Case, Contact, ContactError, ContactModel, Quantity, Request, Scene, Separation,
    SeparationUnit, Sweep, Tolerance,
};

use crate::{Data, Measured};

/// Relative tolerance of predicted values, whose differences give the derivatives.
const TOLERANCE: f64 = 1e-13;
/// The same for a model without laws of one asperity, which may compile tables for each scene.
const COMPILED: f64 = 1e-7;

/// The stiffnesses that a compliance in series reduces.
pub(crate) const STIFFNESSES: [Quantity; 3] =
    [Quantity::Stiffness, Quantity::Tangent, Quantity::UnloadingStiffness];

/// What a test rig adds: a reading of a separation d under a load F is
/// d + `separation_offset` - `series_compliance` F, and a stiffness K reads
/// 1/(1/K + `series_compliance`).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rig {
    /// The reading at separation 0 without load \[m\].
    pub separation_offset: f64,
    /// Normal compliance in series with the contact \[m/N\].
    pub series_compliance: f64,
}

impl Rig {
    /// What is read of a quantity.
    fn reading(&self, quantity: Quantity, value: f64) -> f64 {
        match STIFFNESSES.contains(&quantity) {
            true => 1.0 / (1.0 / value + self.series_compliance),
            false => value,
        }
    }
}

/// The values of a model on a scene, read by a rig where data were measured, in their order; each
/// with the reason where there is none.
#[must_use]
pub fn predict(
    model: &dyn ContactModel,
    scene: &Scene,
    rig: Rig,
    data: &Data,
) -> Vec<Result<f64, ContactError>> {
    match Forward::new(model, data) {
        Ok(forward) => forward.predict(scene, rig),
        Err(error) => vec![Err(error); data.len()],
    }
}

/// The separations and loads at which a model on a scene is asked for the data.
#[must_use]
pub fn places(model: &dyn ContactModel, scene: &Scene, rig: Rig, data: &Data) -> Vec<At> {
    let Ok(forward) = Forward::new(model, data) else { return vec![] };
    let (on, groups) = (forward.on(scene), forward.groups.iter());
    let places = groups.flat_map(|group| &group.places);
    places.filter_map(|place| forward.place(&on, rig, place.at).ok()).collect()
}

/// A predicted value, or the reason why there is none.
pub(crate) type Predicted = Result<f64, ContactError>;

/// A model that is asked for the same data on many scenes.
#[derive(Debug)]
pub(crate) struct Forward<'f> {
    model: &'f dyn ContactModel,
    data: &'f Data,
    /// Places that need the same quantities, with the sweep of these.
    groups: Vec<Group<'f>>,
    /// Force and tangent, for readings of separations.
    loads: Sweep<'f>,
    /// What is asked of a model without laws of one asperity: it is compiled once for a scene.
    compiled: Option<Request>,
    /// Relative tolerance of the values.
    pub(crate) tolerance: f64,
}

/// A model on one scene.
struct OnScene<'s, 'f> {
    forward: &'s Forward<'f>,
    scene: &'s Scene,
    contact: Option<Compiled>,
    /// For force and tangent, where a rig needs them.
    loads: OnceCell<Compiled>,
}

type Compiled = Result<Box<dyn Contact>, ContactError>;

impl OnScene<'_, '_> {
    /// The quantities of a group at some places.
    fn values(&self, group: &Group<'_>, at: &[At]) -> Vec<Result<Vec<f64>, ContactError>> {
        let Group { quantities, sweep, .. } = group;
        if quantities.is_empty() {
            return vec![Ok(vec![]); at.len()];
        }
        let Some(contact) = &self.contact else {
            let cases: Vec<Case> = at.iter().map(|at| self.case(*at)).collect();
            let found = sweep.evaluate_all(&cases).into_iter();
            return found.map(|row| Ok(row?.iter().map(|one| one.value()).collect())).collect();
        };
        let value = |contact: &dyn Contact, quantity: &Quantity, at: At| {
            contact.evaluate_at(*quantity, at).map(|found| found.value())
        };
        let row = |at: &At| match contact {
            Ok(contact) => quantities.iter().map(|one| value(&**contact, one, *at)).collect(),
            Err(error) => Err(error.clone()),
        };
        at.iter().map(row).collect()
    }

    /// The separation under a load.
    fn separation(&self, at: At) -> Result<Separation, ContactError> {
        match &self.contact {
            Some(contact) => contact.as_ref().map_err(Clone::clone)?.separation(at),
            None => {
                let found = self.forward.loads.separations(&[self.case(at)]).pop();
                found.unwrap_or(Err(ContactError::NoMeanPlane)).map(Separation::sigmas)
            }
        }
    }

    fn force_and_tangent(&self, at: At) -> Result<[f64; 2], ContactError> {
        if let Some(request) = &self.forward.compiled {
            let compile = || {
                let mut request = request.clone();
                request.quantities = vec![Quantity::Force, Quantity::Tangent];
                self.forward.model.compile(self.scene, &request)
            };
            let contact = self.loads.get_or_init(compile).as_ref().map_err(Clone::clone)?;
            let (force, tangent) = contact.force_and_tangent_at(at)?;
            return Ok([force.value(), tangent.value()]);
        }
        let values = self.forward.loads.evaluate(&self.case(at))?;
        Ok([0, 1].map(|k| values.get(k).map_or(0.0, |v| v.value())))
    }

    fn case(&self, at: At) -> Case {
        Case::new(self.scene.clone(), at)
    }
}

#[derive(Debug)]
struct Group<'f> {
    quantities: Vec<Quantity>,
    sweep: Sweep<'f>,
    places: Vec<PlaceValues>,
}

/// A load or reading with what was measured there.
#[derive(Debug)]
struct PlaceValues {
    at: At,
    /// The measured values, each with its place among the quantities; none for the separation.
    values: Vec<(usize, Option<usize>)>,
}

impl<'f> Forward<'f> {
    pub(crate) fn new(model: &'f dyn ContactModel, data: &'f Data) -> Result<Self, ContactError> {
        let is_compiled = model.asperity_model().is_none();
        let tolerance = Tolerance::new(if is_compiled { COMPILED } else { TOLERANCE })?;
        let mut groups: Vec<Group<'_>> = vec![];
        let mut rest = 0..data.len();
        while let Some(first) = rest.next() {
            let at = data[first].at;
            let same = |k: &usize| data[*k].at == at && data[*k].row == data[first].row;
            let together: Vec<usize> = (first..data.len()).take_while(same).collect();
            rest.start = first + together.len();
            let mut quantities: Vec<Quantity> = vec![];
            let mut values = vec![];
            for k in together {
                let place = quantities.len();
                let quantity = match data[k].measured {
                    Measured::Quantity(quantity) => Some(quantity),
                    Measured::Separation => None,
                };
                quantities.extend(quantity);
                values.push((k, quantity.map(|_| place)));
            }
            let place = PlaceValues { at, values };
            match groups.iter_mut().find(|group| group.quantities == quantities) {
                Some(group) => group.places.push(place),
                None => {
                    let sweep = Sweep::new(model, &quantities, tolerance);
                    groups.push(Group { quantities, sweep, places: vec![place] });
                }
            }
        }
        let loads = Sweep::new(model, &[Quantity::Force, Quantity::Tangent], tolerance);
        // A separation is read under the force.
        let mut quantities = vec![Quantity::Force];
        quantities.extend(groups.iter().flat_map(|group| group.quantities.iter().copied()));
        quantities.sort_unstable();
        quantities.dedup();
        let at = data.iter().map(|one| one.at);
        let request = Request::new(quantities).within(tolerance).at(at);
        let compiled = is_compiled.then_some(request);
        Ok(Self { model, data, groups, loads, compiled, tolerance: tolerance.relative() })
    }

    /// Whether each scene takes long.
    pub(crate) fn is_slow(&self) -> bool {
        self.compiled.is_some()
    }

    fn on<'s>(&'s self, scene: &'s Scene) -> OnScene<'s, 'f> {
        let compile = |request| self.model.compile(scene, request);
        let contact = self.compiled.as_ref().map(compile);
        OnScene { forward: self, scene, contact, loads: OnceCell::new() }
    }

    /// The values on a scene, in the order of the data.
    pub(crate) fn predict(&self, scene: &Scene, rig: Rig) -> Vec<Predicted> {
        let mut found: Vec<Predicted> = vec![Err(ContactError::NoMeanPlane); self.data.len()];
        let on = self.on(scene);
        for group in &self.groups {
            let (mut places, mut asked) = (vec![], vec![]);
            for place in &group.places {
                match self.place(&on, rig, place.at) {
                    Ok(at) => {
                        places.push(at);
                        asked.push(place);
                    }
                    Err(error) => {
                        place.values.iter().for_each(|(k, _)| found[*k] = Err(error.clone()));
                    }
                }
            }
            let answers = on.values(group, &places);
            for ((place, at), answer) in asked.into_iter().zip(places).zip(answers) {
                for (k, column) in &place.values {
                    found[*k] = match (column, &answer) {
                        (None, _) => self.separation(&on, rig, at),
                        (_, Err(error)) => Err(error.clone()),
                        (Some(column), Ok(values)) => {
                            Ok(rig.reading(group.quantities[*column], values[*column]))
                        }
                    };
                }
            }
        }
        found
    }

    /// The reading of the separation under a load.
    fn separation(&self, on: &OnScene<'_, '_>, rig: Rig, at: At) -> Predicted {
        let (unit, from) = (SeparationUnit::Metres, self.data.from);
        let scene = self.model.scene_of(on.scene)?;
        let separation = on.separation(at)?.measured_in(unit, from, &scene)?;
        let load = at.load(on.scene).unwrap_or(0.0);
        Ok(separation.value + rig.separation_offset - rig.series_compliance * load)
    }

    /// Where the model is asked: a load as it is, a reading of a separation as the separation.
    fn place(&self, on: &OnScene<'_, '_>, rig: Rig, at: At) -> Result<At, ContactError> {
        let At::Separation(reading) = at else { return Ok(at) };
        let own = self.model.scene_of(on.scene)?;
        let reading = reading.measured_in(SeparationUnit::Metres, reading.from, &own)?;
        let unloaded = reading.value - rig.separation_offset;
        let mut at = At::from(Separation { value: unloaded, ..reading });
        if rig.series_compliance == 0.0 {
            return Ok(at);
        }
        // d - c F(d) rises, ever less steeply where the force is convex: Newton's method comes from
        // below.
        let mut separation = unloaded;
        for _ in 0..MOST_STEPS {
            let [force, tangent] = on.force_and_tangent(at)?;
            let missing = separation - rig.series_compliance * force - unloaded;
            let step = -missing / (1.0 + rig.series_compliance * tangent);
            separation += step;
            at = Separation { value: separation, ..reading }.into();
            if step.abs() <= 1e-15 * (own.surface.asperity_height_std + separation.abs()) {
                return Ok(at);
            }
        }
        let reason = format!("no separation gives a reading of {:e} m", reading.value);
        Err(ContactError::Refused { model: self.model.id().into(), reason })
    }
}

/// The largest number of steps to the separation of a reading.
const MOST_STEPS: usize = 200;
