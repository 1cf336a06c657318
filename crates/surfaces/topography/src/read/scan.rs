//! Options for reading scans, and the content of a file, completed by them.

use std::fmt::Display;

use asperity_core::{Code, Finding};
use serde::{Deserialize, Deserializer};

use crate::error::{at_most, excerpt, out_of_range, refuse, undecided, unknown_name};
use crate::topography::extremes;
use crate::{Distance, Given, LengthUnit, MAX_POINTS, Topography, TopographyError};

/// Smaller pixels \[m\] are refused: no instrument resolves them.
const ATOM: f64 = 1e-11;

/// The highest ratio of deflate: 258 bytes in two bits.
pub(super) const DEFLATE_RATIO: usize = 1032;

/// Properties that a file may not state, and the accepted share of missing points.
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(default)]
pub struct ReadOptions {
    /// Unit of the heights, and of a `pixel_size` without one. A unit stated in the file must
    /// agree.
    pub unit: Option<LengthUnit>,
    /// Distance of neighbouring points along a row and along a column; without a unit of its own in
    /// `unit` (by default in the unit stated in the file). A distance stated in the file must
    /// agree to one part in a thousand.
    #[serde(deserialize_with = "sides")]
    pub pixel_size: Option<[Distance; 2]>,
    /// The largest share of missing points accepted, 0 to 1; by default
    /// [`MAX_MISSING`](Self::MAX_MISSING).
    pub max_missing: Option<f64>,
    /// The channel of a file with several (.gwy, .sur): its name, or its number among those of
    /// heights, from 1. By default the first one with heights. Of a text with several tables, the
    /// name or the number of the table; it has no default.
    #[serde(deserialize_with = "word")]
    pub channel: Option<String>,
    /// Units of a text that states none: of lengths and heights, or of x, y and heights.
    pub units: Option<Vec<LengthUnit>>,
    /// The columns of a text: `x,y,z` for each column, with `-` for those left out; the number of
    /// the column of heights, from 1; `matrix`, if all are heights; or `axes`, if the first row or
    /// column, or both, are positions.
    #[serde(deserialize_with = "word")]
    pub columns: Option<String>,
    /// The number of lines at the beginning of a text that are not read.
    pub skip_lines: usize,
    /// The number that marks missing points in the file; NaN if none does, although it seems so.
    pub missing: Option<f64>,
    /// The factor from the numbers in the file to heights in their unit. A factor stated in the
    /// file must agree.
    pub factor: Option<f64>,
    /// The separator of the fields of a text, in ASCII; a space stands for any number of blanks. By
    /// default that of the first row.
    pub delimiter: Option<char>,
}

/// One distance, of square pixels, or two.
fn sides<'de, D: Deserializer<'de>>(given: D) -> Result<Option<[Distance; 2]>, D::Error> {
    #[derive(Deserialize)]
    #[serde(
        untagged,
        expecting = "a length in the unit of the heights or with its own (\"0.5 um\"), or a list of two, along a row and a column,"
    )]
    enum Sides {
        Square(Distance),
        Rectangle([Distance; 2]),
    }
    Ok(Some(match Sides::deserialize(given)? {
        Sides::Square(side) => [side; 2],
        Sides::Rectangle(sides) => sides,
    }))
}

/// A text, or a number as one.
fn word<'de, D: Deserializer<'de>>(given: D) -> Result<Option<String>, D::Error> {
    Ok(Some(match Given::deserialize(given)? {
        Given::Text(text) => text,
        Given::Number(number) => number.to_string(),
    }))
}

impl ReadOptions {
    /// The share of missing points that is accepted by default.
    pub const MAX_MISSING: f64 = 0.1;

    /// Checks the range of every option, before a file is read.
    pub(crate) fn check(&self) -> Result<(), TopographyError> {
        for size in self.pixel_size.into_iter().flatten().map(|size| size.value) {
            if !(f64::MIN_POSITIVE..=f64::MAX).contains(&size) {
                return Err(out_of_range("pixel_size", size, "a finite length above 0"));
            }
        }
        if let Some(share) = self.max_missing.filter(|share| !(0.0..=1.0).contains(share)) {
            return Err(out_of_range("max_missing", share, "a share from 0 to 1"));
        }
        if let Some(factor) = self.factor.filter(|factor| *factor == 0.0 || !factor.is_finite()) {
            return Err(out_of_range("factor", factor, "a finite number other than 0"));
        }
        if let Some(delimiter) = self.delimiter.filter(|delimiter| !delimiter.is_ascii()) {
            let found = format!("{delimiter:?}");
            return Err(refuse("delimiter", found, "an ASCII character, for example \";\""));
        }
        match self.units.as_ref().map(Vec::len) {
            None | Some(2 | 3) => Ok(()),
            Some(n) => Err(out_of_range("the number of units", n as f64, "2 or 3")),
        }
    }

    /// The unit of lengths along an axis.
    pub(super) fn lateral(&self, axis: usize) -> Option<LengthUnit> {
        let units = self.units.as_ref()?;
        units.get(if units.len() > 2 { axis } else { 0 }).copied()
    }

    /// The unit of the heights.
    pub(super) fn height_unit(&self) -> Option<LengthUnit> {
        self.unit.or_else(|| self.units.as_ref()?.last().copied())
    }
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
    /// The distance of points, if the file states it.
    pub(super) pixel_size: Option<[Distance; 2]>,
    /// Factor from `heights` to heights in the unit, if the file states it.
    pub(super) factor: Option<f64>,
    /// Choices made in reading.
    pub(super) notes: Vec<Finding>,
}

impl Scan {
    /// Heights in a unit, at distances in m.
    pub(super) fn new(
        heights: Vec<f64>,
        columns: usize,
        unit: Option<LengthUnit>,
        pixel_size: [f64; 2],
    ) -> Self {
        let pixel_size = Some(pixel_size.map(Distance::metre));
        Self { heights, columns, unit, pixel_size, ..Self::default() }
    }

    /// The surface in metres.
    pub(super) fn topography(self, options: &ReadOptions) -> Result<Topography, TopographyError> {
        let named = self.unit(options)?;
        let unit = named.metres();
        let pixel_size = self.pixel_size(options, named)?;
        let is_tiny = |size: &Distance| size.unit.is_none() && size.value * unit < ATOM;
        let tiny = options.pixel_size.into_iter().flatten().find(is_tiny);
        if let Some(Distance { value: size, .. }) = tiny {
            let required = format!(
                "more than an atom: in {named}, the unit of the heights, it is {:e} m, and {size:e} looks like m; a size with its own unit (10nm)",
                size * unit
            );
            return Err(out_of_range("pixel_size", size, &required));
        }
        let factor = agree("factor", options.factor, self.factor)?;
        let Self { mut heights, columns, notes, .. } = self;
        match options.missing {
            Some(code) => {
                heights.iter_mut().filter(|z| is_code(**z, code)).for_each(|z| *z = f64::NAN)
            }
            None => refuse_code(&heights)?,
        }
        for height in &mut heights {
            *height *= factor.unwrap_or(1.0);
            *height *= unit;
        }
        let topography = Topography { notes, ..Topography::new(heights, columns, pixel_size)? };
        let share = topography.missing_share();
        let limit = options.max_missing.unwrap_or(ReadOptions::MAX_MISSING);
        if share > limit {
            return Err(TopographyError::TooManyMissing { share, limit });
        }
        Ok(topography)
    }

    fn unit(&self, options: &ReadOptions) -> Result<LengthUnit, TopographyError> {
        let last = options.units.as_ref().and_then(|units| units.last().copied());
        let given = agree("unit", options.unit, last)?;
        agree("unit", given, self.unit)?.ok_or(TopographyError::UnitMissing)
    }

    fn pixel_size(
        &self,
        options: &ReadOptions,
        named: LengthUnit,
    ) -> Result<[f64; 2], TopographyError> {
        let of = |size: [Distance; 2]| {
            [0, 1].map(|axis| {
                let unit = size[axis].unit.or(options.lateral(axis)).unwrap_or(named);
                size[axis].value * unit.metres()
            })
        };
        let (given, in_file) = (options.pixel_size.map(of), self.pixel_size.map(of));
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

/// Whether a height is a number that marks missing points, up to the digits that files print.
pub(super) fn is_code(height: f64, code: f64) -> bool {
    (height - code).abs() <= 1e-5 * code.abs()
}

/// The share of points that have a height exactly, from which it may mark missing points.
const CODED: f64 = 0.01;
/// The fewest heights among which a code is looked for.
const FEWEST: usize = 50;
/// The distance of a code from all others, over the spread of these; and the distance from which
/// it is one although others repeat as well, such as -9999 among nanometres.
const APART: [f64; 2] = [0.5, 30.0];

/// Refuses heights whose lowest or highest value is exactly that of many points, apart from those
/// of all others: it may mark missing points.
fn refuse_code(heights: &[f64]) -> Result<(), TopographyError> {
    let measured = || heights.iter().copied().filter(|z| !z.is_nan());
    let same = |a: &f64, b: &f64| (a - b).abs() <= 0.0;
    let n = measured().count();
    for end in extremes(heights) {
        let count = measured().filter(|z| same(z, &end)).count();
        if n < FEWEST || (count as f64) < CODED * n as f64 || n - count < FEWEST {
            continue;
        }
        let mut rest: Vec<f64> = measured().filter(|z| !same(z, &end)).collect();
        rest.sort_unstable_by(f64::total_cmp);
        // Terraces and coarse steps repeat other heights as well.
        let repeated = rest.chunk_by(same).any(|same| 3 * same.len() > count);
        let at = |share: f64| rest[(share * (rest.len() - 1) as f64) as usize];
        let gap = (end - at(0.0)).abs().min((end - at(1.0)).abs());
        let spread = at(0.84) - at(0.16);
        let [apart, far] = APART.map(|times| gap > times * spread);
        // Steps have two heights and no spread.
        if far && spread > 0.0 && count > 1 || apart && !repeated {
            let percent = 100.0 * count as f64 / n as f64;
            let found = format!("{end:?} at {percent:.2} % of the points, apart from all others");
            let choice = format!("{end:?} if it marks missing points, nan if it is a height");
            return Err(undecided("heights".into(), found, "missing", &choice));
        }
    }
    Ok(())
}

/// What an option or the file states; both must be equal.
pub(super) fn agree<T: Display + PartialEq>(
    option: &'static str,
    given: Option<T>,
    in_file: Option<T>,
) -> Result<Option<T>, TopographyError> {
    match (given, in_file) {
        (Some(given), Some(in_file)) if given != in_file => {
            Err(contradiction(option, given, in_file))
        }
        (given, in_file) => Ok(given.or(in_file)),
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

/// The names of channels with their numbers.
pub(super) fn listed(names: &[String]) -> String {
    let shown = names.iter().take(12).enumerate();
    let shown = shown.map(|(i, name)| format!("{} {:?}", i + 1, excerpt(name)));
    shown.collect::<Vec<_>>().join(", ")
}

/// The index of a channel, and a note on the choice where the file has several.
pub(super) fn select(
    names: &[String],
    channel: Option<&str>,
) -> Result<(usize, Option<Finding>), TopographyError> {
    let Some(channel) = channel else {
        let note = |name: &String| {
            Finding::note(Code::Channel, "channel", 1.0)
                .fact(format!("the file has {} surfaces; {:?} is read", names.len(), excerpt(name)))
                .advice(format!("choose another with channel: {}", listed(names)))
        };
        return Ok((0, names.first().filter(|_| names.len() > 1).map(note)));
    };
    let same = |name: &String| name.to_lowercase() == channel.trim().to_lowercase();
    let numbered = || channel.trim().parse::<usize>().ok()?.checked_sub(1);
    let at = names.iter().position(same).or_else(numbered).filter(|at| *at < names.len());
    Ok((at.ok_or_else(|| unknown_name("channel", channel, listed(names)))?, None))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scan(unit: Option<LengthUnit>, pixel_size: Option<[Distance; 2]>) -> Scan {
        let heights = vec![1.0, 2.0, f64::NAN, 4.0];
        Scan { heights, columns: 2, unit, pixel_size, ..Scan::default() }
    }

    #[test]
    fn options_that_contradict_the_file_are_refused() {
        let options = ReadOptions {
            unit: "um".parse().ok(),
            pixel_size: Some([Distance::from(2.0); 2]),
            max_missing: Some(0.5),
            ..ReadOptions::default()
        };
        let in_nm = scan("nm".parse().ok(), None);
        let finer = scan(None, Some([2e-6, 1e-6].map(Distance::metre)));
        for (other, named) in [(in_nm, "unit"), (finer, "pixel_size")] {
            let refused = other.topography(&options);
            assert!(
                matches!(refused, Err(TopographyError::Contradiction { option, .. }) if option == named)
            );
        }
        let same = scan("um".parse().ok(), Some([2.0004, 2.0].map(Distance::from)));
        let surface = same.topography(&options).unwrap();
        assert!((surface.pixel_size()[0] / 2.0004e-6 - 1.0).abs() < 1e-15);
    }

    #[test]
    fn missing_points_are_refused_above_their_share() {
        let some = |max_missing| {
            let max_missing = Some(max_missing);
            let options = ReadOptions { max_missing, ..ReadOptions::default() };
            scan(Some(LengthUnit::METRE), Some([Distance::from(1.0); 2])).topography(&options)
        };
        assert!(some(0.25).is_ok());
        assert!(matches!(some(0.1), Err(TopographyError::TooManyMissing { share: 0.25, .. })));
    }

    #[test]
    fn a_few_points_far_from_all_others_are_a_code_though_others_repeat() {
        let heights = |lost: f64| -> Vec<f64> {
            (0..168_u32).map(|k| if k % 34 == 5 { lost } else { f64::from(k * 7 % 40) }).collect()
        };
        assert!(refuse_code(&heights(-9999.0)).is_err());
        assert!(refuse_code(&heights(12.0)).is_ok() && refuse_code(&heights(60.0)).is_ok());
    }
}
