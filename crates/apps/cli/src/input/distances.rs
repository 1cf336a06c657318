//! Separations and retreats on the command line: multiples of σ_z, or lengths with their unit.

use std::str::FromStr;

use asperity::SeparationUnit;
use asperity_answer::unit_warning;

use crate::input::lists::{Numbers, ReadNumber, Span, have_units};
use crate::input::numbers::{number, of_unit};
use crate::output::show;

/// Separations of one option: plain numbers in units of σ_z, or lengths in metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Length<T> {
    pub value: T,
    pub unit: SeparationUnit,
}

/// A list or a range with its values.
pub type Distances = Length<Vec<f64>>;

impl<T> Length<T> {
    fn read(
        text: &str,
        read: fn(&str, ReadNumber<'_>) -> Result<T, String>,
    ) -> Result<Self, String> {
        let (number, unit): (ReadNumber<'_>, _) = match have_units(text, &metre)? {
            true => (&metre, SeparationUnit::Metres),
            false => (&number, SeparationUnit::Sigma),
        };
        Ok(Self { value: read(text, number)?, unit })
    }
}

impl FromStr for Distances {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Self::read(text, |text, number| Ok(Numbers::read(text, number)?.0))
    }
}

impl FromStr for Length<Span> {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Self::read(text, Span::even)
    }
}

/// A length in m, or with its unit.
pub fn metre(text: &str) -> Result<f64, String> {
    of_unit(text, "m")
}

/// Warns of values that look like another unit, by the largest of them.
pub fn warn_unit(name: &str, values: &[f64], unit: SeparationUnit, height_std: f64) {
    show(&unit_warning(name, values, unit, height_std));
}
