//! The quantities at one place: each integral is made when first needed and kept, or made
//! beforehand with a run of places. The point and its integrals are two types: merged into one, a
//! value takes two to five nanoseconds more.

use asperity_quadrature::Moments;

use crate::engine::averages::{Averages, separation_at, shares};
use crate::error::integral_failed;
use crate::law::contact_radii;
use crate::request::quantity_table::Derivation;
use crate::response::Answered;
use crate::scene::place::SeparationInSigma;
use crate::{At, ContactError, Evaluation, Quantity, Regime, Scene, Tolerance};

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

    /// One quantity, whether or not it was requested.
    #[inline]
    pub(crate) fn quantity(&mut self, quantity: Quantity) -> Result<Evaluation, ContactError> {
        self.point.of(quantity, &mut self.integrals)
    }
}

/// The quantities of one row, each if `check` allows it.
pub(crate) fn answers<'s>(
    averages: &mut impl Averages<'s>,
    quantities: &[Quantity],
    at: &At,
    check: impl Fn(Quantity) -> Result<(), ContactError>,
) -> Vec<Answered> {
    let mut row = RowIntegrals::<_, LAWS>::new(averages, quantities, at);
    let mut one = |quantity| {
        check(quantity)?;
        row.as_mut().map_err(|error| error.clone())?.quantity(quantity)
    };
    quantities.iter().map(|quantity| one(*quantity).map_err(Box::new)).collect()
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

/// The integrals at one place.
trait Integrals {
    /// The integral of the law for `base`, with its slope if that is set, and its factor.
    fn moments(&mut self, base: Quantity, slope: bool) -> Result<(Moments, f64), ContactError>;

    /// The share of a regime in the force, and the sum of its parts' absolute shares.
    fn share(&mut self, regime: Regime) -> Result<(f64, f64), ContactError>;
}

/// A point of evaluation, with the inputs of quantities other than the integrals.
#[derive(Debug, Clone, Copy)]
struct AtPoint<'s> {
    scene: &'s Scene,
    /// Whether the model has a law for the stiffness.
    own_stiffness: bool,
    tolerance: Tolerance,
    place: SeparationInSigma,
    /// In the caller's units, for errors.
    at: &'s At,
}

impl AtPoint<'_> {
    /// The quantity at this place.
    #[inline]
    fn of(
        &self,
        quantity: Quantity,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        match quantity.derivation() {
            Derivation::Integral => self.value(quantity, integrals),
            Derivation::IntegralOrSlope(_) if self.own_stiffness => self.value(quantity, integrals),
            Derivation::IntegralOrSlope(of) | Derivation::Slope(of) => {
                self.slope(quantity, of, integrals)
            }
            Derivation::PerNominalArea(of) => self.total(of, self.scene.nominal_area, integrals),
            Derivation::ContactRadii(..) => self.total(quantity, 1.0, integrals),
            Derivation::Ratio(above, below) => self.ratio(quantity, (above, below), integrals),
            Derivation::Logarithm(of) => self.logarithm(quantity, of, integrals),
            Derivation::RegimeShare(regime) => self.share(quantity, regime, integrals),
            // Refused where laws are made.
            Derivation::Flow
            | Derivation::Gap
            | Derivation::Map
            | Derivation::Seal
            | Derivation::Bodies => Err(ContactError::NotRequested { quantity }),
        }
    }

    /// An integral, or a multiple of the sum of contact radii, over an area.
    #[inline(never)]
    fn total(
        &self,
        quantity: Quantity,
        area: f64,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        let mut total = self.value(quantity.origin(), integrals)?;
        if let Some(factor) = contact_radii::factor(quantity, &self.scene.interface)? {
            let (scaled, size) = (total.scaled * factor, total.size * factor);
            total = Evaluation { scaled, size, ..total }.held(total.size, quantity)?;
        }
        Ok(Evaluation { scaled: total.scaled / area, size: total.size / area, ..total })
    }

    #[inline(always)]
    fn value(
        &self,
        base: Quantity,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        // The slope bounds the effect of a rounded separation.
        let (moments, factor) = integrals.moments(base, self.place.rounding > 0.0)?;
        Evaluation::of_value(&moments, factor, self.place).held(moments.sizes[0], base)
    }

    #[inline(always)]
    fn slope(
        &self,
        quantity: Quantity,
        of: Quantity,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        let (moments, factor) = integrals.moments(of, true)?;
        let within = moments.slope_within(self.place.s, self.tolerance.relative());
        within.map_err(integral_failed(quantity, self.at))?;
        let height_std = self.scene.surface.asperity_height_std;
        Evaluation::of_slope(&moments, factor, height_std, self.place)
            .held(moments.sizes[1], quantity)
    }

    #[inline(never)]
    fn logarithm(
        &self,
        quantity: Quantity,
        of: Quantity,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        let of = self.value(of, integrals)?;
        let ln = self.number(quantity, of.ln_value())?;
        Ok(Evaluation::absolute(ln, of.ln_error()))
    }

    /// The ratio of the scaled values, which exists where both values underflow.
    #[inline(never)]
    fn ratio(
        &self,
        quantity: Quantity,
        (above, below): (Quantity, Quantity),
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        let (above, below) = (self.value(above, integrals)?, self.value(below, integrals)?);
        let ratio = above.scaled / below.scaled * (above.ln_scale - below.ln_scale).exp();
        let ratio = self.number(quantity, ratio)?;
        // One scale for both cancels, however its logarithm is rounded.
        let scales = match above.ln_scale - below.ln_scale {
            0.0 => 0.0,
            moved => 0.5 * (above.ln_scale.abs() + below.ln_scale.abs() + moved.abs()),
        };
        let error = above.cancelled() + below.cancelled() + (scales + 4.0) * f64::EPSILON;
        Ok(Evaluation::new(ratio, error))
    }

    #[inline(never)]
    fn share(
        &self,
        quantity: Quantity,
        regime: Regime,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        let force = self.value(Quantity::Force, integrals)?;
        self.number(quantity, force.ln_value())?;
        let (share, size) = integrals.share(regime)?;
        // Each part has the error of the tolerance, and so has the force that divides it.
        let error = self.tolerance.relative() + force.cancelled();
        // A force of unknown size has no shares.
        self.number(quantity, error)?;
        Ok(Evaluation::absolute(share, size * error))
    }

    /// Ratios and logarithms have no value without a contact.
    fn number(&self, quantity: Quantity, value: f64) -> Result<f64, ContactError> {
        match value.is_finite() {
            true => Ok(value),
            false => Err(ContactError::NoValue { quantity, at: *self.at }),
        }
    }
}
