//! A quantity of one asperity after a retreat, as a law that the engine integrates over heights.

use std::sync::Arc;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Formula, Law, QuadratureError,
    Quantity, Sampler, Tolerance,
};

use crate::asperity_laws::{AsperityLaws, UnloadingQuantity, refused};
use crate::contact_range::contact_range;
use crate::remaining::RemainingFraction;

/// A quantity of one asperity after a retreat, as the force law of a model.
#[derive(Debug)]
pub(crate) struct RetreatModel<'u> {
    pub(crate) source: &'u Citation,
    pub(crate) name: &'u str,
    /// The smallest interference \[m\] that contributes, the onset of the law.
    pub(crate) first: f64,
    law: Law,
}

impl<'u> RetreatModel<'u> {
    pub(crate) fn new(
        (source, name): (&'u Citation, &'u str),
        loading: &Arc<AsperityLaws>,
        quantity: UnloadingQuantity,
        u: f64,
    ) -> Result<Self, ContactError> {
        let (unit, value_unit) = (loading.force.interference_unit, loading.force.value_unit);
        let value_unit = match quantity {
            UnloadingQuantity::Area => loading.area.value_unit,
            UnloadingQuantity::Contacts => 1.0,
            UnloadingQuantity::Stiffness => value_unit / unit,
            UnloadingQuantity::Loss | UnloadingQuantity::Returned => value_unit * unit,
            UnloadingQuantity::Force | UnloadingQuantity::Released => value_unit,
        };
        let failed = |source: QuadratureError| refused(name, "retreat", u, &source);
        let whole = matches!(
            quantity,
            UnloadingQuantity::Released | UnloadingQuantity::Loss | UnloadingQuantity::Returned
        );
        let mut ranges = vec![];
        for pair in loading.breaks().windows(2) {
            let (low, high) = (pair[0], pair[1]);
            let found = contact_range(&|w| loading.recovered(w), [low, high], u).map_err(failed)?;
            match found {
                Some([from, to]) if !whole => ranges.push((from, to)),
                // Asperities out of contact have released their whole force.
                Some([from, to]) => ranges.extend([(low, from), (from, to), (to, high)]),
                None if whole => ranges.push((low, high)),
                None => {}
            }
        }
        ranges.retain(|(low, high)| high > low);
        // x starts at the first remaining contact, which may be far beyond the heights integrated
        // at the closest approach.
        let first = ranges.first().map_or(0.0, |(low, _)| *low);
        let mut law = Law::in_units(unit, value_unit).with_onset(first / unit);
        for (low, high) in ranges {
            // At a kink, δ of the first remaining contact may exceed u.
            let near = match u > 0.0 && low <= first && !whole {
                true => RemainingFraction::new([low, high], u, |w| loading.recovered(w))
                    .map_err(failed)?,
                false => None,
            };
            let loading = loading.clone();
            let sample = move |x: &[f64], out: &mut [f64]| {
                for (out, x) in out.iter_mut().zip(x) {
                    let left = near.as_ref().and_then(|near| near.at(x * unit));
                    *out = loading.answer(first + x * unit, u, left, quantity)? / value_unit;
                }
                Ok(())
            };
            let sampler: Arc<dyn Sampler> = Arc::new(sample);
            law =
                law.elastic((low - first) / unit..(high - first) / unit, Formula::sampled(sampler));
        }
        let law = match loading.sum {
            Some(sum) => sum(law, &loading.asperity)?,
            None => law,
        };
        Ok(Self { source, name, first, law })
    }
}

impl Described for RetreatModel<'_> {
    fn citation(&self) -> &Citation {
        self.source
    }

    fn name(&self) -> &str {
        self.name
    }
}

impl AsperityModel for RetreatModel<'_> {
    fn force(&self, _: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        Ok(self.law.clone())
    }

    fn area(&self, _: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        // Only forces are asked of this model.
        Err(ContactError::NoLaw { model: self.name.into(), quantity: Quantity::Area })
    }
}
