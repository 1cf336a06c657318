//! Pressures of a map under the pointer: the largest of each of its parts.

use asperity::bem::{Bem, Solution};
use serde::Serialize;

use crate::picture::largest_of;
use crate::shown::shown;

/// Most parts along a side.
const PARTS: usize = 64;

/// What the page shows of each part.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct MapReadings {
    /// Pixels along a column and along a row.
    pixels: [usize; 2],
    /// Pixels along a side of a part; the last of a row or column may have fewer.
    step: usize,
    /// The middles of columns and of rows.
    x: Vec<String>,
    y: Vec<String>,
    /// Row by row, as the picture from its top.
    values: Vec<String>,
}

impl MapReadings {
    pub(crate) fn of(bem: &Bem, solution: &Solution) -> Self {
        Self::of_map(&solution.pressures, bem.map().shape(), bem.map().pixel())
    }

    /// Those of pressures on rows x columns of pixels with these heights and widths.
    fn of_map(pressures: &[f64], [rows, columns]: [usize; 2], [dy, dx]: [f64; 2]) -> Self {
        let step = rows.max(columns).div_ceil(PARTS).max(1);
        let (largest, _) = largest_of(pressures, columns, step);
        let middles = |count: usize, pixel: f64| {
            let middle = |from: usize| 0.5 * (from + (from + step).min(count)) as f64 * pixel;
            (0..count).step_by(step).map(|from| shown(middle(from), "m")).collect()
        };
        // A part of several pixels is described by its largest pressure.
        let bound = if step > 1 { "up to " } else { "" };
        let text = |pressure: f64| match pressure > 0.0 {
            true => format!("{bound}{}", shown(pressure, "Pa")),
            false => "no contact".into(),
        };
        Self {
            pixels: [rows, columns],
            step,
            x: middles(columns, dx),
            y: middles(rows, dy),
            values: largest.into_iter().map(text).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_have_their_middle_and_their_largest_pressure() {
        let mut pressures = vec![0.0; 130 * 65];
        (pressures[129], pressures[128]) = (2e9, 1e9);
        let found = MapReadings::of_map(&pressures, [65, 130], [2e-6, 1e-6]);
        assert_eq!((found.step, found.x.len(), found.y.len()), (3, 44, 22));
        assert_eq!([&found.x[42], &found.x[43], &found.y[21]], ["127.5 µm", "129.5 µm", "128 µm"]);
        assert_eq!([&found.values[42], &found.values[43]], ["up to 1 GPa", "up to 2 GPa"]);
        assert_eq!((found.values.len(), &*found.values[44]), (44 * 22, "no contact"));
    }

    #[test]
    fn a_single_pixel_has_its_own_pressure() {
        let found = MapReadings::of_map(&[0.0, 3e6], [1, 2], [1e-6; 2]);
        assert_eq!((found.step, found.values), (1, vec!["no contact".into(), "3 MPa".into()]));
    }
}
