//! Plausibility of an answer: interferences, number of contacts, and the range of validity of the
//! model.

use super::interferences::Interferences;
use super::{Check, Scene};
use crate::diagnostic::short;
use crate::recommended::{DMT, FULL_CONTACT, JKR, WHOLE_SURFACE, YIELDING};
use crate::{
    At, Contact, ContactError, ContactModel, Datum, Diagnostic, Diagnostics, KnownDefect, Quantity,
    Regime, Request, Separation, SeparationUnit, Severity, Tolerance, Validity,
};

/// Tolerance of the numbers in diagnostics.
const TOLERANCE: f64 = 1e-6;
/// Area fractions above which asperities interact (warning), and above which they would overlap
/// (error).
const CROWDED: [f64; 2] = [0.1, 1.0];
/// Number of contacts below which a single realisation differs much from the average.
const FEW: f64 = 30.0;
/// w/R beyond which an asperity is no spherical cap under small deformation.
const FLATTENED: f64 = 0.3;
/// Share of the contacts that carries less than one per cent of the load.
const NEGLIGIBLE: f64 = 1e-6;
/// Largest plausible p/H; plastic contacts of JG and AF, whose p/H rises with w, are below.
const PLASTIC: f64 = 1.5;
/// Share of the force on yielding asperities (note, warning), which an elastic law ignores.
const YIELDS: [f64; 2] = [0.02, 0.1];
/// Meaning of that share.
const YIELDING_SHARE: &str = "of the load, by asperities with w > w_c";
/// Share of the force in the range of a known defect of the law.
const MISSED: f64 = 0.2;
/// Share of the force beyond the fitted range of a law.
const BEYOND: f64 = 0.02;

impl Check {
    /// Derived numbers and findings of a scene ([`Scene::check`]) and of a model's answer at a
    /// place.
    ///
    /// # Errors
    /// [`ContactError`] with the reason why the scene, the model or the place is refused.
    pub fn at(model: &dyn ContactModel, scene: &Scene, at: At) -> Result<Self, ContactError> {
        let mut check = scene.check()?;
        let answer = Self::of_answer(model, scene, at, true)?;
        check.keep_for(model);
        check.numbers.extend(answer.numbers);
        check.extend(answer.findings);
        Ok(check)
    }

    /// Findings of the answers at these places, each once: at the smallest separation, and at the
    /// smallest and largest loads. Places without an answer have no findings.
    #[must_use]
    pub fn answers(model: &dyn ContactModel, scene: &Scene, places: &[At]) -> Diagnostics {
        let mut check = Self::default();
        for at in extremes(places, scene) {
            if let Ok(answer) = Self::of_answer(model, scene, at, false) {
                check.extend(answer.findings);
            }
        }
        // The worst of a few extremes: rows are not counted.
        check.findings.into_iter().map(|found| found.in_rows(1)).collect()
    }

    /// Removes findings about asperities for models of the whole surface.
    pub fn keep_for(&mut self, model: &dyn ContactModel) {
        let findings = std::mem::take(&mut self.findings);
        self.findings = findings.for_asperities(model.validity().asperities);
    }

    /// An error where a model's real area at a pressure exceeds the nominal area.
    #[must_use]
    pub fn no_answer(
        model: &dyn ContactModel,
        pressure: f64,
        area_fraction: f64,
    ) -> Option<Diagnostic> {
        let found = Diagnostic::error("above-nominal", "area_fraction", area_fraction)
            .usual([0.0, CROWDED[0]])
            .of_model(model.name())
            .at(At::Pressure(pressure))
            .fact(format!("area_fraction is {}, above 1", short(area_fraction)))
            .advice(format!(
                "check the units of modulus and load; at such loads use {FULL_CONTACT}"
            ));
        (area_fraction > 1.0).then_some(found)
    }

    /// All numbers if `whole`, otherwise only those with warnings: models with inclined contacts
    /// are then solved without tables, and interferences only where they may matter.
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
        let contacts_at = |at: At| -> Result<(Separation, f64), ContactError> {
            let found = contact.separation(at)?.measured_in(SeparationUnit::Sigma, from, scene)?;
            Ok((found, contact.evaluate(Quantity::Contacts, found)?.value()))
        };
        // Theories of the whole surface have no number of contacts.
        let (place, contacts) = match contacts_at(at) {
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
            let plastic = law.parts.last().is_some_and(|part| part.regime == Regime::Plastic);
            check.of_depths(model, scene, at, (&deep, plastic));
        }
        if whole || yields {
            check.of_different_radii(model, scene, at, place);
        }
        Ok(check)
    }

    /// Numbers and diagnostics from the shares of the force that yielding asperities of different
    /// radii carry; none for other models and without a hardness.
    fn of_different_radii(
        &mut self,
        model: &dyn ContactModel,
        scene: &Scene,
        at: At,
        place: Separation,
    ) {
        let Validity { holds_to, known_defect, .. } = model.validity();
        let defect = known_defect.map(|defect| [defect.from, defect.to]);
        let mut multiples = vec![1.0];
        multiples.extend(defect.iter().flatten());
        let Ok(Some(beyond)) = model.shares_beyond(scene, place.into(), &multiples) else { return };
        let [yielding, missing @ ..] = &beyond[..] else { return };
        self.add_number("yielding_share", *yielding, "", YIELDING_SHARE);
        if holds_to.is_some_and(|multiple| multiple <= 1.0) {
            self.extend(yields(model, at, *yielding));
        }
        if let (Some(defect), [from, to]) = (known_defect, missing) {
            self.extend(missed(model, at, from - to, &defect));
        }
    }

    /// Numbers and findings from force \[N\], area \[m²\] and number of contacts.
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
        check.add_number("load", force, "N", "normal force");
        check.add_number("pressure", force / scene.nominal_area, "Pa", "load over A_n");
        if let Some(Separation { value, .. }) = place {
            let meaning = "d/sigma_z, from the mean of the asperity heights";
            check.add_number("separation_over_sigma", value, "", meaning);
            let meaning = "d, from the mean of the asperity heights";
            check.add_number("separation", value * sigma, "m", meaning);
        }
        check.add_number("area", area, "m2", format!("real area of contact, by {}", model.name()));
        check.add_number("area_fraction", fraction, "", "real over nominal area");
        check.extend(crowded(model, at, fraction).filter(|_| model.validity().asperities));
        check.extend(sticks(model, scene));
        if let Some(contacts) = contacts {
            check.add_number("contacts", contacts, "", "asperities that touch");
            if matches!(at, At::Load(_) | At::Pressure(_)) && contacts > 0.0 && contacts < FEW {
                check.extend([few(model, at, contacts)]);
            }
            if contacts > 0.0 && area > 0.0 {
                let radius = (area / (std::f64::consts::PI * contacts)).sqrt();
                check.add_number("contact_radius", radius, "m", "of a contact of mean area");
            }
        }
        let mean = force / area;
        if mean > 0.0 {
            check.add_number("mean_pressure", mean, "Pa", "load over real area");
            if let Ok((Some(hardness), ..)) = scene.interface.check() {
                check.add_number("mean_pressure_over_hardness", mean / hardness, "", "p/H");
                // Other models with a limited range report yielding by interference.
                let Validity { asperities, holds_to, .. } = model.validity();
                match holds_to {
                    None => check.extend(above_hardness(model, at, mean / hardness)),
                    Some(_) if asperities => {}
                    Some(_) => check.extend(yields(model, at, share_above(hardness / mean))),
                }
            }
        }
        check
    }

    /// Numbers and diagnostics from the interferences of the asperities, for a law that may end in
    /// a plastic part.
    fn of_depths(
        &mut self,
        model: &dyn ContactModel,
        scene: &Scene,
        at: At,
        (deep, plastic): (&Interferences, bool),
    ) {
        let (w, r) = (deep.largest(), scene.surface.asperity_radius);
        self.add_number(
            "interference",
            w,
            "m",
            "exceeded by the asperities that carry the top 1 % of the load",
        );
        self.add_number("interference_over_radius", w / r, "", "w/R of it");
        if w > FLATTENED * r {
            let deep = Diagnostic::warning("deep", "interference_over_radius", w / r)
                .usual([0.0, FLATTENED])
                .of_model(model.name())
                .at(at)
                .advice("the interference is too large for a spherical-asperity law");
            self.extend([deep]);
        }
        let Some(critical) = scene.asperity().ok().and_then(|a| a.critical_interference().ok())
        else {
            return;
        };
        self.add_number("interference_over_critical", w / critical, "", "w/w_c of it");
        let beyond = deep.beyond(critical);
        self.add_number("yielding_share", beyond, "", YIELDING_SHARE);
        if let Some(misses) = model.validity().known_defect {
            let [from, to] = [misses.from, misses.to].map(|x| deep.beyond(x * critical));
            self.extend(missed(model, at, from - to, &misses));
        }
        let Some(holds_to) = model.validity().holds_to else { return };
        let outside = deep.beyond(holds_to * critical);
        if holds_to <= 1.0 {
            self.extend(yields(model, at, outside));
        } else {
            let x = w / critical;
            self.extend(beyond_fit(model, at, (outside, x), holds_to, plastic));
        }
    }
}

/// Whether a relevant share of the contacts is deeper than spherical caps allow, by counting.
fn may_be_deep(contact: &dyn Contact, place: Separation, contacts: f64) -> bool {
    let surface = &contact.scene().surface;
    let depth = FLATTENED * surface.asperity_radius / surface.asperity_height_std;
    let deep = contact.evaluate(Quantity::Contacts, Separation::sigmas(place.value + depth));
    deep.is_ok_and(|deep| deep.value() > NEGLIGIBLE * contacts)
}

const HIDDEN: f64 = Scene::HIDES_ADHESION;

/// A warning if the model ignores the scene's adhesion or is outside its range of adhesion.
fn sticks(model: &dyn ContactModel, scene: &Scene) -> Option<Diagnostic> {
    let theta = scene.adhesion_parameter().filter(|theta| *theta < HIDDEN)?;
    let Some([least, most]) = model.validity().tabor else {
        let found = Diagnostic::warning("sticks", "adhesion_parameter", theta)
            .usual([HIDDEN, f64::INFINITY])
            .of_model(model.name())
            .advice(format!(
                "this model ignores work_of_adhesion, which matters here; use {DMT} or {JKR}"
            ));
        return Some(found);
    };
    let tabor = scene.asperity().ok()?.tabor_parameter()?;
    let other = if tabor > most { JKR } else { DMT };
    let found = Diagnostic::warning("tabor", "tabor_parameter", tabor)
        .usual([least, most])
        .of_model(model.name())
        .advice(format!("outside the range of this model; use {other}"));
    (!(least..=most).contains(&tabor)).then_some(found)
}

/// The share of the load that an elastic theory of the whole surface puts on pressures above this
/// multiple of the mean pressure: pressures of small contact areas follow Rayleigh's distribution
/// (Persson 2001) \[derived\].
fn share_above(multiple: f64) -> f64 {
    let x = 0.5 * std::f64::consts::PI.sqrt() * multiple;
    libm::erfc(x) + std::f64::consts::FRAC_2_SQRT_PI * x * (-x * x).exp()
}

/// A finding for a load on yielding asperities with an elastic model.
fn yields(model: &dyn ContactModel, at: At, share: f64) -> Option<Diagnostic> {
    let name = model.name();
    let remedy = match model.validity().adhesive {
        true => format!(
            "no model has both yielding and adhesion; use {YIELDING} if adhesion_parameter is above {HIDDEN}"
        ),
        false => format!("use {YIELDING}"),
    };
    let carriers = match model.validity().asperities {
        true => "yielding asperities",
        false => "pressures above the hardness",
    };
    let severity = if share > YIELDS[1] { Severity::Warning } else { Severity::Note };
    let found = Diagnostic::warning("yields", "yielding_share", share)
        .severity(severity)
        .usual([0.0, YIELDS[0]])
        .of_model(name)
        .at(at)
        .fact(format!("{carriers} carry {} % of the force", short(100.0 * share)))
        .advice(format!(
            "{name} ignores yielding and underestimates the area at this load; {remedy}"
        ));
    (share > YIELDS[0]).then_some(found)
}

/// A finding for a load in the range of a known defect of the law.
fn missed(
    model: &dyn ContactModel,
    at: At,
    share: f64,
    defect: &KnownDefect,
) -> Option<Diagnostic> {
    let KnownDefect { from, to, summary } = defect;
    let percent = short(100.0 * share);
    let found = Diagnostic::warning("fit-misses", "missed_share", share)
        .usual([0.0, MISSED])
        .of_model(model.name())
        .at(at)
        .fact(format!(
            "asperities with interferences from {from} to {to} w_c carry {percent} % of the force"
        ))
        .advice(format!("{} {summary}", model.name()));
    (share > MISSED).then_some(found)
}

/// A finding for a load beyond the fitted range of a law; `x` is the largest relevant w/w_c.
fn beyond_fit(
    model: &dyn ContactModel,
    at: At,
    (share, x): (f64, f64),
    holds_to: f64,
    plastic: bool,
) -> Option<Diagnostic> {
    let continued = if plastic { "assumes full plasticity" } else { "is extrapolated" };
    let (name, limit, percent) = (model.name(), short(holds_to), short(100.0 * share));
    let found = Diagnostic::note("beyond-fit", "interference_over_critical", x)
        .usual([0.0, holds_to])
        .of_model(name)
        .at(at)
        .fact(format!(
            "asperities with interferences beyond {limit} w_c carry {percent} % of the force"
        ))
        .advice(format!("beyond this interference {name} {continued}"));
    (share > BEYOND).then_some(found)
}

fn crowded(model: &dyn ContactModel, at: At, fraction: f64) -> Option<Diagnostic> {
    let severity = match fraction {
        f if f > CROWDED[1] => Severity::Error,
        f if f > CROWDED[0] => Severity::Warning,
        _ => return None,
    };
    let found = Diagnostic::warning("crowded", "area_fraction", fraction).severity(severity);
    let advice = format!(
        "contacts merge, and models of independent asperities do not hold; use {WHOLE_SURFACE}"
    );
    Some(found.usual([0.0, CROWDED[0]]).of_model(model.name()).at(at).advice(advice))
}

/// A warning for a mean pressure that exceeds any hardness.
fn above_hardness(model: &dyn ContactModel, at: At, ratio: f64) -> Option<Diagnostic> {
    let found = Diagnostic::warning("above-hardness", "mean_pressure_over_hardness", ratio)
        .usual([0.0, PLASTIC])
        .of_model(model.name())
        .at(at)
        .advice(format!("the contacts would yield, and the real area is larger; use {YIELDING}"));
    (ratio > PLASTIC).then_some(found)
}

fn few(model: &dyn ContactModel, at: At, contacts: f64) -> Diagnostic {
    let advice =
        "with so few contacts, the scatter between samples exceeds the differences between models";
    let found = Diagnostic::warning("few-contacts", "contacts", contacts);
    found.usual([FEW, f64::INFINITY]).of_model(model.name()).at(at).advice(advice)
}

/// The smallest separation, and the smallest and largest loads and pressures.
fn extremes(places: &[At], scene: &Scene) -> Vec<At> {
    let mut found: Vec<At> = vec![];
    let number = |at: &At| match at {
        // Invalid separations are refused elsewhere.
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
