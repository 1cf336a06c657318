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
