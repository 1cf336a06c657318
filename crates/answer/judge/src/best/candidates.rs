//! A model that answers without evidence, on a scene, and what is known of a place.

use std::sync::{Arc, OnceLock};

use super::model::Answering;
use crate::check::{Check, LEAST_TABOR, MOST_TABOR};
use crate::evidence::{Compared, ExpectedContact, Lacking, compile_known};
use crate::recommended::{DMT, JKR};
use asperity_core::{
    At, Code, Contact, ContactError, Evaluation, Finding, Quantity, Request, Scene, Severity, short,
};

/// A model on the scene of an answer.
#[derive(Debug)]
pub(super) struct Candidate<M> {
    pub(super) model: M,
    contact: Box<dyn Contact>,
    lacking: Lacking,
}

impl<M: Answering> Candidate<M> {
    pub(super) fn new(model: M, scene: &Scene, request: &Request) -> Option<Self> {
        let mut asked = Compared::QUANTITIES.to_vec();
        asked.extend([Quantity::Force]);
        asked.extend(model.validity().asperities.then_some(Quantity::Contacts));
        // Few places need no tables.
        let compile = |quantities: &[Quantity]| {
            let asked = Request::new(quantities.iter().copied()).within(request.tolerance);
            match &request.at[..] {
                [] => model.compile(scene, &asked),
                places => model.contact(scene, &asked.at(places.iter().copied())),
            }
        };
        let (contact, lacking) = compile_known(&asked, &[], compile).ok()?;
        Some(Self { contact, lacking, model })
    }

    /// Its value of a compared quantity.
    pub(super) fn value(&self, of: Compared, at: At) -> Result<f64, ContactError> {
        let lacks = |(lacks, _): &&(Quantity, _)| Some(*lacks) == of.quantity();
        match self.lacking.iter().find(lacks) {
            Some((_, why)) => Err(why.clone()),
            None => of.of_contact(&*self.contact, at),
        }
    }

    /// The force \[N\].
    pub(super) fn force(&self, at: At) -> Result<Evaluation, ContactError> {
        self.contact.evaluate(Quantity::Force, at)
    }

    /// How it is judged at a place.
    pub(super) fn judged(&self, at: At) -> Judged {
        let contact = &*self.contact;
        let found = Check::answers(&self.model, contact.scene(), Some(contact), &[at]);
        let limits = |one: &Finding| {
            one.code.is_of_model() || matches!(one.code, Code::Crowded | Code::Tabor)
        };
        let warnings = || found.iter().filter(|one| one.severity < Severity::Note);
        let outside = warnings().find(|one| limits(one)).cloned();
        let deep = warnings().find(|one| one.code == Code::Deep).cloned();
        Judged { outside, deep }
    }
}

/// How a model is judged at a place.
#[derive(Debug)]
pub(super) struct Judged {
    /// Why it is not valid there, if it is not.
    pub(super) outside: Option<Finding>,
    /// That asperities are pressed in deeply, as with any law of spheres.
    pub(super) deep: Option<Finding>,
}

impl Judged {
    /// Whether no contact carries or has so much.
    pub(super) fn is_impossible(&self) -> bool {
        self.outside.as_ref().is_some_and(|why| {
            why.code == Code::BeyondFullContact || why.code == Code::Crowded && why.value > 1.0
        })
    }
}

/// A model that may answer, compiled where its answer is needed; none where the scene refuses it.
pub(super) type OnDemand<M> = (M, OnceLock<Option<Candidate<M>>>);

/// How each of the candidates is judged at a place, where that was asked for.
pub(super) type AllJudged = OnceLock<Vec<OnceLock<Judged>>>;

/// A place of an answer.
#[derive(Debug)]
pub(super) struct Place {
    /// Mean pressure \[Pa\]; none at a separation that no pressure is expected to have.
    pub(super) pressure: Option<f64>,
    pub(super) expected: Result<ExpectedContact, ContactError>,
    pub(super) judged: AllJudged,
}

impl Place {
    /// Whether what is expected there is known at a pressure \[Pa\] itself.
    pub(super) fn has(&self, pressure: f64) -> bool {
        let is_here = |found: &ExpectedContact| !found.extrapolated;
        self.pressure == Some(pressure) && self.expected.as_ref().is_ok_and(is_here)
    }

    /// Whether solved surfaces give an interval.
    pub(super) fn has_interval(&self) -> bool {
        let any = |found: &ExpectedContact| found.values.iter().any(|(_, one)| one.ends.is_some());
        self.expected.as_ref().is_ok_and(any)
    }
}

/// Shared, as several quantities are asked for at a place.
pub(super) type SharedPlace = Arc<Place>;

/// The model without adhesion that both extend.
const PLAIN: &str = "gw";
/// A relative change of the area that intervals do not count.
const MATTERS: f64 = 0.05;

/// A quantity of a scene by one model.
#[derive(Debug)]
pub(super) struct ByModel {
    contact: Box<dyn Contact>,
    quantity: Quantity,
}

impl ByModel {
    /// None where the model refuses the scene.
    pub(super) fn new<M: Answering>(id: &str, quantity: Quantity, scene: &Scene) -> Option<Self> {
        // With the force law, which finds the separation of a load.
        let asked = Request::new([quantity]).at([At::Pressure(1.0)]);
        Some(Self { contact: id.parse::<M>().ok()?.contact(scene, &asked).ok()?, quantity })
    }

    /// The value at a mean pressure \[Pa\], if it is known.
    pub(super) fn at(&self, pressure: f64) -> Option<f64> {
        Some(self.contact.evaluate(self.quantity, At::Pressure(pressure)).ok()?.value())
    }
}

/// A model with adhesion beside the same without, on a scene that has a work of adhesion.
#[derive(Debug)]
pub(super) struct Adhesion {
    id: &'static str,
    adhering: ByModel,
    plain: ByModel,
}

impl Adhesion {
    /// None without a work of adhesion.
    pub(super) fn on<M: Answering>(scene: &Scene) -> Option<Self> {
        let tabor = scene.asperity().ok()?.tabor_parameter()?;
        // Between their limits the nearer model.
        let id = if tabor * tabor > LEAST_TABOR * MOST_TABOR { JKR } else { DMT };
        let area = |id| ByModel::new::<M>(id, Quantity::Area, scene);
        Some(Self { id, adhering: area(id)?, plain: area(PLAIN)? })
    }

    /// By how much it changes the area at a mean pressure \[Pa\], if that matters.
    pub(super) fn effect_on_area(&self, pressure: f64) -> Option<String> {
        let ratio = self.adhering.at(pressure)? / self.plain.at(pressure)?;
        let (times, id) = (short(ratio), self.id);
        let text =
            format!("adhesion, which is left out, makes the area {times} times as large by {id}");
        ((ratio - 1.0).abs() > MATTERS).then_some(text)
    }
}
