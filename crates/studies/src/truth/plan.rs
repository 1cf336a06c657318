//! The extent of the evidence: which families, materials and loads.

use anyhow::Result;

use super::family::{FAMILIES, Family, GRADIENT, LOADS, MODULUS, scene};

/// Number of seeds behind every row.
pub const LEAST_SEEDS: u64 = 4;
/// Loads above this share of the hardness are left out.
const MOST_OF_HARDNESS: f64 = 0.7;
/// Most surfaces of a case.
const MOST_SEEDS: u64 = 16;

/// Families with the same materials and loads: surfaces, plasticity indices (0 for no hardness),
/// pressures over E g, and the most surfaces of a case.
pub type Part = (&'static [Family], &'static [f64], &'static [f64], u64);

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

/// The cases in the order in which they are solved: those whose load is well below the hardness.
///
/// # Errors
/// A surface that cannot be made.
pub fn cases(scope: Scope) -> Result<Vec<Case>> {
    let mut cases = vec![];
    for (families, indices, loads, most) in scope {
        for family in families.iter().copied() {
            let surface = family.surface(family.pixels)?;
            for &index in *indices {
                let hardness = scene(&surface, index)?.interface.hardness;
                let most_load = hardness.map(|h| MOST_OF_HARDNESS * h / (MODULUS * GRADIENT));
                let carried =
                    loads.iter().filter(|load| most_load.is_none_or(|most| **load < most));
                let seeds = [LEAST_SEEDS.min(*most), *most];
                cases.extend(carried.map(|&load| Case { family, index, load, seeds }));
            }
        }
    }
    Ok(cases)
}

const ISOTROPIC: &[Family] = FAMILIES.split_at(4).0;
/// Of few asperities, and of many.
const NARROW: &[Family] = ISOTROPIC.split_at(2).0;
const BROAD: &[Family] = ISOTROPIC.split_at(2).1;
const BROADEST: &[Family] = ISOTROPIC.split_at(3).1;
/// Skewed surfaces and those with a lay.
const OTHERS: &[Family] = FAMILIES.split_at(5).1;
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
    // Broad spectra have few contacts, and light loads cost little.
    (BROAD, USUAL, LIGHT_LOADS, 64),
    (NARROW, USUAL, &LOADS, MOST_SEEDS),
    (&[FAMILIES[2]], USUAL, HEAVY_LOADS, MOST_SEEDS),
    (BROADEST, USUAL, DECADES.split_at(2).1, MOST_SEEDS),
    (OTHERS, &[0.0, 2.0], DECADES.split_at(1).1, MOST_SEEDS),
    (ISOTROPIC, &[1.0, 8.0], DECADES, MOST_SEEDS),
    (NARROW, &[0.7], DECADES, MOST_SEEDS),
    (BROADEST, &[4.0], &[0.03], MOST_SEEDS),
    (ISOTROPIC, &[8.0], PLASTIC, MOST_SEEDS),
    (ISOTROPIC, &[2.0], &[0.15, 0.2], MOST_SEEDS),
    (ISOTROPIC, &[4.0], &[0.05, 0.07, 0.15], MOST_SEEDS),
    (ISOTROPIC, &[8.0], &[0.02, 0.04, 0.07], MOST_SEEDS),
    (ISOTROPIC, &[15.0], DECADES, MOST_SEEDS),
    (ISOTROPIC, &[15.0], &[0.02, 0.03, 0.05], MOST_SEEDS),
    (OTHERS, &[8.0], DECADES.split_at(1).1, MOST_SEEDS),
    (OTHERS, &[8.0], PLASTIC, MOST_SEEDS),
    (OTHERS, &[4.0], DECADES.split_at(1).1, MOST_SEEDS),
    (&[FAMILIES[4]], USUAL, DECADES.split_at(2).1, LEAST_SEEDS),
];
const SMALL_FAMILY: Family =
    Family { name: "small", waves: [12.0, 16.0], pixels: 128, most_pixels: 256, ..FAMILIES[0] };
/// The small case, which tests solve again.
pub const SMALL: Scope = &[(&[SMALL_FAMILY], &[0.0, 2.0], &[1e-4, 0.02, 0.1], 2)];
