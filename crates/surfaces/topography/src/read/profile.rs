//! Profiles of positions and heights.

use asperity_core::{Code, Finding, written};

use super::points::{SLACK, deviation};
use super::scan::Scan;
use crate::error::refuse;
use crate::{LengthUnit, Topography, TopographyError};

/// The least number of positions whose last digit may be coarse against their distance.
const MANY: usize = 20;
/// The largest unit of the last digit, relative to the distance of points.
const COARSE: f64 = 0.7;

impl Topography {
    /// A profile from positions, ascending or descending, and heights in the same unit; NaN for
    /// missing heights. Heights at unequal distances are interpolated linearly at as many equal
    /// ones, with a warning among the [`notes`](Self::notes).
    ///
    /// # Errors
    /// [`TopographyError::Content`] when the positions have no order or are fewer than two, and
    /// otherwise as [`new`](Self::new).
    pub fn from_profile(
        places: Vec<f64>,
        heights: Vec<f64>,
        unit: LengthUnit,
    ) -> Result<Self, TopographyError> {
        if places.len() != heights.len() {
            let found = format!("{} for {} positions", heights.len(), places.len());
            return Err(refuse("heights", found, "a height for each position"));
        }
        let (Scan { heights, columns, notes, .. }, step) = profile(places, heights)?;
        Ok(Self { notes, ..Self::in_unit(heights, columns, [step; 2], unit)? })
    }
}

/// A profile from ascending or descending positions, in ascending order, and its step. Heights at
/// unequal distances are interpolated linearly at as many equal ones, with a note.
pub(super) fn profile(
    mut places: Vec<f64>,
    mut heights: Vec<f64>,
) -> Result<(Scan, f64), TopographyError> {
    let required = "at least two positions in ascending or descending order";
    let wrong = |found: String| refuse("x", found, required);
    let (Some(&first), Some(&last)) = (places.first(), places.last()) else {
        return Err(wrong("no position".to_owned()));
    };
    if first > last {
        places.reverse();
        heights.reverse();
    }
    let (first, last) = (first.min(last), first.max(last));
    let step = (last - first) / (places.len().max(2) - 1) as f64;
    if !(step > 0.0 && step.is_finite()) {
        return Err(wrong(match places.len() {
            1 => format!("a single position, {}", written(first)),
            many => format!(
                "a profile of {many} positions from {} to {}",
                written(first),
                written(last)
            ),
        }));
    }
    let found = |heights: Vec<f64>, notes| {
        (Scan { columns: heights.len(), heights, notes, ..Scan::default() }, step)
    };
    let farthest = deviation(&places);
    if farthest <= SLACK {
        return Ok(found(heights, vec![]));
    }
    let pairs = || places.windows(2).map(|pair| pair[1] - pair[0]).enumerate();
    if let Some((i, _)) = pairs().find(|(_, distance)| distance.is_nan() || *distance <= 0.0) {
        let (place, before) = (places[i + 1], places[i]);
        return Err(wrong(format!(
            "{} as position {} after {}",
            written(place),
            i + 2,
            written(before)
        )));
    }
    if places.len() >= MANY && last_digit(&places, COARSE * step) >= farthest * step {
        return Ok(found(heights, vec![]));
    }
    let distances = || pairs().map(|(_, distance)| distance);
    let note = Finding::warning(Code::Resampled, "points", places.len() as f64)
        .fact(format!(
            "the positions of the profile are {:.4e} to {:.4e} apart: the heights are interpolated \
             linearly at {} equal distances of {step:.4e}, in the unit of the file",
            distances().fold(f64::INFINITY, f64::min),
            distances().fold(0.0, f64::max),
            places.len() - 1,
        ))
        .advice("slopes and curvatures follow the interpolation; measure at equal distances");
    let heights = interpolated(&places, &heights, step);
    Ok(found(heights, vec![note]))
}

/// The unit of the last digit of the positions, or 0 if it is below a millionth of `largest`.
fn last_digit(places: &[f64], largest: f64) -> f64 {
    let coarsest = 10_f64.powf(largest.log10().floor());
    let units = (0..7).map(|digits| coarsest / 10_f64.powi(digits));
    let fits = |unit: &f64| {
        let whole = |place: &f64| (place / unit - (place / unit).round()).abs() < 1e-6;
        places.iter().all(whole)
    };
    { units }.find(fits).unwrap_or(0.0)
}

/// The heights at the first place and every step after it.
fn interpolated(places: &[f64], heights: &[f64], step: f64) -> Vec<f64> {
    let at = |i: usize| {
        let place = places[0] + step * i as f64;
        let right = places.partition_point(|before| *before < place);
        match (right.checked_sub(1), places.get(right)) {
            (None, _) => heights[0],
            // The last position, up to rounding.
            (Some(left), None) => heights[left],
            // A position is met exactly, whatever is missing before it.
            (Some(_), Some(there)) if *there <= place => heights[right],
            (Some(left), Some(there)) => {
                let share = (place - places[left]) / (there - places[left]);
                heights[left] + share * (heights[right] - heights[left])
            }
        }
    };
    (0..places.len()).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(places: &[f64]) -> String {
        profile(places.to_vec(), vec![0.0; places.len()]).err().unwrap().to_string()
    }

    #[test]
    fn equal_distances_are_kept() {
        let (found, step) = profile(vec![3.0, 2.0, 1.01, 0.0], vec![1.0, 2.0, 3.0, 4.0]).unwrap();
        assert!((step - 1.0).abs() < 1e-12 && found.notes.is_empty());
        // x ascends.
        assert_eq!(found.heights, [4.0, 3.0, 2.0, 1.0]);
        // Positions of 0.156 printed to 0.1.
        let printed: Vec<f64> = (0..99).map(|i| (f64::from(i) * 1.5625).round() / 10.0).collect();
        let (found, _) = profile(printed.clone(), printed.clone()).unwrap();
        assert!(found.notes.is_empty() && found.heights == printed);
    }

    #[test]
    fn unequal_distances_are_interpolated() {
        let places = vec![0.0, 1.0, 1.5, 4.0, 5.0];
        let heights = places.iter().map(|place| 7.0 - 2.0 * place).collect();
        let (found, _) = profile(places, heights).unwrap();
        for (i, height) in found.heights.iter().enumerate() {
            assert!((height - (7.0 - 2.5 * i as f64)).abs() < 1e-12, "{i} {height}");
        }
        let text = found.notes[0].to_string();
        assert!(text.contains("5.0000e-1 to 2.5000e0 apart") && text.contains("4 equal"), "{text}");
        // A missing height leaves a gap as wide as its neighbours.
        let (found, _) =
            profile(vec![0.0, 1.0, 1.5, 4.0, 5.0], vec![1., 2., f64::NAN, 3., 4.]).unwrap();
        let missing: Vec<_> = found.heights.iter().map(|height| height.is_nan()).collect();
        assert_eq!(missing, [false, true, true, true, false]);
    }

    #[test]
    fn a_profile_is_a_topography() {
        let unit = "um".parse().unwrap();
        let found = Topography::from_profile(vec![4.0, 1.0, 0.0], vec![8.0, 2.0, 0.0], unit);
        let found = found.unwrap();
        assert!(found.is_profile() && (found.pixel_size()[0] / 2e-6 - 1.0).abs() < 1e-12);
        assert!((found.heights()[1] / 4e-6 - 1.0).abs() < 1e-12 && found.notes().len() == 1);
        assert!(Topography::from_profile(vec![0.0, 1.0], vec![0.0], unit).is_err());
    }

    #[test]
    fn positions_without_order_are_refused() {
        assert!(message(&[0.0, 2.0, 1.0, 3.0]).contains("1 as position 3 after 2"));
        assert!(message(&[0.0, 0.0, 3.0]).contains("0 as position 2 after 0"));
        assert!(message(&[1.0]).starts_with("x: a single position, 1;"));
        assert!(message(&[]).contains("no position"));
        assert!(message(&[0.0, f64::NAN, 2.0]).contains("NaN as position 2"));
        assert!(message(&[0.0, f64::NAN]).contains("2 positions from 0 to"));
    }
}
