//! The extent of the evidence: which families, materials and loads.

use super::solved::{FAMILIES, Family, LOADS};

/// Families with the same materials and loads.
#[derive(Debug, Clone, Copy)]
pub struct Part {
    /// Surfaces.
    pub families: &'static [Family],
    /// Plasticity indices; 0 for no hardness.
    pub indices: &'static [f64],
    /// Pressures over E g.
    pub loads: &'static [f64],
}

/// Parts in the order in which they are solved, and the most seeds of a case.
#[derive(Debug, Clone, Copy)]
pub struct Scope {
    /// What matters most comes first.
    pub parts: &'static [Part],
    /// Surfaces of a case.
    pub most_seeds: u64,
}

const ISOTROPIC: &[Family] = FAMILIES.split_at(4).0;
/// Alpha to 30.
const NARROW: &[Family] = FAMILIES.split_at(3).0;
/// The broadest spectrum, whose heavy loads need the most pixels.
const BROAD: &[Family] = ISOTROPIC.split_at(3).1;
const OTHERS: &[Family] = FAMILIES.split_at(4).1;
/// One load of a decade.
const DECADES: &[f64] = &[1e-5, 1e-4, 1e-3, 1e-2, 0.1];
/// Loads on skewed surfaces and on those with a lay.
const FEW_LOADS: &[f64] = &[1e-4, 1e-3, 1e-2, 0.1];
/// Loads on the broadest spectrum.
const BROAD_LOADS: &[f64] = &[1e-5, 3e-5, 1e-4, 3e-4, 1e-3, 1e-2, 0.1];

/// The committed evidence: what matters most first.
pub const FULL: Scope = Scope {
    parts: &[
        Part { families: NARROW, indices: &[0.0, 2.0, 4.0], loads: &LOADS },
        Part { families: BROAD, indices: &[0.0, 2.0, 4.0], loads: BROAD_LOADS },
        Part { families: ISOTROPIC, indices: &[1.0, 8.0], loads: DECADES },
        Part { families: OTHERS, indices: &[0.0, 2.0], loads: FEW_LOADS },
        Part { families: FAMILIES.split_at(2).0, indices: &[0.7], loads: DECADES },
    ],
    most_seeds: super::solved::MOST_LIGHT_SEEDS,
};

/// A sketch of the evidence in two minutes.
pub const QUICK: Scope = Scope {
    parts: &[Part { families: NARROW, indices: &[0.0, 2.0], loads: &[3e-4, 1e-2, 0.1] }],
    most_seeds: 2,
};

/// The small case, which tests solve again.
pub const SMALL: Scope = Scope {
    parts: &[Part {
        families: &[Family {
            name: "small",
            waves: [12.0, 16.0],
            skewness: 0.0,
            slope_ratio: 1.0,
            pixels: 128,
            most_pixels: 256,
        }],
        indices: &[0.0, 2.0],
        loads: &[1e-4, 0.02, 0.1],
    }],
    most_seeds: 2,
};
