//! The model that answers, and how far others are from the answer.

use std::sync::OnceLock;

use super::candidates::{AllJudged, Candidate, Judged, OnDemand};
use super::contact::BestContact;
use super::model::Answering;
use crate::evidence::{Compared, ExpectedContact};
use crate::recommended::{ANSWERING, usual_reference};
use asperity_core::{At, ContactError, Finding, Scene};

/// A model beside the answer.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Other<M> {
    /// The model.
    pub model: M,
    /// How far it is from the answer in area and stiffnesses, relative to it.
    pub off: Vec<(Compared, f64)>,
    /// Why the model is not valid here, if it is not.
    pub outside: Option<Finding>,
}

impl<M: Answering> BestContact<M> {
    /// The models, preferred first: without adhesion, unless it matters.
    fn models(&self) -> &[OnDemand<M>] {
        self.candidates.get_or_init(|| {
            let named = || ANSWERING.iter().filter_map(|id| id.parse().ok()).collect();
            let models = match &self.best.models[..] {
                [] => named(),
                models => models.to_vec(),
            };
            let theta = self.scene.adhesion_parameter();
            let adheres = theta.is_some_and(|theta| theta < Scene::HIDES_ADHESION);
            let fits = |model: &M| model.validity().adhesive == adheres;
            models.into_iter().filter(fits).map(|model| (model, OnceLock::new())).collect()
        })
    }

    /// Each model on the scene, with why it is not valid at a place, if it is not; what is not
    /// looked at is not computed.
    fn candidates<'a, 'j>(
        &'a self,
        judged: &'j AllJudged,
        at: At,
    ) -> impl Iterator<Item = (&'a Candidate<M>, &'j Judged)> {
        let models = self.models();
        let judged = judged.get_or_init(|| models.iter().map(|_| OnceLock::new()).collect());
        models.iter().zip(judged).filter_map(move |(one, judged)| {
            let one = self.made(one)?;
            Some((one, judged.get_or_init(|| one.judged(at))))
        })
    }

    fn made<'a>(&'a self, (model, made): &'a OnDemand<M>) -> Option<&'a Candidate<M>> {
        let new = || Candidate::new(model.clone(), &self.scene, &self.request);
        made.get_or_init(new).as_ref()
    }

    /// The usual reference model of the scene.
    pub(super) fn usual(&self) -> Option<&Candidate<M>> {
        let id = usual_reference(&self.scene);
        self.models().iter().find(|(model, _)| model.id() == id).and_then(|one| self.made(one))
    }

    /// The first valid model with a value, or the first with one and why it is not valid.
    pub(super) fn first(
        &self,
        of: Compared,
        at: At,
    ) -> Result<(&Candidate<M>, f64, Option<Finding>), ContactError> {
        let place = self.place(at);
        let (mut invalid, mut refused, mut failed) = (None, None, None);
        // An area carries the hardness at most, to the error of a model by one per cent.
        let hardness = self.scene.asperity()?.hardness;
        let carried = hardness.zip(at.pressure(&self.scene)).map_or(0.0, |(h, p)| 0.99 * p / h);
        let (least, name, limit) = match of {
            Compared::MeanGap => (0.0, "mean gap", "0"),
            Compared::Area => (carried, "area", "load over hardness"),
            _ => (f64::NEG_INFINITY, "", ""),
        };
        for (one, judged) in self.candidates(&place.judged, at) {
            match (one.value(of, at), &judged.outside) {
                (Ok(value), _) if value < least => {
                    let id = one.model.id();
                    let why = format!("the {name} by {id} is below {limit}, which cannot be");
                    refused.get_or_insert_with(|| self.refused(why));
                }
                (Ok(value), None) => return Ok((one, value, None)),
                (Ok(_), Some(why)) if judged.is_impossible() => {
                    refused.get_or_insert_with(|| self.refused(why.to_string()));
                }
                (Ok(value), Some(why)) => {
                    invalid.get_or_insert((one, value, Some(why.clone())));
                }
                (Err(error), _) => drop(failed.get_or_insert(error)),
            }
        }
        invalid.ok_or_else(|| {
            refused
                .or(failed)
                .unwrap_or_else(|| self.refused("no model has a value on this scene".into()))
        })
    }

    /// The valid model that is nearest to the expected value, and its own there; at an `other`
    /// pressure \[Pa\] it has no more area than there is.
    pub(super) fn nearest(
        &self,
        of: Compared,
        expected: &ExpectedContact,
        other: Option<f64>,
    ) -> Option<(&Candidate<M>, f64)> {
        let wanted = expected.estimate(of)?.value;
        let at = At::Pressure(expected.pressure);
        let place = self.place(at);
        let valid =
            self.candidates(&place.judged, at).filter(|(_, judged)| judged.outside.is_none());
        let fits = |one: &Candidate<M>| {
            let area = |other: f64| one.value(Compared::Area, At::Pressure(other));
            other.is_none_or(|other| area(other).is_ok_and(|area| area <= 1.0))
        };
        let known = valid.filter(|(one, _)| fits(one));
        let known = known.filter_map(|(one, _)| Some((one, one.value(of, at).ok()?)));
        let off = |value: f64| match of {
            Compared::MeanGap => (value - wanted).abs(),
            _ => (value / wanted).ln().abs(),
        };
        known.min_by(|(_, a), (_, b)| off(*a).total_cmp(&off(*b)))
    }

    /// The model whose value is the answer or, with evidence, the valid one that is nearest to it.
    #[must_use]
    pub fn by(&self, of: Compared, at: At) -> Option<&M> {
        let expected = || {
            let pressure = self.place(at).pressure?;
            let anchor = self.anchor(of, pressure)?;
            let expected = anchor.expected.as_ref().ok()?;
            match anchor.has(pressure) {
                true => Some(self.nearest(of, expected, None)?.0),
                false => self.keeping(of, expected, pressure),
            }
        };
        let first = || self.first(of, at).ok().map(|(one, ..)| one);
        expected().or_else(first).map(|one| &one.model)
    }

    /// That the asperities of a model are pressed in deeply, if they are.
    pub(super) fn deep(&self, id: &str, at: At) -> Option<Finding> {
        let place = self.place(at);
        let mut all = self.candidates(&place.judged, at);
        all.find(|(one, _)| one.model.id() == id)?.1.deep.clone()
    }

    /// Every model that may answer beside the answer, preferred first.
    #[must_use]
    pub fn others(&self, at: At) -> Vec<Other<M>> {
        let place = self.place(at);
        let all = self.candidates(&place.judged, at);
        let other = |(one, judged): (&Candidate<M>, &Judged)| {
            let off = |of: &Compared| {
                let (own, answer) = (one.value(*of, at).ok()?, self.known(*of, at).ok()?.value);
                Some((*of, own / answer - 1.0))
            };
            let relative = Compared::ALL.iter().filter(|of| of.quantity().is_some());
            let off = relative.filter_map(off).collect();
            Other { model: one.model.clone(), off, outside: judged.outside.clone() }
        };
        all.map(other).collect()
    }
}
