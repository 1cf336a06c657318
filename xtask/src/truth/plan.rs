//! The extent of the evidence: which families, materials and loads.

use anyhow::Result;

use super::family::{FAMILIES, Family, LOADS, is_carried, scene};
use crate::figures::truth;

/// Number of seeds behind every row.
pub const LEAST_SEEDS: u64 = 4;

/// Families with the same materials and loads.
#[derive(Debug, Clone, Copy)]
pub struct Part {
    /// Surfaces.
    pub families: &'static [Family],
    /// Plasticity indices; 0 for no hardness.
    pub indices: &'static [f64],
    /// Pressures over E g.
    pub loads: &'static [f64],
    /// Most surfaces of a case.
    pub most_seeds: u64,
}

/// Parts in the order in which they are solved.
#[derive(Debug, Clone, Copy)]
pub struct Scope {
    /// What matters most comes first.
    pub parts: &'static [Part],
}

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

impl Part {
    /// The cases of a family whose load is carried.
    ///
    /// # Errors
    /// A surface that cannot be made.
    pub fn cases_of(&self, family: Family) -> Result<Vec<Case>> {
        let surface = family.surface(family.pixels)?;
        let mut all = vec![];
        for &index in self.indices {
            let hardness = scene(&surface, index)?.interface.hardness;
            let carried = self.loads.iter().filter(|load| is_carried(hardness, **load));
            let seeds = [LEAST_SEEDS.min(self.most_seeds), self.most_seeds];
            all.extend(carried.map(|&load| Case { family, index, load, seeds }));
        }
        Ok(all)
    }
}

impl Scope {
    /// All cases in the order of the table.
    ///
    /// # Errors
    /// A surface that cannot be made.
    pub fn cases(&self) -> Result<Vec<Case>> {
        let mut all: Vec<Case> = vec![];
        for part in self.parts {
            for family in part.families {
                all.extend(part.cases_of(*family)?);
            }
        }
        let place = |case: &Case| FAMILIES.iter().position(|family| *family == case.family);
        all.sort_by(|a, b| {
            let index = a.index.total_cmp(&b.index);
            place(a).cmp(&place(b)).then(index).then(a.load.total_cmp(&b.load))
        });
        Ok(all)
    }
}

const ISOTROPIC: &[Family] = FAMILIES.split_at(4).0;
/// Skewed surfaces and those with a lay.
const OTHERS: &[Family] = FAMILIES.split_at(4).1;
const LIGHT_LOADS: &[f64] = LOADS.split_at(4).0;
const HEAVY_LOADS: &[f64] = LOADS.split_at(4).1;
/// One load of a decade.
const DECADES: &[f64] = &[1e-5, 1e-4, 1e-3, 1e-2, 0.1];
/// Where separations of yielded contacts change most between decades.
const PLASTIC: &[f64] = &[0.03, 0.05];

/// Most surfaces of a case.
pub const MOST_SEEDS: u64 = 16;

/// The committed evidence: what matters most first.
pub const FULL: Scope = Scope {
    parts: &[
        Part {
            families: &[FAMILIES[2], FAMILIES[3]],
            indices: &[0.0, 2.0, 4.0],
            loads: LIGHT_LOADS,
            most_seeds: truth::MOST_SEEDS,
        },
        part(FAMILIES.split_at(2).0, &[0.0, 2.0, 4.0], &LOADS),
        part(&[FAMILIES[2]], &[0.0, 2.0, 4.0], HEAVY_LOADS),
        part(&[FAMILIES[3]], &[0.0, 2.0, 4.0], DECADES.split_at(2).1),
        part(OTHERS, &[0.0, 2.0], DECADES.split_at(1).1),
        part(ISOTROPIC, &[1.0, 8.0], DECADES),
        part(FAMILIES.split_at(2).0, &[0.7], DECADES),
        part(&[FAMILIES[3]], &[4.0], &[0.03]),
        part(ISOTROPIC, &[8.0], PLASTIC),
    ],
};

const fn part(families: &'static [Family], indices: &'static [f64], loads: &'static [f64]) -> Part {
    Part { families, indices, loads, most_seeds: MOST_SEEDS }
}

/// A sketch of the evidence in two minutes.
pub const QUICK: Scope = Scope {
    parts: &[Part {
        families: FAMILIES.split_at(3).0,
        indices: &[0.0, 2.0],
        loads: &[3e-4, 1e-2, 0.1],
        most_seeds: 2,
    }],
};

/// The small case, which tests solve again.
pub const SMALL: Scope = Scope {
    parts: &[Part {
        families: &[Family {
            name: "small",
            waves: [12.0, 16.0],
            pixels: 128,
            most_pixels: 256,
            ..FAMILIES[0]
        }],
        indices: &[0.0, 2.0],
        loads: &[1e-4, 0.02, 0.1],
        most_seeds: 2,
    }],
};
