//! Conversion of numbers with a unit, "210 GPa", to SI units.

use std::fmt::Write;
use std::ops::Range;

use asperity::nearest_hint;
use toml::de::{DeTable, DeValue};

use crate::decimal_comma::{comma_readings, may_be_thousands};
use crate::sides;
use crate::template::key;

type Units = (&'static str, &'static str, &'static [(&'static str, i32)]);

/// The SI unit as in the template, an example, and the units with their powers of ten. Spaces, dots
/// between units, * and ^ are ignored; µ is u, ² is 2, and Ω is ohm.
const UNITS: [Units; 10] = [
    (
        "Pa",
        "210 GPa",
        &[("GPa", 9), ("MPa", 6), ("kPa", 3), ("Pa", 0), ("bar", 5), ("N/mm2", 6), ("N/m2", 0)],
    ),
    ("m", "0.2 mm", &[("m", 0), ("cm", -2), ("mm", -3), ("um", -6), ("nm", -9)]),
    ("m^2", "100 mm2", &[("m2", 0), ("cm2", -4), ("mm2", -6), ("um2", -12), ("nm2", -18)]),
    ("N", "2 kN", &[("N", 0), ("kN", 3), ("MN", 6), ("mN", -3), ("uN", -6)]),
    ("J/m^2", "50 mJ/m2", &[("J/m2", 0), ("mJ/m2", -3), ("N/m", 0), ("mN/m", -3)]),
    (
        "m/N",
        "2 nm/N",
        &[("mm/kN", -6), ("um/kN", -9), ("mm/N", -3), ("um/N", -6), ("nm/N", -9), ("m/N", 0)],
    ),
    ("1/m", "2 1/mm", &[("1/m", 0), ("1/cm", 2), ("1/mm", 3), ("1/um", 6)]),
    (
        "1/m^2",
        "200 1/mm2",
        &[("1/m2", 0), ("1/cm2", 4), ("1/mm2", 6), ("1/um2", 12), ("1/nm2", 18)],
    ),
    (
        "W/(m K)",
        "50 W/(m K)",
        &[
            ("mW/(mK)", -3),
            ("mW/mK", -3),
            ("W/(mK)", 0),
            ("W/mK", 0),
            ("W/m/K", 0),
            ("kW/(mK)", 3),
            ("kW/mK", 3),
            ("W/(cmK)", 2),
            ("W/(mmK)", 3),
        ],
    ),
    (
        "ohm m",
        "17 uohm cm",
        &[("uohmcm", -8), ("uohmm", -6), ("nohmm", -9), ("mohmm", -3), ("ohmcm", -2), ("ohmm", 0)],
    ),
];

/// The error for a text that is not a number in the unit of its key.
pub(crate) struct QuantityError {
    /// The key with its sections.
    pub(crate) path: String,
    pub(crate) found: String,
    /// The same number with a unit that differs only in case.
    pub(crate) near: Option<String>,
    pub(crate) needed: String,
}

/// A number with its unit in a text.
struct Stated {
    /// The key with its sections.
    path: String,
    span: Range<usize>,
    /// In SI units.
    value: f64,
}

/// The text with plain numbers instead of numbers with units, and the keys of these; line numbers
/// stay.
pub(crate) fn in_si(
    text: &str,
    table: &DeTable<'_>,
) -> Result<(String, Vec<String>), QuantityError> {
    let mut found = vec![];
    collect(table, "", &mut found)?;
    found.sort_by_key(|stated: &Stated| stated.span.start);
    let (mut rewritten, mut done) = (String::with_capacity(text.len()), 0);
    let mut paths = vec![];
    for Stated { path, span, value } in found {
        paths.push(path);
        rewritten.push_str(text.get(done..span.start).unwrap_or_default());
        // A text in three quotes may contain newlines.
        let lines = text.get(span.clone()).unwrap_or_default().matches('\n').count();
        let _ = write!(rewritten, "{value:?}");
        if lines > 0 {
            rewritten.push_str(" #");
            rewritten.extend(std::iter::repeat_n('\n', lines));
        }
        done = span.end;
    }
    rewritten.push_str(text.get(done..).unwrap_or_default());
    Ok((rewritten, paths))
}

/// A key behind its section.
pub(crate) fn joined(section: &str, key: &str) -> String {
    let dot = if section.is_empty() || key.is_empty() { "" } else { "." };
    format!("{section}{dot}{key}")
}

fn collect(
    table: &DeTable<'_>,
    section: &str,
    found: &mut Vec<Stated>,
) -> Result<(), QuantityError> {
    let items = table.iter().map(|(name, value)| (name.get_ref().to_string(), value));
    for (name, value) in items {
        match value.get_ref() {
            DeValue::Table(inner) => collect(inner, &joined(section, &name), found)?,
            DeValue::Array(tables) => {
                for (table, k) in tables.iter().zip(1..) {
                    if let DeValue::Table(inner) = table.get_ref() {
                        collect(inner, &format!("{name}[{k}]"), found)?;
                    }
                }
            }
            DeValue::String(given) => {
                let bare = section.split('[').next().unwrap_or(section);
                if let Some(units) = units_of(bare, &name) {
                    let dot = if section.is_empty() { "" } else { "." };
                    let path = format!("{section}{dot}{name}");
                    let Some(number) = read(given, units) else {
                        let ((si, example, _), known) = (units, list(units.2));
                        let with_point = comma_readings(given);
                        let needed = match (converted(given, si), with_point) {
                            (Some(same), _) => {
                                format!("a known unit, as in \"{same}\", which is the same,")
                            }
                            (_, Some(both)) if may_be_thousands(given) => {
                                format!("a number without a comma, {both},")
                            }
                            (_, Some(same)) => format!("a decimal point, as in \"{same}\","),
                            _ => format!(
                                "a number in {si} without quotes, or with a unit, for example \"{example}\" (units: {known}),"
                            ),
                        };
                        let near = in_other_case(given, units);
                        return Err(QuantityError { path, found: given.to_string(), near, needed });
                    };
                    found.push(Stated { path, span: value.span(), value: number });
                }
            }
            _ => {}
        }
    }
    Ok(())
}

/// The units of a key; its meaning in the template begins with the SI unit.
fn units_of(section: &str, name: &str) -> Option<Units> {
    let key = key(section, name)?;
    let si = |known: &str| {
        let rest = key.meaning.strip_prefix(known);
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with([' ', ',', ';']))
    };
    // "m" begins no "m^2", as no space follows.
    UNITS.into_iter().find(|(known, ..)| si(known))
}

/// The SI unit of a key of scene files, as [`quantity`] takes it; `None` for keys without a unit.
///
/// ```
/// assert_eq!(asperity_scene::unit_of("youngs_modulus"), Some("Pa"));
/// assert_eq!(asperity_scene::unit_of("poissons_ratio"), None);
/// ```
#[must_use]
pub fn unit_of(key: &str) -> Option<&'static str> {
    units_of("", key).map(|(si, ..)| si)
}

/// A number in the SI unit `si` (Pa, m, m^2, N, J/m^2, m/N, 1/m, 1/m^2, W/(m K) or ohm m), plain or
/// with another unit of the same dimension: `"5 MPa"`, `"0.2mm"`. Rounded once.
///
/// ```
/// assert_eq!(asperity_scene::quantity("2.5 kN", "N").unwrap(), 2500.0);
/// let error = asperity_scene::quantity("2.5 mm", "N").unwrap_err();
/// assert_eq!(error, "\"2.5 mm\" is not a number in N: write 2kN, for example (units: N, kN, MN, mN, uN)");
/// ```
///
/// # Errors
/// A message with the text and the known units.
pub fn quantity(text: &str, si: &str) -> Result<f64, String> {
    if let Ok(value) = text.trim().parse() {
        return Ok(value);
    }
    let Some(units) = UNITS.into_iter().find(|(known, ..)| *known == si) else {
        let number = text.trim().strip_suffix(si).unwrap_or(text).trim().parse();
        return number.map_err(|_| format!("{text:?} is not a number in {si}: write it in {si}"));
    };
    read(text, units).ok_or_else(|| {
        if let Some(same) = converted(text, si) {
            let same = same.replace(' ', "");
            return format!("{text:?} is not a number in {si}: write {same}, which is the same");
        }
        if let Some(same) = comma_readings(text) {
            let comma = if may_be_thousands(text) { "comma" } else { "decimal comma" };
            return format!("{text:?} has a {comma}; write {same}");
        }
        let (_, example, names) = units;
        let near = nearest_hint(in_other_case(text, units));
        let (example, names) = (example.replace(' ', ""), list(names));
        format!(
            "{text:?} is not a number in {si}{near}: write {example}, for example (units: {names})"
        )
    })
}

/// Units that are not decimal, with their size in a decimal unit.
const OTHERS: [(&str, &str, f64, &str); 8] = [
    ("Pa", "HV", 9.80665e-3, "GPa"),
    ("Pa", "kgf/mm2", 9.80665, "MPa"),
    ("Pa", "ksi", 6.894_757_3, "MPa"),
    ("Pa", "psi", 6.894_757_3, "kPa"),
    ("N", "kgf", 9.80665, "N"),
    ("N", "lbf", 4.448_221_6, "N"),
    ("m", "uin", 25.4, "nm"),
    ("m", "in", 25.4, "mm"),
];

/// A number in a unit that is not decimal, in one that is: 2.452 GPa for 250 HV.
fn converted(given: &str, si: &str) -> Option<String> {
    let text = plain(given);
    let other = OTHERS.iter().filter(|(of, ..)| *of == si);
    other.into_iter().find_map(|(_, unit, factor, decimal)| {
        let value = scale(text.strip_suffix(unit)?, 0)?;
        Some(format!("{} {decimal}", asperity::short(factor * value)))
    })
}

fn list(units: &[(&str, i32)]) -> String {
    units.iter().map(|(unit, _)| *unit).collect::<Vec<_>>().join(", ")
}

/// The number with the only unit that differs in case: 20kN for 20KN; `None` if there are two (MN,
/// mN).
fn in_other_case(given: &str, units: Units) -> Option<String> {
    let text = plain(given);
    let mut alike = units.2.iter().filter_map(|(unit, _)| {
        let start = text.len().checked_sub(unit.len())?;
        let (number, end) = (text.get(..start)?, text.get(start..)?);
        let same = end.eq_ignore_ascii_case(unit) && scale(number, 0).is_some();
        same.then(|| format!("{number}{unit}"))
    });
    alike.next().filter(|_| alike.next().is_none())
}

/// The text without ignored characters, in ASCII.
fn plain(given: &str) -> String {
    let left_out = |c: char| c.is_whitespace() || "^\u{b7}".contains(c);
    let text: String = given.chars().filter(|c| !left_out(*c)).collect();
    // Between units; between numbers it is a product.
    let is_product = |(_, rest): (&str, &str)| rest.starts_with(|c: char| c.is_ascii_digit());
    let text = match text.split_once('*').is_some_and(is_product) {
        true => text,
        false => text.replace('*', ""),
    };
    let text = text.replace(['\u{b5}', '\u{3bc}'], "u").replace('\u{b2}', "2");
    text.replace('\u{207b}', "-").replace(['\u{3a9}', '\u{2126}'], "ohm")
}

/// A number with one of the units.
fn read(given: &str, (si, _, units): Units) -> Option<f64> {
    let text = plain(given);
    if si == "m^2" && text.contains(['x', 'X', '\u{d7}', '*']) {
        let lengths = UNITS.iter().find(|(known, ..)| *known == "m")?.2;
        return sides::area(&text, lengths, units);
    }
    let value_in = |unit: &str, power| scale(text.strip_suffix(unit)?, power);
    units.iter().find_map(|(unit, power)| {
        // 1/mm2 may be written /mm2 or mm-2.
        let inverse = || {
            let length = unit.strip_prefix("1/")?.strip_suffix('2')?;
            value_in(&format!("/{length}2"), *power)
                .or_else(|| value_in(&format!("{length}-2"), *power))
        };
        value_in(unit, *power).or_else(inverse)
    })
}

/// A decimal number times a power of ten, rounded once.
pub(crate) fn scale(number: &str, power: i32) -> Option<f64> {
    let (digits, own) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let is_number = digits.chars().all(|c| c.is_ascii_digit() || "+-._".contains(c));
    let exponent = own.parse::<i32>().ok()?.checked_add(power)?;
    let text = format!("{}e{exponent}", digits.replace('_', ""));
    text.parse().ok().filter(|_| is_number)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str, key: &str) -> Option<f64> {
        let units = units_of("", key).unwrap();
        read(text, units)
    }

    #[test]
    fn other_units_are_converted() {
        for (text, si, same) in [
            ("250 HV", "Pa", "write 2.452GPa, which is the same"),
            ("36 ksi", "Pa", "write 248.2MPa,"),
            ("100 lbf", "N", "write 444.8N,"),
            ("16 \u{b5}in", "m", "write 406.4nm,"),
        ] {
            let error = quantity(text, si).unwrap_err();
            assert!(error.contains(same), "{error}");
        }
        assert!(quantity("36 ksi", "N").unwrap_err().contains("write 2kN, for example"));
    }

    #[test]
    fn units_in_another_case_are_suggested() {
        for (text, si, near) in [
            ("20KN", "N", Some("20kN")),
            ("69 Gpa", "Pa", Some("69GPa")),
            ("2Um", "m", Some("2um")),
            ("1 W/(m k)", "W/(m K)", Some("1W/(mK)")),
            // Ambiguous: mega or milli.
            ("3 mn", "N", None),
            ("20 KP", "N", None),
        ] {
            let error = quantity(text, si).unwrap_err();
            let suggestion = near.map(|near| format!("(the nearest is {near:?})"));
            match suggestion {
                Some(suggestion) => assert!(error.contains(&suggestion), "{error}"),
                None => assert!(!error.contains("nearest"), "{error}"),
            }
        }
    }

    #[test]
    fn numbers_with_units_equal_those_in_si_bit_for_bit() {
        for (text, key, meant) in [
            ("210 GPa", "youngs_modulus", 210e9),
            ("0.2mm", "asperity_radius", 0.2e-3),
            ("1.1e2 \u{b5}m", "asperity_radius", 1.1e-4),
            ("1_000 nm", "asperity_height_std", 1e-6),
            ("200 1/mm2", "asperity_density", 200e6),
            ("200 /mm^2", "asperity_density", 200e6),
            ("200 mm^-2", "asperity_density", 200e6),
            ("0.3 cm^2", "nominal_area", 0.3e-4),
            ("355 N/mm2", "yield_strength", 355e6),
            ("7 m", "asperity_radius", 7.0),
            ("50 mJ/m^2", "work_of_adhesion", 0.05),
            ("0.05 N/m", "work_of_adhesion", 0.05),
            ("50 W/(m K)", "thermal_conductivity", 50.0),
            ("0.5 W/(cm\u{b7}K)", "thermal_conductivity", 50.0),
            ("30 mW/(m*K)", "thermal_conductivity", 0.03),
            ("17 \u{b5}\u{3a9} cm", "electrical_resistivity", 17e-8),
            ("1.7e-7 ohm m", "electrical_resistivity", 1.7e-7),
            ("6.1 mm\u{b2}", "nominal_area", 6.1e-6),
            ("2 m\u{b2}", "nominal_area", 2.0),
            ("200 mm\u{207b}\u{b2}", "asperity_density", 200e6),
            ("50 W/m/K", "thermal_conductivity", 50.0),
            ("0.4 kW/(m K)", "thermal_conductivity", 400.0),
            ("2750 bar", "yield_strength", 275e6),
        ] {
            let found = value(text, key).unwrap_or_else(|| panic!("{text}"));
            assert!(found.total_cmp(&meant).is_eq(), "{text}: {found}");
        }
        for (text, key) in [
            ("210", "youngs_modulus"),
            ("GPa", "youngs_modulus"),
            ("210 mm", "youngs_modulus"),
            ("1 mm", "nominal_area"),
            ("58 MS/m", "electrical_resistivity"),
            ("50 W", "thermal_conductivity"),
            ("200 mm2", "asperity_density"),
            ("1e999999999999 m", "asperity_radius"),
            ("inf m", "asperity_radius"),
            ("1e2e3 m", "asperity_radius"),
        ] {
            assert_eq!(value(text, key), None, "{text}");
        }
    }
}
