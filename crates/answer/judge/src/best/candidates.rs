//! A model that answers without evidence, on a scene, and what is known of a place.

use std::sync::{Arc, OnceLock};

use super::model::Answering;
use crate::check::Check;
use crate::evidence::{Compared, ExpectedContact, Lacking, compile_known};
use asperity_core::{
    At, Code, Contact, ContactError, Evaluation, Finding, Quantity, Request, Scene, Severity,
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
        let compile = |quantities: &[Quantity]| {
            let asked = Request::new(quantities.iter().copied()).within(request.tolerance);
            model.compile(scene, &asked)
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

    /// Why it is not valid at a place, if it is not.
    pub(super) fn outside(&self, at: At) -> Option<Finding> {
        let contact = &*self.contact;
        let found = Check::answers(&self.model, contact.scene(), Some(contact), &[at]);
        let limits = |one: &Finding| {
            one.code.is_of_model() || matches!(one.code, Code::Crowded | Code::Tabor)
        };
        found.into_iter().find(|one| one.severity < Severity::Note && limits(one))
    }
}

/// A model that may answer, compiled where its answer is needed; none where the scene refuses it.
pub(super) type OnDemand<M> = (M, OnceLock<Option<Candidate<M>>>);

/// Why each of the candidates is not valid at a place, if it is not, where that was asked for.
pub(super) type Judged = OnceLock<Vec<OnceLock<Option<Finding>>>>;

/// A place of an answer.
#[derive(Debug)]
pub(super) struct Place {
    /// Mean pressure \[Pa\]; none at a separation outside of all evidence.
    pub(super) pressure: Option<f64>,
    pub(super) expected: Result<ExpectedContact, ContactError>,
    pub(super) judged: Judged,
}

/// Shared, as several quantities are asked for at a place.
pub(super) type SharedPlace = Arc<Place>;
