//! An answer that is looked at before it is believed: how deep the asperities are pressed, how many
//! there are, and whether the model is made for that.

use super::finding::{Finding, Severity, short};
use super::interferences::Interferences;
use super::{Check, Scene};
use crate::{
    At, Contact, ContactError, ContactModel, Datum, KnownDefect, Quantity, Request, Separation,
    SeparationUnit, Tolerance,
};

/// So many numbers are enough for a word.
const TOLERANCE: f64 = 1e-6;
/// Asperities that cover more of the nominal area feel each other.
const CROWDED: [f64; 2] = [0.1, 0.5];
/// An average of fewer contacts says little about one surface.
const FEW: f64 = 30.0;
/// w/R beyond which an asperity is no longer a cap that is pressed a little.
const DEEP: [f64; 2] = [0.3, 1.0];
/// Fewer of the contacts than this carry no per cent of a load.
const NEGLIGIBLE: f64 = 1e-6;
/// p/H of the models that go on rising where contacts are plastic (JG, AF) is still below this.
const PLASTIC: f64 = 1.5;
/// Share of the force by asperities that yield, which an elastic law does not know.
const YIELDS: [f64; 2] = [0.02, 0.1];
/// Share of the force that a law is known to miss.
const MISSED: f64 = 0.2;
/// Share of the force beyond what a law was fitted to.
const BEYOND: f64 = 0.02;

impl Check {
    /// What follows from a scene, a model and a place: the numbers of [`Scene::check`], those of the
    /// answer, and what is unusual about either.
    ///
    /// # Errors
    /// [`ContactError`] naming what the scene or the model is refused for, and why there is no
    /// answer at this place.
    pub fn at(model: &dyn ContactModel, scene: &Scene, at: At) -> Result<Self, ContactError> {
        let mut check = scene.check()?;
        let answer = Self::of_answer(model, scene, at, true)?;
        check.keep_for(model);
        check.numbers.extend(answer.numbers);
        check.extend(answer.findings);
        Ok(check)
    }

    /// What is unusual about the answers at these places, each finding once: where the surfaces are
    /// closest, and at the lightest of the loads. A place that has no answer has no findings.
    #[must_use]
    pub fn answers(model: &dyn ContactModel, scene: &Scene, places: &[At]) -> Vec<Finding> {
        let mut check = Self::default();
        for at in extremes(places, scene) {
            if let Ok(answer) = Self::of_answer(model, scene, at, false) {
                check.extend(answer.findings);
            }
        }
        check.findings
    }

    /// Leaves out what a model of the whole surface knows nothing of.
    pub fn keep_for(&mut self, model: &dyn ContactModel) {
        let asperities = model.validity().asperities;
        self.findings.retain(|finding| asperities || !finding.is_of_asperities());
    }

    /// Why a real area is no answer of a model at a pressure: there is more of it than of the surface.
    #[must_use]
    pub fn no_answer(
        model: &dyn ContactModel,
        pressure: f64,
        area_fraction: f64,
    ) -> Option<Finding> {
        let at = At::Pressure(pressure);
        (area_fraction > 1.0).then(|| {
            let message = format!(
                "area_fraction is {} at {at} by {}, more than there is: no answer; are modulus and load in their units? else the load is too heavy for asperities: ask persson-fudge, or bem",
                short(area_fraction),
                model.name()
            );
            let (field, usual) = ("area_fraction", [0.0, CROWDED[0]]);
            let (code, severity) = ("above-nominal", Severity::Error);
            Finding::new(code, severity, field, area_fraction, usual, message)
        })
    }

    /// With all numbers, or with those alone that warnings come of: models over angles are then
    /// answered without their tables, and depths are looked at where they may matter.
    fn of_answer(
        model: &dyn ContactModel,
        scene: &Scene,
        at: At,
        whole: bool,
    ) -> Result<Self, ContactError> {
        let quantities = [Quantity::Force, Quantity::Area, Quantity::Contacts];
        let request = Request::new(quantities).within(Tolerance::new(TOLERANCE)?);
        let validity = model.validity();
        if validity.angles && !whole {
            let response = model.solve(scene, &request.at([at]))?;
            let row = |k: usize| response.columns[k].rows[0].as_ref();
            let value = |k| row(k).map(|found| found.value()).map_err(|error| (**error).clone());
            let totals = ([value(0)?, value(1)?], Some(value(2)?));
            return Ok(Self::of_totals(model, scene, at, None, totals));
        }
        let contact = model.compile(scene, &request)?;
        let from = crate::Datum::AsperityMean;
        let known = |at: At| -> Result<(Separation, f64), ContactError> {
            let found = contact.separation(at)?.measured_in(SeparationUnit::Sigma, from, scene)?;
            Ok((found, contact.evaluate(Quantity::Contacts, found)?.value()))
        };
        // A theory of the whole surface knows no single contacts.
        let (place, contacts) = match known(at) {
            Ok((found, contacts)) => (Some(found), Some(contacts)),
            Err(ContactError::Unsupported { .. } | ContactError::Missing { .. }) => (None, None),
            Err(error) => return Err(error),
        };
        let there = place.map_or(at, At::from);
        let of = |quantity| contact.evaluate(quantity, there).map(|found| found.value());
        let totals = ([of(Quantity::Force)?, of(Quantity::Area)?], contacts);
        let mut check = Self::of_totals(model, scene, at, place, totals);
        let Some((place, contacts)) = place.zip(contacts) else { return Ok(check) };
        let yields = validity.holds_to.is_some_and(|x| x <= 1.0);
        if (whole || yields || may_be_deep(&*contact, place, contacts))
            && let Ok(law) = model.law(&scene.asperity()?, Quantity::Force, request.tolerance)
            && let Some(deep) = Interferences::of(&*contact, &law, place)?
        {
            check.of_depths(model, scene, at, &deep);
        }
        Ok(check)
    }

    /// What force \[N\], area \[m²\] and number of contacts say.
    fn of_totals(
        model: &dyn ContactModel,
        scene: &Scene,
        at: At,
        place: Option<Separation>,
        ([force, area], contacts): ([f64; 2], Option<f64>),
    ) -> Self {
        let mut check = Self::default();
        let fraction = area / scene.nominal_area;
        let sigma = scene.surface.asperity_height_std;
        check.say("load", force, "N", "normal force");
        check.say("pressure", force / scene.nominal_area, "Pa", "load over A_n");
        if let Some(Separation { value, .. }) = place {
            let meaning = "d/sigma_z, from the mean of the asperity heights";
            check.say("separation_over_sigma", value, "", meaning);
            let meaning = "d, from the mean of the asperity heights";
            check.say("separation", value * sigma, "m", meaning);
        }
        check.say("area", area, "m2", format!("real area of contact, by {}", model.name()));
        check.say("area_fraction", fraction, "", "real over nominal area");
        check.extend(crowded(model, at, fraction).filter(|_| model.validity().asperities));
        check.extend(sticks(model, scene));
        if let Some(contacts) = contacts {
            check.say("contacts", contacts, "", "asperities that touch");
            if matches!(at, At::Load(_) | At::Pressure(_)) && contacts > 0.0 && contacts < FEW {
                check.extend([few(at, contacts)]);
            }
            if contacts > 0.0 && area > 0.0 {
                let radius = (area / (std::f64::consts::PI * contacts)).sqrt();
                check.say("contact_radius", radius, "m", "of a contact of mean area");
            }
        }
        let mean = force / area;
        if mean > 0.0 {
            check.say("mean_pressure", mean, "Pa", "load over real area");
            if let Ok((Some(hardness), ..)) = scene.interface.check() {
                check.say("mean_pressure_over_hardness", mean / hardness, "", "p/H");
                // What yields is told by its depth.
                if model.validity().holds_to.is_none() {
                    check.extend(above_hardness(model, at, mean / hardness));
                }
            }
        }
        check
    }

    /// What the depths tell to which the asperities are pressed.
    fn of_depths(&mut self, model: &dyn ContactModel, scene: &Scene, at: At, deep: &Interferences) {
        let (w, r) = (deep.largest(), scene.surface.asperity_radius);
        self.say("interference", w, "m", "w beyond which 1 % of the load is carried");
        self.say("interference_over_radius", w / r, "", "w/R of it");
        if w > DEEP[0] * r {
            let severity = if w > DEEP[1] * r { Severity::Error } else { Severity::Warning };
            let name = model.name();
            let message = format!(
                "interference_over_radius is {} at {at} by {name}: asperities are pressed as flat as they are high, which no law of a spherical cap describes",
                short(w / r)
            );
            let usual = [0.0, DEEP[0]];
            self.extend([Finding::new(
                "deep",
                severity,
                "interference_over_radius",
                w / r,
                usual,
                message,
            )]);
        }
        let Some(critical) = scene.asperity().ok().and_then(|a| a.critical_interference().ok())
        else {
            return;
        };
        self.say("interference_over_critical", w / critical, "", "w/w_c of it");
        let beyond = deep.beyond(critical);
        self.say("yielding_share", beyond, "", "of the load, by asperities with w > w_c");
        if let Some(misses) = model.validity().known_defect {
            let [from, to] = [misses.from, misses.to].map(|x| deep.beyond(x * critical));
            self.extend(missed(model, at, from - to, &misses));
        }
        let Some(holds_to) = model.validity().holds_to else { return };
        let outside = deep.beyond(holds_to * critical);
        if holds_to <= 1.0 {
            self.extend(yields(model, at, outside));
        } else {
            self.extend(beyond_fit(model, at, outside, w / critical, holds_to));
        }
    }
}

/// Whether enough asperities are pressed deeper than caps may be for it to matter: counted, which
/// is cheap.
fn may_be_deep(contact: &dyn Contact, place: Separation, contacts: f64) -> bool {
    let surface = &contact.scene().surface;
    let depth = DEEP[0] * surface.asperity_radius / surface.asperity_height_std;
    let deep = contact.evaluate(Quantity::Contacts, Separation::sigmas(place.value + depth));
    deep.is_ok_and(|deep| deep.value() > NEGLIGIBLE * contacts)
}

const HIDDEN: f64 = Scene::HIDES_ADHESION;

/// Adhesion that a scene has and a model does not know, or knows beyond what it is derived for.
fn sticks(model: &dyn ContactModel, scene: &Scene) -> Option<Finding> {
    let theta = scene.adhesion_parameter().filter(|theta| *theta < HIDDEN)?;
    let name = model.name();
    let Some([least, most]) = model.validity().tabor else {
        let message = format!(
            "adhesion_parameter is {}: at less than {HIDDEN} surfaces stick, and {name} leaves the work_of_adhesion out: ask dmt or jkr",
            short(theta)
        );
        let (field, usual) = ("adhesion_parameter", [HIDDEN, f64::INFINITY]);
        return Some(Finding::new("sticks", Severity::Warning, field, theta, usual, message));
    };
    let tabor = scene.asperity().ok()?.tabor_parameter()?;
    let other = if tabor > most { "jkr" } else { "dmt" };
    let message = format!(
        "tabor_parameter is {}: {name} holds from {least} to {most}: {other} is nearer",
        short(tabor)
    );
    let (field, usual) = ("tabor_parameter", [least, most]);
    let finding = Finding::new("tabor", Severity::Warning, field, tabor, usual, message);
    (!(least..=most).contains(&tabor)).then_some(finding)
}

/// A load that asperities carry which yield, by a model that knows no yielding.
fn yields(model: &dyn ContactModel, at: At, share: f64) -> Option<Finding> {
    let severity = if share > YIELDS[1] { Severity::Warning } else { Severity::Note };
    let (name, percent) = (model.name(), short(100.0 * share));
    let advice = match model.validity().adhesive {
        true => {
            "no model here has both yielding and adhesion: ke and jg have the first alone, and are nearer where adhesion_parameter is above 10"
        }
        false => "ask a model that does (ke, jg)",
    };
    let message = format!(
        "yielding_share is {percent} % at {at}: {name} knows no yielding and gives too small an area and too large a load there: {advice}"
    );
    let usual = [0.0, YIELDS[0]];
    let finding = Finding::new("yields", severity, "yielding_share", share, usual, message);
    (share > YIELDS[0]).then_some(finding)
}

/// A load that is carried where a law is known to be off.
fn missed(model: &dyn ContactModel, at: At, share: f64, defect: &KnownDefect) -> Option<Finding> {
    let KnownDefect { from, to, summary } = defect;
    let message = format!(
        "missed_share is {} % at {at}, of the load by asperities from {from} to {to} w_c: {} {summary}",
        short(100.0 * share),
        model.name()
    );
    let usual = [0.0, MISSED];
    let finding =
        Finding::new("fit-misses", Severity::Warning, "missed_share", share, usual, message);
    (share > MISSED).then_some(finding)
}

/// A load that is carried beyond what a law was fitted to; `x` is the largest w/w_c that matters.
fn beyond_fit(
    model: &dyn ContactModel,
    at: At,
    share: f64,
    x: f64,
    holds_to: f64,
) -> Option<Finding> {
    let (name, percent) = (model.name(), short(100.0 * share));
    let message = format!(
        "interference_over_critical is {} at {at}: {percent} % of the load is carried beyond {} w_c, to which {name} is fitted; it goes on as plastic there, as one expects",
        short(x),
        short(holds_to)
    );
    let (field, usual) = ("interference_over_critical", [0.0, holds_to]);
    let finding = Finding::new("beyond-fit", Severity::Note, field, x, usual, message);
    (share > BEYOND).then_some(finding)
}

fn crowded(model: &dyn ContactModel, at: At, fraction: f64) -> Option<Finding> {
    let severity = match fraction {
        f if f > CROWDED[1] => Severity::Error,
        f if f > CROWDED[0] => Severity::Warning,
        _ => return None,
    };
    let message = format!(
        "area_fraction is {} at {at} by {}: models of asperities that do not feel each other are made for less than {}, and contacts grow together beyond",
        short(fraction),
        model.name(),
        CROWDED[0]
    );
    Some(Finding::new("crowded", severity, "area_fraction", fraction, [0.0, CROWDED[0]], message))
}

/// A mean pressure that no contact carries.
fn above_hardness(model: &dyn ContactModel, at: At, ratio: f64) -> Option<Finding> {
    let message = format!(
        "mean_pressure_over_hardness is {} at {at} by {}: no contact carries much more than its hardness, the real area is larger: ask a model of yielding (ke, jg)",
        short(ratio),
        model.name()
    );
    let field = "mean_pressure_over_hardness";
    let usual = [0.0, PLASTIC];
    let finding = Finding::new("above-hardness", Severity::Warning, field, ratio, usual, message);
    (ratio > PLASTIC).then_some(finding)
}

fn few(at: At, contacts: f64) -> Finding {
    let message = format!(
        "contacts is {} at {at}: one surface differs from this average of many by more than the models do",
        short(contacts)
    );
    let usual = [FEW, f64::INFINITY];
    Finding::new("few-contacts", Severity::Warning, "contacts", contacts, usual, message)
}

/// The closest place and, of loads, the lightest.
fn extremes(places: &[At], scene: &Scene) -> Vec<At> {
    let mut found: Vec<At> = vec![];
    let number = |at: &At| match at {
        // One that is no place is refused elsewhere.
        At::Separation(place) => place
            .measured_in(SeparationUnit::Metres, Datum::AsperityMean, scene)
            .map_or(f64::NEG_INFINITY, |place| -place.value),
        At::Load(load) => *load,
        At::Pressure(pressure) => *pressure,
    };
    for kind in 0..3 {
        let same = |at: &&At| match at {
            At::Separation(_) => kind == 0,
            At::Load(_) => kind == 1,
            At::Pressure(_) => kind == 2,
        };
        let by_number = |a: &&At, b: &&At| number(a).total_cmp(&number(b));
        found.extend(places.iter().filter(same).max_by(by_number));
        if kind > 0 {
            found.extend(places.iter().filter(same).min_by(by_number));
        }
    }
    found
}
