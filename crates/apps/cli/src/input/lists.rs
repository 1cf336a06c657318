//! Lists and ranges on the command line: A:B:N, A:B:N:log or v,v,...

use std::str::FromStr;

use asperity::{linspace, shortest_digits};

use crate::input::numbers::{count_up_to, length, number};

/// The largest number of values in one range.
const MOST: usize = 1_000_000;

/// The values of one `--separation` or `--load`.
#[derive(Debug, Clone, PartialEq)]
pub struct Numbers(pub Vec<f64>);

/// A range A:B, A:B:N or A:B:N:log.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    pub first: f64,
    pub last: f64,
    pub count: Option<usize>,
    /// Whether the values have equal ratios.
    pub log: bool,
}

impl FromStr for Numbers {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Self::read(text, &number)
    }
}

impl Numbers {
    /// Numbers, each as `number` reads it.
    pub fn read(text: &str, number: ReadNumber<'_>) -> Result<Self, String> {
        have_units(text, number)?;
        if !text.contains(':') {
            return text.split(',').map(number).collect::<Result<_, _>>().map(Self);
        }
        let Span { first, last, count, log } = Span::read(text, number)?;
        let count = count.ok_or("the number of values is missing; write A:B:N")?;
        if !log {
            return Ok(Self(linspace(first, last, count)));
        }
        // Decades are exact, and so are the ends.
        let powers = linspace(first.log10(), last.log10(), count).into_iter();
        let mut values: Vec<f64> = powers.map(|power| 10f64.powf(power)).collect();
        (values[0], values[count - 1]) = (first, last);
        Ok(Self(values))
    }
}

impl Span {
    fn read(text: &str, number: ReadNumber<'_>) -> Result<Self, String> {
        let parts: Vec<&str> = text.split(':').collect();
        let [first, last, ref others @ ..] = parts[..] else {
            return Err("write A:B or A:B:N".into());
        };
        let (first, last) = (number(first)?, number(last)?);
        if first >= last {
            let [first, last] = [first, last].map(shortest_digits);
            return Err(format!("A is {first} and B is {last}; A must be below B"));
        }
        if !(last - first).is_finite() {
            let [first, last] = [first, last].map(shortest_digits);
            return Err(format!("the range from {first} to {last} exceeds f64"));
        }
        let required = |error| format!("N is wrong: {error}");
        let count = others.first().map(|text| count_up_to(MOST)(text).map_err(required));
        let log = match others {
            [] | [_] => false,
            [_, kind] if kind.trim() == "log" && first > 0.0 => true,
            [_, kind] if kind.trim() == "log" => {
                return Err(format!("A is {first}; a log range must begin above 0"));
            }
            _ => return Err(format!("{text} has more parts than A:B:N; only :log may follow")),
        };
        Ok(Self { first, last, count: count.transpose()?, log })
    }

    /// A range A:B, or A:B:N in equal steps, of which the ends may be 0.
    pub fn even(text: &str, number: ReadNumber<'_>) -> Result<Self, String> {
        have_units(text, number)?;
        match Self::read(text, number)? {
            Self { log: true, .. } => Err("log is not allowed here; write A:B or A:B:N".into()),
            span => Ok(span),
        }
    }
}

/// Whether the values of a list, or the ends of a range, have units: all of them or none, because
/// the 1 of `1:20kN:5` is ambiguous. 0 needs none, but in `0,5um`, which may be a decimal comma.
pub fn have_units(text: &str, number: ReadNumber<'_>) -> Result<bool, String> {
    let parts: Vec<&str> = match text.contains(':') {
        true => text.split(':').take(2).collect(),
        false => text.split(',').collect(),
    };
    let is_decimal = text.contains(',') && parts.len() == 2;
    let plain =
        |part: &&&str| part.trim().parse::<f64>().is_ok_and(|value| value != 0.0 || is_decimal);
    let has_unit = |part: &&str| part.trim().parse::<f64>().is_err() && number(part).is_ok();
    let units = parts.iter().any(has_unit);
    match parts.iter().find(plain).filter(|_| units) {
        Some(part) => {
            let example = parts.iter().find(|part| has_unit(part)).map_or("", |part| part.trim());
            let lists = match text.contains(',') {
                true => " (a comma separates values; decimals have a point)",
                false => "",
            };
            Err(format!(
                "{text}: {part} has no unit; give every value a unit, as in {example}{lists}"
            ))
        }
        None => Ok(units),
    }
}

/// One size, or two along a row and along a column: `1um`, `1x5`, `0.5um x 0.4um`.
pub fn sizes<T: Copy>(text: &str, one: fn(&str) -> Result<T, String>) -> Result<[T; 2], String> {
    have_units(&text.replace('x', ","), &length)?;
    let sizes: Vec<T> = text.split('x').map(|part| one(part.trim())).collect::<Result<_, _>>()?;
    match sizes[..] {
        [both] => Ok([both; 2]),
        [across, down] => Ok([across, down]),
        _ => Err(format!("{} values; write DX or DXxDY", sizes.len())),
    }
}

/// A reader of a number.
pub type ReadNumber<'a> = &'a dyn Fn(&str) -> Result<f64, String>;

/// Reads a list or range of numbers, each as `one` reads it.
pub fn all(
    one: fn(&str) -> Result<f64, String>,
) -> impl Fn(&str) -> Result<Numbers, String> + Clone {
    move |text| Numbers::read(text, &one)
}

/// Reads a range A:B, A:B:N or A:B:N:log, whose ends `one` reads.
pub fn range(
    one: fn(&str) -> Result<f64, String>,
) -> impl Fn(&str) -> Result<Span, String> + Clone {
    move |text| have_units(text, &one).and_then(|_| Span::read(text, &one))
}

/// Reads a range likewise, or a list of at least two numbers: its ends, and the numbers.
pub fn range_or_list(
    one: fn(&str) -> Result<f64, String>,
) -> impl Fn(&str) -> Result<(Span, Vec<f64>), String> + Clone {
    move |text| {
        if text.contains(':') {
            return Ok((range(one)(text)?, vec![]));
        }
        let Numbers(list) = Numbers::read(text, &one)?;
        match list[..] {
            [first, .., last] => {
                Ok((Span { first, last, count: Some(list.len()), log: false }, list))
            }
            _ => Err("write A:B, A:B:N or several values v,v".into()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_sizes_have_units_or_an_x() {
        for (text, wanted) in [
            ("0.5", [0.5, 0.5]),
            ("1x5", [1.0, 5.0]),
            ("1 um x 5 um", [1e-6, 5e-6]),
            ("5e-7x4e-7", [5e-7, 4e-7]),
        ] {
            assert_eq!(sizes(text, length), Ok(wanted), "{text}");
        }
        for text in ["1,5", "1,5um", "1x5um", "1x2x3", "1um,5um"] {
            assert!(sizes(text, length).is_err(), "{text}");
        }
    }
    use crate::input::numbers::{load, load_or_tension, pressure};

    fn numbers(text: &str) -> Result<Vec<f64>, String> {
        text.parse::<Numbers>().map(|numbers| numbers.0)
    }

    #[test]
    fn ranges_and_lists_are_read() {
        assert_eq!(numbers("-1:4:11").unwrap()[..2], [-1.0, -0.5]);
        assert_eq!(numbers("0:4:401").unwrap()[400..], [4.0]);
        assert_eq!(numbers("-1e-6,2, 3").unwrap(), [-1e-6, 2.0, 3.0]);
        assert_eq!(numbers("0:9:1e1").unwrap().len(), 10);
        let log = numbers("0.1:7:3:log").unwrap();
        assert_eq!((log[0], log[2]), (0.1, 7.0));
        assert!((log[1] * log[1] / 0.7 - 1.0).abs() < 1e-14);
        assert_eq!(numbers("1:1e6:4:log").unwrap(), [1.0, 100.0, 1e4, 1e6]);
        assert_eq!(all(load)("10 N:2kN:3").unwrap().0, [10.0, 1005.0, 2000.0]);
        assert_eq!(all(pressure)("5 MPa,1e5Pa").unwrap().0, [5e6, 1e5]);
        let span = Span::even("0:4", &number).unwrap();
        assert_eq!((span.first, span.last, span.count), (0.0, 4.0, None));
        assert_eq!(range(load)("10N:2kN").unwrap().last.to_bits(), 2000f64.to_bits());
        for (mixed, part) in [
            ("1:20kN:5", "1 has"),
            ("1kN:20:5", "20 has"),
            ("1kN,2", "2 has"),
            ("1, 2kN", "1 has"),
            ("0,5kN", "0 has"),
        ] {
            let refused = [all(load)(mixed).unwrap_err(), all(load_or_tension)(mixed).unwrap_err()];
            assert!(refused.iter().all(|r| r.contains(part)), "{mixed}: {refused:?}");
        }
        for refused in [range(load)("1kN:20:5"), range(pressure)("1:2MPa")] {
            assert!(refused.unwrap_err().contains("has no unit"));
        }
        assert!(range(pressure)("0:1MPa").is_err() && range(load)("1:2kN:3:log").is_err());
        assert_eq!(Span::even("-1:4:9", &number).unwrap().count, Some(9));
    }

    #[test]
    fn everything_else_is_refused() {
        for bad in [
            "",
            ",",
            "1,,2",
            "1:2",
            "4:0:5",
            "1:1:5",
            "0:4:1",
            "0:4:2.5",
            "0:4:-3",
            "0:4:9999999",
            "a:b:c",
            "0:4:5:6",
            "1:4:5:lin",
            "1:4:5:log:log",
            "0:4:5:log",
            "-1:4:5:log",
            "nan",
            "inf",
            "0:inf:3",
            "--model",
            "0:4:",
            "-1e308:1e308:3",
            "1;2",
        ] {
            assert!(numbers(bad).is_err(), "{bad}");
        }
        assert_eq!(all(load_or_tension)("-10mN,2N").unwrap().0, [-0.01, 2.0]);
        assert!(all(load_or_tension)("-1,0").is_err() && all(load)("1 mm").is_err());
        assert!(Span::even("1:3:4:log", &number).is_err());
        assert!(range(load)("1:3:4:log").is_ok_and(|span| span.log));
    }
}
