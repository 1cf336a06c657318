//! The quantities at one place: each integral is made when first needed and kept, or made
//! beforehand with those of a run of places.

use asperity_quadrature::Moments;

use crate::engine::averages::{Averages, place, shares};
use crate::engine::readings::{Integrals, Reading};
use crate::request::separation::Place;
use crate::response::Cell;
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
pub(crate) struct Row<'a, A, const MEMORY: usize = LAWS> {
    reading: Reading<'a>,
    integrals: AtPlace<'a, A, MEMORY>,
}

/// The integrals at one place.
struct AtPlace<'a, A, const MEMORY: usize> {
    averages: &'a mut A,
    place: (f64, &'a At),
    /// Whether slopes are made with values.
    slopes: bool,
    made: [Option<LawIntegral>; MEMORY],
}

impl<'a, 's: 'a, A: Averages<'s>, const MEMORY: usize> Row<'a, A, MEMORY> {
    /// The row for these quantities; a load is inverted.
    #[inline]
    pub(crate) fn new(
        averages: &'a mut A,
        quantities: &[Quantity],
        at: &'a At,
    ) -> Result<Self, ContactError> {
        let place = place(averages, at)?;
        let slopes = place.rounding > 0.0 || quantities.iter().any(|q| q.is_slope());
        Ok(Self::with(averages, (place, at), slopes, []))
    }

    /// The row of these integrals.
    #[inline]
    pub(crate) fn with(
        averages: &'a mut A,
        (place, at): (Place, &'a At),
        slopes: bool,
        known: impl IntoIterator<Item = LawIntegral>,
    ) -> Self {
        let scene = averages.scene();
        let own_stiffness = averages.laws().own_stiffness;
        let reading = Reading { scene, own_stiffness, tolerance: averages.tolerance(), place, at };
        let mut integrals =
            AtPlace { averages, place: (place.s, at), slopes, made: [None; MEMORY] };
        known.into_iter().for_each(|known| integrals.keep(known));
        Self { reading, integrals }
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
        self.reading.of(quantity, &mut self.integrals)
    }
}

/// The cells of one row.
pub(crate) fn cells<'s>(
    averages: &mut impl Averages<'s>,
    quantities: &[Quantity],
    at: &At,
) -> Vec<Cell> {
    let requested = quantities.iter().map(|q| averages.check_requested(*q)).collect::<Vec<_>>();
    let row = Row::<_, LAWS>::new(averages, quantities, at).map_err(Box::new);
    let refused = |requested: Result<(), ContactError>, error: &ContactError| {
        Err(Box::new(requested.err().unwrap_or_else(|| error.clone())))
    };
    match row {
        Ok(mut row) => quantities.iter().map(|q| row.quantity(*q).map_err(Box::new)).collect(),
        Err(error) => requested.into_iter().map(|requested| refused(requested, &error)).collect(),
    }
}

impl<A, const MEMORY: usize> AtPlace<'_, A, MEMORY> {
    #[inline]
    fn keep(&mut self, integral: LawIntegral) {
        if let Some(free) = self.made.iter_mut().find(|made| made.is_none()) {
            *free = Some(integral);
        }
    }
}

impl<'s, A: Averages<'s>, const MEMORY: usize> AtPlace<'_, A, MEMORY> {
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

impl<'s, A: Averages<'s>, const MEMORY: usize> Integrals for AtPlace<'_, A, MEMORY> {
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
