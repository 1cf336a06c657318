//! Plausibility of an answer: interferences, number of contacts, and the range of validity of the
//! model.

use std::mem::discriminant;

use super::Check;
use super::findings::{Answer, FEW, share_above};
use super::interferences::Interferences;
use asperity_core::{
    At, Code, Contact, ContactError, ContactModel, Datum, Findings, Quantity, Regime, Request,
    Scene, Separation, SeparationUnit, Tolerance, Validity, short,
};

/// Tolerance of the numbers in findings.
const TOLERANCE: f64 = 1e-6;
/// w/R beyond which an asperity is no spherical cap under small deformation.
const FLATTENED: f64 = 0.3;
/// Share of the contacts that carries less than one per cent of the load.
const NEGLIGIBLE: f64 = 1e-6;
/// Meaning of that share.
const YIELDING_SHARE: &str = "of the load, by asperities with w > w_c";

impl Check {
    /// Derived numbers and findings of a scene ([`of`](Self::of)) and of a model's answer at a
    /// place.
    ///
    /// # Errors
    /// [`ContactError`] with the reason why the scene, the model or the place is refused.
    pub fn at(model: &dyn ContactModel, scene: &Scene, at: At) -> Result<Self, ContactError> {
        scene.asperity()?;
        let contact = model.compile(scene, &judging()?)?;
        let mut check = Self::of_contacts(scene, contact.scene())?;
        let answer = Self::of_answer(model, &*contact, at, true)?;
        check.numbers.extend(answer.numbers);
        check.extend(answer.findings);
        check.findings = check.findings.for_asperities(model.validity().asperities);
        Ok(check)
    }

    /// Findings of the answers at these places, each once: at the smallest separation, and at the
    /// smallest and largest loads. Where a contact of the model is given that has what is judged
    /// ([`Quantity::JUDGED`]), nothing is compiled and no load is inverted again. Places without an
    /// answer have no findings.
    #[must_use]
    pub fn answers(
        model: &dyn ContactModel,
        scene: &Scene,
        contact: Option<&dyn Contact>,
        places: &[At],
    ) -> Findings {
        let places = extremes(places, scene);
        let has = |contact: &&dyn Contact| {
            Quantity::JUDGED.iter().all(|judged| contact.quantities().contains(judged))
        };
        let compiled = match contact.filter(has) {
            Some(_) => None,
            None => judging().and_then(|of| model.contact(scene, &of.at(places.clone()))).ok(),
        };
        let Some(contact) = compiled.as_deref().or(contact) else { return Findings::default() };
        let answer = |at: &At| Self::of_answer(model, contact, *at, false).ok();
        let found: Findings =
            places.iter().filter_map(answer).flat_map(|check| check.findings).collect();
        // The worst of a few extremes: rows are not counted.
        found.by_cause().into_iter().map(|found| found.in_rows(1)).collect()
    }

    /// All numbers if `whole`, otherwise only those with warnings: of models with inclined contacts
    /// then no interferences, and of others only where they may matter.
    fn of_answer(
        model: &dyn ContactModel,
        contact: &dyn Contact,
        at: At,
        whole: bool,
    ) -> Result<Self, ContactError> {
        let (scene, validity) = (contact.scene(), model.validity());
        let answer = Answer { model, scene, at };
        // Theories of the whole surface have no number of contacts, and some no separation.
        let known = |found: Result<f64, ContactError>| match found {
            Ok(number) => Ok(Some(number)),
            Err(ContactError::Unsupported { .. } | ContactError::Missing { .. }) => Ok(None),
            Err(error) => Err(error),
        };
        let in_sigma = |at| contact.separation_in(SeparationUnit::Sigma, Datum::AsperityMean, at);
        let asked = validity.asperities && (whole || !validity.angles);
        let place = if asked { known(in_sigma(at))?.map(Separation::sigmas) } else { None };
        let row = contact.respond(&Request::new(Quantity::JUDGED).at([place.map_or(at, At::from)]));
        let value = |k: usize| row.columns[k].values().map(|all| all[0]);
        let contacts = known(value(2))?;
        let place = place.filter(|_| contacts.is_some());
        let mut check = Self::of_totals(answer, place, [value(0)?, value(1)?], contacts);
        let tolerance = Tolerance::new(TOLERANCE)?;
        let stiffnesses = [
            (Quantity::Tangent, "tangent", "stiffness in first loading, -dF/dd"),
            (Quantity::UnloadingStiffness, "unloading_stiffness", "stiffness of small vibrations"),
        ];
        for (quantity, name, meaning) in stiffnesses.into_iter().filter(|_| whole) {
            let contact = model.compile(scene, &Request::new([quantity]).within(tolerance));
            let found = contact.and_then(|of| of.evaluate(quantity, place.map_or(at, At::from)));
            check.add_number(name, found.ok().map(|found| found.value()), "N/m", meaning);
        }
        let Some((place, contacts)) = place.zip(contacts) else { return Ok(check) };
        // Elastic laws are judged by what yields; others only where it may matter.
        let is_elastic = validity.holds_to.is_some_and(|multiple| multiple <= 1.0);
        let asked = whole || is_elastic;
        let [from, to] = validity.known_defect.map_or([1.0; 2], |defect| [defect.from, defect.to]);
        let multiples = [1.0, from, to];
        let mut shares = None;
        if (asked || may_be_deep(contact, place, contacts))
            && let Some(laws) = model.asperity_model()
            && let Ok(law) = laws.force(&scene.asperity()?, tolerance)
            && let Some(deep) = Interferences::of(contact, &law, place)?
        {
            let plastic = law.parts.last().is_some_and(|part| part.regime == Regime::Plastic);
            check.of_depths(answer, &deep, plastic);
            let critical = scene.asperity().and_then(|asperity| asperity.critical_interference());
            shares = critical.ok().map(|w| multiples.map(|multiple| deep.beyond(multiple * w)));
        }
        // Of asperities with different radii.
        if asked && let Ok(Some(found)) = contact.shares_beyond(place.into(), &multiples) {
            shares = found.try_into().ok();
        }
        if let Some([yielding, from, to]) = shares {
            check.add_number("yielding_share", yielding, "", YIELDING_SHARE);
            let defect = validity.known_defect;
            check.extend(defect.and_then(|defect| answer.missed(from - to, &defect)));
            check.extend(answer.yields(yielding).filter(|_| is_elastic));
        }
        Ok(check)
    }

    /// Numbers and findings from force \[N\], area \[m²\] and number of contacts.
    fn of_totals(
        answer: Answer<'_>,
        place: Option<Separation>,
        [force, area]: [f64; 2],
        contacts: Option<f64>,
    ) -> Self {
        let (mut check, Answer { model, scene, at }) = (Self::default(), answer);
        let fraction = area / scene.nominal_area;
        let sigma = scene.surface.asperity_height_std;
        // What was asked for is exact; the force of the contact has an error.
        let load = at.load(scene).unwrap_or(force);
        let pressure = at.pressure(scene).unwrap_or(force / scene.nominal_area);
        check.add_number("load", load, "N", "normal force");
        check.add_number("pressure", pressure, "Pa", "load over A_n");
        let (place, plane) =
            (place.map(|place| place.value), Datum::AsperityMean.name(&scene.heights));
        check.add_number("separation_over_sigma", place, "", format!("d/sigma_z, from {plane}"));
        let distance = place.map(|value| value * sigma);
        check.add_number("separation", distance, "m", format!("d, from {plane}"));
        check.add_number("area", area, "m2", format!("real area of contact, by {}", model.id()));
        check.add_number("area_fraction", fraction, "", "real over nominal area");
        check.extend(answer.crowded(fraction).filter(|_| model.validity().asperities));
        check.extend(answer.beyond_full_contact([pressure, fraction]));
        check.extend(answer.sticks());
        check.add_number("contacts", contacts, "", "asperities that touch");
        let touching = contacts.filter(|contacts| *contacts > 0.0);
        let is_load = matches!(at, At::Load(_) | At::Pressure(_));
        let scarce = touching.filter(|contacts| is_load && *contacts < FEW);
        check.extend(scarce.map(|contacts| answer.few(contacts)));
        let each = touching.filter(|_| area > 0.0).map(|n| area / (std::f64::consts::PI * n));
        check.add_number("contact_radius", each.map(f64::sqrt), "m", "of a contact of mean area");
        let mean = force / area;
        if mean > 0.0 {
            check.add_number("mean_pressure", mean, "Pa", "load over real area");
            if let Some(hardness) = scene.interface.softer_hardness() {
                check.add_number("mean_pressure_over_hardness", mean / hardness, "", "p/H");
                // Other models with a limited range report yielding by interference.
                let Validity { asperities, holds_to, .. } = model.validity();
                match holds_to {
                    None => check.extend(answer.above_hardness(mean / hardness)),
                    Some(_) if asperities => {}
                    Some(_) => check.extend(answer.yields(share_above(hardness / mean))),
                }
            }
        }
        check
    }

    /// Numbers and findings from the interferences of the asperities, for a law that may end in
    /// a plastic part.
    fn of_depths(&mut self, answer: Answer<'_>, deep: &Interferences, plastic: bool) {
        let Answer { model, scene, .. } = answer;
        let (w, r) = (deep.largest(), scene.surface.asperity_radius);
        let top = "exceeded by the asperities that carry the top 1 % of the load";
        self.add_number("interference", w, "m", top);
        self.add_number("interference_over_radius", w / r, "", "w/R of it");
        if w > FLATTENED * r {
            let deep = answer
                .warning(Code::Deep, "interference_over_radius", w / r)
                .usual([0.0, FLATTENED])
                .fact(format!(
                    "the asperities that carry the top 1 % of the load are pressed in by more than {} times their radius",
                    short(w / r)
                ))
                .advice("laws of spherical asperities do not hold so deep; boundary elements and persson-plastic have none");
            self.extend([deep]);
        }
        let critical = scene.asperity().and_then(|asperity| asperity.critical_interference());
        let Ok(critical) = critical else { return };
        self.add_number("interference_over_critical", w / critical, "", "w/w_c of it");
        let holds_to = model.validity().holds_to.filter(|multiple| *multiple > 1.0);
        self.extend(holds_to.and_then(|multiple| {
            let outside = deep.beyond(multiple * critical);
            answer.beyond_fit((outside, w / critical), multiple, plastic)
        }));
    }
}

/// What is judged, as accurate as the numbers of findings have to be.
fn judging() -> Result<Request, ContactError> {
    Ok(Request::new(Quantity::JUDGED).within(Tolerance::new(TOLERANCE)?))
}

/// Whether a relevant share of the contacts is deeper than spherical caps allow, by counting.
fn may_be_deep(contact: &dyn Contact, place: Separation, contacts: f64) -> bool {
    let surface = &contact.scene().surface;
    let depth = FLATTENED * surface.asperity_radius / surface.asperity_height_std;
    let deep = contact.evaluate(Quantity::Contacts, Separation::sigmas(place.value + depth));
    deep.is_ok_and(|deep| deep.value() > NEGLIGIBLE * contacts)
}

/// The smallest separation, and the largest and smallest loads and pressures, each once.
fn extremes(places: &[At], scene: &Scene) -> Vec<At> {
    let number = |at: &At| match at {
        // Invalid separations are refused elsewhere.
        At::Separation(place) => place
            .measured_in(SeparationUnit::Metres, Datum::AsperityMean, scene)
            .map_or(f64::NEG_INFINITY, |place| -place.value),
        _ => at.load(scene).unwrap_or(f64::NEG_INFINITY),
    };
    let mut found: Vec<At> = vec![];
    for kind in [At::sigmas(0.0), At::Load(0.0), At::Pressure(0.0)].map(|at| discriminant(&at)) {
        let mut alike: Vec<&At> = places.iter().filter(|at| discriminant(*at) == kind).collect();
        alike.sort_by(|a, b| number(a).total_cmp(&number(b)));
        alike.dedup_by(|a, b| number(a).total_cmp(&number(b)).is_eq());
        let least = alike.first().filter(|at| alike.len() > 1 && at.load(scene).is_some());
        found.extend(alike.last().into_iter().chain(least).map(|at| **at));
    }
    found
}
