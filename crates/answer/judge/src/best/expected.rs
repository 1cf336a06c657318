//! What boundary elements are expected to give, also beyond the loads that were solved.

use super::contact::{BestContact, Known, ROUNDED, Source};
use super::model::Answering;
use crate::evidence::{Compared, Estimate, ExpectedContact};
use asperity_core::At;

impl<M: Answering> BestContact<M> {
    /// What boundary elements are expected to give. Under loads lighter than all solved ones, and
    /// without an interval above the heaviest at which a quantity is stated, its ratio to the
    /// nearest model is kept.
    pub(super) fn expected_value(&self, of: Compared, pressure: f64) -> Option<Known> {
        let place = self.place(At::Pressure(pressure));
        let expected = place.expected.as_ref().ok()?;
        if expected.extrapolated {
            return self.kept_ratio(of, pressure, expected);
        }
        if let Some(Estimate { value, low, high }) = expected.estimate(of) {
            let source = Source::Evidence;
            return Some(Known { value, ends: Some([low, high]), source, error: ROUNDED });
        }
        let hardness = self.scene.asperity().ok()?.hardness?;
        let heaviest = of.highest_pressure() * hardness * (1.0 - ROUNDED);
        let place = (heaviest < pressure).then(|| self.place(At::Pressure(heaviest)))?;
        let known = self.kept_ratio(of, pressure, place.expected.as_ref().ok()?)?;
        Some(Known { ends: None, ..known })
    }

    /// What is expected at a pressure by what is expected at another, as the nearest model changes.
    fn kept_ratio(&self, of: Compared, pressure: f64, at: &ExpectedContact) -> Option<Known> {
        let Estimate { value, low, high } = at.estimate(of)?;
        let there = At::Pressure(at.pressure);
        let (model, light) = self.nearest(of, at).or_else(|| {
            let (model, value, _) = self.first(of, there).ok()?;
            Some((model, value))
        })?;
        let own = model.value(of, At::Pressure(pressure)).ok()?;
        // Gaps change as the stiffness tells, whose ratio to the model is kept.
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
        let [value, low, high] = [value, low, high].map(|x| kept(x).max(least));
        let source = Source::Evidence;
        Some(Known { value, ends: Some([low, high]), source, error: ROUNDED })
    }

    /// The least share of the nominal area that carries a pressure.
    fn least_area(&self, pressure: f64) -> f64 {
        let hardness = self.scene.asperity().ok().and_then(|asperity| asperity.hardness);
        hardness.map_or(0.0, |hardness| pressure / hardness)
    }
}
