//! The integrals of one case: shared if parts recur in other cases, otherwise made for its
//! separation.

use std::rc::Rc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, PoisonError, RwLock};

use asperity_quadrature::{AnyScale, Moments, Nearby, QuadratureError};

use crate::engine::averages::Averages;
use crate::engine::height_integral::{HeightIntegral, LawUnits, with_slope_within};
use crate::engine::inverse::Halves;
use crate::engine::inverse::above::ROUGH;
use crate::engine::inverse::force_at::Falls;
use crate::engine::laws::Laws;
use crate::error::integral_failed;
use crate::scene::place::SeparationInSigma;
use crate::{At, ContactError, Formula, HeightDistribution, Law, Part, Quantity, Scene, Tolerance};

/// The distance in s within which the bound of an integral holds.
const SETTLED: f64 = 1e-3;

/// How the integral of one part is obtained.
enum PartIntegral {
    /// For a part that recurs: rules for any scale.
    Shared(Rc<LocalShape>),
    /// Made for one s to a tolerance, and kept for its neighbourhood.
    Alone(Option<(Nearby, f64)>),
}

/// The integral of one law of the case.
struct LawIntegrals<'c> {
    base: Quantity,
    law: &'c Law,
    units: LawUnits,
    /// Part by part, for Gaussian heights; none for others.
    sources: Vec<PartIntegral>,
}

/// The integrals of one case.
pub(crate) struct CaseIntegrals<'c> {
    scene: &'c Scene,
    laws: &'c Laws,
    law_integrals: Vec<LawIntegrals<'c>>,
    /// The separation of the load for which they are, if it was inverted before.
    inverted: Option<SeparationInSigma>,
}

impl<'c> CaseIntegrals<'c> {
    /// The integrals of a single scene.
    pub(crate) fn alone(scene: &'c Scene, laws: &'c Laws) -> Result<Self, ContactError> {
        Self::new(scene, laws, |_, _| PartIntegral::Alone(None))
    }

    /// The integrals of a case among others: functions in the laws of its neighbours recur, and so
    /// do sums of powers.
    pub(crate) fn sharing(
        (shapes, neighbours): (&mut RecentShapes<'_>, [Option<&Laws>; 2]),
        scene: &'c Scene,
        laws: &'c Laws,
    ) -> Result<Self, ContactError> {
        let mut count = 0;
        Self::new(scene, laws, |(k, j), part| {
            let recurs = |other: &&Laws| {
                let other = other.laws.get(k).and_then(|(_, law)| law.parts.get(j));
                other.is_some_and(|other| part.recurs_in(other))
            };
            let shared =
                matches!(part.form, Formula::Powers(_)) || neighbours.iter().flatten().any(recurs);
            count += 1;
            match shared {
                true => PartIntegral::Shared(shapes.shape(count - 1, part)),
                false => PartIntegral::Alone(None),
            }
        })
    }

    /// `source` decides for each part, given the indices of its law and of itself.
    fn new(
        scene: &'c Scene,
        laws: &'c Laws,
        mut source: impl FnMut((usize, usize), &Part) -> PartIntegral,
    ) -> Result<Self, ContactError> {
        let gaussian = matches!(scene.heights, HeightDistribution::Gaussian);
        let mut law_integrals = Vec::with_capacity(laws.laws.len());
        for (k, (base, law)) in laws.laws.iter().enumerate() {
            let units = LawUnits::new(*base, law, scene)?;
            let parts = law.parts.iter().enumerate().filter(|_| gaussian);
            let sources = parts.map(|(j, part)| source((k, j), part)).collect();
            law_integrals.push(LawIntegrals { base: *base, law, units, sources });
        }
        Ok(Self { scene, laws, law_integrals, inverted: None })
    }

    /// For a load that was inverted before.
    pub(crate) fn after(self, inverted: Option<SeparationInSigma>) -> Self {
        Self { inverted, ..self }
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

    fn inverted(&self, at: &At) -> Option<SeparationInSigma> {
        self.inverted.filter(|_| !matches!(at, At::Separation(_)))
    }

    fn factor(&self, base: Quantity) -> Result<f64, ContactError> {
        let found = self.law_integrals.iter().find(|law| law.base == base);
        Ok(found.ok_or(ContactError::NotRequested { quantity: base })?.units.factor)
    }

    fn integral(
        &mut self,
        base: Quantity,
        (s, at): (f64, &At),
        slope: bool,
    ) -> Result<(Moments, f64), ContactError> {
        let (scene, tolerance) = (self.scene, self.laws.tolerance.relative());
        let law = self.law(base)?;
        let moments = law.at(s, (slope, true), scene, tolerance);
        Ok((moments.map_err(integral_failed(base, at))?, law.units.factor))
    }

    fn rough_force(&mut self, s: f64) -> Result<Moments, ContactError> {
        let (scene, tolerance) = (self.scene, self.laws.tolerance.relative());
        let moments = self.law(Quantity::Force)?.at(s, (true, false), scene, tolerance);
        moments.map_err(integral_failed(Quantity::Force, &s.into()))
    }

    fn parts(&mut self, base: Quantity, (s, at): (f64, &At)) -> Result<Vec<Moments>, ContactError> {
        let (scene, tolerance) = (self.scene, self.laws.tolerance.relative());
        let LawIntegrals { law, units, sources, .. } = self.law(base)?;
        if sources.is_empty() || law.shares.is_some() {
            let alone = |part: &Part| {
                HeightIntegral::new(part.density(), law, scene, tolerance).once(s, false)
            };
            let parts = law.share_parts().iter().map(alone).collect::<Result<_, _>>();
            return parts.map_err(integral_failed(base, at));
        }
        let s = units.onset.shifted(s);
        let parts = law.parts.iter().zip(sources).map(|(part, source)| {
            let (factor, moments) = source.at(part, (s, units.scale), false, tolerance)?;
            Ok(Moments::NONE.plus(factor, &moments))
        });
        parts.collect::<Result<_, _>>().map_err(integral_failed(base, at))
    }

    fn rises_above(&self, s: f64) -> Result<bool, ContactError> {
        self.laws.rises_above(self.scene, s)
    }

    fn halves(&mut self, s: f64) -> Result<Option<Halves>, ContactError> {
        let tolerance = self.laws.tolerance.relative();
        let halves = self.law(Quantity::Force)?.halves(s, tolerance);
        halves.map_err(integral_failed(Quantity::Force, &s.into()))
    }

    fn falls(&self) -> Result<Option<Arc<Falls>>, ContactError> {
        self.laws.falls(self.scene)
    }

    fn settle(&mut self, base: Quantity, (s, at): (f64, &At)) -> Result<bool, ContactError> {
        let tolerance = self.laws.tolerance.relative();
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
            Self::Alone(Some((made, to))) if *to <= tolerance && made.serves(s) => {
                (1.0, made.at(s))
            }
            Self::Alone(made) => {
                let new = Nearby::new(&part.density(), scale, s, tolerance)?;
                (1.0, made.insert((new, tolerance)).0.at(s))
            }
        })
    }
}

impl LawIntegrals<'_> {
    /// The sum over the parts: its slope may miss the tolerance far below 0, unless it is `within`.
    fn at(
        &mut self,
        s: f64,
        (slope, within): (bool, bool),
        scene: &Scene,
        tolerance: f64,
    ) -> Result<Moments, QuadratureError> {
        let LawUnits { scale, onset, .. } = self.units;
        if self.sources.is_empty() {
            let integral = HeightIntegral::new(self.law.density(), self.law, scene, tolerance);
            return integral.once(s, slope);
        }
        let (given, s, slope) = (s, onset.shifted(s), slope || onset.is_nonzero());
        let mut sum = Moments::NONE;
        // A search is settled where it ends.
        let enough = if within { tolerance } else { tolerance.max(ROUGH) };
        for (part, source) in self.law.parts.iter().zip(&mut self.sources) {
            let (factor, m) = source.at(part, (s, scale), slope, enough)?;
            sum = sum.plus(factor, &m);
        }
        if slope && within {
            let finer = |tolerance| self.law.density().finer(tolerance);
            sum = with_slope_within(sum, finer, (scale, s), tolerance);
        }
        Ok(onset.widened(given, sum))
    }

    /// The sums over the added and over the subtracted parts, both as positive.
    fn halves(&mut self, s: f64, tolerance: f64) -> Result<Option<Halves>, QuadratureError> {
        if self.sources.is_empty() || self.units.onset.is_nonzero() {
            return Ok(None);
        }
        let (scale, mut halves) = (self.units.scale, [Moments::NONE; 2]);
        for (part, source) in self.law.parts.iter().zip(&mut self.sources) {
            let (factor, m) = match source {
                PartIntegral::Alone(made) => match made {
                    Some((made, _)) if (made.from() - s).abs() <= SETTLED => (1.0, made.at(s)),
                    _ => (1.0, Nearby::new(&part.density(), scale, s, ROUGH)?.at(s)),
                },
                shared => shared.at(part, (s, scale), true, tolerance)?,
            };
            let m = Moments::NONE.plus(factor, &m);
            // Where a sum of numbers is as large as the sum of their sizes, all have one sign.
            if m.value.abs() < (1.0 - 1e-12) * m.sizes[0] {
                return Ok(None);
            }
            let (half, sign) = if m.value < 0.0 { (1, -1.0) } else { (0, 1.0) };
            halves[half] = halves[half].plus(sign, &m);
        }
        Ok(Some(halves))
    }

    /// Makes integrals for s if they were made too far from it for their bounds to hold; returns
    /// whether there were any.
    fn settle(&mut self, s: f64, tolerance: f64) -> Result<bool, QuadratureError> {
        let (mut moved, s) = (false, self.units.onset.shifted(s));
        for (part, source) in self.law.parts.iter().zip(&mut self.sources) {
            let PartIntegral::Alone(made) = source else { continue };
            let settled =
                |(made, to): &(Nearby, f64)| *to <= tolerance && (made.from() - s).abs() <= SETTLED;
            if !made.as_ref().is_some_and(settled) {
                let new = Nearby::new(&part.density(), self.units.scale, s, tolerance)?;
                *made = Some((new, tolerance));
                moved = true;
            }
        }
        Ok(moved)
    }
}

/// Number of shapes kept.
const SHAPES: usize = 64;

/// A part of a law without its factor, and its integral.
#[derive(Debug)]
pub(crate) struct Shape {
    part: Part,
    pub(crate) integral: AnyScale,
    /// Whether the shape has recurred.
    recurs: AtomicBool,
}

/// The shapes of all threads.
#[derive(Debug, Default)]
pub(crate) struct Shapes(RwLock<Vec<Arc<Shape>>>);

impl Shapes {
    /// The shape of a part, new or kept.
    fn shape(&self, part: &Part, tolerance: Tolerance) -> Arc<Shape> {
        let known = |shapes: &[Arc<Shape>]| shapes.iter().find(|s| s.part.recurs_in(part)).cloned();
        let shapes = self.0.read().unwrap_or_else(PoisonError::into_inner);
        if let Some(shape) = known(&shapes) {
            shape.recurs.store(true, Ordering::Relaxed);
            return shape;
        }
        drop(shapes);
        let mut shapes = self.0.write().unwrap_or_else(PoisonError::into_inner);
        // Another thread may have added it meanwhile.
        if let Some(shape) = known(&shapes) {
            return shape;
        }
        let part = part.without_factor();
        let integral = AnyScale::new(part.density(), tolerance.relative());
        let shape = Arc::new(Shape { part, integral, recurs: AtomicBool::new(false) });
        if shapes.len() >= SHAPES {
            shapes.retain(|shape| shape.recurs.load(Ordering::Relaxed));
        }
        if shapes.len() < SHAPES {
            shapes.push(shape.clone());
        }
        shape
    }
}

/// A shape of all threads, counted within one: no row writes what another thread reads.
pub(crate) struct LocalShape(pub(crate) Arc<Shape>);

/// One thread's view of the shapes.
pub(crate) struct RecentShapes<'s> {
    shapes: &'s Shapes,
    tolerance: Tolerance,
    /// Shapes of the previous case, part by part: mostly the next one's as well.
    recent: Vec<Rc<LocalShape>>,
}

impl<'s> RecentShapes<'s> {
    pub(crate) fn new(shapes: &'s Shapes, tolerance: Tolerance) -> Self {
        Self { shapes, tolerance, recent: vec![] }
    }

    /// The shape of a part, at its place in the laws of a case.
    pub(crate) fn shape(&mut self, place: usize, part: &Part) -> Rc<LocalShape> {
        if let Some(shape) = self.recent.get(place)
            && shape.0.part.recurs_in(part)
        {
            return shape.clone();
        }
        let shape = Rc::new(LocalShape(self.shapes.shape(part, self.tolerance)));
        if place >= self.recent.len() {
            self.recent.resize(place + 1, shape.clone());
        }
        self.recent[place] = shape.clone();
        shape
    }
}
