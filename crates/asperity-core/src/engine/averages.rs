//! The averages of a scene's laws over its heights: one trait, whether they are prepared for many
//! separations or made for one, and what follows from them for both: places, shares, inversion.

use asperity_quadrature::{Moments, QuadratureError};

use crate::engine::channel::{Units, failed};
use crate::engine::inverse::{ForceCurve, Target, check_load};
use crate::engine::laws::Laws;
use crate::request::separation::Place;
use crate::{At, ContactError, Quantity, Scene, Share, Tolerance};

/// The integrals of the laws of one scene at any separation.
///
/// `at` is the place in the caller's units, for errors.
pub(crate) trait Averages<'s> {
    fn scene(&self) -> &'s Scene;

    fn laws(&self) -> &'s Laws;

    fn tolerance(&self) -> Tolerance;

    /// From the numbers of the law for `base` to those of the scene.
    fn units(&self, base: Quantity) -> Result<Units, ContactError>;

    /// I(s) of the law for `base`, and -dI/ds if `slope` is set.
    fn integral(
        &mut self,
        base: Quantity,
        place: (f64, At),
        slope: bool,
    ) -> Result<Moments, ContactError>;

    /// The same of each part of the law for `base`.
    fn parts(
        &mut self,
        base: Quantity,
        place: (f64, At),
        slope: bool,
    ) -> Result<Vec<Moments>, ContactError>;

    /// Makes the integrals for s itself where they were made too far from it for their bounds;
    /// returns whether there were any.
    fn settle(&mut self, _base: Quantity, _place: (f64, At)) -> Result<bool, ContactError> {
        Ok(false)
    }

    /// # Errors
    /// [`ContactError::NotRequested`] for a quantity that nothing was prepared for.
    fn check_requested(&self, _quantity: Quantity) -> Result<(), ContactError> {
        Ok(())
    }
}

/// d/σ_z at a place; a load is inverted.
#[inline]
pub(crate) fn place<'s>(averages: &mut impl Averages<'s>, at: At) -> Result<Place, ContactError> {
    match at {
        At::Separation(separation) => separation.place(averages.scene()),
        At::Load(load) => place_of_load(averages, ("load", load), 1.0),
        At::Pressure(pressure) => {
            let area = averages.scene().nominal_area;
            place_of_load(averages, ("pressure", pressure), area)
        }
    }
}

/// The largest d/σ_z that carries a load of `value` times `area`.
pub(crate) fn place_of_load<'s>(
    averages: &mut impl Averages<'s>,
    (field, value): (&'static str, f64),
    area: f64,
) -> Result<Place, ContactError> {
    let value = check_load(field, value, averages.laws().adhesive)?;
    target(averages, value * area)?.first(&mut ForceAt::new(averages))
}

/// All d/σ_z that carry a load, ascending.
pub(crate) fn all_places_of_load<'s>(
    averages: &mut impl Averages<'s>,
    load: f64,
) -> Result<Vec<f64>, ContactError> {
    let load = check_load("load", load, averages.laws().adhesive)?;
    target(averages, load)?.all(&mut ForceAt::new(averages))
}

fn target<'s>(averages: &impl Averages<'s>, load: f64) -> Result<Target, ContactError> {
    let Units { factor, begins, .. } = averages.units(Quantity::Force)?;
    let laws = averages.laws();
    let signed = laws.law(Quantity::Force).is_some_and(|law| law.is_signed());
    let Laws { monotone, adhesive, .. } = *laws;
    Ok(Target { load, factor, monotone, signed, adhesive, begins })
}

/// The force over the separation, to be inverted.
struct ForceAt<'a, A> {
    averages: &'a mut A,
}

impl<'a, A> ForceAt<'a, A> {
    fn new(averages: &'a mut A) -> Self {
        Self { averages }
    }
}

impl<'s, A: Averages<'s>> ForceCurve for ForceAt<'_, A> {
    fn at(&mut self, s: f64) -> Result<Moments, ContactError> {
        self.averages.integral(Quantity::Force, (s, s.into()), true)
    }

    fn parts(&mut self, s: f64) -> Result<Moments, ContactError> {
        Ok(sum_of(&self.averages.parts(Quantity::Force, (s, s.into()), true)?))
    }

    fn settle(&mut self, s: f64) -> Result<bool, ContactError> {
        self.averages.settle(Quantity::Force, (s, s.into()))
    }
}

/// The sum of integrals at one s, whatever their scales.
fn sum_of(parts: &[Moments]) -> Moments {
    parts.iter().fold(Moments::NONE, |sum, part| {
        let (small, large) = match *part {
            part if sum.sizes[0] == 0.0 => (sum, part),
            part if part.ln_scale > sum.ln_scale => (sum, part),
            part => (part, sum),
        };
        large.plus(
            (small.ln_scale - large.ln_scale).exp(),
            &Moments { ln_scale: large.ln_scale, ..small },
        )
    })
}

/// The share of every part of the law for `base`.
pub(crate) fn shares<'s>(
    averages: &mut impl Averages<'s>,
    base: Quantity,
    place: (f64, At),
) -> Result<Vec<Share>, ContactError> {
    averages.settle(base, place)?;
    let total = averages.integral(base, place, false)?;
    let integrals = averages.parts(base, place, false)?;
    let law = averages.laws().law(base).ok_or(ContactError::NotRequested { quantity: base })?;
    let share = |part: &Moments| {
        let value = part.value * (part.ln_scale - total.ln_scale).exp();
        if value == 0.0 { 0.0 } else { value / total.value }
    };
    let shares = law.parts.iter().zip(&integrals).map(|(part, integral)| Share {
        name: part.name.clone(),
        regime: part.regime,
        share: share(integral),
    });
    Ok(shares.collect())
}

/// The integrals of parts, each of which may fail.
pub(crate) fn all_parts(
    parts: impl Iterator<Item = Result<Moments, QuadratureError>>,
    base: Quantity,
    at: At,
) -> Result<Vec<Moments>, ContactError> {
    parts.collect::<Result<_, _>>().map_err(failed(base, at))
}
