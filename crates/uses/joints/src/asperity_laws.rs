//! The laws of one asperity: loading to w, and force, area and work after a retreat u.

use std::f64::consts::PI;

use asperity_core::{
    Asperity, ContactError, ContactModel, Law, QuadratureError, SumOfContacts, Tolerance, positive,
    require,
};

use crate::contact_range::recovery_extrema;
use crate::tabulated_law::tabulated;
use crate::unloading_law::UnloadingLaw;

/// A quantity of one asperity after a retreat u.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum UnloadingQuantity {
    /// The remaining force \[N\].
    Force,
    /// The remaining area \[m²\].
    Area,
    /// -dF/du \[N/m\].
    Stiffness,
    /// The force at u = 0 minus the remaining force \[N\], without cancellation.
    Released,
    /// 8 ∫₀ᵘ released du - 4 u released \[J\], without cancellation.
    Loss,
    /// 1 for asperities in contact, 0 for others.
    Contacts,
    /// The work returned, ∫₀ᵘ force du \[J\]; u may be infinite.
    Returned,
}

impl UnloadingQuantity {
    /// Whether it is an energy: it is 0 at retreat 0, and asperities that have lost contact count.
    pub(crate) fn sums_up(self) -> bool {
        matches!(self, Self::Released | Self::Loss | Self::Returned)
    }
}

/// The loading laws of one asperity with its unloading law.
#[derive(Debug)]
pub(crate) struct AsperityLaws {
    pub(crate) force: Law,
    pub(crate) area: Law,
    pub(crate) asperity: Asperity,
    pub(crate) unloading: UnloadingLaw,
    /// w_c \[m\]; infinite where nothing yields.
    pub(crate) critical: f64,
    /// From a law of these contacts to the law of an asperity that has several.
    pub(crate) sum: Option<SumOfContacts>,
    /// Interferences of the extrema of δ \[m\].
    turns: Vec<f64>,
}

/// Relative difference below which two laws are equal within rounding.
const SAME_LAW: f64 = 1e-12;

/// State of an asperity at its largest interference w.
struct PeakState {
    force: f64,
    area: f64,
    /// δ: the retreat at which the contact is lost \[m\].
    recovered: f64,
    exponent: f64,
}

impl AsperityLaws {
    /// The laws of a model of upright asperities without adhesion.
    pub(crate) fn new(
        model: &(impl ContactModel + ?Sized),
        asperity: Asperity,
        unloading: UnloadingLaw,
        tolerance: Tolerance,
    ) -> Result<Self, ContactError> {
        let unsupported = |what: &str| ContactError::Unsupported {
            model: model.id().into(),
            what: format!("unloading and partial slip: {what}"),
        };
        if model.validity().angles {
            return Err(unsupported("its contacts are inclined"));
        }
        if model.validity().adhesive {
            return Err(unsupported(
                "with adhesion, the curve of the model jkr-separation is the unloading curve of jkr, and the quantity unloading-stiffness is for small vibrations",
            ));
        }
        let one = model.asperity_model().ok_or_else(|| {
            unsupported("these need a model of asperities of one radius, such as ke")
        })?;
        let sum = model.sum_of_contacts();
        let force = tabulated(one.force(&asperity, tolerance)?);
        let area = tabulated(one.area(&asperity, tolerance)?);
        let yields = asperity.hardness.is_some() && !force.kinks().is_empty();
        let critical = if yields { asperity.critical_interference()? } else { f64::INFINITY };
        let turns = vec![];
        let mut loading = Self { force, area, asperity, unloading, critical, sum, turns };
        if yields {
            let mut found = vec![];
            for pair in loading.breaks().windows(2) {
                let of = |source| refused(model.id(), "interference", pair[0], &source);
                found.extend(
                    recovery_extrema(&|w| loading.recovered(w), [pair[0], pair[1]]).map_err(of)?,
                );
            }
            loading.turns = found;
        }
        Ok(loading)
    }

    /// δ \[m\].
    pub(crate) fn recovered(&self, w: f64) -> Result<f64, QuadratureError> {
        Ok(self.pressed(w)?.recovered)
    }

    /// The state at interference w \[m\].
    fn pressed(&self, w: f64) -> Result<PeakState, QuadratureError> {
        let Asperity { equivalent_modulus: e, radius, .. } = self.asperity;
        let (force, area) = (self.force.value(w)?, self.area.value(w)?);
        let x = w / self.critical;
        Ok(match self.unloading {
            UnloadingLaw::Etsion if x > 1.0 => {
                let residual = (1.0 - x.powf(-0.28)) * (1.0 - x.powf(-0.69));
                let exponent = 1.5 * x.powf(-0.0331);
                PeakState { force, area, recovered: w * (1.0 - residual), exponent }
            }
            UnloadingLaw::Brake => {
                let recovered = force / (4.0 / 3.0 * e * (radius * w).sqrt());
                let elastic = force / (4.0 / 3.0 * e * recovered);
                PeakState { force, area: PI * elastic * elastic, recovered, exponent: 1.5 }
            }
            UnloadingLaw::Hertz | UnloadingLaw::Etsion => {
                let recovered = 0.75 * force / (e * (area / PI).sqrt());
                PeakState { force, area, recovered, exponent: 1.5 }
            }
        })
    }

    /// A quantity at w after a retreat u; `left` replaces 1 - u/δ where it is more accurate.
    pub(crate) fn answer(
        &self,
        w: f64,
        u: f64,
        left: Option<f64>,
        quantity: UnloadingQuantity,
    ) -> Result<f64, QuadratureError> {
        let PeakState { force, area, recovered, exponent: n } = self.pressed(w)?;
        if force == 0.0 {
            return Ok(0.0);
        }
        let y = u / recovered;
        let left = left.unwrap_or(1.0 - y).max(0.0);
        Ok(match quantity {
            UnloadingQuantity::Force => force * left.powf(n),
            UnloadingQuantity::Area => area * left,
            UnloadingQuantity::Contacts => f64::from(y < 1.0),
            UnloadingQuantity::Stiffness => n * force * left.powf(n - 1.0) / recovered,
            UnloadingQuantity::Released if y < 1.0 => -force * (n * (-y).ln_1p()).exp_m1(),
            UnloadingQuantity::Released => force,
            UnloadingQuantity::Loss => force * recovered * loss(y, n),
            UnloadingQuantity::Returned => {
                let all = force * recovered / (n + 1.0);
                if y < 1.0 { -all * ((n + 1.0) * (-y).ln_1p()).exp_m1() } else { all }
            }
        })
    }

    /// Interferences at which a formula changes \[m\], from 0 to infinity.
    pub(crate) fn breaks(&self) -> Vec<f64> {
        let mut breaks = vec![0.0];
        for law in [&self.force, &self.area] {
            breaks.extend(law.kinks().into_iter().map(|x| x * law.interference_unit));
        }
        breaks.extend(&self.turns);
        let fitted = self.unloading == UnloadingLaw::Etsion && self.critical.is_finite();
        breaks.extend(fitted.then_some(self.critical));
        breaks.sort_by(f64::total_cmp);
        // Two units may round one kink to two neighbours.
        breaks.dedup_by(|a, b| (*a - *b).abs() <= 1e-14 * a.abs());
        breaks.push(f64::INFINITY);
        breaks
    }

    /// The interference \[m\] below which unloading retraces loading: the end of the first range of
    /// the law if that range is Hertzian, otherwise 0.
    pub(crate) fn elastic_limit(&self) -> f64 {
        let end = self.breaks()[1];
        if !self.critical.is_finite() || end == f64::INFINITY {
            return self.critical;
        }
        let is_hertz = |w: f64| {
            let power = self.force.value(w)? / self.force.value(0.5 * w)? / 2f64.powf(1.5);
            Ok::<_, QuadratureError>([self.recovered(w)? / w, power])
        };
        let same = |ratio: f64| (ratio - 1.0).abs() < SAME_LAW;
        let hertz = [0.9, 0.5, 0.1]
            .iter()
            .all(|share| is_hertz(share * end).is_ok_and(|ratios| ratios.into_iter().all(same)));
        if hertz { end } else { 0.0 }
    }
}

/// 8 ∫₀ʸ (1 - (1-t)ⁿ) dt - 4 y (1 - (1-y)ⁿ), with t and y limited to 1 in the powers.
fn loss(y: f64, n: f64) -> f64 {
    if y >= 1.0 {
        return 4.0 * y - 8.0 / (n + 1.0);
    }
    if y > 0.1 {
        let left = 1.0 - y;
        let integral = y - (1.0 - left.powf(n + 1.0)) / (n + 1.0);
        return 8.0 * integral - 4.0 * y * (1.0 - left.powf(n));
    }
    // Binomial series from y³, as lower orders cancel.
    let (mut binomial, mut sum) = (-n * y, 0.0);
    for k in 2..20 {
        let k = f64::from(k);
        binomial *= -(n - k + 1.0) / k * y;
        sum -= binomial * (8.0 / (k + 1.0) - 4.0) * y;
    }
    sum
}

/// Quasi-static coefficient of restitution of one asperity loaded to `interference` \[m\]:
/// √(work returned by unloading/work of loading). Stress waves and rate effects are ignored.
///
/// # Errors
/// The errors of [`Joint::new`](crate::Joint::new); [`ContactError::OutOfRange`] for an
/// interference that is not above 0.
pub fn restitution(
    model: &(impl ContactModel + ?Sized),
    asperity: &Asperity,
    interference: f64,
    law: UnloadingLaw,
    tolerance: Tolerance,
) -> Result<f64, ContactError> {
    let w = positive("interference", interference)?;
    let loading = AsperityLaws::new(model, *asperity, law, tolerance)?;
    let failed = |source: QuadratureError| refused(model.id(), "interference", w, &source);
    let [spent, returned] = loading.works(w, tolerance.relative()).map_err(failed)?;
    let required = "an interference with a work of loading of at least 2.2e-308 J";
    require(spent >= f64::MIN_POSITIVE, "interference", w, required)?;
    Ok((returned / spent).sqrt())
}

/// The error of one asperity's law; `length` \[m\] is an interference or a retreat, named by
/// `place`.
pub(crate) fn refused(
    model: &str,
    place: &str,
    length: f64,
    source: &QuadratureError,
) -> ContactError {
    let reason = format!("one asperity at {place} {length:e} m: {source}");
    ContactError::Refused { model: model.into(), reason }
}

#[cfg(test)]
mod tests {
    use super::loss;

    #[test]
    fn loss_series_and_closed_form_agree_where_they_meet() {
        for n in [1.5, 1.3] {
            let (below, above) = (loss(0.1, n), loss(0.1_f64.next_up(), n));
            assert!((below / above - 1.0).abs() < 1e-12, "{below} {above}");
            assert!((loss(1e-6, n) / (2.0 / 3.0 * n * (n - 1.0) * 1e-18) - 1.0).abs() < 1e-5);
            let (below, above) = (loss(1.0_f64.next_down(), n), loss(1.0, n));
            assert!((below / above - 1.0).abs() < 1e-12, "{below} {above}");
        }
    }
}
