//! The decimal number at the start of a text, and powers of ten.

/// Signs of a product of a number and a power of ten: 5 x 10^6.
pub(crate) const PRODUCTS: [char; 5] = ['x', 'X', '\u{d7}', '*', '\u{b7}'];

/// A decimal number times a power of ten, rounded once.
pub(crate) fn scale(number: &str, power: i32) -> Option<f64> {
    let (digits, own) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let is_number = digits.chars().all(|c| c.is_ascii_digit() || "+-._".contains(c));
    let exponent = own.parse::<i32>().ok()?.checked_add(power)?;
    let text = format!("{}e{exponent}", digits.replace('_', ""));
    text.parse().ok().filter(|_| is_number)
}

/// The decimal number at the start of a text, without blanks between groups of three digits, and
/// the rest of the text.
pub(crate) fn mantissa(text: &str) -> Option<(String, &str)> {
    let body = text.trim_start_matches(['-', '+']);
    let (sign, end) = text.split_at(text.len() - body.len());
    let (whole, mut rest) = digits(end);
    let mut number = format!("{sign}{whole}");
    if (1..=3).contains(&whole.len()) {
        while let Some((group, after)) = group(rest) {
            number.push_str(group);
            rest = after;
        }
    }
    if let Some(after) = rest.strip_prefix('.') {
        let (fraction, after) = digits(after);
        number = format!("{number}.{fraction}");
        rest = after;
    }
    if !number.contains(|c: char| c.is_ascii_digit()) || sign.len() > 1 {
        return None;
    }
    if let Some((exponent, after)) = exponent(rest) {
        number = format!("{number}e{exponent}");
        rest = after;
    }
    Some((number, rest))
}

/// The decimal number at the start of a text, times a power of ten such as 10^6 or x 10^6 where one
/// follows, as digits and an exponent; and the rest of the text.
pub(crate) fn leading(text: &str) -> Option<(String, i32, &str)> {
    let text = text.trim();
    if let Some((power, rest)) = ten_to(text) {
        return Some(("1".into(), power, rest));
    }
    let (number, rest) = mantissa(text)?;
    let product = rest.trim_start().strip_prefix(PRODUCTS).map(str::trim_start);
    match product.and_then(ten_to) {
        Some((power, rest)) => Some((number, power, rest)),
        // No other product of numbers, and no other power.
        None if product.is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit())) => None,
        None if rest.trim_start().starts_with('^') => None,
        None => Some((number, 0, rest)),
    }
}

/// The exponent of a power of ten, 10^6 or 10 with raised digits, and the rest of the text.
pub(crate) fn ten_to(text: &str) -> Option<(i32, &str)> {
    const RAISED: &str =
        "\u{2070}\u{b9}\u{b2}\u{b3}\u{2074}\u{2075}\u{2076}\u{2077}\u{2078}\u{2079}";
    let rest = text.strip_prefix("10")?;
    if let Some(rest) = rest.strip_prefix('^').or_else(|| rest.strip_prefix("**")) {
        let signed = rest.trim_start_matches(['-', '+']);
        let end = signed.find(|c: char| !c.is_ascii_digit()).unwrap_or(signed.len());
        let (exponent, rest) = rest.split_at(rest.len() - signed.len() + end);
        return Some((exponent.parse().ok()?, rest));
    }
    let negative = rest.strip_prefix('\u{207b}');
    let raised = negative.unwrap_or(rest);
    let digit = |c: char| RAISED.chars().position(|raised| raised == c);
    let end = raised.find(|c: char| digit(c).is_none()).unwrap_or(raised.len());
    let (exponent, rest) = raised.split_at(end);
    let exponent: String = exponent.chars().filter_map(digit).map(|k| k.to_string()).collect();
    let exponent: i32 = exponent.parse().ok()?;
    Some((if negative.is_some() { -exponent } else { exponent }, rest))
}

/// The digits, with _ between them, at the start of a text.
fn digits(text: &str) -> (&str, &str) {
    text.split_at(text.find(|c: char| !(c.is_ascii_digit() || c == '_')).unwrap_or(text.len()))
}

/// A blank and exactly three digits at the start of a text.
fn group(text: &str) -> Option<(&str, &str)> {
    let (three, rest) = digits(text.strip_prefix([' ', '\u{a0}', '\u{2009}', '\u{202f}'])?);
    (three.len() == 3 && !three.contains('_')).then_some((three, rest))
}

fn exponent(text: &str) -> Option<(&str, &str)> {
    let after = text.strip_prefix(['e', 'E'])?;
    let signed = after.strip_prefix(['-', '+']).unwrap_or(after);
    let end = signed.find(|c: char| !c.is_ascii_digit()).unwrap_or(signed.len());
    (end > 0).then(|| after.split_at(after.len() - signed.len() + end))
}
