//! Options for reading scans, and the content of a file, completed by them.

use std::fmt::Display;

use asperity_core::{Code, Finding};

use crate::error::{at_most, excerpt, out_of_range, refuse};
use crate::{Distance, LengthUnit, MAX_POINTS, Topography, TopographyError};

/// Smaller pixels \[m\] are refused: no instrument resolves them.
const ATOM: f64 = 1e-11;

/// The highest ratio of deflate: 258 bytes in two bits.
pub(super) const DEFLATE_RATIO: usize = 1032;

/// Properties that a file may not state, and the accepted share of missing points.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadOptions {
    /// Unit of the heights, and of a `pixel_size` without one. A unit stated in the file must
    /// agree.
    pub unit: Option<LengthUnit>,
    /// Distance of neighbouring points along a row and along a column; without a unit of its own in
    /// `unit` (by default in the unit stated in the file). A distance stated in the file must
    /// agree to one part in a thousand.
    pub pixel_size: Option<[Distance; 2]>,
    /// The largest share of missing points accepted, 0 to 1; 0.1 by default.
    pub max_missing: f64,
    /// The channel of a file with several (.gwy, .sur): its name, or its number among those of
    /// heights, from 1. By default the first one with heights.
    pub channel: Option<String>,
}

impl ReadOptions {
    /// Checks the range of every option, before a file is read.
    pub(crate) fn check(&self) -> Result<(), TopographyError> {
        for size in self.pixel_size.into_iter().flatten().map(|size| size.value) {
            if !(f64::MIN_POSITIVE..=f64::MAX).contains(&size) {
                return Err(out_of_range("pixel_size", size, "a finite length above 0"));
            }
        }
        if !(0.0..=1.0).contains(&self.max_missing) {
            return Err(out_of_range("max_missing", self.max_missing, "a share from 0 to 1"));
        }
        Ok(())
    }
}

impl Default for ReadOptions {
    fn default() -> Self {
        Self { unit: None, pixel_size: None, max_missing: 0.1, channel: None }
    }
}

/// The distance between points, as stated in the file.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) enum PixelSize {
    /// Not stated.
    #[default]
    Unknown,
    /// A number in the unit of the heights.
    InUnit([f64; 2]),
    /// A length \[m\].
    Metres([f64; 2]),
}

/// A surface as stored in its file.
#[derive(Debug, Default)]
pub(super) struct Scan {
    /// Heights in `unit`, row by row: x grows with the column and y with the row, in the
    /// coordinates of the file or, without any, in its order. NaN for missing points.
    pub(super) heights: Vec<f64>,
    pub(super) columns: usize,
    /// Unit of the heights, if the file states it.
    pub(super) unit: Option<LengthUnit>,
    pub(super) pixel_size: PixelSize,
    /// Choices made in reading.
    pub(super) notes: Vec<Finding>,
}

impl Scan {
    /// The surface in metres.
    pub(super) fn topography(self, options: &ReadOptions) -> Result<Topography, TopographyError> {
        let named = self.unit(options)?;
        let unit = named.metres();
        let pixel_size = self.pixel_size(options, named)?;
        let mut bare = options.pixel_size.into_iter().flatten().filter(|size| size.unit.is_none());
        if let Some(tiny) = bare.find(|size| size.value * unit < ATOM) {
            let (value, metres) = (tiny.value, tiny.value * unit);
            return Err(TopographyError::TinyPixel { value, unit: named, metres });
        }
        let Self { mut heights, columns, notes, .. } = self;
        for height in &mut heights {
            *height *= unit;
        }
        let topography = Topography { notes, ..Topography::new(heights, columns, pixel_size)? };
        let share = topography.missing_share();
        let limit = options.max_missing;
        if share > limit {
            return Err(TopographyError::TooManyMissing { share, limit });
        }
        Ok(topography)
    }

    fn unit(&self, options: &ReadOptions) -> Result<LengthUnit, TopographyError> {
        match (options.unit, self.unit) {
            (Some(given), Some(in_file)) if given != in_file => {
                Err(contradiction("unit", given, in_file))
            }
            (given, in_file) => given.or(in_file).ok_or(TopographyError::UnitMissing),
        }
    }

    fn pixel_size(
        &self,
        options: &ReadOptions,
        named: LengthUnit,
    ) -> Result<[f64; 2], TopographyError> {
        let unit = named.metres();
        let given = options.pixel_size.map(|size| size.map(|size| size.in_unit(named) * unit));
        let in_file = match self.pixel_size {
            PixelSize::Unknown => None,
            PixelSize::InUnit(size) => Some(size.map(|size| size * unit)),
            PixelSize::Metres(size) => Some(size),
        };
        if let (Some(given), Some(in_file)) = (given, in_file) {
            // A profile uses the first only.
            let axes = if self.heights.len() == self.columns { 1 } else { 2 };
            for (given, in_file) in given.into_iter().zip(in_file).take(axes) {
                if (given - in_file).abs() > 1e-3 * in_file {
                    let [given, in_file] = [given, in_file].map(|size| format!("{size:e} m"));
                    return Err(contradiction("pixel_size", given, in_file));
                }
            }
        }
        in_file.or(given).ok_or(TopographyError::PixelSizeMissing)
    }
}

/// An option that disagrees with the file.
fn contradiction<T: Display>(option: &'static str, given: T, in_file: T) -> TopographyError {
    let (given, in_file) = (given.to_string(), in_file.to_string());
    TopographyError::Contradiction { option, given, in_file }
}

/// The product of two counts declared in a file, if it is within the limit of points.
pub(super) fn points(columns: u64, rows: u64) -> Result<usize, TopographyError> {
    let size = columns.saturating_mul(rows);
    at_most("the number of points", size, MAX_POINTS as u64)?;
    Ok(size as usize)
}

/// A field of a file that is a length or a factor.
pub(super) fn positive<T: Into<f64> + Display + Copy>(
    field: impl Display,
    found: T,
) -> Result<f64, TopographyError> {
    let value = found.into();
    let wrong = || refuse(field, found, "a finite number above 0");
    (value.is_finite() && value > 0.0).then_some(value).ok_or_else(wrong)
}

/// Reverses every row.
pub(super) fn mirror_columns(heights: &mut [f64], columns: usize) {
    heights.chunks_mut(columns).for_each(<[f64]>::reverse);
}

/// Reverses the order of the rows.
pub(super) fn mirror_rows(heights: &mut [f64], columns: usize) {
    heights.reverse();
    mirror_columns(heights, columns);
}

/// The error for a channel that the file does not have.
pub(super) fn unknown_channel(channel: &str, names: String) -> TopographyError {
    TopographyError::UnknownName { field: "channel", found: excerpt(channel), names }
}

/// The index of a channel, and a note on the choice where the file has several.
pub(super) fn select(
    names: &[String],
    channel: Option<&str>,
) -> Result<(usize, Option<Finding>), TopographyError> {
    let list = || {
        let shown = names.iter().take(12).enumerate();
        let shown = shown.map(|(i, name)| format!("{} {:?}", i + 1, excerpt(name)));
        shown.collect::<Vec<_>>().join(", ")
    };
    let Some(channel) = channel else {
        let note = |name: &String| {
            Finding::note(Code::Channel, "channel", 1.0)
                .fact(format!("the file has {} surfaces; {:?} is read", names.len(), excerpt(name)))
                .advice(format!("choose another with channel: {}", list()))
        };
        return Ok((0, names.first().filter(|_| names.len() > 1).map(note)));
    };
    let same = |name: &String| name.to_lowercase() == channel.trim().to_lowercase();
    let numbered = || channel.trim().parse::<usize>().ok()?.checked_sub(1);
    let at = names.iter().position(same).or_else(numbered).filter(|at| *at < names.len());
    let wrong = || unknown_channel(channel, list());
    Ok((at.ok_or_else(wrong)?, None))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scan(unit: Option<LengthUnit>, pixel_size: PixelSize) -> Scan {
        Scan { heights: vec![1.0, 2.0, f64::NAN, 4.0], columns: 2, unit, pixel_size, notes: vec![] }
    }

    fn message(scan: Scan, options: &ReadOptions) -> String {
        scan.topography(options).unwrap_err().to_string()
    }

    #[test]
    fn missing_units_and_pixel_sizes_are_requested() {
        let options = ReadOptions { max_missing: 0.5, ..ReadOptions::default() };
        let unit = Some(LengthUnit::Nanometre);
        assert!(message(scan(None, PixelSize::Unknown), &options).contains("give unit"));
        assert!(message(scan(unit, PixelSize::Unknown), &options).contains("give pixel_size"));
        // The pixel size given is in the unit of the heights.
        let options = ReadOptions { pixel_size: Some([2.0, 3.0].map(Distance::from)), ..options };
        let surface = scan(unit, PixelSize::Unknown).topography(&options).unwrap();
        assert!((surface.pixel_size()[1] / 3e-9 - 1.0).abs() < 1e-15);
        assert!((surface.heights()[3] / 4e-9 - 1.0).abs() < 1e-15);
        assert!(surface.heights()[2].is_nan());
    }

    #[test]
    fn options_that_contradict_the_file_are_refused() {
        let options = ReadOptions {
            unit: Some(LengthUnit::Micrometre),
            pixel_size: Some([Distance::from(2.0); 2]),
            max_missing: 0.5,
            channel: None,
        };
        let in_nm = scan(Some(LengthUnit::Nanometre), PixelSize::Unknown);
        let finer = scan(None, PixelSize::Metres([2e-6, 1e-6]));
        for (other, named) in [(in_nm, "unit"), (finer, "pixel_size")] {
            let refused = other.topography(&options);
            assert!(
                matches!(refused, Err(TopographyError::Contradiction { option, .. }) if option == named)
            );
        }
        let same = scan(Some(LengthUnit::Micrometre), PixelSize::InUnit([2.0004, 2.0]));
        let surface = same.topography(&options).unwrap();
        assert!((surface.pixel_size()[0] / 2.0004e-6 - 1.0).abs() < 1e-15);
    }

    #[test]
    fn missing_points_are_refused_above_their_share() {
        let some = |max_missing| {
            let options = ReadOptions { max_missing, ..ReadOptions::default() };
            scan(Some(LengthUnit::Metre), PixelSize::InUnit([1.0; 2])).topography(&options)
        };
        assert!(some(0.25).is_ok());
        assert!(matches!(some(0.1), Err(TopographyError::TooManyMissing { share: 0.25, .. })));
    }
}
