//! What boundary elements are expected to give, also beyond the loads that were solved, and the
//! load at a separation, where they determine the mean gap.

use super::candidates::{Candidate, SharedPlace};
use super::contact::{BestContact, ROUNDED};
use super::model::{Answering, Known, Source};
use crate::evidence::{Compared, Estimate, ExpectedContact};
use asperity_core::{At, ContactError, Datum, Separation, SeparationUnit, short};
use asperity_quadrature::bracketed_root;

/// Mean gaps over Sq are not stated below: of plastic bodies -0.42 was solved, at 0.68 H.
const DEEPEST: f64 = -0.5;

/// Ratio of neighbouring pressures between which a gap is looked for.
const STEP: f64 = 2.0;
/// Pressures over the equivalent modulus that are searched.
const LIGHTEST: f64 = 1e-15;
const HEAVIEST: f64 = 1.0;

impl<M: Answering> BestContact<M> {
    /// What boundary elements are expected to give; none on surfaces of another kind. Under loads
    /// that were not solved, the ratio to a model at the nearest solved one is kept.
    ///
    /// # Errors
    /// [`ContactError::Refused`] where no contact has so much.
    pub(super) fn expected_value(
        &self,
        of: Compared,
        pressure: f64,
    ) -> Result<Option<Known>, ContactError> {
        let (largest, what) = self.largest_pressure()?;
        if pressure >= largest * (1.0 - ROUNDED) {
            let ratio = short(pressure / largest);
            let why =
                format!("the mean pressure is {ratio} times the {what}, which no contact carries");
            return Err(self.refused(why));
        }
        let Some(anchor) = self.anchor(of, pressure) else { return Ok(None) };
        let Ok(expected) = &anchor.expected else { return Ok(None) };
        let Some(Estimate { value, ends, presumed }) = expected.estimate(of) else {
            return Ok(None);
        };
        if anchor.has(pressure) {
            let source = Source::Evidence;
            return Ok(Some(Known { value, ends, presumed, source, error: ROUNDED }));
        }
        let kept = self.kept_ratio(of, pressure, expected);
        match kept {
            // What has not flowed does not overlap.
            Some(kept)
                if of == Compared::MeanGap
                    && kept.value < 0.0
                    && (value >= 0.0 || kept.value < DEEPEST * expected.rms_height) =>
            {
                Err(self.refused("the mean gap is below 0, which cannot be".into()))
            }
            // Beyond the pressures up to which a quantity is stated there are no intervals.
            Some(kept) if anchor.pressure != Some(pressure) => {
                Ok(Some(Known { ends: None, ..kept }))
            }
            Some(kept) => Ok(Some(kept)),
            None => {
                Err(self.refused("no model tells how it changes beyond the solved loads".into()))
            }
        }
    }

    /// The place by which a quantity is expected at a pressure: its own or, above the pressure up
    /// to which the quantity is stated, the heaviest at which it is.
    pub(super) fn anchor(&self, of: Compared, pressure: f64) -> Option<SharedPlace> {
        let place = self.place(At::Pressure(pressure));
        if place.expected.as_ref().ok()?.estimate(of).is_some() {
            return Some(place);
        }
        let heaviest = of.highest_pressure() * self.largest_pressure().ok()?.0 * (1.0 - ROUNDED);
        (heaviest < pressure).then(|| self.place(At::Pressure(heaviest)))
    }

    /// What is expected at a pressure by what is expected at another, as a model changes.
    fn kept_ratio(&self, of: Compared, pressure: f64, at: &ExpectedContact) -> Option<Known> {
        let Estimate { value, ends, presumed } = at.estimate(of)?;
        let there = At::Pressure(at.pressure);
        let model = self.keeping(of, at, pressure)?;
        let [known, own] = [there, At::Pressure(pressure)].map(|at| model.value(of, at).ok());
        let (known, own) = known.zip(own)?;
        let softer = || {
            let known = at.estimate(Compared::Stiffness)?.value;
            Some(model.value(Compared::Stiffness, there).ok()? / known)
        };
        let kept = |x: f64| match of {
            Compared::MeanGap => x + (own - known) * softer().unwrap_or(1.0),
            _ => x * (own / known),
        };
        // A contact carries the load at the hardness, has no more area than there is, and unloads
        // at least as stiff.
        let [value, low, high] = match (of, ends.or(presumed).unwrap_or([value; 2])) {
            (Compared::Area, [low, high]) => {
                let least = pressure / self.largest_pressure().ok()?.0;
                [value, low, high].map(|x| kept(x).max(least).min(1.0))
            }
            (Compared::UnloadingStiffness, [low, high]) => {
                let loading = self.expected_value(Compared::Stiffness, pressure).ok().flatten();
                let least = loading.and_then(|known| {
                    let [low, high] = known.ends.or(known.presumed)?;
                    Some([known.value, low, high])
                });
                let least = least.unwrap_or_default();
                [(value, least[0]), (low, least[1]), (high, least[2])]
                    .map(|(x, least)| kept(x).max(least))
            }
            (_, [low, high]) => [value, low, high].map(kept),
        };
        let [ends, presumed] = [ends, presumed].map(|known| known.map(|_| [low, high]));
        Some(Known { value, ends, presumed, source: Source::Evidence, error: ROUNDED })
    }

    /// The model whose ratio at a solved pressure is kept at another.
    pub(super) fn keeping(
        &self,
        of: Compared,
        at: &ExpectedContact,
        pressure: f64,
    ) -> Option<&Candidate<M>> {
        // The stiffness gives the change of the gap.
        let of = if of == Compared::MeanGap { Compared::Stiffness } else { of };
        // Under light loads models of asperities change alike: one does not give way to another.
        let usual = || self.usual().filter(|one| one.value(of, At::Pressure(pressure)).is_ok());
        let usual = if pressure < at.pressure { usual() } else { None };
        let nearest = || Some(self.nearest(of, at, Some(pressure))?.0);
        let first = || Some(self.first(of, At::Pressure(at.pressure)).ok()?.0);
        usual.or_else(nearest).or_else(first)
    }

    /// The largest mean pressure \[Pa\], the hardness or, by small strains, the modulus.
    fn largest_pressure(&self) -> Result<(f64, &'static str), ContactError> {
        let asperity = self.scene.asperity()?;
        let modulus = (asperity.equivalent_modulus, "equivalent modulus");
        Ok(asperity.hardness.map_or(modulus, |hardness| (hardness, "hardness")))
    }

    /// The mean gap that is expected at a mean pressure.
    fn gap_at(&self, pressure: f64) -> Option<f64> {
        let of = Compared::MeanGap;
        let expected = self.expected_of(&[of], pressure, None).ok()?;
        let estimate = expected.estimate(of).filter(|_| !expected.extrapolated);
        let known = || Some(self.expected_value(of, pressure).ok()??.value);
        estimate.map(|one| one.value).or_else(known)
    }

    fn gaps(&self) -> &[[f64; 2]] {
        self.gaps.get_or_init(|| {
            let modulus = self.scene.asperity().map_or(f64::NAN, |one| one.equivalent_modulus);
            let next = |p: &f64| Some(p * STEP).filter(|p| *p < HEAVIEST * modulus);
            let all = std::iter::successors(Some(LIGHTEST * modulus), next);
            let mut found: Vec<[f64; 2]> = vec![];
            for pressure in all {
                match (self.gap_at(pressure), found.last()) {
                    // Falling gaps alone can be inverted.
                    (Some(gap), Some([_, last])) if gap >= *last => {}
                    (Some(gap), _) => found.push([pressure.ln(), gap]),
                    (None, None) => {}
                    (None, Some(_)) => break,
                }
            }
            found
        })
    }

    /// The mean pressure at a separation; `None` at one that no pressure is expected to have.
    pub(super) fn pressure_at(&self, separation: Separation) -> Option<f64> {
        let unit = SeparationUnit::Metres;
        let gap = separation.measured_in(unit, Datum::SurfaceMean, &self.scene).ok()?.value;
        let gaps = self.gaps();
        let above = gaps.partition_point(|[_, known]| *known > gap);
        let ([low, _], [high, _]) = (gaps.get(above.checked_sub(1)?)?, gaps.get(above)?);
        let off = |ln: f64| self.gap_at(ln.exp()).map_or(f64::NAN, |known| known - gap);
        bracketed_root(off, *low, *high).map(f64::exp)
    }
}
