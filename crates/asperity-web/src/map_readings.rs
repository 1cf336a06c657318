//! Pressures of a map under the pointer: the largest of each of its parts.

use asperity::bem::{Bem, Solution};
use serde_json::{Value, json};

use crate::picture::largest_of;
use crate::shown::shown;

/// Most parts along a side.
const PARTS: usize = 64;

/// What the page shows of each part of the pressures of a solution.
pub(crate) fn map_readings(bem: &Bem, solution: &Solution) -> Value {
    of_map(&solution.pressures, bem.map().shape(), bem.map().pixel())
}

/// The readings of pressures on rows x columns of pixels with these heights and widths: the pixels
/// along a side of a part, of which the last of a row or column may have fewer, the middles of
/// columns and of rows, and the values row by row, as the picture from its top.
fn of_map(pressures: &[f64], [rows, columns]: [usize; 2], [dy, dx]: [f64; 2]) -> Value {
    let step = rows.max(columns).div_ceil(PARTS).max(1);
    let (largest, _) = largest_of(pressures, columns, step);
    let middles = |count: usize, pixel: f64| -> Value {
        let middle = |from: usize| 0.5 * (from + (from + step).min(count)) as f64 * pixel;
        (0..count).step_by(step).map(|from| shown(middle(from), "m")).collect()
    };
    // A part of several pixels is described by its largest pressure.
    let bound = if step > 1 { "up to " } else { "" };
    let text = |pressure: f64| match pressure > 0.0 {
        true => format!("{bound}{}", shown(pressure, "Pa")),
        false => "no contact".into(),
    };
    let values: Value = largest.into_iter().map(text).collect();
    let (x, y) = (middles(columns, dx), middles(rows, dy));
    json!({ "pixels": [rows, columns], "step": step, "x": x, "y": y, "values": values })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_have_their_middle_and_their_largest_pressure() {
        let mut pressures = vec![0.0; 130 * 65];
        (pressures[129], pressures[128]) = (2e9, 1e9);
        let found = of_map(&pressures, [65, 130], [2e-6, 1e-6]);
        let all = |key: &str| found[key].as_array().unwrap();
        assert_eq!((&found["step"], all("x").len(), all("y").len()), (&json!(3), 44, 22));
        assert_eq!(all("x")[42..44], [json!("127.5 µm"), json!("129.5 µm")]);
        assert_eq!((&found["y"][21], all("values").len()), (&json!("128 µm"), 44 * 22));
        let values = ["up to 1 GPa", "up to 2 GPa", "no contact"].map(Value::from);
        assert_eq!(all("values")[42..45], values);
    }

    #[test]
    fn a_single_pixel_has_its_own_pressure() {
        let found = of_map(&[0.0, 3e6], [1, 2], [1e-6; 2]);
        assert_eq!(
            (&found["step"], &found["values"]),
            (&json!(1), &json!(["no contact", "3 MPa"]))
        );
    }
}
