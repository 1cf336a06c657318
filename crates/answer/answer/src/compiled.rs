//! A model on a scene, compiled once for what is asked of it.

use asperity::film::{PatirCheng, not_gaussian};
use asperity::joints::conductance::gap_conductance;
use asperity::{
    ATOMIC_DISTANCE, At, Best, Code, Contact, ContactError, ContactModel, Datum, Evaluation,
    Finding, Findings, Interval, Model, Quantity, Request, Separation, SeparationUnit, Severity,
    compile_known, short, usual_reference,
};
use asperity_scene::{Gas, SceneFile};

use crate::AnswerError;
use crate::models::grouped;
use crate::subject::measured;

/// Why an answer of curved bodies has no interval.
pub const NO_EVIDENCE: &str = "without an interval: the solved surfaces are flat";
/// The conductance of the contacts beside the gas.
const CONTACTS: Quantity = Quantity::ThermalConductancePerArea;

/// A model on a scene, compiled once for the quantities that it has.
#[derive(Debug)]
pub struct Asked {
    model: Model,
    contact: Box<dyn Contact>,
    request: Request,
    /// The factors of flow, where some are asked for.
    flow: Option<PatirCheng>,
    /// The gas in the gap, where its conductance is asked for.
    gas: Option<Gas>,
    /// The quantities that the model does not have, and why.
    refused: Vec<(Quantity, ContactError)>,
    /// Whether a load has a row for every separation that carries it, not for the largest alone.
    all: bool,
}

/// A separation or load with the values there.
#[derive(Debug)]
pub struct Line {
    /// As given.
    pub given: At,
    /// The separation \[σ_z, m\] from the plane of the scene, or the reason why there is none.
    pub separation: [Result<f64, ContactError>; 2],
    /// The film \[m\] and its ratio to the standard deviation of the surface heights, from the mean
    /// plane of the surface, if there is one.
    pub film: [Option<f64>; 2],
    /// One for each quantity of the request, or the reason why there is none.
    pub values: Vec<Result<Evaluation, ContactError>>,
    /// Their intervals, where the model knows one.
    pub intervals: Vec<Option<Interval>>,
    /// The interval of the separation \[m\] from the plane of the scene, likewise.
    pub between: Option<[f64; 2]>,
}

/// A note that the model `best` of curved bodies is a single model.
fn behind_best(file: &SceneFile, model: &Model) -> Option<Finding> {
    let note = Finding::note(Code::NoEvidence, "curvature", f64::NAN).of_model(model.id());
    let fact = format!("by {}, {NO_EVIDENCE}", usual_reference(&file.scene));
    (model.id() == Best::<Model>::ID).then(|| note.fact(fact))
}

impl Asked {
    /// Compiles the model for the requested quantities that it has, and for those by which answers
    /// are judged.
    ///
    /// # Errors
    /// The reason why the scene refuses the model or its factors of flow.
    pub fn new(
        file: &SceneFile,
        model: &Model,
        request: &Request,
        all: bool,
    ) -> Result<Self, AnswerError> {
        let scene = &file.scene;
        let asked = |is: fn(&Quantity) -> bool| request.quantities.iter().any(is);
        let flow = asked(|q| q.is_flow_factor()).then(|| file.flow(model)).transpose()?;
        let of_gas = asked(|q| q.is_of_film() && !q.is_flow_factor());
        let gas = of_gas.then(|| file.needed_gas()).transpose()?;
        let of_model = request.quantities.iter().copied().filter(|q| !q.is_of_film());
        let contacts = asked(|q| *q == Quantity::JointConductancePerArea).then_some(CONTACTS);
        // The separation of such a model is the mean of a gap that is 0 in contact.
        let closed = (of_gas && !model.validity().asperities).then_some(Quantity::AreaFraction);
        let of_model: Vec<Quantity> = of_model.chain(contacts).chain(closed).collect();
        // The law of an area that is not asked for is made for it: of inclined contacts, it takes
        // longer than to judge without tables. Boundary elements count no contacts.
        let (asperities, angles) = (model.validity().asperities, model.validity().angles);
        let free = |q: &Quantity| asperities && (*q != Quantity::Area || !angles);
        let judged = Quantity::JUDGED.into_iter().filter(free);
        // Where each load has one row, few loads need no tables.
        let alone = |quantities: &[Quantity]| {
            let quantities = quantities.iter().copied().chain(judged.clone());
            let places = request.at.iter().copied();
            let request = Request::new(quantities).within(request.tolerance).at(places);
            if all { model.compile(scene, &request) } else { model.contact(scene, &request) }
        };
        // Without any quantity, the separations are still known.
        let otherwise = [Quantity::Force];
        let (contact, refused) = compile_known(&of_model, &otherwise, alone)?;
        let (model, request) = (model.clone(), request.clone());
        Ok(Self { model, contact, request, flow, gas, refused, all })
    }

    /// The model.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Whether the model has a quantity.
    #[must_use]
    pub fn has(&self, quantity: Quantity) -> bool {
        self.refused.iter().all(|(lacks, _)| *lacks != quantity)
    }

    /// The contact.
    #[must_use]
    pub fn contact(&self) -> &dyn Contact {
        &*self.contact
    }

    /// The findings at these places, and the notes of the contact, such as how a scan is continued.
    #[must_use]
    pub fn findings(&self, file: &SceneFile, places: &[At]) -> [Findings; 2] {
        let found = file.judge(&self.model, Some(&*self.contact), places);
        let notes: Findings = match self.model.validity().asperities {
            true => behind_best(file, &self.model).into_iter().collect(),
            false => {
                let notes = self.contact.notes(places).into_iter();
                notes.filter(|note| note.severity == Severity::Note).collect()
            }
        };
        let of_flow = self.flow.and_then(|_| not_gaussian(&file.scene.heights));
        [found, file.accepted(notes.into_iter().chain(of_flow).collect())]
    }

    /// The quantities that the model does not have, by their reasons.
    #[must_use]
    pub fn refusals(&self) -> Vec<String> {
        // The id of the model stands in front of the text.
        let is_own = |model: &str| model == self.model.id();
        let text = |(reason, names): (&ContactError, Vec<String>)| match reason {
            ContactError::NoLaw { model, quantity } if is_own(model) => {
                format!("has no law for {quantity}")
            }
            ContactError::Unsupported { model, what } if is_own(model) => {
                match names.iter().all(|name| what.contains(name)) {
                    true => format!("cannot give {what}"),
                    false => format!("no {} (cannot give {what})", names.join(", ")),
                }
            }
            other => format!("no {}: {}", names.join(", "), other),
        };
        let asked = self.refused.iter().filter(|(one, _)| self.request.quantities.contains(one));
        let pairs = asked.map(|(quantity, why)| (why, format!("{quantity}")));
        grouped(pairs).into_iter().map(text).collect()
    }

    /// The lines of these places, and the findings of their values.
    #[must_use]
    pub fn lines(&self, file: &SceneFile, places: &[At]) -> (Vec<Line>, Vec<Finding>) {
        let places: Vec<(At, At)> = places.iter().flat_map(|at| self.places(file, *at)).collect();
        let of_film = |q: &Quantity| q.is_of_film();
        let had = self.request.quantities.iter().copied();
        let had = had.filter(|quantity| self.has(*quantity) && !of_film(quantity));
        let request = Request::new(had).within(self.request.tolerance);
        let mut response = self.contact.respond(&request.at(places.iter().map(|place| place.1)));
        let mut columns: Vec<_> =
            response.columns.drain(..).map(|column| column.rows.into_iter()).collect();
        let rows = places.into_iter().zip(response.separations);
        let lines = rows.map(|((given, at), separation)| {
            let separation = separation.map_err(|reason| *reason);
            let (places, film) = self.separations(file, &separation);
            let mut found = columns.iter_mut().filter_map(Iterator::next);
            let value = |quantity: &Quantity| {
                if of_film(quantity) {
                    return self.of_film(*quantity, separation.clone()?, given);
                }
                let lacks = self.refused.iter().find(|(lacks, _)| lacks == quantity);
                match lacks.map_or_else(|| found.next(), |(_, why)| Some(Err(why.clone().into()))) {
                    Some(value) => value.map_err(|reason| *reason),
                    None => Err(ContactError::NotRequested { quantity: *quantity }),
                }
            };
            let values = self.request.quantities.iter().map(value).collect();
            let interval = |quantity: &Quantity| self.contact.interval(*quantity, at);
            let intervals = self.request.quantities.iter().map(interval).collect();
            let between = self.contact.interval_at(None, at).and_then(|of| self.between(file, &of));
            Line { given, separation: places, film, values, intervals, between }
        });
        (lines.collect(), response.warnings)
    }

    /// The interval of the mean gap from the plane of the scene \[m\].
    fn between(&self, file: &SceneFile, of: &Interval) -> Option<[f64; 2]> {
        let end = |gap| {
            let gap = Separation::metres(gap).from_surface_mean();
            measured(file, self.contact.scene(), gap, SeparationUnit::Metres).ok()
        };
        Some([end(of.lower)?, end(of.upper)?])
    }

    /// A separation in σ_z and in metres, from the plane of the scene, and as a film.
    fn separations(
        &self,
        file: &SceneFile,
        separation: &Result<Separation, ContactError>,
    ) -> ([Result<f64, ContactError>; 2], [Option<f64>; 2]) {
        let scene = self.contact.scene();
        let from_scene = |unit| measured(file, scene, separation.clone()?, unit);
        let (sigma, metres) = (SeparationUnit::Sigma, SeparationUnit::Metres);
        let ratio = separation.clone().and_then(|at| self.film_ratio(at)).ok();
        let film = separation
            .as_ref()
            .ok()
            .and_then(|at| Some(at.measured_in(metres, Datum::SurfaceMean, scene).ok()?.value));
        ([sigma, metres].map(from_scene), [film, ratio])
    }

    /// A quantity of the film at a separation, where a load or another place is given.
    fn of_film(
        &self,
        quantity: Quantity,
        separation: Separation,
        given: At,
    ) -> Result<Evaluation, ContactError> {
        let (unit, scene) = (SeparationUnit::Metres, self.contact.scene());
        let sigma = scene.surface.asperity_height_std;
        // Of a separation that follows from a load: F/|dF/dd| is at most some σ_z, and below the
        // heights at most the distance from them.
        let error = match given {
            At::Separation(_) => 0.0,
            _ => {
                let depth = separation.measured_in(unit, Datum::AsperityMean, scene)?.value;
                self.request.tolerance.relative() * (3.0 * sigma - depth.min(0.0))
            }
        };
        if let Some(flow) = self.flow.filter(|_| quantity.is_flow_factor()) {
            let film = self.film_ratio(separation)?;
            let mut found = flow.factor(quantity, film)?;
            // A factor of no size has its limit, which no film changes.
            if error > 0.0 && found.size > 0.0 {
                let step = 1e-4;
                let slope = (flow.factor(quantity, film + step)?.value() - found.value()) / step;
                found.error += (slope * error / scene.surface_height_std() / found.size).abs();
            }
            return Ok(found);
        }
        // Each row of a load with several separations has its own.
        let at = if self.all { separation.into() } else { given };
        // The gas conducts through the part of the area that is open, and there the gap is wider.
        let (mut open, mut of_area) = (1.0, 0.0);
        if !self.model.validity().asperities {
            let closed = self.contact.evaluate(Quantity::AreaFraction, at)?;
            open -= closed.value();
            of_area = 2.0 * closed.value() * closed.relative_error() / open;
        }
        let gap = separation.measured_in(unit, Datum::SurfaceMean, scene)?.value / open;
        let Some(gas) = self.gas.filter(|_| gap > ATOMIC_DISTANCE) else {
            return Err(ContactError::Unsupported {
                model: self.model.id().into(),
                what: format!("{quantity}: the mean planes are {} m apart", short(gap)),
            });
        };
        let value = open * gap_conductance(gas.gas_conductivity, gap, gas.gas_parameter)?;
        let of_gap = error / open / (gap + gas.gas_parameter);
        let of_gas = Evaluation::new(value, 1e-15 + of_gap + of_area);
        match quantity {
            Quantity::JointConductancePerArea => {
                if let Some((_, why)) = self.refused.iter().find(|(one, _)| *one == CONTACTS) {
                    return Err(why.clone());
                }
                let of_contacts = self.contact.evaluate(CONTACTS, at)?;
                let sum = of_contacts.value() + of_gas.value();
                let error = of_contacts.relative_error().max(of_gas.relative_error());
                Ok(Evaluation::new(sum, error))
            }
            _ => Ok(of_gas),
        }
    }

    /// A film over the standard deviation of the heights of both surfaces.
    fn film_ratio(&self, at: Separation) -> Result<f64, ContactError> {
        let unit = SeparationUnit::SurfaceStd;
        Ok(at.measured_in(unit, Datum::SurfaceMean, self.contact.scene())?.value)
    }

    /// A load or separation as given and as evaluated: with `all`, each separation of a load.
    fn places(&self, file: &SceneFile, at: At) -> Vec<(At, At)> {
        let (scene, from) = (self.contact.scene(), file.spec.separation_from);
        let counted = |s: Separation| s.measured_in(SeparationUnit::Sigma, from, scene);
        let load = at.load(scene).filter(|_| self.all);
        match load.map(|load| self.contact.separations_at(load)) {
            Some(Ok(found)) => {
                found.into_iter().map(|s| (at, counted(s).unwrap_or(s).into())).collect()
            }
            _ => vec![(at, at)],
        }
    }
}
