//! Findings about what is known best: what the answer rests on.

use std::collections::{BTreeMap, BTreeSet};

use super::contact::BestContact;
use super::model::{Answering, Best, Known, Source};
use crate::evidence::{Compared, ExpectedContact};
use crate::recommended::usual_reference;
use asperity_core::{At, Code, Finding, Severity};

/// Elastic bodies that hardly yield, as of rubber, have a lower modulus \[Pa\].
const SOFTEST_METAL: f64 = 1e9;

impl<M: Answering> BestContact<M> {
    /// What a reader of the answers at these places should know.
    pub(super) fn findings(&self, at: &[At]) -> Vec<Finding> {
        let mut found: Vec<Finding> = vec![];
        let mut add = |new: Finding| {
            let known = |one: &Finding| one.code == new.code && one.field == new.field;
            if !found.iter().any(known) {
                found.push(new);
            }
        };
        let note = |code, field| Finding::note(code, field, f64::NAN).of_model(Best::<M>::ID);
        let warning = |code, field| note(code, field).severity(Severity::Warning);
        let behind = self.request.quantities.iter().filter_map(|q| Compared::behind(*q));
        let interface = &self.scene.interface;
        let is_metal = interface.equivalent_modulus > SOFTEST_METAL;
        if interface.softer_hardness().is_none() && is_metal && !self.never_yields {
            let fact = "no body has a hardness, and the contacts are taken as elastic";
            let advice =
                "set hardness, yield_strength or material of the bodies, unless they do not yield";
            add(warning(Code::NoHardness, "hardness").fact(fact).advice(advice));
        }
        for &at in at {
            let place = self.place(at);
            if let Some((code, why)) = self.uncertain(at) {
                let (code, is) = match place.has_interval() {
                    true => (Code::SolutionNotUsed, "not used"),
                    false => (*code, "uncertain"),
                };
                let fact = format!("the solution on this scan is {is}: {why}");
                add(warning(code, "solution").fact(fact));
            }
            let is_light = |one: &ExpectedContact| one.extrapolated && one.outside.is_none();
            if place.expected.as_ref().is_ok_and(is_light) {
                let usual = usual_reference(&self.scene);
                let fact = format!(
                    "the load is below the lightest solved one, whose ratios to {usual} are kept"
                );
                add(note(Code::Extrapolated, "load").fact(fact));
            }
            let mut open: BTreeMap<String, (&str, BTreeSet<Compared>)> = BTreeMap::new();
            for of in behind.clone() {
                let (field, reason) = self.why(of, at);
                match self.known(of, at) {
                    Ok(Known { source: Source::Model(id, outside), .. }) => {
                        let fact = format!("{} by {id}, without an interval: {reason}", of.label());
                        add(note(Code::NoEvidence, field).fact(fact));
                        let deep = self.deep(&id, at);
                        outside.into_iter().for_each(|outside| add(*outside));
                        deep.into_iter().for_each(&mut add);
                    }
                    Ok(Known { source: Source::Evidence, ends: None, .. }) => {
                        if field == Self::ADHESION {
                            add(warning(Code::Sticks, field).fact(reason));
                            continue;
                        }
                        let (_, all) = open.entry(reason).or_insert((field, BTreeSet::new()));
                        all.insert(of);
                    }
                    _ => {}
                }
            }
            for (reason, (field, all)) in open {
                let labels: Vec<_> = all.into_iter().map(Compared::label).collect();
                let fact = format!("{} without an interval: {reason}", labels.join(", "));
                add(note(Code::Extrapolated, field).fact(fact));
            }
        }
        found
    }
}
