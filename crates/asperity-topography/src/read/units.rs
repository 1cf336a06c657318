//! Units of length as files write them.

use crate::LengthUnit;

/// The unit in a name or symbol, spelled out or not: `µm`, `Micrometer`, `microns`.
pub(super) fn unit(text: &str) -> Option<LengthUnit> {
    let text = text.trim().trim_matches(['"', '\'', '.']);
    let lower = text.to_lowercase();
    let stem = lower.strip_suffix('s').unwrap_or(&lower);
    let symbol = match stem {
        "meter" | "metre" => "m",
        "centimeter" | "centimetre" => "cm",
        "millimeter" | "millimetre" => "mm",
        "micrometer" | "micrometre" | "mikrometer" => "um",
        "nanometer" | "nanometre" => "nm",
        "\u{e5}ngstr\u{f6}m" | "\u{e5}" => "angstrom",
        "picometer" | "picometre" => "pm",
        _ => text,
    };
    symbol.parse().ok()
}

/// `10.00 µm` in metres; the decimal separator is a point or a comma.
pub(super) fn length(text: &str) -> Option<f64> {
    let (number, unit) = quantity(text)?;
    let length = number * unit?.metres();
    (length.is_finite() && length > 0.0).then_some(length)
}

/// A number and the unit after it, if there is one: `3.7e-007 m`.
pub(crate) fn quantity(text: &str) -> Option<(f64, Option<LengthUnit>)> {
    let text = text.trim();
    let end = text.find(|c: char| c.is_alphabetic() && !matches!(c, 'e' | 'E'));
    let (value, name) = text.split_at(end.unwrap_or(text.len()));
    let value = number(value)?;
    match name.trim() {
        "" => Some((value, None)),
        name => Some((value, Some(unit(name)?))),
    }
}

/// A finite number with a decimal point or comma.
fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    let number = text.parse().or_else(|_| text.replacen(',', ".", 1).parse()).ok()?;
    f64::is_finite(number).then_some(number)
}

/// The unit in `x [mm]`, `x (mm)`, `x_mm`, `x / mm`, `x in mm`, `Lateral mm` or `mm`.
pub(super) fn unit_in(name: &str) -> Option<LengthUnit> {
    let name = name.trim().trim_matches('"').trim_end_matches([']', ')']);
    let last = name.rsplit(['[', '(', '_', '/', ' ']).next()?;
    // A single letter is the name of a column, as in `a`.
    let bare = last.len() == name.len();
    unit(last).filter(|_| !bare || name.chars().count() > 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_found_in_names_of_columns() {
        for name in ["x [\u{b5}m]", "x_(microns)", "z_um", "Raw Micrometer", "y in \u{3bc}m", "um"]
        {
            assert_eq!(unit_in(name), Some(LengthUnit::Micrometre), "{name}");
        }
        for name in ["m", "a", "", "height", "y1", "[1/0"] {
            assert_eq!(unit_in(name), None, "{name}");
        }
        assert_eq!(unit_in("[mm]"), Some(LengthUnit::Millimetre));
    }

    #[test]
    fn lengths_have_a_number_and_a_unit() {
        assert_eq!(length("5678,9 nm").map(|length| (1e13 * length).round()), Some(56_789_000.0));
        assert_eq!(quantity("3.69862e-007 m"), Some((3.69862e-7, Some(LengthUnit::Metre))));
        assert_eq!(quantity("-2"), Some((-2.0, None)));
        for text in ["", "um", "nan um", "1e400 m", "-3 um", "3 V", "1,2,3 um", "7"] {
            assert_eq!(length(text), None, "{text}");
        }
    }
}
