//! Findings together: merged, ordered and silenced by their codes.

use std::ops::Deref;
use std::slice;
use std::vec;

use serde::Serialize;

use super::{Code, Finding, Severity};

/// Findings, one for each cause.
///
/// ```
/// use asperity_core::{At, Code, Finding, Findings, Severity};
///
/// let few = |load, contacts| {
///     let few = Finding::warning(Code::FewContacts, "contacts", contacts);
///     few.usual([30.0, f64::INFINITY]).at(At::Load(load))
/// };
/// let mut all: Findings = [few(2.0, 20.0), few(1.0, 10.0)].into_iter().collect();
/// all.push(Finding::refusal(Code::NoValue, "", f64::NAN).fact("no model has a value"));
/// let texts: Vec<_> = all.iter().map(ToString::to_string).collect();
/// assert_eq!(texts[0], "no model has a value");
/// assert_eq!(texts[1], "contacts is 10 in 2 rows, worst at a load of 1 N (usual: at least 30)");
/// // Refusals are not silenced.
/// assert_eq!(all.clone().silenced(&[Code::FewContacts, Code::NoValue]).len(), 1);
/// assert_eq!(all.at_least(Severity::Refusal).len(), 1);
/// ```
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Findings(Vec<Finding>);

impl Findings {
    /// Adds a finding; the most severe come first. Findings with the same code, field, model,
    /// quantity, law and origin merge: rows are counted and the worst is kept.
    pub fn push(&mut self, new: Finding) {
        match self.0.iter_mut().find(|known| known.has_cause_of(&new)) {
            Some(known) => {
                let count = known.count + new.count;
                if new.excess() > known.excess() {
                    *known = new;
                }
                known.count = count;
            }
            None => self.0.push(new),
        }
        self.0.sort_by_key(|found| (found.severity, !found.implausible));
    }

    /// Without warnings and notes of these codes; refusals stay. Scene files name them in `accept`.
    #[must_use]
    pub fn silenced(mut self, codes: &[Code]) -> Self {
        self.0.retain(|found| !found.is_accepted(codes));
        self
    }

    /// Findings of at least this severity: `at_least(Severity::Warning)` leaves out notes.
    #[must_use]
    pub fn at_least(mut self, least: Severity) -> Self {
        self.0.retain(|found| found.severity <= least);
        self
    }

    /// Whether an input is [implausible](Finding::implausible), which findings about answers may
    /// follow from.
    #[must_use]
    pub fn are_implausible(&self) -> bool {
        self.0.iter().any(Finding::is_implausible)
    }

    /// Without findings about asperities unless `asperities` is set.
    #[must_use]
    pub fn for_asperities(mut self, asperities: bool) -> Self {
        self.0.retain(|found| asperities || !found.is_of_asperities());
        self
    }

    /// One finding for each cause: the worst of several models with the names of the others, and
    /// none that follows from another finding.
    #[must_use]
    pub fn by_cause(self) -> Self {
        let mut kept: Vec<Finding> = vec![];
        for new in self.0 {
            let same = |known: &&mut Finding| {
                let places = (&known.field, &known.origin) == (&new.field, &new.origin);
                let of_models = known.model.is_some() && new.model.is_some();
                known.code == new.code && places && of_models && known.quantity == new.quantity
            };
            match kept.iter_mut().find(same) {
                Some(known) => known.add_model(new),
                None => kept.push(new),
            }
        }
        let follows = |found: &Finding| {
            // A note hides no warning.
            let hides = |o: &Finding| o.code.hides(found.code) && o.severity <= found.severity;
            // β of a scan and of the asperities derived from it.
            let scan = |o: &Finding| {
                o.code == Code::RoughnessParameter && found.field == "roughness_parameter"
            };
            kept.iter().any(|o| hides(o) || scan(o) && found.code != o.code)
        };
        Self(kept.iter().filter(|found| !follows(found)).cloned().collect())
    }
}

impl Finding {
    /// Whether one of these codes accepts the finding; refusals are not accepted.
    #[must_use]
    pub fn is_accepted(&self, codes: &[Code]) -> bool {
        self.severity != Severity::Refusal && codes.iter().any(|code| code.accepts(self.code))
    }

    fn has_cause_of(&self, other: &Self) -> bool {
        let cause = |d: &Self| (d.code, d.quantity);
        cause(self) == cause(other)
            && (&self.field, &self.model) == (&other.field, &other.model)
            && (&self.law, &self.origin) == (&other.law, &other.origin)
    }

    /// Adds another model with the same finding; the worse one comes first.
    fn add_model(&mut self, mut other: Self) {
        if other.excess() > self.excess() {
            std::mem::swap(self, &mut other);
        }
        for name in other.model.into_iter().chain(other.also) {
            if self.model.as_ref() != Some(&name) && !self.also.contains(&name) {
                self.also.push(name);
            }
        }
    }
}

impl Deref for Findings {
    type Target = [Finding];

    fn deref(&self) -> &[Finding] {
        &self.0
    }
}

impl Extend<Finding> for Findings {
    fn extend<T: IntoIterator<Item = Finding>>(&mut self, found: T) {
        found.into_iter().for_each(|new| self.push(new));
    }
}

impl FromIterator<Finding> for Findings {
    fn from_iter<T: IntoIterator<Item = Finding>>(found: T) -> Self {
        let mut all = Self::default();
        all.extend(found);
        all
    }
}

impl IntoIterator for Findings {
    type Item = Finding;
    type IntoIter = vec::IntoIter<Finding>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<'d> IntoIterator for &'d Findings {
    type Item = &'d Finding;
    type IntoIter = slice::Iter<'d, Finding>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}
