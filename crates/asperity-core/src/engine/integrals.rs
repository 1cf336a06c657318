//! Where a compiled scene's readings get their integrals: one at a time, each once, or of a run.

use asperity_quadrature::Moments;

use crate::engine::channel::failed;
use crate::engine::compiled::Compiled;
use crate::engine::readings::Integrals;
use crate::{At, ContactError, Quantity, Regime};

/// The integrals of one law at each place of a run.
pub(crate) struct Batch {
    pub(crate) base: Quantity,
    pub(crate) moments: Vec<Moments>,
    pub(crate) factor: f64,
}

/// Those at one place.
pub(crate) struct Row<'c> {
    pub(crate) here: AtPoint<'c>,
    pub(crate) known: &'c [Batch],
    pub(crate) row: usize,
}

impl Integrals for Row<'_> {
    #[inline]
    fn moments(&mut self, base: Quantity, slope: bool) -> Result<(Moments, f64), ContactError> {
        match self.known.iter().find(|known| known.base == base) {
            Some(known) => Ok((known.moments[self.row], known.factor)),
            None => self.here.moments(base, slope),
        }
    }

    fn share(&mut self, regime: Regime) -> Result<(f64, f64), ContactError> {
        self.here.share(regime)
    }
}

/// The integrals at one place.
pub(crate) struct AtPoint<'c> {
    pub(crate) compiled: &'c Compiled,
    pub(crate) s: f64,
    pub(crate) at: At,
}

impl Integrals for AtPoint<'_> {
    #[inline]
    fn moments(&mut self, base: Quantity, slope: bool) -> Result<(Moments, f64), ContactError> {
        let channel = self.compiled.channel(base)?;
        let total = &channel.total;
        let moments = if slope { total.at(self.s) } else { total.value(self.s) };
        Ok((moments.map_err(failed(base, self.at))?, channel.units.factor))
    }

    fn share(&mut self, regime: Regime) -> Result<(f64, f64), ContactError> {
        let shares = self.compiled.shares_in(Quantity::Force, self.s, self.at)?;
        let of_regime = shares.iter().filter(|share| share.regime == regime);
        Ok(of_regime.fold((0.0, 0.0), |(sum, size), s| (sum + s.share, size + s.share.abs())))
    }
}

/// Force, area, stiffness and the number of contacts have laws.
const BASES: usize = 4;

/// The same, each integral once.
pub(crate) struct Cached<'c> {
    here: AtPoint<'c>,
    slopes: bool,
    known: [Option<(Quantity, (Moments, f64))>; BASES],
}

impl<'c> Cached<'c> {
    pub(crate) fn new(here: AtPoint<'c>, slopes: bool) -> Self {
        Self { here, slopes, known: [None; BASES] }
    }
}

impl Integrals for Cached<'_> {
    #[inline]
    fn moments(&mut self, base: Quantity, slope: bool) -> Result<(Moments, f64), ContactError> {
        let known = self.known.iter().flatten().find(|(known, _)| *known == base);
        if let Some((_, known)) = known {
            return Ok(*known);
        }
        match self.here.moments(base, self.slopes) {
            Ok(found) => {
                if let Some(free) = self.known.iter_mut().find(|known| known.is_none()) {
                    *free = Some((base, found));
                }
                Ok(found)
            }
            // A value is not refused for a slope that it does not need.
            Err(_) if self.slopes && !slope => self.here.moments(base, false),
            Err(error) => Err(error),
        }
    }

    fn share(&mut self, regime: Regime) -> Result<(f64, f64), ContactError> {
        self.here.share(regime)
    }
}
