//! Search for the points of ranges at which numbers are smallest and largest.

use std::collections::BTreeMap;

use asperity_scene::Points;

/// The first and the last step about the points at which a number is smallest or largest, as shares
/// of the ranges, and the factor between steps. From the ends of ranges only the first is taken: a
/// number that falls over it rises by little before.
const STEPS: [f64; 2] = [0.12, 0.006];
const FINER: f64 = 0.4;
/// The number of steps of a search.
const MOST: usize = 9;
/// How far a step moves an end that is found, as a share of the distance of both.
const SETTLED: f64 = 0.003;
/// Beside a pole, the last step moves an end by more than this share, or all of them move both
/// apart by this factor.
const GROWING: f64 = 0.05;
const GROWN: f64 = 4.0;
/// How far numbers may exceed others, for errors of solutions.
const FLAT: f64 = 1e-5;
/// The number of points between the combinations of ends at which curved bodies are solved.
const FEW: usize = 8;

/// The numbers of a sheet, row by row, where they are there.
pub type Numbers = Vec<Option<f64>>;

/// Why a number has no ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoEnds {
    /// It is missing at a point of the ranges.
    Missing,
    /// It grows without end, as beside a pole.
    Growing,
}

impl NoEnds {
    /// The reason, as messages have it.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Missing => "there is no value at a point of the ranges",
            Self::Growing => {
                "the values grow without end within the ranges, as a ratio does where its denominator passes 0"
            }
        }
    }
}

/// The points at which answers are looked for, each by the share of each range.
#[derive(Debug, Clone)]
pub struct Search {
    first: Vec<Vec<f64>>,
    corners: usize,
    /// Where answers jump as the softer body changes.
    equally_hard: Vec<[(usize, f64); 2]>,
    /// Whether each point is a solution: numbers are sought only if they exceed the ends.
    is_costly: bool,
}

impl Search {
    /// Over these points; of `curved` bodies over the first eight between the ends.
    #[must_use]
    pub fn over(points: &Points, curved: bool) -> Self {
        let corners = points.corners().count();
        let few = if curved { corners + FEW } else { points.shares.len() };
        let first = points.shares.iter().take(few).cloned().collect();
        Self { first, corners, equally_hard: points.equally_hard(), is_costly: curved }
    }

    /// How many of the points, from the first, need all numbers.
    #[must_use]
    pub fn first(&self) -> usize {
        self.first.len()
    }

    /// The smallest and the largest of each number by those at the [first](Self::first) points and
    /// in the middle; `fill` gives the numbers at others, in steps that become smaller, where one
    /// of the ends of a number is `sought` (of an end of an interval, that one). Each number has
    /// its own points, so that its ends are the same whatever is asked beside it.
    ///
    /// # Errors
    /// The errors of `fill`.
    pub fn ends<E>(
        &self,
        middle: &[Option<f64>],
        first: Vec<Numbers>,
        sought: &[[bool; 2]],
        mut fill: impl FnMut(&[Vec<f64>]) -> Result<Vec<Numbers>, E>,
    ) -> Result<Vec<Result<[f64; 2], NoEnds>>, E> {
        let mut known = Known::new(&self.first, first);
        let own = |place: usize| {
            let is_sought = sought[place].contains(&true);
            is_sought.then(|| Seeker::new(place, &known, self)).flatten()
        };
        let mut seekers: Vec<Option<Seeker>> = (0..middle.len()).map(own).collect();
        // Of many unknowns not all combinations of ends are there.
        for step in 0..=MOST {
            let before = known.shares.len();
            for seeker in seekers.iter_mut().flatten().filter(|seeker| seeker.step > STEPS[1]) {
                match step {
                    0 => seeker.add_corners(&mut known, self),
                    _ => seeker.seek(&mut known, step == 1, sought[seeker.place]),
                }
            }
            let new = fill(&known.shares[before..])?;
            known.numbers.extend(new);
            for seeker in seekers.iter_mut().flatten().filter(|seeker| seeker.step > STEPS[1]) {
                let moved = seeker.take(&known);
                let [lower, upper] = seeker.extremes.map(|(_, number)| number);
                if step == 0 {
                    seeker.width = upper - lower;
                }
                seeker.is_growing =
                    step > 0 && (moved > GROWING || upper - lower > GROWN * seeker.width);
                if step > 0 && moved < SETTLED {
                    seeker.step *= FINER;
                }
            }
        }
        let of_place = |(place, middle): (usize, &Option<f64>)| {
            let middle = middle.ok_or(NoEnds::Missing)?;
            let number = |point: &usize| known.numbers[*point][place];
            let all: Option<Vec<f64>> = match &seekers[place] {
                Some(seeker) => seeker.points.iter().map(number).collect(),
                None => (0..self.first.len()).map(|point| number(&point)).collect(),
            };
            let all = all.ok_or(NoEnds::Missing)?;
            if seekers[place].as_ref().is_some_and(|seeker| seeker.is_growing) {
                return Err(NoEnds::Growing);
            }
            let end = |of: fn(f64, f64) -> f64| all.iter().copied().fold(middle, of);
            Ok([end(f64::min), end(f64::max)])
        };
        Ok(middle.iter().enumerate().map(of_place).collect())
    }
}

/// Points with their numbers.
struct Known {
    shares: Vec<Vec<f64>>,
    numbers: Vec<Numbers>,
    /// The place of each point by the bits of its shares.
    places: BTreeMap<Vec<u64>, usize>,
}

impl Known {
    fn new(shares: &[Vec<f64>], numbers: Vec<Numbers>) -> Self {
        let mut new = Self { shares: vec![], numbers, places: BTreeMap::new() };
        for shares in shares {
            new.place(shares.clone());
        }
        new
    }

    /// The place of a point, which is added if it is new.
    fn place(&mut self, shares: Vec<f64>) -> usize {
        let bits = shares.iter().map(|share| share.to_bits()).collect();
        *self.places.entry(bits).or_insert_with(|| {
            self.shares.push(shares);
            self.shares.len() - 1
        })
    }
}

/// A number that is sought, with its own points.
struct Seeker {
    place: usize,
    points: Vec<usize>,
    /// The points at which it is smallest and largest, and the number there.
    extremes: [(usize, f64); 2],
    /// Whether the last step moved an end by much.
    is_growing: bool,
    /// The next step.
    step: f64,
    /// The distance of the ends at the first points.
    width: f64,
}

impl Seeker {
    /// None if the number is missing somewhere, does not differ, or need not be sought.
    fn new(place: usize, known: &Known, search: &Search) -> Option<Self> {
        let points = (0..known.numbers.len()).collect();
        let extremes = [(0, known.numbers.first()?[place]?); 2];
        let mut new =
            Self { place, points, extremes, is_growing: false, step: STEPS[0], width: 0.0 };
        new.take(known);
        let of_ends = |k: usize| known.numbers[..search.corners].get(k)?[place];
        let ends: Vec<f64> = (0..search.corners).filter_map(of_ends).collect();
        let is_there = known.numbers.iter().all(|numbers| numbers[place].is_some());
        let [(_, least), (_, most)] = new.extremes;
        new.width = most - least;
        let error = FLAT * least.abs().max(most.abs());
        let exceeds = |ends: &[f64]| {
            let end = |of: fn(f64, f64) -> f64| ends.iter().copied().reduce(of);
            end(f64::min).is_some_and(|end| least < end - error)
                || end(f64::max).is_some_and(|end| most > end + error)
        };
        let is_sought = is_there && most - least > error && (!search.is_costly || exceeds(&ends));
        is_sought.then_some(new)
    }

    /// Adds the combinations of ends at which it is smallest and largest if each unknown acts
    /// alone, and these with two bodies that are equally hard.
    fn add_corners(&mut self, known: &mut Known, search: &Search) {
        let effect = |unknown: usize| -> f64 {
            let signed = |point: usize| {
                let sign = 2.0 * known.shares[point][unknown] - 1.0;
                known.numbers[point][self.place].map(|number| sign * number)
            };
            (0..search.corners).filter_map(signed).sum()
        };
        let unknowns = known.shares[0].len();
        let is_rising: Vec<bool> = (0..unknowns).map(|unknown| effect(unknown) > 0.0).collect();
        for upper in [false, true] {
            let corner: Vec<f64> =
                is_rising.iter().map(|rises| f64::from(*rises == upper)).collect();
            for pair in &search.equally_hard {
                let mut corner = corner.clone();
                pair.iter().for_each(|(unknown, share)| corner[*unknown] = *share);
                self.add(known.place(corner));
            }
            self.add(known.place(corner));
        }
    }

    fn add(&mut self, point: usize) {
        if !self.points.contains(&point) {
            self.points.push(point);
        }
    }

    /// Adds points at a step from the extremes along each unknown.
    fn seek(&mut self, known: &mut Known, is_first: bool, sought: [bool; 2]) {
        let step = self.step;
        for ((point, _), _) in self.extremes.into_iter().zip(sought).filter(|(_, is)| *is) {
            let about = known.shares[point].clone();
            for (unknown, at) in about.iter().enumerate() {
                if !is_first && (*at <= 0.0 || *at >= 1.0) {
                    continue;
                }
                // Both ends as well, from between them.
                let far = if is_first { 1.0 } else { step };
                for step in [-far, -step, step, far] {
                    let mut moved = about.clone();
                    moved[unknown] = (at + step).clamp(0.0, 1.0);
                    self.add(known.place(moved));
                }
            }
        }
    }

    /// Takes the numbers at its points; gives how far an end moved, as a share of the distance of
    /// both before.
    fn take(&mut self, known: &Known) -> f64 {
        let [(_, least), (_, most)] = self.extremes;
        for point in &self.points {
            let Some(number) = known.numbers[*point][self.place] else { continue };
            if number < self.extremes[0].1 {
                self.extremes[0] = (*point, number);
            }
            if number > self.extremes[1].1 {
                self.extremes[1] = (*point, number);
            }
        }
        (least - self.extremes[0].1).max(self.extremes[1].1 - most) / (most - least)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Ends = Vec<Result<[f64; 2], NoEnds>>;

    /// The ends of functions of the shares of two unknowns, and the number of calls.
    fn ends(curved: bool, of: &[fn(f64, f64) -> f64]) -> (Ends, usize) {
        let two = "hardness = [1e9, 2e9]\npoissons_ratio = [0.2, 0.3]\n";
        let text = format!(
            "nominal_area = 1e-4\n[interface]\nequivalent_modulus = 1e11\n{two}[surface]\n\
             asperity_radius = 1e-5\nasperity_density = 1e9\nasperity_height_std = 1e-6\n"
        );
        let file = asperity_scene::parse(&text, std::path::Path::new(".")).unwrap();
        let search = Search::over(&file.points().unwrap(), curved);
        let mut calls = search.first();
        let at = |shares: &[f64]| of.iter().map(|f| Some(f(shares[0], shares[1]))).collect();
        let first = search.first.iter().map(|shares| at(shares)).collect();
        let middle: Numbers = at(&[0.5; 2]);
        let found = search.ends(&middle, first, &vec![[true; 2]; of.len()], |shares| {
            calls += shares.len();
            Ok::<_, ()>(shares.iter().map(|shares| at(shares)).collect())
        });
        (found.unwrap(), calls)
    }

    #[test]
    fn ends_between_the_ends_of_unknowns_are_found_to_some_thousandths() {
        // Largest at the upper end of y, at x = .37; smallest at (1, 0).
        let hump: fn(f64, f64) -> f64 = |x, y| 2.0 + y - (x - 0.37).powi(2);
        let falling: fn(f64, f64) -> f64 = |x, y| 1.0 / (1.0 + x + 2.0 * y);
        let (found, calls) = ends(false, &[hump, falling]);
        let [lower, upper] = found[0].unwrap();
        assert!((upper - 3.0).abs() < 2e-3 && (lower - 1.6031).abs() < 1e-9, "{found:?}");
        assert_eq!(found[1], Ok([0.25, 1.0]));
        // Each has its own points, whatever is asked beside it.
        assert_eq!(ends(false, &[falling]).0[0], found[1]);
        assert_eq!(ends(false, &[hump]).0[0], found[0]);
        assert_eq!((calls, ends(false, &[falling]).1), (91, 72));
    }

    #[test]
    fn beside_a_pole_there_are_no_ends() {
        let (found, _) = ends(false, &[|x, y| 1.0 / (x + 0.3 * y - 0.61), |x, _| 1.0 / (x + 0.1)]);
        assert_eq!(found[0], Err(NoEnds::Growing));
        assert!(found[1].is_ok());
    }

    #[test]
    fn of_curved_bodies_only_what_exceeds_its_ends_is_sought() {
        let (found, calls) = ends(true, &[|x, y| x + y]);
        assert_eq!((found[0], calls), (Ok([0.0, 2.0]), 4 + FEW));
        let (found, calls) = ends(true, &[|x, y| y - (x - 0.5).powi(2)]);
        assert!((found[0].unwrap()[1] - 1.0).abs() < 2e-3 && calls > 4 + FEW, "{found:?} {calls}");
    }
}
