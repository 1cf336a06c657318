//! Boundary elements on random surfaces. Light loads are solved on large surfaces with the highest
//! pixels as unknowns.

use std::ops::ControlFlow;

use anyhow::{Result, anyhow};
use asperity::bem::{BemError, BoundaryElements, LightContact, LoadCase, Progress, Solution};

use super::family::{GRADIENT, LIGHT, MODULUS, scene};
use super::kept::{Contact, Kept};
use super::plan::Case;

/// Patches of fewer pixels do not count.
const LEAST_PATCH: usize = 12;
/// Stiffnesses of first loading are differences between pressures this share to either side.
const STEP: f64 = 0.05;
/// Heavier ones are iterated to this residual, which leaves 1e-4 in differences of gaps.
const HEAVY_TOLERANCE: f64 = 1e-6;

/// Solves what is not kept, surface by surface, and prints the progress.
///
/// # Errors
/// A case that cannot be solved or kept.
pub fn solve(cases: &[Case], kept: &Kept) -> Result<()> {
    for (k, case) in cases.iter().enumerate() {
        let Case { family, index, load, .. } = *case;
        let pixels = family.pixels_for(load);
        let surface = family.surface(pixels)?;
        while !kept.is_done(case) {
            let seed = kept.seeds(case).len() as u64 + 1;
            let of = format!("{}, {pixels} pixels, psi {index}, load {load}", family.name);
            eprintln!("case {} of {}: {of}, seed {seed}", k + 1, cases.len());
            let mut elements = BoundaryElements::new(surface.seed(seed).heights(pixels)?, MODULUS)?;
            if let Some(hardness) = scene(&surface, index)?.interface.hardness {
                elements = elements.hardness(hardness)?;
            }
            let sq = surface.moments().m0.sqrt();
            kept.add(case, &contacts(&elements, &[load], sq, load <= LIGHT)?)?;
        }
    }
    Ok(())
}

/// The contacts of these loads, dimensionless; of light ones with the highest pixels as unknowns.
///
/// # Errors
/// A load that cannot be solved.
pub fn contacts(
    elements: &BoundaryElements,
    loads: &[f64],
    sq: f64,
    are_light: bool,
) -> Result<Vec<Contact>> {
    // For stiffnesses of first loading also to either side; elastic contacts unload as they load.
    let around: &[f64] = match elements.limit() {
        None => &[1.0],
        Some(_) => &[1.0 - STEP, 1.0, 1.0 + STEP],
    };
    let of = |load| around.iter().map(move |k| k * load * MODULUS * GRADIENT);
    let pressures: Vec<f64> = loads.iter().flat_map(of).collect();
    let solved = match are_light.then(|| elements.solve_light(&pressures)) {
        Some(Ok(found)) => found.iter().map(light).collect(),
        Some(Err(BemError::NotLight { .. })) | None => heavy(elements, &pressures, around.len())?,
        Some(Err(error)) => return Err(error.into()),
    };
    let of = |(load, solved): (&f64, &[Contact])| {
        let middle = solved[solved.len() / 2];
        let stiffness = match solved {
            [less, _, more] => 2.0 * STEP * load * MODULUS * GRADIENT / (less.gap - more.gap),
            _ => middle.unloading_stiffness,
        };
        let unit = MODULUS / sq;
        Contact {
            load: *load,
            gap: middle.gap / sq,
            stiffness: stiffness / unit,
            unloading_stiffness: middle.unloading_stiffness / unit,
            ..middle
        }
    };
    Ok(loads.iter().zip(solved.chunks(around.len())).map(of).collect())
}

/// A contact without its load and stiffness, in SI units.
fn light(found: &LightContact) -> Contact {
    Contact {
        area: found.area,
        plastic_area: found.plastic_area,
        gap: found.mean_gap,
        unloading_stiffness: found.unloading_stiffness,
        patches: count(&found.patches),
        ..Contact::default()
    }
}

/// Contacts of the whole map; the unloading stiffness of the middle one of each `around`.
fn heavy(elements: &BoundaryElements, pressures: &[f64], around: usize) -> Result<Vec<Contact>> {
    let elements = elements.clone().tolerance(HEAVY_TOLERANCE)?;
    let of = |found: &Solution, is_middle: bool| -> Result<Contact> {
        let unloading = is_middle.then(|| elements.fixed_contact(found)).transpose()?;
        Ok(Contact {
            area: found.area,
            plastic_area: found.plastic_area,
            gap: found.mean_gap,
            unloading_stiffness: unloading.map_or(0.0, |fixed| fixed.stiffness),
            patches: count(&found.patches),
            ..Contact::default()
        })
    };
    solve_each(&elements, pressures, |at, found| of(found, at % around == around / 2))
}

/// The numbers `of` the contact under each mean pressure.
///
/// # Errors
/// A pressure that cannot be solved.
pub fn solve_each<T>(
    elements: &BoundaryElements,
    pressures: &[f64],
    of: impl Fn(usize, &Solution) -> Result<T>,
) -> Result<Vec<T>> {
    let given: Vec<LoadCase> = pressures.iter().copied().map(LoadCase::MeanPressure).collect();
    let mut solved: Vec<Result<T>> =
        given.iter().map(|_| Err(anyhow!("a load was not solved"))).collect();
    let go_on = |_: &Progress| ControlFlow::Continue(());
    elements.solve_each(&given, go_on, |at, found| {
        solved[at] = found.map_err(Into::into).and_then(|found| of(at, &found));
    });
    solved.into_iter().collect()
}

/// Patches of at least [`LEAST_PATCH`] pixels.
fn count(patches: &[usize]) -> f64 {
    patches.iter().filter(|size| **size >= LEAST_PATCH).count() as f64
}
