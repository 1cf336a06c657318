//! The averages of a scene's laws over its heights: one trait for averages prepared for many
//! separations and for single ones, with places, shares and inversion for both.

use std::sync::Arc;

use asperity_quadrature::Moments;

use crate::engine::inverse::force_at::{Falls, ForceAt};
use crate::engine::inverse::{CarriedLoad, ForceCurve, Halves, check_load};
use crate::engine::laws::Laws;
use crate::error::require;
use crate::scene::place::{HIGHEST, LOWEST, SeparationInSigma};
use crate::{At, ContactError, Quantity, Scene, Share};

/// The integrals of the laws of one scene at any separation.
///
/// `at` is the place in the caller's units, for errors.
pub(crate) trait Averages<'s> {
    fn scene(&self) -> &'s Scene;

    fn laws(&self) -> &'s Laws;

    /// The factor that makes the integral of the law for `base` a quantity of the scene.
    fn factor(&self, base: Quantity) -> Result<f64, ContactError>;

    /// I(s) of the law for `base`, and -dI/ds if `slope` is set, with its factor.
    fn integral(
        &mut self,
        base: Quantity,
        place: (f64, &At),
        slope: bool,
    ) -> Result<(Moments, f64), ContactError>;

    /// I(s) of the law for the force, and a slope to search with, which may miss the tolerance far
    /// below 0.
    fn rough_force(&mut self, s: f64) -> Result<Moments, ContactError>;

    /// [`integral`](Self::integral) after [`settle`](Self::settle). Integrals that hold at any s
    /// have a method of their own: a call that does nothing costs a value 14 instructions of 360.
    fn settled(
        &mut self,
        base: Quantity,
        place: (f64, &At),
        slope: bool,
    ) -> Result<(Moments, f64), ContactError> {
        self.settle(base, place)?;
        self.integral(base, place, slope)
    }

    /// The same of each part of the law for `base`.
    fn parts(&mut self, base: Quantity, place: (f64, &At)) -> Result<Vec<Moments>, ContactError>;

    /// Whether the heights meet only a rising part of the law of the force from this separation on.
    fn rises_above(&self, s: f64) -> Result<bool, ContactError>;

    /// The integrals of the added and of the subtracted parts of the law of the force at s, to a
    /// few digits; `None` if any changes its sign, or where the [`falls`](Self::falls) are at hand.
    fn halves(&mut self, _s: f64) -> Result<Option<Halves>, ContactError> {
        Ok(None)
    }

    /// The falls of the law of the force, if there are any: the force may then rise with the
    /// separation.
    fn falls(&self) -> Result<Option<Arc<Falls>>, ContactError>;

    /// The force's integral and slope at s where its law falls, to guide a search: with a slope
    /// also where its bound exceeds the tolerance.
    fn guide(&self, falls: &Falls, s: f64) -> Result<Moments, ContactError> {
        falls.force(s)
    }

    /// The separation of a load that was inverted before.
    #[inline(always)]
    fn inverted(&self, _at: &At) -> Option<SeparationInSigma> {
        None
    }

    /// Makes the integrals for s if they were made too far from it for their bounds to hold;
    /// returns whether there were any.
    fn settle(&mut self, _base: Quantity, _place: (f64, &At)) -> Result<bool, ContactError> {
        Ok(false)
    }
}

/// d/σ_z at a place; a load is inverted.
#[inline(always)]
pub(crate) fn separation_at<'s>(
    averages: &mut impl Averages<'s>,
    at: &At,
) -> Result<SeparationInSigma, ContactError> {
    if let Some(separation) = averages.inverted(at) {
        return Ok(separation);
    }
    match at {
        At::Separation(separation) => separation.in_sigma(averages.scene()),
        At::Load(load) => separation_of_load(averages, ("load", *load), 1.0),
        At::Pressure(pressure) => {
            let area = averages.scene().nominal_area;
            separation_of_load(averages, ("pressure", *pressure), area)
        }
    }
}

/// The d/σ_z that carries a load of `value` times `area`: the largest, which is the first on
/// approach, of a load above 0, and the smallest, which is stable, of a tension.
#[inline(never)]
pub(crate) fn separation_of_load<'s>(
    averages: &mut impl Averages<'s>,
    (field, value): (&'static str, f64),
    area: f64,
) -> Result<SeparationInSigma, ContactError> {
    let value = check_load(field, value, averages.laws().adhesive)?;
    let target = target(averages, value * area)?;
    // Where the heights meet only a rising law, one separation carries the load.
    let subtracts = averages.laws().law(Quantity::Force).is_some_and(|law| law.is_signed());
    if target.load > 0.0
        && let Ok(found) = target.newton(&mut Force(averages))
    {
        let found = match subtracts {
            true => target.largest_from(&mut Force(averages), found),
            false => averages.rises_above(found.s)?.then_some(found),
        };
        if let Some(found) = found {
            return Ok(found);
        }
    }
    let Some(falls) = averages.falls()? else { return target.newton(&mut Force(averages)) };
    target.first(&ForceAt { guide: &|s| averages.guide(&falls, s), falls: &falls })
}

/// All d/σ_z that carry a load, ascending.
pub(crate) fn all_separations_of_load<'s>(
    averages: &mut impl Averages<'s>,
    load: f64,
) -> Result<Vec<f64>, ContactError> {
    let first = separation_of_load(averages, ("load", load), 1.0)?.s;
    let Some(falls) = averages.falls()? else { return Ok(vec![first]) };
    let force = ForceAt { guide: &|s| averages.guide(&falls, s), falls: &falls };
    let mut found = target(averages, load)?.crossings(&force, false)?;
    found.reverse();
    // The same number as for the load alone.
    let same = if load < 0.0 { found.first_mut() } else { found.last_mut() };
    same.into_iter().for_each(|s| *s = first);
    Ok(found)
}

/// d/σ_z of the least force; `None` if no negative force is within the range of f64.
pub(crate) fn separation_of_pull_off<'s>(
    averages: &mut impl Averages<'s>,
) -> Result<Option<f64>, ContactError> {
    let Some(falls) = averages.falls()? else { return Ok(None) };
    // Far out in the tail of the heights adhesion always prevails, with forces that underflow f64.
    let ln_least = target(averages, -1.0)?.ln_least();
    let force = ForceAt { guide: &|s| averages.guide(&falls, s), falls: &falls };
    let least = force.largest(-1.0, ln_least)?;
    let level = least.level();
    let (pulls, value) = (level.sign < 0.0 && level.ln > ln_least, least.s);
    let required = "one within -1e6 and 1e9 asperity_height_std";
    let inside = value > LOWEST && value < HIGHEST;
    require(inside || !pulls, "separation of the pull-off", value, required)?;
    Ok(pulls.then_some(value))
}

fn target<'s>(averages: &impl Averages<'s>, load: f64) -> Result<CarriedLoad, ContactError> {
    Ok(CarriedLoad { load, factor: averages.factor(Quantity::Force)? })
}

/// The force over the separation, to be inverted.
struct Force<'a, A>(&'a mut A);

impl<'s, A: Averages<'s>> ForceCurve for Force<'_, A> {
    fn at(&mut self, s: f64) -> Result<Moments, ContactError> {
        self.0.rough_force(s)
    }

    fn settle(&mut self, s: f64) -> Result<bool, ContactError> {
        self.0.settle(Quantity::Force, (s, &s.into()))
    }

    fn halves(&mut self, s: f64) -> Result<Option<Halves>, ContactError> {
        self.0.halves(s)
    }
}

/// The share of every part of the law for `base`.
pub(crate) fn shares<'s>(
    averages: &mut impl Averages<'s>,
    base: Quantity,
    place: (f64, &At),
) -> Result<Vec<Share>, ContactError> {
    averages.settle(base, place)?;
    let (total, _) = averages.integral(base, place, false)?;
    let integrals = averages.parts(base, place)?;
    let law = averages.laws().law(base).ok_or(ContactError::NotRequested { quantity: base })?;
    let share = |part: &Moments| {
        let value = part.value * (part.ln_scale - total.ln_scale).exp();
        if value == 0.0 { 0.0 } else { value / total.value }
    };
    let mut shares: Vec<Share> = vec![];
    for (part, integral) in law.share_parts().iter().zip(&integrals) {
        let (name, regime, share) = (part.name.clone(), part.regime, share(integral));
        match shares.last_mut().filter(|last| law.shares.is_some() && last.name == name) {
            Some(last) => last.share += share,
            None => shares.push(Share { name, regime, share }),
        }
    }
    Ok(shares)
}
