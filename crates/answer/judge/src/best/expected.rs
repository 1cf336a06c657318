//! What boundary elements are expected to give, also beyond the loads that were solved.

use super::contact::{BestContact, Known, ROUNDED, Source};
use super::model::Answering;
use crate::evidence::{Compared, Estimate, ExpectedContact};
use asperity_core::{Asperity, At};

impl<M: Answering> BestContact<M> {
    /// What boundary elements are expected to give. Under loads that were not solved, the ratio to
    /// the nearest model at the nearest solved one is kept.
    pub(super) fn expected_value(&self, of: Compared, pressure: f64) -> Option<Known> {
        // No contact carries more than the hardness or, by small strains, the modulus.
        if self.least_area(pressure) > 1.0 {
            return None;
        }
        let place = self.place(At::Pressure(pressure));
        let expected = place.expected.as_ref().ok()?;
        match expected.estimate(of) {
            Some(_) if expected.extrapolated => self.kept_ratio(of, pressure, expected),
            Some(Estimate { value, ends }) => {
                Some(Known { value, ends, source: Source::Evidence, error: ROUNDED })
            }
            None => {
                let hardness = self.scene.asperity().ok()?.hardness?;
                let heaviest = of.highest_pressure() * hardness * (1.0 - ROUNDED);
                let place = (heaviest < pressure).then(|| self.place(At::Pressure(heaviest)))?;
                let known = self.kept_ratio(of, pressure, place.expected.as_ref().ok()?)?;
                Some(Known { ends: None, ..known })
            }
        }
    }

    /// What is expected at a pressure by what is expected at another, as the nearest model changes.
    fn kept_ratio(&self, of: Compared, pressure: f64, at: &ExpectedContact) -> Option<Known> {
        let Estimate { value, ends } = at.estimate(of)?;
        let there = At::Pressure(at.pressure);
        // Gaps change as the stiffness tells, whose ratio to the model is kept.
        let by = if of == Compared::MeanGap { Compared::Stiffness } else { of };
        let nearest = self.nearest(by, at, pressure).map(|(model, _)| model);
        let model = nearest.or_else(|| Some(self.first(by, there).ok()?.0))?;
        let [light, own] = [there, At::Pressure(pressure)].map(|at| model.value(of, at).ok());
        let (light, own) = light.zip(own)?;
        let softer = || {
            let known = self.expected_value(Compared::Stiffness, at.pressure)?.value;
            Some(model.value(Compared::Stiffness, there).ok()? / known)
        };
        let kept = |x: f64| match of {
            Compared::MeanGap => x + (own - light) * softer().unwrap_or(1.0),
            _ => x * (own / light),
        };
        // A contact carries the load at the hardness, and unloads at least as stiff.
        let least = match of {
            Compared::Area => self.least_area(pressure),
            Compared::UnloadingStiffness => {
                let loading = self.expected_value(Compared::Stiffness, pressure);
                loading.map_or(0.0, |loading| loading.value)
            }
            _ => f64::NEG_INFINITY,
        };
        let most = if of == Compared::Area { 1.0 } else { f64::INFINITY };
        let kept = |x: f64| kept(x).max(least).min(most);
        let (value, ends) = (kept(value), ends.map(|ends| ends.map(kept)));
        // Only what has flowed overlaps.
        let overlaps = of == Compared::MeanGap && value < 0.0;
        let is_elastic = || self.scene.asperity().is_ok_and(|asperity| asperity.hardness.is_none());
        let known = Known { value, ends, source: Source::Evidence, error: ROUNDED };
        Some(known).filter(|_| !(overlaps && is_elastic()))
    }

    /// The least share of the nominal area that carries a pressure.
    fn least_area(&self, pressure: f64) -> f64 {
        let most = |asperity: Asperity| asperity.hardness.unwrap_or(asperity.equivalent_modulus);
        self.scene.asperity().map_or(0.0, |asperity| pressure / most(asperity))
    }
}
