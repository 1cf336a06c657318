//! The quantities at one place: each integral is made when first needed and kept, or made
//! beforehand with those of a run of places.

use asperity_quadrature::Moments;

use crate::engine::averages::{Averages, separation_at, shares};
use crate::engine::laws::Laws;
use crate::error::integral_failed;
use crate::request::quantity_table::Derivation;
use crate::request::separation::SeparationInSigma;
use crate::response::Answered;
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
    averages: &'a mut A,
    scene: &'a Scene,
    /// Whether the model has a law for the stiffness.
    own_stiffness: bool,
    tolerance: Tolerance,
    separation: SeparationInSigma,
    /// In the caller's units, for errors.
    at: &'a At,
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
        (separation, at): (SeparationInSigma, &'a At),
        slopes: bool,
        batch: impl IntoIterator<Item = LawIntegral>,
    ) -> Self {
        let (scene, made) = (averages.scene(), [None; MEMORY]);
        let Laws { own_stiffness, tolerance, .. } = *averages.laws();
        let mut row =
            Self { averages, scene, own_stiffness, tolerance, separation, at, slopes, made };
        batch.into_iter().for_each(|integral| row.keep(integral));
        row
    }

    /// One quantity.
    #[inline]
    pub(crate) fn quantity(&mut self, quantity: Quantity) -> Result<Evaluation, ContactError> {
        self.averages.check_requested(quantity)?;
        self.unchecked(quantity)
    }

    /// One quantity, whether or not it was requested.
    #[inline]
    pub(crate) fn unchecked(&mut self, quantity: Quantity) -> Result<Evaluation, ContactError> {
        match quantity.derivation() {
            Derivation::Integral(_) => self.value(quantity),
            Derivation::IntegralOrSlope(..) if self.own_stiffness => self.value(quantity),
            Derivation::IntegralOrSlope(_, of) | Derivation::Slope(of) => self.slope(quantity, of),
            Derivation::PerNominalArea(of) => self.total(of, self.scene.nominal_area),
            Derivation::ContactRadii(_) => self.total(quantity, 1.0),
            Derivation::Ratio(above, below) => self.ratio(quantity, above, below),
            Derivation::Logarithm(of) => self.logarithm(quantity, of),
            Derivation::RegimeShare(regime) => self.share(quantity, regime),
        }
    }

    /// An integral, or a multiple of the sum of contact radii, over an area.
    #[inline(never)]
    fn total(&mut self, quantity: Quantity, area: f64) -> Result<Evaluation, ContactError> {
        let mut total = self.value(quantity.origin())?;
        if let Some(factor) = quantity.radius_factor() {
            let factor = factor.on(&self.scene.interface, quantity)?;
            let (scaled, size) = (total.scaled * factor, total.size * factor);
            total = Evaluation { scaled, size, ..total }.held(total.size, quantity)?;
        }
        Ok(Evaluation { scaled: total.scaled / area, size: total.size / area, ..total })
    }

    #[inline(always)]
    fn value(&mut self, base: Quantity) -> Result<Evaluation, ContactError> {
        // The slope bounds the effect of a rounded separation.
        let (moments, factor) = self.moments(base, self.separation.rounding > 0.0)?;
        Evaluation::of_value(&moments, factor, self.separation).held(moments.sizes[0], base)
    }

    #[inline(always)]
    fn slope(&mut self, quantity: Quantity, of: Quantity) -> Result<Evaluation, ContactError> {
        let (moments, factor) = self.moments(of, true)?;
        let tolerance = self.tolerance.relative();
        let within = moments.slope_within(self.separation.s, tolerance);
        within.map_err(integral_failed(quantity, self.at))?;
        let height_std = self.scene.surface.asperity_height_std;
        Evaluation::of_slope(&moments, factor, height_std, self.separation)
            .held(moments.sizes[1], quantity)
    }

    #[inline(never)]
    fn logarithm(&mut self, quantity: Quantity, of: Quantity) -> Result<Evaluation, ContactError> {
        let of = self.value(of)?;
        let ln = self.number(quantity, of.ln_value())?;
        Ok(Evaluation::absolute(ln, of.ln_error()))
    }

    /// The ratio of the scaled values, which exists where both values underflow.
    #[inline(never)]
    fn ratio(
        &mut self,
        quantity: Quantity,
        above: Quantity,
        below: Quantity,
    ) -> Result<Evaluation, ContactError> {
        let (above, below) = (self.value(above)?, self.value(below)?);
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

    /// The share of a regime in the force.
    #[inline(never)]
    fn share(&mut self, quantity: Quantity, regime: Regime) -> Result<Evaluation, ContactError> {
        let force = self.value(Quantity::Force)?;
        self.number(quantity, force.ln_value())?;
        let shares = shares(self.averages, Quantity::Force, (self.separation.s, self.at))?;
        let of_regime = shares.iter().filter(|share| share.regime == regime);
        let sums = |(sum, size), share: f64| (sum + share, size + share.abs());
        let (share, size) = of_regime.map(|share| share.share).fold((0.0, 0.0), sums);
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

    /// The integral of the law for `base`, with its slope if that is set, and its factor.
    #[inline(always)]
    fn moments(&mut self, base: Quantity, slope: bool) -> Result<(Moments, f64), ContactError> {
        let serves = |made: &&LawIntegral| made.base == base && (made.has_slope || !slope);
        if let Some(made) = self.made.iter().flatten().find(serves) {
            return Ok((made.moments, made.factor));
        }
        let (place, mut has_slope) = ((self.separation.s, self.at), slope || self.slopes);
        self.averages.settle(base, place)?;
        let (moments, factor) = match self.averages.integral(base, place, has_slope) {
            Ok(made) => made,
            // A slope that misses its tolerance is no error for a value without it.
            Err(_) if has_slope && !slope => {
                has_slope = false;
                self.averages.integral(base, place, false)?
            }
            Err(error) => return Err(error),
        };
        self.keep(LawIntegral { base, moments, factor, has_slope });
        Ok((moments, factor))
    }

    #[inline]
    fn keep(&mut self, integral: LawIntegral) {
        if let Some(free) = self.made.iter_mut().find(|made| made.is_none()) {
            *free = Some(integral);
        }
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
