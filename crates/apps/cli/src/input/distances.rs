//! Separations and retreats on the command line: multiples of σ_z, or lengths with their unit.

use std::str::FromStr;

use asperity::SeparationUnit;

use crate::input::lists::{Numbers, ReadNumber, Span, have_units};
use crate::input::numbers::{number, of_unit};

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

impl FromStr for Length<f64> {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.contains([',', ':']) {
            true => Err(format!("{text:?} is more than one value; write one, for example 2um")),
            false => Self::read(text, |text, number| number(text)),
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_have_units_and_plain_numbers_are_multiples_of_sigma() {
        let read = |text: &str| text.parse::<Distances>();
        let plain = read("-1:4:11").unwrap();
        assert_eq!((plain.value[0], plain.unit), (-1.0, SeparationUnit::Sigma));
        for (text, last) in
            [("0:2um:5", 2e-6), ("-10 nm,0,500nm", 500e-9), ("1nm:1um:4:log", 1e-6), ("3um", 3e-6)]
        {
            let found = read(text).unwrap();
            assert_eq!(found.unit, SeparationUnit::Metres, "{text}");
            assert!((found.value.last().unwrap() / last - 1.0).abs() < 1e-15, "{text}");
        }
        for (bad, part) in [
            ("1,2um", "1 has no unit"),
            ("1:2um:3", "1 has no unit"),
            ("1,two", "\"two\" is not a number"),
            ("2um:1um:3", "A must be below B"),
            ("1 kN", "not a number"),
        ] {
            assert!(read(bad).unwrap_err().contains(part), "{bad}: {:?}", read(bad));
        }
        let one: Length<f64> = "-0.5um".parse().unwrap();
        assert_eq!((one.value, one.unit), (-0.5e-6, SeparationUnit::Metres));
        let two = "2um,3um".parse::<Length<f64>>().unwrap_err();
        assert!(two.contains("more than one value"), "{two}");
        assert!("1,2".parse::<Length<f64>>().is_err() && "1um,2um".parse::<Length<f64>>().is_err());
        let span: Length<Span> = "0:3um".parse().unwrap();
        assert!(span.value.last < 1e-5 && "0:3um:4:log".parse::<Length<Span>>().is_err());
    }
}
