//! The extent of the evidence: which families, materials and loads.

use anyhow::Result;

use super::family::{FAMILIES, Family, LOADS, is_carried, scene};
use crate::figures::truth;

/// Number of seeds behind every row.
pub const LEAST_SEEDS: u64 = 4;
/// Most surfaces of a case.
pub const MOST_SEEDS: u64 = 16;

/// Families with the same materials and loads.
#[derive(Debug, Clone, Copy)]
pub struct Part {
    /// Surfaces.
    pub families: &'static [Family],
    /// Plasticity indices; 0 for no hardness.
    indices: &'static [f64],
    /// Pressures over E g.
    loads: &'static [f64],
    /// Most surfaces of a case.
    most_seeds: u64,
}

/// Parts in the order in which they are solved: what matters most comes first.
pub type Scope = &'static [Part];

/// A row of the evidence.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Case {
    /// Surfaces.
    pub family: Family,
    /// Plasticity index; 0 for no hardness.
    pub index: f64,
    /// p/(E g).
    pub load: f64,
    /// Fewest and most surfaces.
    pub seeds: [u64; 2],
}

/// The cases of a family whose load is carried.
///
/// # Errors
/// A surface that cannot be made.
pub fn carried(
    family: Family,
    indices: &[f64],
    loads: &[f64],
    seeds: [u64; 2],
) -> Result<Vec<Case>> {
    let surface = family.surface(family.pixels)?;
    let mut all = vec![];
    for &index in indices {
        let hardness = scene(&surface, index)?.interface.hardness;
        let carried = loads.iter().filter(|load| is_carried(hardness, **load));
        all.extend(carried.map(|&load| Case { family, index, load, seeds }));
    }
    Ok(all)
}

impl Part {
    /// The cases of a family whose load is carried.
    ///
    /// # Errors
    /// A surface that cannot be made.
    pub fn cases_of(&self, family: Family) -> Result<Vec<Case>> {
        let seeds = [LEAST_SEEDS.min(self.most_seeds), self.most_seeds];
        carried(family, self.indices, self.loads, seeds)
    }
}

/// All cases in the order of the table.
///
/// # Errors
/// A surface that cannot be made.
pub fn cases(scope: Scope) -> Result<Vec<Case>> {
    let families = scope.iter().flat_map(|part| part.families.iter().map(move |one| (part, one)));
    let cases = families.map(|(part, family)| part.cases_of(*family));
    let mut all = cases.collect::<Result<Vec<_>>>()?.concat();
    let place = |case: &Case| FAMILIES.iter().position(|family| *family == case.family);
    all.sort_by(|a, b| {
        let index = a.index.total_cmp(&b.index);
        place(a).cmp(&place(b)).then(index).then(a.load.total_cmp(&b.load))
    });
    Ok(all)
}

const fn part(
    families: &'static [Family],
    indices: &'static [f64],
    loads: &'static [f64],
    most_seeds: u64,
) -> Part {
    Part { families, indices, loads, most_seeds }
}

const ISOTROPIC: &[Family] = FAMILIES.split_at(4).0;
/// Of few asperities, and of many.
const NARROW: &[Family] = ISOTROPIC.split_at(2).0;
const BROAD: &[Family] = ISOTROPIC.split_at(2).1;
const BROADEST: &[Family] = ISOTROPIC.split_at(3).1;
/// Skewed surfaces and those with a lay.
const OTHERS: &[Family] = FAMILIES.split_at(4).1;
const LIGHT_LOADS: &[f64] = LOADS.split_at(4).0;
const HEAVY_LOADS: &[f64] = LOADS.split_at(4).1;
/// One load of a decade.
const DECADES: &[f64] = &[1e-5, 1e-4, 1e-3, 1e-2, 0.1];
/// Where separations of yielded contacts change most between decades.
const PLASTIC: &[f64] = &[0.03, 0.05];
/// The materials of all isotropic surfaces.
const USUAL: &[f64] = &[0.0, 2.0, 4.0];

/// The committed evidence.
pub const FULL: Scope = &[
    part(BROAD, USUAL, LIGHT_LOADS, truth::MOST_SEEDS),
    part(NARROW, USUAL, &LOADS, MOST_SEEDS),
    part(&[FAMILIES[2]], USUAL, HEAVY_LOADS, MOST_SEEDS),
    part(BROADEST, USUAL, DECADES.split_at(2).1, MOST_SEEDS),
    part(OTHERS, &[0.0, 2.0], DECADES.split_at(1).1, MOST_SEEDS),
    part(ISOTROPIC, &[1.0, 8.0], DECADES, MOST_SEEDS),
    part(NARROW, &[0.7], DECADES, MOST_SEEDS),
    part(BROADEST, &[4.0], &[0.03], MOST_SEEDS),
    part(ISOTROPIC, &[8.0], PLASTIC, MOST_SEEDS),
];
/// A sketch of the evidence in two minutes.
pub const QUICK: Scope = &[part(FAMILIES.split_at(3).0, &[0.0, 2.0], &[3e-4, 1e-2, 0.1], 2)];

const SMALL_FAMILY: Family =
    Family { name: "small", waves: [12.0, 16.0], pixels: 128, most_pixels: 256, ..FAMILIES[0] };
/// The small case, which tests solve again.
pub const SMALL: Scope = &[part(&[SMALL_FAMILY], &[0.0, 2.0], &[1e-4, 0.02, 0.1], 2)];
