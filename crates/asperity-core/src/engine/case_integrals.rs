//! The integrals of one case of a sweep: shared where parts recur, made where they are asked for
//! where they do not.

use std::rc::Rc;

use asperity_quadrature::{Density, Moments, Nearby, QuadratureError};

use crate::engine::case::{LocalShape, Worker};
use crate::engine::channel::{Laws, Units, failed};
use crate::engine::height_integral::HeightIntegral;
use crate::engine::inverse::force_at::{Falls, ForceAt};
use crate::engine::inverse::{ForceCurve, Target, check_load};
use crate::engine::readings::{Integrals, Reading};
use crate::request::separation::Place;
use crate::{
    At, ContactError, Formula, HeightDistribution, Law, Part, Quantity, Regime, Scene, Tolerance,
};

/// Nearer than this to where an integral was made, its bound holds as good as there.
const SETTLED: f64 = 1e-3;

/// How the integral of one part is come by.
enum Source {
    /// It recurs: rules for any scale.
    Shared(Rc<LocalShape>),
    /// Made for one s, and kept for its neighbourhood.
    Alone(Option<Nearby>),
}

/// One law of the case.
struct OfLaw<'c> {
    base: Quantity,
    law: &'c Law,
    units: Units,
    /// Part by part, for Gaussian heights; none for others.
    sources: Vec<Source>,
}

/// The integrals of one case.
pub(crate) struct CaseIntegrals<'c> {
    scene: &'c Scene,
    laws: &'c Laws,
    tolerance: Tolerance,
    of_laws: Vec<OfLaw<'c>>,
    /// Where they are asked for.
    at: At,
    s: f64,
}

impl<'c> CaseIntegrals<'c> {
    /// Nothing recurs.
    pub(crate) fn alone(
        scene: &'c Scene,
        laws: &'c Laws,
        tolerance: Tolerance,
    ) -> Result<Self, ContactError> {
        let gaussian = matches!(scene.heights, HeightDistribution::Gaussian);
        let of_law = |(base, law): &'c (Quantity, Law)| {
            let units = Units::new(*base, law, scene)?;
            let parts = law.parts.iter().filter(|_| gaussian);
            let sources = parts.map(|_| Source::Alone(None)).collect();
            Ok(OfLaw { base: *base, law, units, sources })
        };
        let of_laws = laws.laws.iter().map(of_law).collect::<Result<_, ContactError>>()?;
        Ok(Self { scene, laws, tolerance, of_laws, at: At::sigmas(0.0), s: 0.0 })
    }

    /// Functions of the neighbours' laws recur, and so do sums of powers.
    pub(crate) fn new(
        worker: &mut Worker<'_>,
        scene: &'c Scene,
        laws: &'c Laws,
        neighbours: [Option<&Laws>; 2],
    ) -> Result<Self, ContactError> {
        let gaussian = matches!(scene.heights, HeightDistribution::Gaussian);
        let mut place = 0;
        let mut of_laws = Vec::with_capacity(laws.laws.len());
        for (k, (base, law)) in laws.laws.iter().enumerate() {
            let units = Units::new(*base, law, scene)?;
            let mut sources = vec![];
            for (j, part) in law.parts.iter().enumerate().filter(|_| gaussian) {
                let recurs = |other: &&Laws| {
                    let other = other.laws.get(k).and_then(|(_, law)| law.parts.get(j));
                    other.is_some_and(|other| part.recurs_in(other))
                };
                let shared = matches!(part.form, Formula::Powers(_))
                    || neighbours.iter().flatten().any(recurs);
                sources.push(match shared {
                    true => Source::Shared(worker.shape(place, part)),
                    false => Source::Alone(None),
                });
                place += 1;
            }
            of_laws.push(OfLaw { base: *base, law, units, sources });
        }
        let tolerance = worker.sweep.tolerance;
        Ok(Self { scene, laws, tolerance, of_laws, at: At::sigmas(0.0), s: 0.0 })
    }

    /// Goes to where the case is asked about.
    pub(crate) fn reading(&mut self, at: At) -> Result<Reading<'c>, ContactError> {
        let load_of = |field, load| check_load(field, load, self.laws.adhesive);
        let place = match at {
            At::Separation(separation) => separation.place(self.scene)?,
            At::Load(load) => self.place_of_load(load_of("load", load)?)?,
            At::Pressure(pressure) => {
                let pressure = load_of("pressure", pressure)?;
                self.place_of_load(pressure * self.scene.nominal_area)?
            }
        };
        (self.at, self.s) = (at, place.s);
        let Laws { own_stiffness, .. } = *self.laws;
        Ok(Reading { scene: self.scene, own_stiffness, tolerance: self.tolerance, place, at })
    }

    fn place_of_load(&mut self, load: f64) -> Result<Place, ContactError> {
        let (scene, tolerance) = (self.scene, self.tolerance);
        let of_law = self.of_law(Quantity::Force)?;
        let (target, law) = (Target { load, factor: of_law.units.factor }, of_law.law);
        let falls = Falls::of(law, scene, tolerance);
        let total = || HeightIntegral::new(law.density(), law, scene, tolerance.relative());
        let total = falls.as_ref().map(|_| total());
        let falling = falls.as_ref().zip(total.as_ref());
        let falling = falling.map(|(falls, total)| ForceAt { total, falls });
        target.first(OfForce { of_law, scene, tolerance }, falling)
    }

    fn of_law(&mut self, base: Quantity) -> Result<&mut OfLaw<'c>, ContactError> {
        let found = self.of_laws.iter_mut().find(|of_law| of_law.base == base);
        found.ok_or(ContactError::NotRequested { quantity: base })
    }
}

impl Integrals for CaseIntegrals<'_> {
    fn moments(&mut self, base: Quantity, slope: bool) -> Result<(Moments, f64), ContactError> {
        let (s, at, scene, tolerance) = (self.s, self.at, self.scene, self.tolerance);
        let of_law = self.of_law(base)?;
        of_law.settle(s, tolerance).map_err(failed(base, at))?;
        let moments = of_law.at(s, slope, scene, tolerance).map_err(failed(base, at))?;
        Ok((moments, of_law.units.factor))
    }

    fn share(&mut self, regime: Regime) -> Result<(f64, f64), ContactError> {
        let (s, at, scene, tolerance) = (self.s, self.at, self.scene, self.tolerance);
        let (total, _) = self.moments(Quantity::Force, false)?;
        let OfLaw { law, units, .. } = *self.of_law(Quantity::Force)?;
        let (mut share, mut size) = (0.0, 0.0);
        for part in law.parts.iter().filter(|part| part.regime == regime) {
            let part = if matches!(scene.heights, HeightDistribution::Gaussian) {
                let seen = units.begins.seen(s);
                alone(part, units.scale, seen, tolerance.relative()).map(|made| made.at(seen))
            } else {
                let density = Density { pieces: vec![part.piece()] };
                HeightIntegral::new(density, law, scene, tolerance.relative()).once(s, false)
            };
            let part = part.map_err(failed(Quantity::Force, at))?;
            let one = part.value / total.value * (part.ln_scale - total.ln_scale).exp();
            share += one;
            size += one.abs();
        }
        Ok((share, size))
    }
}

/// The force, to be inverted.
struct OfForce<'c, 'l> {
    of_law: &'c mut OfLaw<'l>,
    scene: &'l Scene,
    tolerance: Tolerance,
}

impl ForceCurve for OfForce<'_, '_> {
    fn at(&mut self, s: f64) -> Result<Moments, ContactError> {
        let found = self.of_law.at(s, true, self.scene, self.tolerance);
        found.map_err(failed(Quantity::Force, s.into()))
    }

    fn settle(&mut self, s: f64) -> Result<bool, ContactError> {
        let settled = self.of_law.settle(s, self.tolerance);
        settled.map_err(failed(Quantity::Force, s.into()))
    }
}

impl OfLaw<'_> {
    /// The sum over the parts.
    fn at(
        &mut self,
        s: f64,
        slope: bool,
        scene: &Scene,
        tolerance: Tolerance,
    ) -> Result<Moments, QuadratureError> {
        let (Units { scale, begins, .. }, relative) = (self.units, tolerance.relative());
        if self.sources.is_empty() {
            let integral = HeightIntegral::new(self.law.density(), self.law, scene, relative);
            return integral.once(s, slope);
        }
        let (given, s, slope) = (s, begins.seen(s), slope || begins.elsewhere());
        let mut sum = Moments::NONE;
        for (part, source) in self.law.parts.iter().zip(&mut self.sources) {
            let (factor, m) = match source {
                Source::Shared(shape) if slope => (part.factor(), shape.0.integral.at(s, scale)?),
                Source::Shared(shape) => (part.factor(), shape.0.integral.value(s, scale)?),
                Source::Alone(made) => {
                    if !made.as_ref().is_some_and(|made| made.serves(s)) {
                        *made = Some(alone(part, scale, s, relative)?);
                    }
                    (1.0, made.as_ref().map_or(sum, |made| made.at(s)))
                }
            };
            sum = sum.plus(factor, &m);
        }
        Ok(begins.widened(given, sum))
    }

    /// Makes integrals anew that were made too far from s for their bounds to hold; tells whether
    /// there were any.
    fn settle(&mut self, s: f64, tolerance: Tolerance) -> Result<bool, QuadratureError> {
        let (mut moved, s) = (false, self.units.begins.seen(s));
        for (part, source) in self.law.parts.iter().zip(&mut self.sources) {
            let Source::Alone(made) = source else { continue };
            if !made.as_ref().is_some_and(|made| (made.from() - s).abs() <= SETTLED) {
                *made = Some(alone(part, self.units.scale, s, tolerance.relative())?);
                moved = true;
            }
        }
        Ok(moved)
    }
}

/// One part, integrated for one s.
fn alone(part: &Part, scale: f64, s: f64, tolerance: f64) -> Result<Nearby, QuadratureError> {
    Nearby::new(&Density { pieces: vec![part.piece()] }, scale, s, tolerance)
}
