//! The work of closing a joint and of opening it, and energy that a pair of laws creates.

use asperity_core::{
    At, Code, ContactError, Evaluation, Finding, QuadratureError, Quantity, require,
};
use asperity_quadrature::{Estimate, fallible, gauss_kronrod};

use crate::asperity_laws::{AsperityLaws, UnloadingQuantity, refused};
use crate::{Joint, UnloadingLaw};

/// Largest number of samples of one integral.
const MAX_SAMPLES: usize = 100_000;
/// Largest separation integrated \[σ_z\].
const MAX_DISTANCE: f64 = 1e8;
/// Classes of interference between two kinks of the law, in geometric steps.
const CLASSES: u32 = 64;
/// Decades covered beyond the last kink.
const DECADES: f64 = 4.0;
/// Relative error of the work on one asperity: far below [`NEGLIGIBLE`].
const TOLERANCE: f64 = 1e-6;
/// Share of the work of loading below which energy created by some asperities is not reported.
const NEGLIGIBLE: f64 = 0.01;

/// The work of first closing to a closest approach, and the work returned by opening.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Work {
    /// The work \[J\] of first closing from no contact.
    pub spent: Evaluation,
    /// The work \[J\] returned by opening.
    pub returned: Evaluation,
}

impl Work {
    /// The energy \[J\] dissipated by plastic deformation: work spent minus work returned, with an
    /// error bound relative to both. A cycle between fixed separations dissipates it in the first
    /// cycle only. 0 for elastic models.
    ///
    /// Below 0 where the pair of loading and unloading laws creates energy, which
    /// [`Joint::energy_gain`] reports as an [`EnergyGain`].
    #[must_use]
    pub fn lost(&self) -> Evaluation {
        self.spent.less(&self.returned)
    }

    /// The loss factor: energy [dissipated](Self::lost)/(2π × work spent).
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] where the work spent is below 2.2e-308 J.
    pub fn loss_factor(&self) -> Result<f64, ContactError> {
        let spent = self.spent.value();
        let required = "at least 2.2e-308 J, at a closer approach,";
        require(spent >= f64::MIN_POSITIVE, "work of closing", spent, required)?;
        Ok(self.lost().value() / (2.0 * std::f64::consts::PI * spent))
    }
}

impl Joint {
    /// The work of first closing from no contact to `closest`, and the work returned by opening.
    ///
    /// # Errors
    /// The errors of the contact's evaluations, [`ContactError::Integral`], and
    /// [`ContactError::OutOfRange`] for heights with so heavy a tail that separations beyond 1e8
    /// σ_z contribute to the work.
    pub fn work(&self, closest: At) -> Result<Work, ContactError> {
        let way = self.unloading(closest)?;
        let spent = self.spent(way.place)?;
        // Elastic contacts return all of the work.
        let returned =
            if self.loading.critical.is_finite() { way.returned(f64::INFINITY)? } else { spent };
        Ok(Work { spent, returned })
    }

    /// The work of first closing to a separation \[σ_z from the mean of the asperity heights\].
    fn spent(&self, place: f64) -> Result<Evaluation, ContactError> {
        let sigma = self.scene().surface.asperity_height_std;
        // Panels double in length until their work is negligible.
        let (mut from, mut step) = (sigma * place, sigma);
        let (mut work, mut error) = (0.0, 0.0);
        loop {
            let panel = self.closing(from + step, from)?;
            (work, error) = (work + panel.value, error + panel.error);
            (from, step) = (from + step, 2.0 * step);
            if panel.value <= 1e-3 * self.tolerance.relative() * work {
                // The rest is less than the last panel; forces have the error of the tolerance.
                let relative = if work > 0.0 { (error + panel.value) / work } else { 0.0 };
                return Ok(Evaluation::new(work, relative + self.tolerance.relative()));
            }
            let field = "share of the work beyond 1e8 asperity_height_std";
            let required = "about 0, for which the heights need a lighter tail,";
            require(from <= MAX_DISTANCE * sigma, field, panel.value / work, required)?;
        }
    }

    /// The work \[J\] of first closing from one separation \[m\] to another, both from the mean of
    /// the asperity heights.
    pub(crate) fn closing(&self, from: f64, to: f64) -> Result<Estimate, ContactError> {
        let quantity = Quantity::Force;
        let force =
            |d| Ok::<_, ContactError>(self.virgin().evaluate(quantity, At::metres(d))?.value());
        let goal = self.tolerance.relative();
        let work = fallible(force, |force| gauss_kronrod(force, &[to, from], goal, MAX_SAMPLES))?;
        let at = At::metres(to);
        work.map_err(|source| ContactError::Integral { quantity, at, source })
    }
}

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
        let (model, law) = (self.name.clone(), self.law());
        let found = EnergyGain { model, law, amount, is_net };
        Ok((is_net || amount > NEGLIGIBLE).then_some(found))
    }

    /// The energy \[J\] created by asperities with a residual interference below 0, summed over
    /// classes of interference.
    fn created(&self, closest: At) -> Result<f64, ContactError> {
        let place = self.unloading(closest)?.place;
        let (loading, sigma) = (&self.loading, self.scene().surface.asperity_height_std);
        let mut created = 0.0;
        for pair in loading.breaks().windows(2).filter(|pair| pair[0] > 0.0) {
            let low = pair[0];
            let ratio = (pair[1] / low).min(10f64.powf(DECADES)).powf(1.0 / f64::from(CLASSES));
            let end = |k: u32| low * ratio.powf(f64::from(k));
            let gain = |k: u32| {
                let w = end(k) * ratio.sqrt();
                let found = loading.works(w, TOLERANCE).map(|[spent, returned]| returned - spent);
                found.map_err(|source| refused(&self.name, "interference", w, &source))
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
