//! Predicted values: a model on a scene, as the rig reads it.

use asperity_core::{
    At, Case, ContactError, ContactModel, Quantity, Scene, Separation, SeparationUnit, Sweep,
    Tolerance,
};

use crate::{Data, Measured};

/// Relative tolerance of predicted values, whose differences give the derivatives.
const TOLERANCE: f64 = 1e-13;

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
        match quantity {
            Quantity::Stiffness | Quantity::Tangent | Quantity::UnloadingStiffness => {
                1.0 / (1.0 / value + self.series_compliance)
            }
            _ => value,
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
    let places = forward.groups.iter().flat_map(|group| &group.places);
    places.filter_map(|place| forward.place(scene, rig, place.at).ok()).collect()
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
        let tolerance = Tolerance::new(TOLERANCE)?;
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
        Ok(Self { model, data, groups, loads })
    }

    /// The values on a scene, in the order of the data.
    pub(crate) fn predict(&self, scene: &Scene, rig: Rig) -> Vec<Predicted> {
        let mut found: Vec<Predicted> = vec![Err(ContactError::NoMeanPlane); self.data.len()];
        for group in &self.groups {
            let (mut cases, mut asked) = (vec![], vec![]);
            for place in &group.places {
                match self.place(scene, rig, place.at) {
                    Ok(at) => {
                        cases.push(Case::new(scene.clone(), at));
                        asked.push(place);
                    }
                    Err(error) => {
                        place.values.iter().for_each(|(k, _)| found[*k] = Err(error.clone()));
                    }
                }
            }
            let answers = match group.quantities.is_empty() {
                true => vec![Ok(vec![]); cases.len()],
                false => group.sweep.evaluate_all(&cases),
            };
            for ((place, case), answer) in asked.into_iter().zip(&cases).zip(answers) {
                for (k, column) in &place.values {
                    found[*k] = match (column, &answer) {
                        (None, _) => self.separation(case, rig),
                        (_, Err(error)) => Err(error.clone()),
                        (Some(column), Ok(values)) => {
                            let quantity = group.quantities[*column];
                            Ok(rig.reading(quantity, values[*column].value()))
                        }
                    };
                }
            }
        }
        found
    }

    /// The reading of the separation under a load.
    fn separation(&self, case: &Case, rig: Rig) -> Predicted {
        let sigmas = self.loads.separations(std::slice::from_ref(case)).pop();
        let sigmas = sigmas.unwrap_or(Err(ContactError::NoMeanPlane))?;
        let (unit, from) = (SeparationUnit::Metres, self.data.datum());
        let scene = self.model.averaged_over(&case.scene)?;
        let separation = Separation::sigmas(sigmas).measured_in(unit, from, &scene)?;
        let load = case.at.load(&case.scene).unwrap_or(0.0);
        Ok(separation.value + rig.separation_offset - rig.series_compliance * load)
    }

    /// Where the model is asked: a load as it is, a reading of a separation as the separation.
    fn place(&self, scene: &Scene, rig: Rig, at: At) -> Result<At, ContactError> {
        let At::Separation(reading) = at else { return Ok(at) };
        let own = self.model.averaged_over(scene)?;
        let reading = reading.measured_in(SeparationUnit::Metres, reading.from, &own)?;
        let unloaded = reading.value - rig.separation_offset;
        let mut case = Case::new(scene.clone(), Separation { value: unloaded, ..reading });
        if rig.series_compliance == 0.0 {
            return Ok(case.at);
        }
        // d - c F(d) rises, ever less steeply where the force is convex: Newton's method comes from
        // below.
        let mut separation = unloaded;
        for _ in 0..MOST_STEPS {
            let values = self.loads.evaluate(&case)?;
            let [force, tangent] = [0, 1].map(|k| values.get(k).map_or(0.0, |v| v.value()));
            let missing = separation - rig.series_compliance * force - unloaded;
            let step = -missing / (1.0 + rig.series_compliance * tangent);
            separation += step;
            case.at = Separation { value: separation, ..reading }.into();
            if step.abs() <= 1e-15 * (own.surface.asperity_height_std + separation.abs()) {
                return Ok(case.at);
            }
        }
        let reason = format!("no separation gives a reading of {:e} m", reading.value);
        Err(ContactError::Refused { model: self.model.id().into(), reason })
    }
}

/// The largest number of steps to the separation of a reading.
const MOST_STEPS: usize = 200;
