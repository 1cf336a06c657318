//! Separations and retreats on the command line: multiples of σ_z, or lengths with their unit.

use std::str::FromStr;

use asperity::SeparationUnit;
use asperity_answer::unit_warning;

use crate::input::ambiguous::one_value_only;
use crate::input::lists::{Numbers, Span, have_units, refuse_repeated};
use crate::input::numbers::{number, of_unit};
use crate::output::show;

/// The values of one `--separation`: plain numbers in the unit of the command, or metres.
#[derive(Debug, Clone, PartialEq)]
pub struct Distances {
    pub values: Vec<f64>,
    metres: bool,
}

/// A single separation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distance {
    pub value: f64,
    metres: bool,
}

/// A range of separations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DistanceSpan {
    pub span: Span,
    metres: bool,
}

fn unit_of(metres: bool, plain: SeparationUnit) -> SeparationUnit {
    if metres { SeparationUnit::Metres } else { plain }
}

impl Distances {
    /// The unit of the values; `plain` is that of plain numbers.
    pub fn unit(&self, plain: SeparationUnit) -> SeparationUnit {
        unit_of(self.metres, plain)
    }
}

impl Distance {
    /// The unit of the value; `plain` is that of plain numbers.
    pub fn unit(&self, plain: SeparationUnit) -> SeparationUnit {
        unit_of(self.metres, plain)
    }
}

impl DistanceSpan {
    /// The unit of the value; `plain` is that of plain numbers.
    pub fn unit(&self, plain: SeparationUnit) -> SeparationUnit {
        unit_of(self.metres, plain)
    }
}

impl FromStr for Distances {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let metres = have_units(text, metre)?;
        let Numbers(values) = Numbers::read(text, if metres { metre } else { number })?;
        Ok(Self { values, metres })
    }
}

impl FromStr for Distance {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.contains([',', ':']) {
            true => Err(one_value_only(text).unwrap_or_else(|| {
                format!("{text:?} is more than one value; write one, for example 2um")
            })),
            false => {
                let metres = have_units(text, metre)?;
                let value = if metres { metre(text)? } else { number(text)? };
                Ok(Self { value, metres })
            }
        }
    }
}

impl FromStr for DistanceSpan {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let metres = have_units(text, metre)?;
        let span = Span::even(text, if metres { metre } else { number })?;
        Ok(Self { span, metres })
    }
}

/// Separations at which a joint turns.
pub fn turning_separations(text: &str) -> Result<Distances, String> {
    let found: Distances = text.parse()?;
    refuse_repeated(text, &found.values, "separations")?;
    Ok(found)
}

/// A length in m, or with its unit.
fn metre(text: &str) -> Result<f64, String> {
    of_unit(text, "m")
}

/// Warns of values that look like another unit, by the largest of them.
pub fn warn_unit(name: &str, values: &[f64], unit: SeparationUnit, height_std: f64) {
    show(unit_warning(name, values, unit, height_std).as_slice());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_have_units_and_plain_numbers_those_of_the_command() {
        let read = |text: &str| text.parse::<Distances>();
        let sigma = SeparationUnit::Sigma;
        let plain = read("-1:4:11").unwrap();
        assert_eq!((plain.values[0], plain.unit(sigma)), (-1.0, sigma));
        for (text, last) in
            [("0:2um:5", 2e-6), ("-10 nm,0,500nm", 500e-9), ("1nm:1um:4:log", 1e-6), ("3um", 3e-6)]
        {
            let found = read(text).unwrap();
            assert_eq!(found.unit(sigma), SeparationUnit::Metres, "{text}");
            assert!((found.values.last().unwrap() / last - 1.0).abs() < 1e-15, "{text}");
        }
        for (bad, part) in [
            ("1,2um", "write 1.2um for one value"),
            ("1:2um:3", "1 has no unit"),
            ("1,two", "\"two\" is not a number"),
            ("2um:1um:3", "A must be below B"),
            ("1 kN", "not a number"),
        ] {
            assert!(read(bad).unwrap_err().contains(part), "{bad}: {:?}", read(bad));
        }
        for (same, wanted) in [
            ("2,1,1", "1 follows 1; a joint turns at separations that differ"),
            ("2um,2um", "2um follows 2um; a joint turns at separations that differ"),
        ] {
            assert_eq!(turning_separations(same).unwrap_err(), wanted);
        }
        assert_eq!(turning_separations("2,1,2").unwrap().values, [2.0, 1.0, 2.0]);
        let one: Distance = "-0.5um".parse().unwrap();
        assert_eq!((one.value, one.unit(sigma)), (-0.5e-6, SeparationUnit::Metres));
        let two = "2um,3um".parse::<Distance>().unwrap_err();
        assert_eq!(two, "\"2um,3um\" is more than one value; write one, for example 2um");
        assert!("1,2".parse::<Distance>().is_err() && "1um,2um".parse::<Distance>().is_err());
        let span: DistanceSpan = "0:3um".parse().unwrap();
        assert!(span.span.last < 1e-5 && "0:3um:4:log".parse::<DistanceSpan>().is_err());
    }
}
