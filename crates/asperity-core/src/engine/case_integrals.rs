//! The integrals of one case: shared if parts recur in other cases, otherwise made for its
//! separation.

use std::rc::Rc;
use std::sync::Arc;

use asperity_quadrature::{Density, Moments, Nearby, QuadratureError};

use crate::engine::averages::{Averages, all_parts};
use crate::engine::channel::Units;
use crate::engine::height_integral::{HeightIntegral, with_slope_within};
use crate::engine::inverse::force_at::Falls;
use crate::engine::laws::Laws;
use crate::engine::shapes::{LocalShape, RecentShapes};
use crate::error::integral_failed;
use crate::request::separation::Place;
use crate::{At, ContactError, Formula, HeightDistribution, Law, Part, Quantity, Scene, Tolerance};

/// The distance in s within which the bound of an integral holds.
const SETTLED: f64 = 1e-3;

/// How the integral of one part is obtained.
enum PartIntegral {
    /// For a part that recurs: rules for any scale.
    Shared(Rc<LocalShape>),
    /// Made for one s, and kept for its neighbourhood.
    Alone(Option<Nearby>),
}

/// The integral of one law of the case.
struct LawIntegrals<'c> {
    base: Quantity,
    law: &'c Law,
    units: Units,
    /// Part by part, for Gaussian heights; none for others.
    sources: Vec<PartIntegral>,
}

/// The integrals of one case.
pub(crate) struct CaseIntegrals<'c> {
    scene: &'c Scene,
    laws: &'c Laws,
    tolerance: Tolerance,
    law_integrals: Vec<LawIntegrals<'c>>,
    /// The place of the load for which they are, if it was found before.
    known: Option<Place>,
}

impl<'c> CaseIntegrals<'c> {
    /// The integrals of a single scene.
    pub(crate) fn alone(
        scene: &'c Scene,
        laws: &'c Laws,
        tolerance: Tolerance,
    ) -> Result<Self, ContactError> {
        Self::new(scene, laws, tolerance, |_, _| PartIntegral::Alone(None))
    }

    /// The integrals of a case among others: functions in the laws of its neighbours recur, and so
    /// do sums of powers.
    pub(crate) fn sharing(
        (shapes, neighbours): (&mut RecentShapes<'_>, [Option<&Laws>; 2]),
        scene: &'c Scene,
        laws: &'c Laws,
        tolerance: Tolerance,
    ) -> Result<Self, ContactError> {
        let mut place = 0;
        Self::new(scene, laws, tolerance, |(k, j), part| {
            let recurs = |other: &&Laws| {
                let other = other.laws.get(k).and_then(|(_, law)| law.parts.get(j));
                other.is_some_and(|other| part.recurs_in(other))
            };
            let shared =
                matches!(part.form, Formula::Powers(_)) || neighbours.iter().flatten().any(recurs);
            place += 1;
            match shared {
                true => PartIntegral::Shared(shapes.shape(place - 1, part)),
                false => PartIntegral::Alone(None),
            }
        })
    }

    /// `source` decides for each part, given the indices of its law and of itself.
    fn new(
        scene: &'c Scene,
        laws: &'c Laws,
        tolerance: Tolerance,
        mut source: impl FnMut((usize, usize), &Part) -> PartIntegral,
    ) -> Result<Self, ContactError> {
        let gaussian = matches!(scene.heights, HeightDistribution::Gaussian);
        let mut law_integrals = Vec::with_capacity(laws.laws.len());
        for (k, (base, law)) in laws.laws.iter().enumerate() {
            let units = Units::new(*base, law, scene)?;
            let parts = law.parts.iter().enumerate().filter(|_| gaussian);
            let sources = parts.map(|(j, part)| source((k, j), part)).collect();
            law_integrals.push(LawIntegrals { base: *base, law, units, sources });
        }
        Ok(Self { scene, laws, tolerance, law_integrals, known: None })
    }

    /// For a load whose place was found before.
    pub(crate) fn knowing(self, known: Option<Place>) -> Self {
        Self { known, ..self }
    }

    fn law(&mut self, base: Quantity) -> Result<&mut LawIntegrals<'c>, ContactError> {
        let found = self.law_integrals.iter_mut().find(|law| law.base == base);
        found.ok_or(ContactError::NotRequested { quantity: base })
    }
}

impl<'c> Averages<'c> for CaseIntegrals<'c> {
    fn scene(&self) -> &'c Scene {
        self.scene
    }

    fn laws(&self) -> &'c Laws {
        self.laws
    }

    fn tolerance(&self) -> Tolerance {
        self.tolerance
    }

    fn known(&self, at: &At) -> Option<Place> {
        self.known.filter(|_| !matches!(at, At::Separation(_)))
    }

    fn units(&self, base: Quantity) -> Result<Units, ContactError> {
        let found = self.law_integrals.iter().find(|law| law.base == base);
        Ok(found.ok_or(ContactError::NotRequested { quantity: base })?.units)
    }

    fn integral(
        &mut self,
        base: Quantity,
        (s, at): (f64, &At),
        slope: bool,
    ) -> Result<Moments, ContactError> {
        let (scene, tolerance) = (self.scene, self.tolerance);
        self.law(base)?.at(s, slope, scene, tolerance).map_err(integral_failed(base, at))
    }

    fn parts(
        &mut self,
        base: Quantity,
        (s, at): (f64, &At),
        slope: bool,
    ) -> Result<Vec<Moments>, ContactError> {
        let (scene, tolerance) = (self.scene, self.tolerance.relative());
        let of_law = self.law(base)?;
        let LawIntegrals { law, units, .. } = *of_law;
        if of_law.sources.is_empty() {
            let parts = law.parts.iter().map(|part| {
                let alone = Density { pieces: vec![part.piece()] };
                HeightIntegral::new(alone, law, scene, tolerance).once(s, slope)
            });
            return all_parts(parts, base, at);
        }
        let s = units.onset.shifted(s);
        let parts = law.parts.iter().zip(&mut of_law.sources).map(|(part, source)| {
            let (factor, moments) = source.at(part, (s, units.scale), slope, tolerance)?;
            Ok(Moments::NONE.plus(factor, &moments))
        });
        all_parts(parts, base, at)
    }

    fn rises_above(&self, s: f64) -> Result<bool, ContactError> {
        self.laws.rises_above(self.scene, s)
    }

    fn falls(&self) -> Result<Option<Arc<Falls>>, ContactError> {
        self.laws.falls(self.scene, self.tolerance)
    }

    fn settle(&mut self, base: Quantity, (s, at): (f64, &At)) -> Result<bool, ContactError> {
        let tolerance = self.tolerance;
        self.law(base)?.settle(s, tolerance).map_err(integral_failed(base, at))
    }
}

impl PartIntegral {
    /// The integral of a part at s and a scale, and its factor.
    fn at(
        &mut self,
        part: &Part,
        (s, scale): (f64, f64),
        slope: bool,
        tolerance: f64,
    ) -> Result<(f64, Moments), QuadratureError> {
        Ok(match self {
            Self::Shared(shape) if slope => (part.factor(), shape.0.integral.at(s, scale)?),
            Self::Shared(shape) => (part.factor(), shape.0.integral.value(s, scale)?),
            Self::Alone(Some(made)) if made.serves(s) => (1.0, made.at(s)),
            Self::Alone(made) => (1.0, made.insert(alone(part, scale, s, tolerance)?).at(s)),
        })
    }
}

impl LawIntegrals<'_> {
    /// The sum over the parts.
    fn at(
        &mut self,
        s: f64,
        slope: bool,
        scene: &Scene,
        tolerance: Tolerance,
    ) -> Result<Moments, QuadratureError> {
        let (Units { scale, onset, .. }, relative) = (self.units, tolerance.relative());
        if self.sources.is_empty() {
            let integral = HeightIntegral::new(self.law.density(), self.law, scene, relative);
            return integral.once(s, slope);
        }
        let (given, s, slope) = (s, onset.shifted(s), slope || onset.is_nonzero());
        let mut sum = Moments::NONE;
        for (part, source) in self.law.parts.iter().zip(&mut self.sources) {
            let (factor, m) = source.at(part, (s, scale), slope, relative)?;
            sum = sum.plus(factor, &m);
        }
        if slope {
            sum = with_slope_within(sum, || self.law.density(), (scale, s), relative);
        }
        Ok(onset.widened(given, sum))
    }

    /// Makes integrals for s if they were made too far from it for their bounds to hold; returns
    /// whether there were any.
    fn settle(&mut self, s: f64, tolerance: Tolerance) -> Result<bool, QuadratureError> {
        let (mut moved, s) = (false, self.units.onset.shifted(s));
        for (part, source) in self.law.parts.iter().zip(&mut self.sources) {
            let PartIntegral::Alone(made) = source else { continue };
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
