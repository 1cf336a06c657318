//! Decimal numbers times a power of ten.

/// A decimal number times a power of ten, rounded once.
pub(crate) fn scale(number: &str, power: i32) -> Option<f64> {
    let (digits, own) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let is_number = digits.chars().all(|c| c.is_ascii_digit() || "+-._".contains(c));
    let exponent = own.parse::<i32>().ok()?.checked_add(power)?;
    let text = format!("{}e{exponent}", digits.replace('_', ""));
    text.parse().ok().filter(|_| is_number)
}
