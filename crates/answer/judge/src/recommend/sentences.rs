//! A recommendation as text.

use std::fmt;

use crate::{
    Compared, Comparison, EvidenceAt, ExpectedContact, Ratio, Recommendation, Weighed,
    ranking::{self, words},
};
use asperity_core::ContactError;

impl<M: Weighed> Recommendation<M> {
    /// Which model to use, in one sentence: the nearest to boundary elements or, without evidence,
    /// the simplest within the limit.
    #[must_use]
    pub fn verdict(&self) -> String {
        self.nearest_sentence().unwrap_or_else(|| self.simplest_sentence())
    }

    /// The model nearest to boundary elements in the requested quantities and, if it does not hold
    /// here, the nearest that does, or the simplest that is as near; `None` without evidence.
    fn nearest_sentence(&self) -> Option<String> {
        let text = |id: &str| {
            let known = self.comparisons.iter().find(|found| found.model.id() == id)?;
            let in_words = |(of, name): (Compared, &str)| {
                Some(format!("{name} {}", words(&[known.off(of)?[0]])))
            };
            let asked = Compared::RANKED.into_iter().filter(|(of, _)| self.compared.contains(of));
            let all: Vec<String> = asked.filter_map(in_words).collect();
            Some(format!("{id} ({})", all.join(", ")))
        };
        let (first, outside) = self.nearest.first()?;
        let (simplest, invalid) = self.nearest.last()?;
        let holds = self.nearest.iter().find(|(_, why)| why.is_none());
        let is_nearest = holds.is_none_or(|(id, _)| id == simplest);
        let alike = match is_nearest {
            true => format!("{} is", text(simplest)?),
            false => format!(
                "{} is as near within the interval, and the simplest of these",
                text(simplest)?
            ),
        };
        let rest = match (outside, invalid) {
            (None, _) if is_nearest => String::new(),
            (None, _) => format!("; {alike}"),
            (Some(why), Some(_)) => format!(", but does not hold here ({})", why.code),
            (Some(why), None) => {
                format!(", but does not hold here ({}); of the models that do, {alike}", why.code)
            }
        };
        let merging = match (&self.merging, self.evidence.len()) {
            (Some(_), 1) => "; contacts merge here, and no model of asperities is valid",
            (Some(_), _) => "; contacts merge at some loads, where no model of asperities is valid",
            (None, _) => "",
        };
        let text = text(first)?;
        Some(format!("{text} is nearest to boundary elements{rest}{merging}"))
    }

    /// Which model is the simplest within the limit of the reference, in one sentence.
    #[must_use]
    pub fn simplest_sentence(&self) -> String {
        let compared = |model: &&M| self.comparisons.iter().any(|c| c.model.id() == model.id());
        let of = format!("within {} % of {}", percent(self.within), self.reference.id());
        match (self.simplest.as_ref().filter(compared), &self.merging) {
            (None, _) => format!("no valid model is {of}"),
            (Some(simplest), None) if simplest.id() == self.reference.id() => {
                format!("no simpler valid model is {of}; use {}", simplest.id())
            }
            (Some(simplest), None) => {
                format!("{} is the simplest valid model {of}", simplest.id())
            }
            (Some(simplest), Some(_)) => format!(
                "{} is the simplest model {of}, but no model of asperities is valid where contacts merge",
                simplest.id()
            ),
        }
    }

    /// The evidence in lines: the separations or loads without any; which of these models are
    /// expected to be nearest to boundary elements, a line each for area, stiffness in first
    /// loading and unloading stiffness, if requested; and requested quantities that the solved
    /// surfaces do not determine.
    #[must_use]
    pub fn summary(&self) -> Vec<String> {
        let mut groups: Vec<Vec<&EvidenceAt>> = vec![];
        for place in self.evidence.iter().filter(|place| place.expected.is_err()) {
            let same = |group: &&mut Vec<&EvidenceAt>| alike(group[0], place);
            match groups.iter_mut().find(same) {
                Some(group) => group.push(place),
                None => groups.push(vec![place]),
            }
        }
        let mut lines: Vec<String> = groups.iter().map(|group| self.without(group)).collect();
        let asked = Compared::RANKED.into_iter().filter(|(of, _)| self.compared.contains(of));
        lines.extend(asked.filter_map(|named| self.nearest(named)));
        lines.extend(self.compared.iter().filter_map(|quantity| self.undetermined(*quantity)));
        lines
    }

    /// Places that have an expected value of a quantity, or have none of it beside others.
    fn places(&self, quantity: Compared, has: bool) -> Vec<(&EvidenceAt, &ExpectedContact)> {
        let known = self.evidence.iter().filter_map(|at| Some((at, at.expected.as_ref().ok()?)));
        known.filter(|(_, expected)| expected.estimate(quantity).is_some() == has).collect()
    }

    /// The models nearest to boundary elements in a quantity of this name, where it has an expected
    /// value.
    fn nearest(&self, named: (Compared, &str)) -> Option<String> {
        let places = self.places(named.0, true);
        let (first, expected) = places.first()?;
        let off = |id: &str, quantity| {
            let of = |(at, _): &(&EvidenceAt, &ExpectedContact)| {
                Some(at.ratio(id, quantity)?.deviation(quantity))
            };
            places.iter().map(of).collect()
        };
        let ids = self.comparisons.iter().map(|c| c.model.id());
        let nearest = ranking::nearest_in_each(ids, off, &[named]).join("; ");
        let here = match (places.len(), self.evidence.len()) {
            (1, 1) => String::new(),
            (1, _) => format!("at {}, ", first.at.rounded()),
            (some, _) => format!("over these {some} places, "),
        };
        Some(format!("{here}{nearest} ({})", expected.basis()))
    }

    /// Where a quantity has no expected value beside others that have, and why.
    fn undetermined(&self, quantity: Compared) -> Option<String> {
        let places = self.places(quantity, false);
        let ((first, expected), (last, _)) = (places.first()?, places.last()?);
        let here = match (places.len(), self.evidence.len()) {
            (1, 1) => "here".into(),
            (1, _) => format!("at {}", first.at.rounded()),
            (some, _) => {
                format!("at {some} places from {} to {}", first.at.rounded(), last.at.rounded())
            }
        };
        let (label, why) = (quantity.label(), expected.undetermined(quantity));
        Some(format!("boundary elements have no expected value of {label} {here}: {why}"))
    }

    /// How far the reference and the recommended model are expected to be from boundary elements, a
    /// line for each of the two: `KE here underestimates the area by 5 to 12 %, agrees in the
    /// stiffness of first loading within 0.5 % (alpha 8, psi 2; boundary elements on 16 surfaces)`.
    /// Of several places the widest interval.
    #[must_use]
    pub fn expectations(&self) -> Vec<String> {
        let mut both = vec![&self.reference];
        both.extend(self.simplest.iter().filter(|model| model.id() != self.reference.id()));
        both.into_iter().filter_map(|model| self.expectation(model)).collect()
    }

    /// The line of a model; quantities with evidence at other numbers of places have their own
    /// part.
    fn expectation(&self, model: &M) -> Option<String> {
        let mut parts: Vec<(usize, Vec<String>)> = vec![];
        for &quantity in &self.compared {
            let ratios = self.evidence.iter().filter_map(|e| e.ratio(model.id(), quantity));
            let ratios: Vec<Ratio> = ratios.collect();
            let widest = ratios.iter().copied().reduce(|a, b| a.with(b, quantity));
            let Some(words) = widest.map(|ratio| ratio.words(quantity)) else { continue };
            match parts.last_mut().filter(|(places, _)| *places == ratios.len()) {
                Some((_, words_there)) => words_there.push(words),
                None => parts.push((ratios.len(), vec![words])),
            }
        }
        let part = |(places, words): &(usize, Vec<String>)| {
            let here = match (*places, self.evidence.len()) {
                (1, 1) => "here".into(),
                (some, all) if some == all => format!("at these {all} places"),
                (some, all) => format!("at {some} of {all} places"),
            };
            format!("{here} {}", words.join(", "))
        };
        let expected: Vec<&ExpectedContact> =
            self.evidence.iter().filter_map(|place| place.expected.as_ref().ok()).collect();
        let lighter = match expected.iter().any(|expected| expected.extrapolated) {
            true => ", extrapolated to lighter loads",
            false => "",
        };
        let basis = expected.first().filter(|_| !parts.is_empty())?.basis();
        let parts: Vec<String> = parts.iter().map(part).collect();
        Some(format!("{} {} ({basis}{lighter})", model.id(), parts.join("; ")))
    }

    /// The line for places without evidence, for the same reason.
    fn without(&self, group: &[&EvidenceAt]) -> String {
        let [first, last] = [0, group.len() - 1].map(|k| group[k].at.rounded());
        let (error, reason) = match &group[0].expected {
            Err(ContactError::NoEvidence { reason, .. }) => {
                ("no boundary-element solution is close", reason)
            }
            Err(error) => return error.to_string(),
            Ok(_) => return String::new(),
        };
        let places = match (group.len(), self.evidence.len()) {
            (some, all) if some == all => String::new(),
            (1, _) => format!(" at {first}"),
            (some, _) => format!(" at {some} places from {first} to {last}"),
        };
        format!("{error}{places}: {reason}")
    }
}

/// A share in per cent, to three decimals.
fn percent(share: f64) -> f64 {
    (1e5 * share).round() / 1e3
}

/// Whether two places have no evidence for the same reason, up to the numbers of each.
fn alike(one: &EvidenceAt, other: &EvidenceAt) -> bool {
    let property = |place: &EvidenceAt| match place.expected {
        Err(ContactError::NoEvidence { property, .. }) => Some(property),
        _ => None,
    };
    property(one) == property(other) && (property(one).is_some() || one.expected == other.expected)
}

impl<M: Weighed> fmt::Display for Recommendation<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.verdict())?;
        if !self.nearest.is_empty() {
            writeln!(f, "{}", self.simplest_sentence())?;
        }
        let lines = [self.summary(), self.expectations()].concat();
        lines.iter().try_for_each(|line| writeln!(f, "{line}"))?;
        let width = self.comparisons.iter().map(|c| c.model.id().len()).max().unwrap_or(0).max(12);
        for found in &self.comparisons {
            let Comparison { model, deviations, outside, .. } = found;
            write!(f, "  {:width$}", model.id())?;
            match deviations {
                Ok(all) => {
                    for (quantity, deviation) in all {
                        write!(f, " {quantity} {} %", percent(*deviation))?;
                    }
                    for (quantity, name) in Compared::RANKED {
                        let asked = self.compared.contains(&quantity);
                        let off = asked.then(|| found.off(quantity)).flatten();
                        let Some([off, spread]) = off.map(|off| off.map(|x| 100.0 * x)) else {
                            continue;
                        };
                        write!(
                            f,
                            ", {name} {off:+.0} % relative to boundary elements (half interval {spread:.0} %)"
                        )?;
                    }
                    if let Some(outside) = outside {
                        write!(f, "; not valid: {} {}", outside.field, outside.value)?;
                    }
                    writeln!(f)?;
                }
                Err(error) => writeln!(f, " {error}")?,
            }
        }
        Ok(())
    }
}
