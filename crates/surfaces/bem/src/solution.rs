//! The solution of a contact: area, pressures and gaps.

use std::f64::consts::{LN_2, PI};

use asperity_core::{At, Finding};

use crate::{Boundary, HeightMap, note};

/// A load case: the prescribed pressure, load or gap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LoadCase {
    /// Mean pressure on the area of the map \[Pa\].
    MeanPressure(f64),
    /// Load on the area of the map \[N\].
    Load(f64),
    /// Mean gap \[m\]: distance of the mean planes of the two deformed surfaces.
    MeanGap(f64),
    /// [Separation](Solution::separation) \[m\], of any sign.
    Separation(f64),
}

/// A solved contact.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Solution {
    /// The load case.
    pub given: LoadCase,
    /// Mean pressure on the area of the map \[Pa\].
    pub mean_pressure: f64,
    /// Load on the area of the map \[N\].
    pub load: f64,
    /// Real area of contact over the area of the map, corrected for the staircase edge of pixels:
    /// the counted share less (π - 1 + ln 2)/24 of a pixel for every edge of the contact
    /// (Yastrebov and others 2017 \[recalled\], the constant \[seen in tamaas\]). The constant
    /// holds for elastic contacts, whose pressure falls to 0 at the edge; with a hardness H the
    /// area is at least F/H, the least that can carry the load F: within 2 % of finer grids at 8
    /// pixels per shortest wave. \[derived\]
    pub area: f64,
    /// Share of the pixels that carry pressure.
    pub pixel_area: f64,
    /// Share of the pixels that carry the hardness.
    pub plastic_area: f64,
    /// Number of edges between a pixel in contact and one that is not.
    pub edges: usize,
    /// Mean gap \[m\]: distance of the mean planes of the two deformed surfaces. In plastic
    /// pixels the gap is less than 0 by the plastic depth.
    pub mean_gap: f64,
    /// Mean gap \[m\] of the pixels out of contact; `None` where every pixel touches.
    pub mean_open_gap: Option<f64>,
    /// Volume of the gap over the area of the map \[m\]: the mean gap with plastic pixels counted
    /// as 0.
    pub gap_volume: f64,
    /// Separation \[m\]: height of the mean plane of the rough surface above the half-space far
    /// from the map. With a free boundary the mean gap exceeds it by the mean deflection under the
    /// map; if periodic they are equal.
    pub separation: f64,
    /// Number of pixels of every contact patch, largest first. Pixels touch over edges.
    pub patches: Vec<usize>,
    /// Pressures \[Pa\], row after row.
    pub pressures: Vec<f64>,
    /// Gaps \[m\], row after row: 0 in contact, to within the tolerance times the scale of the
    /// residual.
    pub gaps: Vec<f64>,
    /// Σ p (g - min g)/(Σ p s), with a hardness Σ (p g⁺ + (H - p) g⁻)/(Σ p s): a bound of the
    /// energy that is missing. The scale s is Sq or, where that is less, F/(E Δ): about the
    /// deflection of one pixel of side Δ that carries all of the load F.
    pub residual: f64,
    /// Number of iterations, including all trials for a mean gap.
    pub iterations: usize,
    /// Findings of the resolution: `short-waves`, `open-seam`, `few-pixels`, `few-patches`.
    pub notes: Vec<Finding>,
}

/// Share of a pixel that a counted contact is too large by for every edge.
pub const EDGE_SHARE: f64 = (PI - 1.0 + LN_2) / 24.0;

/// The area of a contact in pixels, corrected for its edges.
pub(crate) fn corrected_area(pixels: usize, edges: usize) -> f64 {
    pixels as f64 - EDGE_SHARE * edges as f64
}

/// The result of the iteration.
pub(crate) struct Fields {
    pub(crate) pressures: Vec<f64>,
    pub(crate) gaps: Vec<f64>,
    pub(crate) separation: f64,
    pub(crate) residual: f64,
    pub(crate) iterations: usize,
}

impl Fields {
    pub(crate) fn mean_gap(&self) -> f64 {
        self.gaps.iter().sum::<f64>() / self.gaps.len() as f64
    }
}

impl Solution {
    pub(crate) fn new(
        given: LoadCase,
        (map, boundary, cap): (&HeightMap, Boundary, f64),
        fields: Fields,
        mut notes: Vec<Finding>,
    ) -> Self {
        let mean_gap = fields.mean_gap();
        let Fields { pressures, gaps, separation, residual, iterations } = fields;
        let pixels = pressures.len() as f64;
        let touching: Vec<bool> = pressures.iter().map(|&pressure| pressure > 0.0).collect();
        let count = touching.iter().filter(|&&touches| touches).count();
        let plastic = pressures.iter().filter(|&&pressure| pressure >= cap).count();
        let periodic = boundary == Boundary::Periodic;
        let edges = edges(&touching, map.shape(), periodic);
        let patches = patches(&touching, map.shape(), periodic);
        let mean_pressure = pressures.iter().sum::<f64>() / pixels;
        let (carried, at) = match given {
            LoadCase::MeanPressure(pressure) => (pressure, At::Pressure(pressure)),
            LoadCase::Load(load) => (load / map.area(), At::Load(load)),
            LoadCase::MeanGap(_) | LoadCase::Separation(_) => {
                (mean_pressure, At::Pressure(mean_pressure))
            }
        };
        // At least F/H to the last digit of the given load.
        let (counted, least) = (corrected_area(count, edges) / pixels, carried / cap);
        notes.extend(note::of_contact(at, [count, pressures.len()], patches.len(), boundary));
        let open = gaps.iter().zip(&touching).filter(|(_, touches)| !**touches);
        let open = open.map(|(gap, _)| gap).sum::<f64>() / (pixels - count as f64);
        Self {
            given,
            mean_pressure,
            load: mean_pressure * map.area(),
            area: counted.max(least),
            pixel_area: count as f64 / pixels,
            plastic_area: plastic as f64 / pixels,
            edges,
            mean_gap,
            mean_open_gap: (count < pressures.len()).then_some(open),
            gap_volume: gaps.iter().map(|gap| gap.max(0.0)).sum::<f64>() / pixels,
            separation,
            patches,
            pressures,
            gaps,
            residual,
            iterations,
            notes,
        }
    }
}

/// Edges of the contact inside the map, over its seams too when it is periodic.
pub(crate) fn edges(touching: &[bool], [rows, columns]: [usize; 2], periodic: bool) -> usize {
    let mut edges = 0;
    for (i, row) in touching.chunks(columns).enumerate() {
        let below = (i + 1) % rows;
        let next_row = &touching[below * columns..][..columns];
        if periodic || below > 0 {
            edges += row.iter().zip(next_row).filter(|(a, b)| a != b).count();
        }
        edges += row.windows(2).filter(|pair| pair[0] != pair[1]).count();
        edges += usize::from(periodic && row[columns - 1] != row[0]);
    }
    edges
}

/// Sizes of the patches in pixels, largest first. Pixels hang together over edges, not corners,
/// and over the seams of a periodic map.
pub(crate) fn patches(
    touching: &[bool],
    [rows, columns]: [usize; 2],
    periodic: bool,
) -> Vec<usize> {
    // A forest: every pixel points to one of its patch, the root to itself.
    let mut parent: Vec<usize> = (0..touching.len()).collect();
    let join = |parent: &mut Vec<usize>, a: usize, b: usize| {
        if touching[a] && touching[b] {
            let (a, b) = (root(parent, a), root(parent, b));
            parent[a.max(b)] = a.min(b);
        }
    };
    for i in 0..rows {
        for j in 0..columns {
            let at = i * columns + j;
            if j + 1 < columns || periodic {
                join(&mut parent, at, i * columns + (j + 1) % columns);
            }
            if i + 1 < rows || periodic {
                join(&mut parent, at, (i + 1) % rows * columns + j);
            }
        }
    }
    let mut sizes = vec![0; touching.len()];
    for at in (0..touching.len()).filter(|&at| touching[at]) {
        sizes[root(&mut parent, at)] += 1;
    }
    sizes.retain(|&size| size > 0);
    sizes.sort_unstable_by(|a, b| b.cmp(a));
    sizes
}

/// Root of a pixel; halves the paths on the way.
fn root(parent: &mut [usize], mut at: usize) -> usize {
    while parent[at] != at {
        parent[at] = parent[parent[at]];
        at = parent[at];
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_inside_and_over_the_seams() {
        // A corner pixel: two edges inside, four with the seams.
        let mut touching = vec![false; 12];
        touching[0] = true;
        assert_eq!(edges(&touching, [3, 4], false), 2);
        assert_eq!(edges(&touching, [3, 4], true), 4);
        assert_eq!(edges(&[true; 12], [3, 4], true), 0);
    }

    #[test]
    fn over_edges_and_seams_but_not_over_corners() {
        let map = "
            #..#.
            .#...
            .##..
            #...#";
        let touching: Vec<bool> =
            map.chars().filter(|c| "#.".contains(*c)).map(|c| c == '#').collect();
        assert_eq!(patches(&touching, [4, 5], false), [3, 1, 1, 1, 1]);
        // The corners meet over both seams, the rest does not.
        assert_eq!(patches(&touching, [4, 5], true), [3, 3, 1]);
        assert_eq!(patches(&[false; 20], [4, 5], true), []);
        assert_eq!(patches(&[true; 20], [4, 5], false), [20]);
    }
}
