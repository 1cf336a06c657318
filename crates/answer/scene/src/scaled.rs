//! The decimal number at the start of a text, and powers of ten.

/// Signs of a product of a number and a power of ten: 5 x 10^6.
const PRODUCTS: [char; 5] = ['x', 'X', '\u{d7}', '*', '\u{b7}'];
/// Digits and the minus sign of exponents.
const RAISED: &str =
    "\u{2070}\u{b9}\u{b2}\u{b3}\u{2074}\u{2075}\u{2076}\u{2077}\u{2078}\u{2079}\u{207b}";

/// A decimal number times a power of ten, rounded once.
pub(crate) fn scale(number: &str, power: i32) -> Option<f64> {
    let (digits, own) = number.split_once('e').unwrap_or((number, "0"));
    let exponent = own.parse::<i32>().ok()?.checked_add(power)?;
    format!("{digits}e{exponent}").parse().ok()
}

/// The decimal number at the start of a text, without blanks between groups of three digits, and
/// the rest of the text.
pub(crate) fn mantissa(text: &str) -> Option<(String, &str)> {
    let digits =
        |text: &str| text.find(|c: char| !(c.is_ascii_digit() || c == '_')).unwrap_or(text.len());
    let (sign, body) = text.split_at(usize::from(text.starts_with(['-', '+'])));
    let (whole, mut rest) = body.split_at(digits(body));
    let mut number = format!("{sign}{whole}");
    while let Some(after) = rest.strip_prefix([' ', '\u{a0}', '\u{2009}', '\u{202f}']) {
        if digits(after) != 3 || !(1..=3).contains(&whole.len()) {
            break;
        }
        let (group, behind) = after.split_at(3);
        number += group;
        rest = behind;
    }
    if let Some(after) = rest.strip_prefix('.') {
        let (fraction, behind) = after.split_at(digits(after));
        number = format!("{number}.{fraction}");
        rest = behind;
    }
    if !number.contains(|c: char| c.is_ascii_digit()) {
        return None;
    }
    if let Some(after) = rest.strip_prefix(['e', 'E']) {
        let signed = after.trim_start_matches(['-', '+']);
        let (exponent, behind) = after.split_at(after.len() - signed.len() + digits(signed));
        if exponent.parse::<i64>().is_ok() {
            number = format!("{number}e{exponent}");
            rest = behind;
        }
    }
    Some((number.replace('_', ""), rest))
}

/// The decimal number at the start of a text, times a power of ten such as 10^6 or x 10^6 where one
/// follows; and the rest of the text.
pub(crate) fn leading(text: &str) -> Option<(String, String)> {
    let is_raised = |c: char| RAISED.contains(c);
    let mut plain = String::new();
    for c in text.trim().replace("**", "^").chars() {
        // Not behind a letter: mm2 has a raised digit as well.
        if is_raised(c) && plain.ends_with("10") {
            plain.push('^');
        }
        let digit = RAISED.chars().position(|raised| raised == c);
        plain.extend(digit.map_or(Some(c), |k| "0123456789-".chars().nth(k)));
    }
    if let Some((before, after)) = plain.split_once("10^") {
        let number = before.trim_end().strip_suffix(PRODUCTS).map(str::trim_end);
        let number = if before.is_empty() { Some("1") } else { number };
        plain = number.map_or(plain.clone(), |number| format!("{number}e{after}"));
    }
    let (number, rest) = mantissa(&plain)?;
    // No other product of numbers, and no other power.
    let product = rest.trim_start().strip_prefix(PRODUCTS).map(str::trim_start);
    let is_product = product.is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
    (!is_product && !rest.trim_start().starts_with('^')).then(|| (number, rest.into()))
}
