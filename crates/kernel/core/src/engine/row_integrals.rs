//! The quantities at one place: each integral is made when first needed and kept, or made
//! beforehand with a run of places.

use asperity_quadrature::Moments;

use crate::engine::at_point::{AtPoint, Integrals};
use crate::engine::averages::{Averages, separation_at, shares};
use crate::response::Answered;
use crate::scene::place::SeparationInSigma;
use crate::{At, ContactError, Evaluation, Quantity, Regime};

/// Number of quantities with laws.
const LAWS: usize = Quantity::INTEGRALS;

/// The integral of one law, with its slope or without.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LawIntegral {
    pub(crate) base: Quantity,
    pub(crate) moments: Moments,
    pub(crate) factor: f64,
    pub(crate) has_slope: bool,
}

/// The quantities at one place, with memory for `MEMORY` integrals; a single value needs none.
pub(crate) struct RowIntegrals<'a, A, const MEMORY: usize = LAWS> {
    point: AtPoint<'a>,
    integrals: IntegralsAt<'a, A, MEMORY>,
}

/// The integrals at one place.
struct IntegralsAt<'a, A, const MEMORY: usize> {
    averages: &'a mut A,
    place: (f64, &'a At),
    /// Whether slopes are made with values.
    slopes: bool,
    made: [Option<LawIntegral>; MEMORY],
}

impl<'a, 's: 'a, A: Averages<'s>, const MEMORY: usize> RowIntegrals<'a, A, MEMORY> {
    /// The row for these quantities; a load is inverted.
    #[inline]
    pub(crate) fn new(
        averages: &'a mut A,
        quantities: &[Quantity],
        at: &'a At,
    ) -> Result<Self, ContactError> {
        let separation = separation_at(averages, at)?;
        let slopes = separation.rounding > 0.0 || quantities.iter().any(|q| q.is_slope());
        Ok(Self::with(averages, (separation, at), slopes, []))
    }

    /// The row of these integrals.
    #[inline]
    pub(crate) fn with(
        averages: &'a mut A,
        (place, at): (SeparationInSigma, &'a At),
        slopes: bool,
        batch: impl IntoIterator<Item = LawIntegral>,
    ) -> Self {
        let scene = averages.scene();
        let own_stiffness = averages.laws().own_stiffness;
        let point =
            AtPoint { scene, own_stiffness, tolerance: averages.laws().tolerance, place, at };
        let mut integrals =
            IntegralsAt { averages, place: (place.s, at), slopes, made: [None; MEMORY] };
        batch.into_iter().for_each(|integral| integrals.keep(integral));
        Self { point, integrals }
    }

    /// One quantity.
    #[inline]
    pub(crate) fn quantity(&mut self, quantity: Quantity) -> Result<Evaluation, ContactError> {
        self.integrals.averages.check_requested(quantity)?;
        self.unchecked(quantity)
    }

    /// One quantity, whether or not it was requested.
    #[inline]
    pub(crate) fn unchecked(&mut self, quantity: Quantity) -> Result<Evaluation, ContactError> {
        self.point.of(quantity, &mut self.integrals)
    }
}

/// The quantities of one row.
pub(crate) fn answers<'s>(
    averages: &mut impl Averages<'s>,
    quantities: &[Quantity],
    at: &At,
) -> Vec<Answered> {
    match RowIntegrals::<_, LAWS>::new(averages, quantities, at) {
        Ok(mut row) => quantities.iter().map(|q| row.quantity(*q).map_err(Box::new)).collect(),
        Err(error) => {
            let refused = |q: &Quantity| averages.check_requested(*q).err();
            quantities.iter().map(|q| Err(Box::new(refused(q).unwrap_or(error.clone())))).collect()
        }
    }
}

impl<A, const MEMORY: usize> IntegralsAt<'_, A, MEMORY> {
    #[inline]
    fn keep(&mut self, integral: LawIntegral) {
        if let Some(free) = self.made.iter_mut().find(|made| made.is_none()) {
            *free = Some(integral);
        }
    }
}

impl<'s, A: Averages<'s>, const MEMORY: usize> IntegralsAt<'_, A, MEMORY> {
    /// The integral and its factor, and whether it has a slope.
    #[inline(always)]
    fn make(
        &mut self,
        base: Quantity,
        slope: bool,
    ) -> Result<((Moments, f64), bool), ContactError> {
        let has_slope = slope || self.slopes;
        match self.averages.settled(base, self.place, has_slope) {
            Ok(made) => Ok((made, has_slope)),
            // A slope that misses its tolerance is no error for a value without it.
            Err(_) if has_slope && !slope => {
                Ok((self.averages.settled(base, self.place, false)?, false))
            }
            Err(error) => Err(error),
        }
    }
}

impl<'s, A: Averages<'s>, const MEMORY: usize> Integrals for IntegralsAt<'_, A, MEMORY> {
    #[inline(always)]
    fn moments(&mut self, base: Quantity, slope: bool) -> Result<(Moments, f64), ContactError> {
        let serves = |made: &&LawIntegral| made.base == base && (made.has_slope || !slope);
        if let Some(made) = self.made.iter().flatten().find(serves) {
            return Ok((made.moments, made.factor));
        }
        let (made, has_slope) = self.make(base, slope)?;
        let (moments, factor) = made;
        self.keep(LawIntegral { base, moments, factor, has_slope });
        Ok(made)
    }

    fn share(&mut self, regime: Regime) -> Result<(f64, f64), ContactError> {
        let shares = shares(self.averages, Quantity::Force, self.place)?;
        let of_regime = shares.iter().filter(|share| share.regime == regime);
        Ok(of_regime.fold((0.0, 0.0), |(sum, size), s| (sum + s.share, size + s.share.abs())))
    }
}
