//! Pressures of a map under the pointer: the largest of each of its parts.

use asperity::bem::{Bem, Solution};
use serde::Serialize;

use crate::picture::largest_of;
use crate::shown::shown;

/// Most parts along a side.
const PARTS: usize = 64;

/// What the page says of each part.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct MapReadings {
    /// The middles of columns and of rows.
    x: Vec<String>,
    y: Vec<String>,
    /// Row by row, as the picture from its top.
    values: Vec<String>,
}

impl MapReadings {
    pub(crate) fn of(bem: &Bem, solution: &Solution) -> Self {
        let ([rows, columns], [dy, dx]) = (bem.map().shape(), bem.map().pixel());
        let step = rows.max(columns).div_ceil(PARTS).max(1);
        let (largest, wide) = largest_of(&solution.pressures, columns, step);
        let middles = |count: usize, pixel: f64| {
            (0..count).map(|k| shown((k as f64 + 0.5) * step as f64 * pixel, "m")).collect()
        };
        let said = |pressure: f64| match pressure > 0.0 {
            true => format!("at most {}", shown(pressure, "Pa")),
            false => "no contact".into(),
        };
        Self {
            x: middles(wide, dx),
            y: middles(rows.div_ceil(step), dy),
            values: largest.into_iter().map(said).collect(),
        }
    }
}
