//! Interferences of the asperities that carry the load.

use asperity_core::{Contact, ContactError, Law, Quantity, Separation, integral_failed};

/// Number of bins of interference.
const BINS: usize = 600;
/// Share of the contacts beyond the last bin.
const REST: f64 = 1e-7;

/// Distribution of the force over the interference of the asperities \[m\].
pub(crate) struct Interferences {
    /// Middle of each bin, and the share of the force that it carries.
    bins: Vec<(f64, f64)>,
}

impl Interferences {
    /// The distribution by counting, accurate to about one per cent: the asperities with an
    /// interference above w are the contacts at d + w. `None` without contact or with a force of at
    /// most 0.
    ///
    /// `place` is in multiples of σ_z from the mean of the asperity heights.
    pub(crate) fn of(
        contact: &dyn Contact,
        law: &Law,
        place: Separation,
    ) -> Result<Option<Self>, ContactError> {
        let s = place.value;
        let sigma = contact.scene().surface.asperity_height_std;
        let above = |s: f64| match contact.evaluate(Quantity::Contacts, Separation::sigmas(s)) {
            Ok(found) => Ok(found.value()),
            Err(ContactError::NoValue { .. }) => Ok(0.0),
            Err(error) => Err(error),
        };
        let at = place.into();
        let failed = integral_failed(Quantity::Force, &at);
        let all = above(s)?;
        let mut reach = 0.01;
        while above(s + reach)? > REST * all && reach < 1e6 {
            reach *= 1.3;
        }
        let onset = law.onset * law.interference_unit;
        let edges: Vec<f64> = (1..=BINS).map(|k| s + reach * k as f64 / BINS as f64).collect();
        let mut counts = vec![0.0; BINS];
        contact.fill(&[Quantity::Contacts], &edges, &mut [&mut counts])?;
        let (mut bins, mut total, mut outer) = (vec![], 0.0, all);
        for (k, inner) in counts.into_iter().enumerate() {
            let w = onset + reach * sigma * (k as f64 + 0.5) / BINS as f64;
            let force = (outer - inner) * law.value(w).map_err(&failed)?;
            bins.push((w, force));
            (total, outer) = (total + force, inner);
        }
        if !(total > 0.0 && total.is_finite()) {
            return Ok(None);
        }
        bins.iter_mut().for_each(|(_, force)| *force /= total);
        Ok(Some(Self { bins }))
    }

    /// The share of the force that is carried beyond this interference \[m\].
    pub(crate) fn beyond(&self, interference: f64) -> f64 {
        self.bins.iter().filter(|(w, _)| *w > interference).map(|(_, share)| share).sum()
    }

    /// The interference \[m\] beyond which one per cent of the force is carried.
    pub(crate) fn largest(&self) -> f64 {
        let mut rest = 0.0;
        let found = self.bins.iter().rev().find(|(_, share)| {
            rest += share;
            rest > 0.01
        });
        found.map_or(0.0, |(w, _)| *w)
    }
}
