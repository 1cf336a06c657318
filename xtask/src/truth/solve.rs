//! Boundary elements on random surfaces. Light loads are solved on large surfaces with the highest
//! pixels as unknowns.

use std::ops::ControlFlow;
use std::time::Instant;

use anyhow::{Result, anyhow, bail};
use asperity::bem::{
    BemError, BoundaryElements, HeightMap, LightContact, LoadCase, Progress, Solution,
};

use super::family::{GRADIENT, LIGHT, MODULUS, scene};
use super::kept::{Contact, Kept};
use super::plan::{Case, Scope, cases};
use crate::figures::truth_ranges::equal;

/// Patches of fewer pixels do not count.
const LEAST_PATCH: usize = 12;
/// Stiffnesses of first loading are differences between pressures this share to either side.
const STEP: f64 = 0.05;
/// Heavier ones are iterated to this residual, which leaves 1e-4 in differences of gaps.
const HEAVY_TOLERANCE: f64 = 1e-6;

/// Solves what is not kept, with the progress and the time left.
///
/// # Errors
/// A case that cannot be solved or kept.
pub fn solve(scope: Scope, kept: &Kept) -> Result<()> {
    let all = cases(scope)?;
    let done = || all.iter().filter(|case| kept.is_done(case)).count();
    let (total, before, start) = (all.len(), done(), Instant::now());
    for part in scope {
        for family in part.families {
            solve_family(&part.cases_of(*family)?, kept, |surface| {
                let done = done();
                let left = match done - before.min(done) {
                    0 => String::new(),
                    new => {
                        let all = start.elapsed().as_secs_f64() * (total - done) as f64;
                        format!(", about {:.0} s left", all / new as f64)
                    }
                };
                eprintln!("{done} of {total} cases{left}: {surface}");
            })?;
        }
    }
    Ok(())
}

/// Whether all cases of a family are kept, after solving those that are not if they may be.
///
/// # Errors
/// A case that cannot be solved or kept.
pub fn are_kept(cases: &[Case], kept: &Kept, solve_missing: bool) -> Result<bool> {
    if solve_missing {
        solve_family(cases, kept, |surface| eprintln!("{surface}"))?;
    }
    Ok(cases.iter().all(|case| kept.is_done(case)))
}

/// Solves what cases of one family still need, surface by surface; `progress` gets a line for each.
///
/// # Errors
/// A case that cannot be solved or kept.
fn solve_family(cases: &[Case], kept: &Kept, progress: impl Fn(&str)) -> Result<()> {
    let Some(Case { family, .. }) = cases.first() else { return Ok(()) };
    let mut sizes: Vec<usize> = cases.iter().map(|case| family.pixels_for(case.load)).collect();
    sizes.sort_unstable();
    sizes.dedup();
    let mut indices: Vec<f64> = cases.iter().map(|case| case.index).collect();
    indices.dedup();
    let most = cases.iter().map(|case| case.seeds[1]).max().unwrap_or(0);
    for pixels in sizes {
        let surface = family.surface(pixels)?;
        for seed in 1..=most {
            let mut map = None;
            for &index in &indices {
                let needed = |case: &&Case| {
                    equal(case.index, index)
                        && family.pixels_for(case.load) == pixels
                        && kept.seeds(case).len() as u64 == seed - 1
                        && !kept.is_done(case)
                };
                let loads: Vec<f64> = cases.iter().filter(needed).map(|case| case.load).collect();
                if loads.is_empty() {
                    continue;
                }
                progress(&format!("{}, {pixels} pixels, psi {index}, seed {seed}", family.name));
                let map: &HeightMap = match &mut map {
                    Some(map) => map,
                    none => none.insert(surface.seed(seed).heights(pixels)?),
                };
                let mut elements = BoundaryElements::new(map.clone(), MODULUS)?;
                if let Some(hardness) = scene(&surface, index)?.interface.hardness {
                    elements = elements.hardness(hardness)?;
                }
                let sq = surface.moments().m0.sqrt();
                let (light, heavy): (Vec<f64>, Vec<f64>) =
                    loads.iter().partition(|load| **load <= LIGHT);
                let mut found = light_contacts(&elements, &light, sq)?;
                found.extend(heavy_contacts(elements, &heavy, sq)?);
                kept.add(family, pixels, index, seed, &found)?;
            }
        }
    }
    Ok(())
}

/// The pressures to solve for each load: for stiffnesses of first loading also to either side;
/// elastic contacts unload as they load.
fn pressures(elements: &BoundaryElements, loads: &[f64]) -> Vec<f64> {
    let around: &[f64] = match elements.limit() {
        None => &[1.0],
        Some(_) => &[1.0 - STEP, 1.0, 1.0 + STEP],
    };
    let of = |load| around.iter().map(move |k| k * load * MODULUS * GRADIENT);
    loads.iter().flat_map(of).collect()
}

/// A contact without its load and stiffness, in SI units.
fn contact(areas: [f64; 2], gap: f64, unloading_stiffness: f64, patches: &[usize]) -> Contact {
    let [area, plastic_area] = areas;
    let count = patches.iter().filter(|size| **size >= LEAST_PATCH).count() as f64;
    let pixels = patches.iter().sum::<usize>() as f64;
    let solid = Contact { area, plastic_area, gap, unloading_stiffness, ..Contact::default() };
    Contact { patches: count, pixels, ..solid }
}

/// Contacts with the highest pixels as unknowns.
fn light_contacts(elements: &BoundaryElements, loads: &[f64], sq: f64) -> Result<Vec<Contact>> {
    let solved = match elements.solve_light(&pressures(elements, loads)) {
        Err(BemError::NotLight { .. }) => return heavy_contacts(elements.clone(), loads, sq),
        solved => solved?,
    };
    let of = |found: &LightContact| {
        let areas = [found.area, found.plastic_area];
        let pixels = found.pressures.len() as f64;
        let found = contact(areas, found.mean_gap, found.unloading_stiffness, &found.patches);
        Contact { pixels, ..found }
    };
    dimensionless(loads, &solved.iter().map(of).collect::<Vec<_>>(), sq)
}

/// Contacts of the whole map.
fn heavy_contacts(elements: BoundaryElements, loads: &[f64], sq: f64) -> Result<Vec<Contact>> {
    let elements = elements.tolerance(HEAVY_TOLERANCE)?;
    let given = pressures(&elements, loads).into_iter().map(LoadCase::MeanPressure);
    let given: Vec<LoadCase> = given.collect();
    let around = given.len() / loads.len().max(1);
    let of = |found: &Solution, middle: bool| -> Result<Contact> {
        let fixed = if middle { elements.fixed_contact(found)?.stiffness } else { 0.0 };
        Ok(contact([found.area, found.plastic_area], found.mean_gap, fixed, &found.patches))
    };
    let mut solved: Vec<Result<Contact>> =
        given.iter().map(|_| Err(anyhow!("a load was not solved"))).collect();
    let go_on = |_: &Progress| ControlFlow::Continue(());
    elements.solve_each(&given, go_on, |at, found| {
        let middle = at % around == around / 2;
        solved[at] = found.map_err(Into::into).and_then(|found| of(&found, middle));
    });
    dimensionless(loads, &solved.into_iter().collect::<Result<Vec<_>>>()?, sq)
}

/// The contacts of the loads from the solutions around each.
fn dimensionless(loads: &[f64], solved: &[Contact], sq: f64) -> Result<Vec<Contact>> {
    let unit = MODULUS / sq;
    let around = solved.len() / loads.len().max(1);
    let of = |(load, solved): (&f64, &[Contact])| {
        let (stiffness, mut contact) = match solved {
            [here] => (here.unloading_stiffness, *here),
            [less, here, more] => {
                let force = 2.0 * STEP * load * MODULUS * GRADIENT;
                (force / (less.gap - more.gap), *here)
            }
            _ => bail!("a load was not solved"),
        };
        contact.load = *load;
        contact.gap /= sq;
        contact.stiffness = stiffness / unit;
        contact.unloading_stiffness /= unit;
        Ok(contact)
    };
    loads.iter().zip(solved.chunks(around.max(1))).map(of).collect()
}
