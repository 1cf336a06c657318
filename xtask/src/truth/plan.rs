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
const OTHERS: &[Family] = FAMILIES.split_at(4).1;
/// Loads on skewed surfaces and on those with a lay.
const FEW_LOADS: &[f64] = &[1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3];

/// The committed evidence: what matters most first.
pub const FULL: Scope = Scope {
    parts: &[
        Part { families: ISOTROPIC, indices: &[0.0, 2.0], loads: &LOADS },
        Part { families: OTHERS, indices: &[0.0, 2.0], loads: FEW_LOADS },
        Part { families: ISOTROPIC, indices: &[1.0, 4.0], loads: &LOADS },
        Part { families: ISOTROPIC, indices: &[0.7, 8.0], loads: &LOADS },
    ],
    most_seeds: super::solved::MOST_SEEDS,
};

/// A sketch of the evidence in two minutes.
pub const QUICK: Scope = Scope {
    parts: &[Part {
        families: ISOTROPIC.split_at(3).0,
        indices: &[0.0, 2.0],
        loads: &[3e-4, 1e-2, 0.1],
    }],
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
