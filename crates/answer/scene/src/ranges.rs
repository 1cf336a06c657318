//! Numbers that are known within a range, and the scene at points of the ranges.

use asperity::{Body, Code, ContactError, Finding, Interface, Severity};

use crate::error::{Place, SceneError};
use crate::input::SceneInput;
use crate::materials::METALS_HARDNESS_OVER_YIELD;
use crate::roughness::Roughness;
use crate::scene_file::SceneFile;
use crate::spec::{Bodies, Description, SceneSpec};
use crate::unknown::Unknown;

/// The number of unknowns up to which every combination of ends is taken.
const FULL: usize = 7;
/// The number of points inside the ranges.
const INSIDE: usize = 64;
/// Relative difference of two hardnesses of which one is barely smaller.
const BARELY: f64 = 1e-6;
/// Of a Halton sequence every 409th point is taken: neighbours of large bases are alike.
const LEAP: usize = 409;

/// A scene in the middle of its ranges and at points of them: first at combinations of their ends,
/// then at 64 fixed points inside (a Halton sequence).
///
/// Up to seven unknowns all combinations of ends are taken. Of more there are 128, in which any
/// three unknowns have all combinations of their ends equally often: the end beyond the seventh is
/// the parity of three or more of the first seven.
#[derive(Debug, Clone)]
pub struct Points {
    /// The scene in the middle of the ranges.
    pub middle: SceneFile,
    /// The scenes at the points; none where every number is known.
    pub all: Vec<SceneFile>,
    /// The numbers with a range.
    pub unknowns: Vec<Unknown>,
    /// For each point the share of each range, from 0 at its lower end to 1 at its upper one.
    pub shares: Vec<Vec<f64>>,
}

impl Points {
    /// The warnings at points with codes that are not `known` in the middle: one of each code, with
    /// the largest excess over its usual range.
    #[must_use]
    pub fn worst<'f>(
        known: &[Finding],
        at_points: impl Iterator<Item = &'f Finding>,
    ) -> Vec<Finding> {
        let mut new: Vec<&Finding> = vec![];
        let is_new = |found: &Finding| known.iter().all(|known| known.code != found.code);
        for found in at_points.filter(|one| one.severity < Severity::Note && is_new(one)) {
            match new.iter_mut().find(|known| known.code == found.code) {
                Some(known) if found.excess() > known.excess() => *known = found,
                Some(_) => {}
                None => new.push(found),
            }
        }
        new.into_iter().map(|found| found.clone().from_origin("within the ranges")).collect()
    }

    /// For each combination of ends whether each unknown is at its upper end.
    pub fn corners(&self) -> impl Iterator<Item = Vec<bool>> {
        let corners = self.shares.len().saturating_sub(INSIDE);
        self.shares[..corners].iter().map(|all| all.iter().map(|share| *share > 0.5).collect())
    }

    /// The ratio of a positive number between the ends of each unknown, as a logarithm, by its
    /// logarithms at the points: the mean over all combinations of the other ends.
    #[must_use]
    pub fn effects(&self, logs: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.unknowns.len()];
        for (uppers, log) in self.corners().zip(logs) {
            for (sum, is_upper) in sums.iter_mut().zip(uppers) {
                *sum += if is_upper { *log } else { -log };
            }
        }
        let corners = self.corners().count() as f64;
        sums.into_iter().map(|sum| (2.0 * sum / corners).abs()).collect()
    }
}

impl Points {
    /// Pairs of an unknown and its share of its range at which one of two bodies is barely softer
    /// than the other, at both ends of what their ranges of hardness have in common: answers jump
    /// there, as they follow from the softer body.
    #[must_use]
    pub fn equally_hard(&self) -> Vec<[(usize, f64); 2]> {
        let place = |name: &str| self.unknowns.iter().position(|one| one.name == name);
        let Some(of) = place("body1_hardness").zip(place("body2_hardness")) else { return vec![] };
        let of = <[usize; 2]>::from(of);
        let both = of.map(|k| &self.unknowns[k]);
        let lower = both[0].ends[0].max(both[1].ends[0]);
        let upper = both[0].ends[1].min(both[1].ends[1]);
        let at =
            |end: f64, factors: [f64; 2]| [0, 1].map(|k| (of[k], both[k].share(end * factors[k])));
        let ends = [(lower, 1.0 + BARELY), (upper, 1.0 - BARELY)];
        let pairs = ends
            .into_iter()
            .flat_map(|(end, other)| [at(end, [1.0, other]), at(end, [other, 1.0])]);
        if lower < upper { pairs.collect() } else { vec![] }
    }
}

/// The shares of the ranges of some unknowns at each point.
fn shares(unknowns: usize) -> Vec<Vec<f64>> {
    let full = unknowns.min(FULL);
    let is_parity = |mask: &usize| mask.count_ones() > 1 && mask.count_ones() % 2 == 1;
    let own = (0..full).map(|unknown| 1 << unknown);
    let masks: Vec<usize> =
        own.chain((0..1 << full).filter(is_parity)).cycle().take(unknowns).collect();
    let corner =
        |k: usize| masks.iter().map(|mask| f64::from((k & mask).count_ones() % 2)).collect();
    let bases = (2..).filter(|base| (2..*base).all(|divisor| base % divisor != 0));
    let bases: Vec<usize> = bases.take(unknowns).collect();
    let inside = |k: usize| bases.iter().map(|base| reversed(k * LEAP, *base)).collect();
    (0..1 << full).map(corner).chain((1..=INSIDE).map(inside)).collect()
}

/// The digits of a number, reversed behind the point.
fn reversed(mut number: usize, base: usize) -> f64 {
    let (mut share, mut place) = (0.0, 1.0);
    while number > 0 {
        place /= base as f64;
        share += place * (number % base) as f64;
        number /= base;
    }
    share
}

impl Bodies {
    /// The bodies with each hardness that follows from a yield strength alone taken where `take`
    /// says, in the place of that strength unless hardening is described by a tangent modulus; of a
    /// body that is harder than the other in any case in the middle.
    pub(crate) fn settled(&self, take: &mut dyn FnMut(Unknown) -> f64) -> Self {
        let [from, to] = METALS_HARDNESS_OVER_YIELD;
        let mut settled = self.clone();
        // Hardness, yield strength, and whether hardening is described, of each by its name.
        let all: Vec<_> = match &mut settled {
            Self::Interface(of) => {
                let hardens = of.tangent_modulus.is_some();
                vec![("hardness", &mut of.hardness, &mut of.yield_strength, hardens)]
            }
            Self::Each { bodies, .. } => {
                let named = bodies.iter_mut().zip(["body1_hardness", "body2_hardness"]);
                named
                    .map(|(of, name)| {
                        let hardens = of.tangent_modulus.is_some();
                        (name, &mut of.hardness, &mut of.yield_strength, hardens)
                    })
                    .collect()
            }
        };
        let upper = all.iter().filter_map(|(_, hardness, of, _)| hardness.or(of.map(|of| to * of)));
        let most = upper.fold(f64::INFINITY, f64::min);
        for (name, hardness, of, hardens) in all {
            let Some(strength) = of.filter(|of| hardness.is_none() && *of > 0.0) else { continue };
            let source =
                format!("{from} to {to} times the yield strength, as of nine of ten materials");
            let (name, narrowed) = (name.into(), "a hardness, such as \"150 HV\"");
            let (ends, status) = ([from * strength, to * strength], "assumed");
            let one = Unknown { name, ends, status, source, narrowed };
            *hardness = Some(if ends[0] > most { one.middle() } else { take(one) });
            *of = of.filter(|_| hardens);
        }
        settled
    }

    /// The properties of both together, with each hardness in the middle of its range.
    pub(crate) fn middle(&self) -> Result<Interface, ContactError> {
        self.settled(&mut |one| one.middle()).interface()
    }
}

impl SceneSpec {
    /// The yield strength of the weaker of curved bodies \[Pa\], if one was written without a
    /// hardness.
    pub(crate) fn strength(&self) -> Option<f64> {
        let alone = |hardness: Option<f64>, of: Option<f64>| of.filter(|_| hardness.is_none());
        let hardened = |hardness: f64| hardness / asperity::HARDNESS_OVER_YIELD;
        let written = match &self.bodies {
            Bodies::Interface(of) => alone(of.hardness, of.yield_strength),
            Bodies::Each { bodies, .. } => {
                let mut all = bodies.iter();
                let is_alone = all.any(|of| alone(of.hardness, of.yield_strength).is_some());
                let of = |of: &Body| of.yield_strength.or(of.hardness.map(hardened));
                let least = bodies.iter().filter_map(of).min_by(f64::total_cmp);
                least.filter(|_| is_alone)
            }
        };
        written.or(self.curvature?.strength)
    }

    /// What was written, with the numbers that follow within ranges from others taken where `take`
    /// says.
    fn settled(&self, take: &mut dyn FnMut(Unknown) -> f64) -> Result<Self, ContactError> {
        let mut settled = Self { bodies: self.bodies.settled(take), ..self.clone() };
        if let Some(curvature) = &mut settled.curvature {
            curvature.strength = self.strength();
        }
        for (section, one) in self.surfaces() {
            let drawing = one.drawing();
            let Some(drawing) = drawing.filter(|drawing| drawing.is_open()) else { continue };
            let mut number = |mut one: Unknown| {
                one.name = SceneInput { section, key: "" }.name() + &one.name;
                if one.is_open() { take(one) } else { one.ends[0] }
            };
            let [height, ..] = drawing.unknowns()?;
            let rq = number(height);
            let [_, slope, bandwidth] = drawing.with_rq(rq)?.unknowns()?;
            let numbers = [rq, number(slope), number(bandwidth)];
            if let Some(one) = settled.surface_mut(section) {
                one.by = Description::Numbers(Roughness::of_profile(numbers));
            }
        }
        Ok(settled)
    }
}

impl SceneFile {
    /// The numbers that are known within a range, each of its own: those written, then those of
    /// yield strengths and finishes.
    #[must_use]
    pub fn unknowns(&self) -> Vec<Unknown> {
        let mut all: Vec<Unknown> = self.ranges.iter().map(|(_, one)| one.clone()).collect();
        // A refusal is that of the scene.
        let _ = self.spec.settled(&mut |one| {
            let middle = one.middle();
            all.push(one);
            middle
        });
        all
    }

    /// The unknowns; those that follow from others have the ends between these.
    pub(crate) fn unknowns_between(&self) -> Result<Vec<Unknown>, ContactError> {
        let mut all = self.unknowns();
        // All combinations of ends, of many ranges those of the first.
        for corner in 0..1_usize << self.ranges.len().min(FULL) {
            let end = |k: usize| ((corner >> k) & 1) as f64;
            let written = self.ranges.iter().enumerate();
            let written = written.map(|(k, (input, one))| (*input, one.at(end(k))));
            let there = self.with_inputs(written)?.unknowns();
            for one in &mut all {
                for other in there.iter().filter(|other| other.name == one.name) {
                    one.ends[0] = one.ends[0].min(other.ends[0]);
                    one.ends[1] = one.ends[1].max(other.ends[1]);
                }
            }
        }
        Ok(all)
    }

    /// The scene with its unknowns at these shares of their ranges; it has no unknowns.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn at(&self, shares: &[f64]) -> Result<Self, ContactError> {
        let mut shares = shares.iter().copied();
        let written = self.ranges.iter();
        let written: Vec<_> =
            written.zip(shares.by_ref()).map(|((input, one), at)| (*input, one.at(at))).collect();
        let edited = if written.is_empty() { self } else { &self.with_inputs(written)? };
        let mut take = |one: Unknown| one.at(shares.next().unwrap_or(0.5));
        let made = Self::of_spec(edited.spec.settled(&mut take)?)?;
        let (warnings, origin) = (self.warnings.clone(), self.origin.clone());
        Ok(Self { warnings, origin, ..made })
    }

    /// The scene [there](Self::at) as a point of the ranges, whose answers are ends of those of
    /// this scene.
    ///
    /// # Errors
    /// The errors of [`at`](Self::at).
    pub fn point(&self, shares: &[f64]) -> Result<Self, ContactError> {
        Ok(Self { within_ranges: true, ..self.at(shares)? })
    }

    /// The scene in the middle of its ranges and at points of them.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn points(&self) -> Result<Points, ContactError> {
        let unknowns = self.unknowns();
        let shares = if unknowns.is_empty() { vec![] } else { shares(unknowns.len()) };
        let all = shares.iter().map(|shares| self.point(shares)).collect::<Result<_, _>>()?;
        let within_ranges = !unknowns.is_empty();
        let middle = Self { within_ranges, ..self.middle()? };
        Ok(Points { middle, all, unknowns, shares })
    }

    /// Whether the nominal area, or the seal from which it follows, has no range.
    #[must_use]
    pub fn has_fixed_area(&self) -> bool {
        let count = self.unknowns().len();
        let area =
            |share: f64| Some(self.at(&vec![share; count]).ok()?.scene.nominal_area.to_bits());
        count == 0 || area(0.0) == area(1.0)
    }

    /// The scene in the middle of its ranges.
    ///
    /// # Errors
    /// The errors of [`at`](Self::at).
    pub fn middle(&self) -> Result<Self, ContactError> {
        match self.unknowns().len() {
            0 => Ok(self.clone()),
            all => self.at(&vec![0.5; all]),
        }
    }

    /// The scene with every unknown at one `end` of its range, `lower` or `upper`, or in its
    /// `middle`, for an answer in single numbers, and a note that names the ranges, if there are
    /// any.
    ///
    /// # Errors
    /// [`SceneError::Refused`] for another word, and for numbers that no scene has.
    pub fn taken_at(&self, end: &str) -> Result<(Self, Option<Finding>), SceneError> {
        let refused = |reason: String| SceneError::refused(Place::field("at"), reason);
        let (share, place) = match end {
            "lower" => (0.0, "at the lower end"),
            "middle" => (0.5, "in the middle"),
            "upper" => (1.0, "at the upper end"),
            _ => return Err(refused(format!("{end:?} is none of lower, middle and upper"))),
        };
        let unknowns = self.unknowns();
        if unknowns.is_empty() {
            return Ok((self.clone(), None));
        }
        let taken = self.at(&vec![share; unknowns.len()]);
        let taken = taken.map_err(|error| refused(error.to_string()))?;
        // Where no scene has a combination of ends, those beside the middle of the others.
        let ranges = self.unknowns_between().unwrap_or(unknowns);
        let ranges = ranges.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
        let found = Finding::note(Code::TakenAt, "at", share)
            .fact(format!("calculated {place} of the ranges of {ranges}"))
            .advice("a value with every number at its lower or its upper end need not be an end of the answer: curve and answer, in Python ranges and answer, give these");
        Ok((taken, Some(found)))
    }
}
