//! Energy created by a pair of loading and unloading laws.

use asperity_core::{At, Code, ContactError, Finding, QuadratureError};
use asperity_quadrature::{fallible, gauss_kronrod};

use crate::asperity_laws::{AsperityLaws, MAX_SAMPLES, UnloadingQuantity};
use crate::{Joint, UnloadingLaw, Work};

/// Classes of interference between two kinks of the law, in geometric steps.
const CLASSES: u32 = 64;
/// Decades covered beyond the last kink.
const DECADES: f64 = 4.0;
/// Relative error of the work on one asperity: far below [`NEGLIGIBLE`].
const TOLERANCE: f64 = 1e-6;
/// Share of the work of loading below which energy created by some asperities is not reported.
const NEGLIGIBLE: f64 = 0.01;

/// The finding that opening creates energy.
///
/// An asperity whose loading law is steeper than Hertz' (AF above w_c), or jumps up (CEB and KE at
/// w_c), has a residual interference w - δ below 0: it recovers by more than its interference and
/// returns more energy than the work of loading.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct EnergyGain {
    /// Name of the model.
    pub model: String,
    /// The unloading law.
    pub law: UnloadingLaw,
    /// Energy created over the work of loading, 0.6 for 60 %: the net gain of the rough contact if
    /// there is one; otherwise the energy created by asperities with a residual interference below
    /// 0, accurate to some per cent.
    pub amount: f64,
    /// Whether the rough contact returns more than the work of loading.
    pub is_net: bool,
}

impl EnergyGain {
    /// The finding as a warning.
    #[must_use]
    pub fn finding(&self) -> Finding {
        let Self { model, law, amount, is_net } = self;
        let percent = 100.0 * amount;
        let fact = match is_net {
            true => format!(
                "by {law}, opening returns {percent:.1} % more energy than closing took, because asperities recover by more than their interference"
            ),
            false => format!(
                "by {law}, the loss is too small by {percent:.1} % of the work of closing, because asperities recover by more than their interference"
            ),
        };
        Finding::warning(Code::EnergyGain, "energy_gain", *amount)
            .usual([0.0, 0.0])
            .of_model(model.as_str())
            .of_law(law.to_string())
            .fact(fact)
            .advice("use another unloading law or another model")
    }
}

impl Joint {
    /// The energy gain of opening from `closest`, given the [`work`](Self::work): if the whole
    /// contact gains energy beyond the error bounds, or some asperities create more than 1 % of the
    /// work.
    ///
    /// # Errors
    /// The errors of finding a load; [`ContactError::Integral`], [`ContactError::Refused`].
    pub fn energy_gain(
        &self,
        closest: At,
        work: &Work,
    ) -> Result<Option<EnergyGain>, ContactError> {
        let lost = work.lost();
        let is_net = lost.value() < 0.0 && lost.relative_error() < 1.0;
        let gained = if is_net { -lost.value() } else { self.created(closest)? };
        let amount = gained / work.spent.value();
        let (model, law) = (self.name().to_string(), self.law());
        let found = EnergyGain { model, law, amount, is_net };
        Ok((is_net || amount > NEGLIGIBLE).then_some(found))
    }

    /// The energy \[J\] created by asperities with a residual interference below 0, summed over
    /// classes of interference.
    fn created(&self, closest: At) -> Result<f64, ContactError> {
        let place = self.unloading(closest)?.place();
        let (loading, sigma) = (self.loading(), self.scene().surface.asperity_height_std);
        let mut created = 0.0;
        for pair in loading.breaks().windows(2).filter(|pair| pair[0] > 0.0) {
            let low = pair[0];
            let ratio = (pair[1] / low).min(10f64.powf(DECADES)).powf(1.0 / f64::from(CLASSES));
            let end = |k: u32| low * ratio.powf(f64::from(k));
            let gain = |k: u32| {
                let w = end(k) * ratio.sqrt();
                let found = loading.works(w, TOLERANCE).map(|[spent, returned]| returned - spent);
                found.map_err(|source| loading.refused(self.name(), w, &source))
            };
            let gains = (0..CLASSES).map(gain).collect::<Result<Vec<f64>, _>>()?;
            if gains.iter().all(|gain| *gain <= 0.0) {
                continue;
            }
            let places: Vec<f64> = (0..=CLASSES).map(|k| place + end(k) / sigma).collect();
            let above = self.retreated(UnloadingQuantity::Contacts, 0.0, &places)?;
            for (gain, ends) in gains.iter().zip(above.windows(2)) {
                created += gain.max(0.0) * (ends[0].value() - ends[1].value());
            }
        }
        Ok(created)
    }
}

impl AsperityLaws {
    /// The work of loading one asperity to w \[m\], and the work it returns \[J\].
    pub(crate) fn works(&self, w: f64, tolerance: f64) -> Result<[f64; 2], QuadratureError> {
        let mut breaks: Vec<f64> = self.breaks().into_iter().filter(|x| *x < w).collect();
        breaks.push(w);
        let force = |x| self.force.value(x);
        let spent =
            fallible(force, |force| gauss_kronrod(force, &breaks, tolerance, MAX_SAMPLES))??;
        Ok([spent.value, self.answer(w, f64::INFINITY, None, UnloadingQuantity::Returned)?])
    }
}
