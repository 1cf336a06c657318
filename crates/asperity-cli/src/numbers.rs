//! Lists of numbers on the command line: A:B:N or v,v,...

use asperity::linspace;

/// More numbers than this in one list are taken for a slip of the hand.
const MOST: usize = 1_000_000;

/// What one `--separation` or `--load` says.
#[derive(Debug, Clone, PartialEq)]
pub struct Numbers(pub Vec<f64>);

/// A:B:N, or numbers with commas between them.
pub fn numbers(text: &str) -> Result<Numbers, String> {
    if text.contains(':') {
        let (first, last, count) = span(text)?;
        let count = count.ok_or_else(|| needed("A:B:N", "3 numbers with colons between them"))?;
        return Ok(Numbers(linspace(first, last, count)));
    }
    let values: Result<Vec<f64>, String> = text.split(',').map(number).collect();
    let values = values?;
    if values.len() > MOST {
        return Err(format!("{} numbers: at most {MOST} were expected", values.len()));
    }
    Ok(Numbers(values))
}

/// Numbers that are all above 0.
pub fn positive_numbers(text: &str) -> Result<Numbers, String> {
    let Numbers(values) = numbers(text)?;
    values.into_iter().map(positive).collect::<Result<_, _>>().map(Numbers)
}

/// A range A:B or A:B:N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    pub first: f64,
    pub last: f64,
    pub count: Option<usize>,
}

/// A:B or A:B:N.
pub fn range(text: &str) -> Result<Span, String> {
    let (first, last, count) = span(text)?;
    Ok(Span { first, last, count })
}

/// A finite number.
pub fn number(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(format!("{text} is not finite: a finite number was expected")),
        Err(_) => {
            Err(format!("{text:?} is not a number: one such as 2, -0.5 or 1e-6 was expected"))
        }
    }
}

/// A finite number above 0.
pub fn positive_number(text: &str) -> Result<f64, String> {
    number(text).and_then(positive)
}

fn positive(value: f64) -> Result<f64, String> {
    if value > 0.0 { Ok(value) } else { Err(format!("{value} is not above 0, which was expected")) }
}

fn span(text: &str) -> Result<(f64, f64, Option<usize>), String> {
    let parts: Vec<&str> = text.split(':').collect();
    let (first, last) = match parts[..] {
        [first, last] | [first, last, _] => (number(first)?, number(last)?),
        _ => return Err(needed("A:B:N", &format!("not {} parts", parts.len()))),
    };
    if first >= last {
        return Err(format!("A is {first} and B is {last}: A below B was expected"));
    }
    if !(last - first).is_finite() {
        return Err(format!("from {first} to {last} is more than a double can hold"));
    }
    let Some(text) = parts.get(2) else { return Ok((first, last, None)) };
    match text.trim().parse::<usize>() {
        Ok(count) if (2..=MOST).contains(&count) => Ok((first, last, Some(count))),
        _ => Err(format!("N is {text}: a whole number from 2 to {MOST} was expected")),
    }
}

fn needed(form: &str, detail: &str) -> String {
    format!("{form} was expected, {detail}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_and_lists_are_read() {
        assert_eq!(numbers("-1:4:11").unwrap().0[..2], [-1.0, -0.5]);
        assert_eq!(numbers("0:4:401").unwrap().0[400..], [4.0]);
        assert_eq!(numbers("-1e-6,2, 3").unwrap().0, [-1e-6, 2.0, 3.0]);
        assert_eq!(range("0:4").unwrap(), Span { first: 0.0, last: 4.0, count: None });
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
        assert!(positive_numbers("1,0").is_err() && positive_number("-1").is_err());
    }
}
