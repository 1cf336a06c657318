//! Boundary elements on random surfaces. Light loads are solved on large surfaces with the highest
//! pixels as unknowns.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use anyhow::{Result, anyhow, bail};
use asperity::bem::{BemError, BoundaryElements, HeightMap, LoadCase, Solution};
use indicatif::{ProgressBar, ProgressStyle};

use super::family::{GRADIENT, LIGHT, MODULUS, equal, scene};
use super::kept::{Contact, Kept};
use super::plan::{Case, Scope};

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
pub fn solve(scope: &Scope, kept: &Kept) -> Result<()> {
    let total = scope.cases()?.len();
    let done =
        || -> Result<usize> { Ok(scope.cases()?.iter().filter(|case| kept.is_done(case)).count()) };
    let bar = ProgressBar::new(total as u64);
    bar.set_style(ProgressStyle::with_template("{wide_bar} {pos}/{len} cases, {eta} left, {msg}")?);
    let (before, start) = (done()?, Instant::now());
    bar.set_position(before as u64);
    for part in scope.parts {
        for family in part.families {
            solve_family(&part.cases_of(*family)?, kept, |surface| {
                let done = done()?;
                bar.set_position(done as u64);
                bar.set_message(surface.to_owned());
                if bar.is_hidden() {
                    let left = match done - before.min(done) {
                        0 => String::new(),
                        new => {
                            let each = start.elapsed().as_secs_f64() / new as f64;
                            let left = Duration::from_secs_f64(each * (total - done) as f64);
                            format!(", about {} s left", left.as_secs())
                        }
                    };
                    eprintln!("{done} of {total} cases{left}: {surface}");
                }
                Ok(())
            })?;
        }
    }
    bar.finish_and_clear();
    Ok(())
}

/// Solves what cases of one family still need, surface by surface; `progress` gets a line for each.
///
/// # Errors
/// A case that cannot be solved or kept.
pub fn solve_family(
    cases: &[Case],
    kept: &Kept,
    mut progress: impl FnMut(&str) -> Result<()>,
) -> Result<()> {
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
                progress(&format!("{}, {pixels} pixels, psi {index}, seed {seed}", family.name))?;
                let map: &HeightMap = match &mut map {
                    Some(map) => map,
                    none => none.insert(surface.seed(seed).heights(pixels)?),
                };
                let elements = BoundaryElements::new(map.clone(), MODULUS)?;
                let elements = match scene(&surface, index)?.interface.hardness {
                    Some(hardness) => elements.hardness(hardness)?,
                    None => elements,
                };
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
fn around(elements: &BoundaryElements) -> &'static [f64] {
    match elements.limit() {
        None => &[1.0],
        Some(_) => &[1.0 - STEP, 1.0, 1.0 + STEP],
    }
}

fn pressures(loads: &[f64], around: &[f64]) -> Vec<f64> {
    let of = |load: &f64| around.iter().map(move |k| k * load * MODULUS * GRADIENT).collect();
    loads.iter().flat_map(|load| -> Vec<f64> { of(load) }).collect()
}

fn count_patches(sizes: &[usize]) -> f64 {
    sizes.iter().filter(|size| **size >= LEAST_PATCH).count() as f64
}

/// Contacts with the highest pixels as unknowns.
fn light_contacts(elements: &BoundaryElements, loads: &[f64], sq: f64) -> Result<Vec<Contact>> {
    let around = around(elements);
    let solved = match elements.solve_light(&pressures(loads, around)) {
        Err(BemError::NotLight { .. }) => return heavy_contacts(elements.clone(), loads, sq),
        solved => solved?,
    };
    let solved = solved.iter().map(|found| Contact {
        area: found.area,
        plastic_area: found.plastic_area,
        gap: found.mean_gap,
        unloading_stiffness: found.unloading_stiffness,
        patches: count_patches(&found.patches),
        pixels: found.pressures.len() as f64,
        ..Contact::default()
    });
    dimensionless(loads, &solved.collect::<Vec<_>>(), sq)
}

/// Contacts of the whole map.
fn heavy_contacts(elements: BoundaryElements, loads: &[f64], sq: f64) -> Result<Vec<Contact>> {
    let around = around(&elements);
    let elements = elements.tolerance(HEAVY_TOLERANCE)?;
    let pressures = pressures(loads, around);
    let given: Vec<LoadCase> = pressures.iter().map(|p| LoadCase::MeanPressure(*p)).collect();
    let of = |found: &Solution, middle: bool| -> Result<Contact> {
        let fixed = if middle { elements.fixed_contact(found)?.stiffness } else { 0.0 };
        Ok(Contact {
            area: found.area,
            plastic_area: found.plastic_area,
            gap: found.mean_gap,
            unloading_stiffness: fixed,
            patches: count_patches(&found.patches),
            pixels: found.patches.iter().sum::<usize>() as f64,
            ..Contact::default()
        })
    };
    let mut solved: Vec<Result<Contact>> =
        given.iter().map(|_| Err(anyhow!("a load was not solved"))).collect();
    elements.solve_each(
        &given,
        |_| ControlFlow::Continue(()),
        |at, found| {
            let middle = at % around.len() == around.len() / 2;
            solved[at] = found.map_err(Into::into).and_then(|found| of(&found, middle));
        },
    );
    let solved: Vec<Contact> = solved.into_iter().collect::<Result<_>>()?;
    dimensionless(loads, &solved, sq)
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
