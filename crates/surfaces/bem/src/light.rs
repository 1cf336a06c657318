//! Contacts of few pixels: the problem of the whole map with the highest pixels as unknowns.
//!
//! Pressures outside these candidates are 0, and one transform of the whole map gives the
//! deflections there. If no gap is negative, this solves the whole map; otherwise
//! pixels with a negative gap become candidates, too. As the load falls no pixel comes into
//! contact, so that the pixels in contact are the candidates of the next lighter load. \[derived\]

use std::ops::ControlFlow;

use crate::half_space::{Compliance, Filter, HalfSpace};
use crate::height_map::positive;
use crate::iteration::{Iteration, Problem};
use crate::parallel::number;
use crate::solution::{corrected_area, edges, patches};
use crate::unloading::even_approach;
use crate::{BemError, Boundary, BoundaryElements};

/// Most candidates: two matrices of 200 MB.
const MOST_CANDIDATES: usize = 5000;
/// Candidates over the expected number of pixels in contact, and at least this many.
const MARGIN: f64 = 2.2;
const LEAST_CANDIDATES: usize = 64;
/// Rounds of new candidates; two are usual.
const MOST_ROUNDS: usize = 12;

/// The solution of a contact of few pixels, without maps.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct LightContact {
    /// Mean pressure on the area of the map \[Pa\].
    pub mean_pressure: f64,
    /// Real area over the area of the map, corrected as in a [`Solution`](crate::Solution).
    pub area: f64,
    /// Share of the pixels that carry pressure.
    pub pixel_area: f64,
    /// Share of the pixels that carry the hardness.
    pub plastic_area: f64,
    /// Mean gap \[m\]: distance of the mean planes of the two deformed surfaces.
    pub mean_gap: f64,
    /// Volume of the gap over the area of the map \[m\]: the mean gap with plastic pixels counted
    /// as 0.
    pub gap_volume: f64,
    /// Stiffness at [fixed contact](BoundaryElements::fixed_contact) \[Pa/m\].
    pub unloading_stiffness: f64,
    /// Number of pixels of every contact patch, largest first.
    pub patches: Vec<usize>,
    /// Places of the pixels in contact on the map, ascending, and their pressures \[Pa\].
    pub pressures: Vec<(usize, f64)>,
    /// As in a [`Solution`](crate::Solution).
    pub residual: f64,
    /// Number of iterations.
    pub iterations: usize,
}

/// Influence coefficients of each [`Filter`] between some pixels: symmetric matrices, row after
/// row.
struct Coefficients([Vec<f64>; 2]);

impl Compliance for Coefficients {
    fn apply(&mut self, filter: Filter, map: &mut [f64]) {
        let (matrix, given) = (&self.0[filter as usize], map.to_vec());
        map.fill(0.0);
        // Most pixels carry nothing.
        for (row, value) in matrix.chunks(given.len()).zip(given).filter(|(_, x)| *x != 0.0) {
            map.iter_mut().zip(row).for_each(|(sum, coefficient)| *sum += value * coefficient);
        }
    }
}

/// Responses of the whole map to a pixel in its corner, by each [`Filter`].
struct Responses {
    columns: usize,
    maps: [Vec<f64>; 2],
}

impl Responses {
    fn new(pixels: usize, columns: usize, space: &mut HalfSpace) -> Self {
        let maps = [Filter::Deflect, Filter::Undo].map(|filter| {
            let mut map = vec![0.0; pixels];
            map[0] = 1.0;
            space.apply(filter, &mut map);
            map
        });
        Self { columns, maps }
    }

    fn between(&self, pixels: &[usize]) -> Coefficients {
        let columns = self.columns;
        let places: Vec<(usize, usize)> =
            pixels.iter().map(|at| (at / columns, at % columns)).collect();
        let of = |response: &Vec<f64>| {
            let mut matrix = Vec::with_capacity(places.len() * places.len());
            for (i, j) in &places {
                matrix.extend(
                    places.iter().map(|(k, l)| response[i.abs_diff(*k) * columns + j.abs_diff(*l)]),
                );
            }
            matrix
        };
        Coefficients(self.maps.each_ref().map(of))
    }
}

impl BoundaryElements {
    /// Solves contacts of few pixels at mean pressures \[Pa\], in their order: as
    /// [`solve_all`](Self::solve_all) to within the tolerance, in a small part of its time, with
    /// the stiffness at fixed contact.
    ///
    /// # Errors
    /// [`BemError::NotLight`] above some thousand pixels in contact or with a free boundary;
    /// otherwise the errors of [`solve`](Self::solve).
    pub fn solve_light(&self, pressures: &[f64]) -> Result<Vec<LightContact>, BemError> {
        let mut order: Vec<(usize, f64)> = vec![];
        for (at, pressure) in pressures.iter().enumerate() {
            let (pressure, hardness) = (positive("mean pressure", *pressure)?, self.cap());
            if pressure >= hardness {
                return Err(BemError::CannotBeCarried { pressure, hardness });
            }
            order.push((at, pressure));
        }
        order.sort_by(|a, b| b.1.total_cmp(&a.1));
        let Some((_, heaviest)) = order.first() else { return Ok(vec![]) };
        if self.boundary_condition() != Boundary::Periodic {
            return Err(BemError::NotLight { pixels: self.map.heights().len(), most: 0 });
        }
        let mut light = Light::new(self, *heaviest)?;
        let mut found = vec![];
        for (at, pressure) in order {
            found.push((at, light.solve(pressure)?));
        }
        found.sort_by_key(|(at, _)| *at);
        Ok(found.into_iter().map(|(_, contact)| contact).collect())
    }
}

/// The contacts of a list, solved from the heaviest load down.
struct Light<'a> {
    setup: &'a BoundaryElements,
    space: HalfSpace,
    responses: Responses,
    rms_height: f64,
    highest: f64,
    /// Candidates, ascending, and their pressures.
    pixels: Vec<usize>,
    pressures: Vec<f64>,
    /// Whether the candidates include every pixel in contact.
    checked: bool,
}

impl<'a> Light<'a> {
    fn new(setup: &'a BoundaryElements, heaviest: f64) -> Result<Self, BemError> {
        let map = &setup.map;
        let heights = map.heights();
        let mut space = HalfSpace::new(map, setup.modulus, Boundary::Periodic);
        let count = MARGIN * expected_area(setup, heaviest) * heights.len() as f64;
        let count = (count as usize).max(LEAST_CANDIDATES).min(heights.len());
        refuse_above(MOST_CANDIDATES, count)?;
        let mut by_height: Vec<usize> = (0..heights.len()).collect();
        by_height.select_nth_unstable_by(count - 1, |a, b| heights[*b].total_cmp(&heights[*a]));
        by_height.truncate(count);
        by_height.sort_unstable();
        Ok(Self {
            setup,
            responses: Responses::new(heights.len(), map.shape()[1], &mut space),
            space,
            rms_height: map.rms_height(),
            highest: map.highest(),
            pressures: vec![heaviest; by_height.len()],
            pixels: by_height,
            checked: false,
        })
    }

    fn solve(&mut self, pressure: f64) -> Result<LightContact, BemError> {
        let Self { setup, highest, .. } = *self;
        let (heights, cap) = (setup.map.heights(), setup.cap());
        let load = pressure * heights.len() as f64;
        let goal = setup.goal(setup.scale(pressure, self.rms_height));
        let mut iterations = 0;
        for _ in 0..MOST_ROUNDS {
            let mut coefficients = self.responses.between(&self.pixels);
            let candidates: Vec<f64> = self.pixels.iter().map(|at| heights[*at]).collect();
            let problem = Problem { heights: &candidates, highest, cap, load };
            let start = std::mem::take(&mut self.pressures);
            let mut go_on = |_, _| ControlFlow::Continue(());
            let (iteration, reached) =
                Iteration::run(problem, start, !self.checked, goal, &mut coefficients, &mut go_on)?;
            iterations += reached.iterations;
            let (pressures, deflections) = iteration.into_maps();
            self.pressures = pressures;
            let little = goal.tolerance * goal.scale;
            if !self.checked && self.add_pixels_below(reached.offset - little)? {
                continue;
            }
            self.checked = true;
            let contact: Vec<f64> = self.pressures.iter().map(|p| number(*p > 0.0)).collect();
            let fixed = even_approach(&contact, heights.len() as f64, &mut coefficients)?;
            let depths = candidates.iter().zip(deflections).zip(&self.pressures);
            let depths = depths
                .filter(|(_, pressure)| **pressure >= cap)
                .map(|((height, u), _)| (reached.offset - problem.distance(u, *height)).max(0.0));
            let depth: f64 = depths.sum::<f64>() / heights.len() as f64;
            // Only the pixels in contact are left.
            let all = self.pixels.iter().copied().zip(self.pressures.iter().copied());
            (self.pixels, self.pressures) = all.filter(|(_, pressure)| *pressure > 0.0).unzip();
            let (mean_gap, residual) = (highest - reached.offset, reached.residual);
            return Ok(self.contact(fixed.stiffness, [mean_gap, depth], residual, iterations));
        }
        let (residual, required) = (f64::INFINITY, goal.tolerance);
        Err(BemError::NotConverged { residual, iterations, required })
    }

    /// Adds the pixels whose [distance](Problem::distance) is below `offset` to the candidates, by
    /// one transform of the whole map; true if there are any.
    fn add_pixels_below(&mut self, offset: f64) -> Result<bool, BemError> {
        let heights = self.setup.map.heights();
        let mut deflections = vec![0.0; heights.len()];
        for (at, pressure) in self.pixels.iter().zip(&self.pressures) {
            deflections[*at] = *pressure;
        }
        self.space.apply(Filter::Deflect, &mut deflections);
        let highest = self.highest;
        let open = |at: &usize| deflections[*at] + (highest - heights[*at]) >= offset;
        let more: Vec<usize> = (0..heights.len())
            .filter(|at| !open(at) && self.pixels.binary_search(at).is_err())
            .collect();
        if more.is_empty() {
            return Ok(false);
        }
        refuse_above(MOST_CANDIDATES, self.pixels.len() + more.len())?;
        let known = self.pixels.iter().copied().zip(self.pressures.iter().copied());
        let mut all: Vec<(usize, f64)> =
            known.chain(more.into_iter().map(|at| (at, 0.0))).collect();
        all.sort_unstable_by_key(|(at, _)| *at);
        (self.pixels, self.pressures) = all.into_iter().unzip();
        Ok(true)
    }

    fn contact(
        &self,
        unloading_stiffness: f64,
        [mean_gap, depth]: [f64; 2],
        residual: f64,
        iterations: usize,
    ) -> LightContact {
        let map = &self.setup.map;
        let pixels = map.heights().len() as f64;
        let plastic = self.pressures.iter().filter(|p| **p >= self.setup.cap()).count();
        let (mut touching, shape) = (vec![false; map.heights().len()], map.shape());
        self.pixels.iter().for_each(|at| touching[*at] = true);
        let (patches, edges) = (patches(&touching, shape, true), edges(&touching, shape, true));
        let (count, force) = (self.pixels.len(), self.pressures.iter().sum::<f64>());
        LightContact {
            mean_pressure: force / pixels,
            area: corrected_area(count, edges).max(force / self.setup.cap()) / pixels,
            pixel_area: count as f64 / pixels,
            plastic_area: plastic as f64 / pixels,
            mean_gap,
            gap_volume: mean_gap + depth,
            unloading_stiffness,
            patches,
            pressures: self.pixels.iter().copied().zip(self.pressures.iter().copied()).collect(),
            residual,
            iterations,
        }
    }
}

fn refuse_above(most: usize, pixels: usize) -> Result<(), BemError> {
    if pixels > most { Err(BemError::NotLight { pixels, most }) } else { Ok(()) }
}

/// An estimate of the share in contact: √(2π) p/(E g), and p/H where that is more.
fn expected_area(setup: &BoundaryElements, pressure: f64) -> f64 {
    let map = &setup.map;
    let columns = map.shape()[1];
    let [_, dx] = map.pixel();
    let rows = map.heights().chunks(columns);
    let slopes = rows.flat_map(|row| row.windows(2).map(|pair| ((pair[1] - pair[0]) / dx).powi(2)));
    let square = 2.0 * slopes.sum::<f64>() / map.heights().len() as f64;
    let elastic = if square > 0.0 { 2.5 * pressure / (setup.modulus * square.sqrt()) } else { 1.0 };
    elastic.max(pressure / setup.cap())
}
