//! Numbers with a unit, "210 GPa", in SI units.

use asperity::{OTHER_UNITS, UNITS, Units, nearest_hint, plain_unit as plain};

use crate::keys::Key;
use crate::likely::{hardness, notation_hint};
use crate::scaled::{leading, scale};
use crate::sides;

/// The SI unit of a key of scene files, as [`quantity`] takes it; `None` for keys without a unit.
///
/// ```
/// assert_eq!(asperity_inputs::unit_of("youngs_modulus"), Some("Pa"));
/// assert_eq!(asperity_inputs::unit_of("poissons_ratio"), None);
/// ```
#[must_use]
pub fn unit_of(key: &str) -> Option<&'static str> {
    Key::find("", key).map(|key| key.unit).filter(|unit| !unit.is_empty())
}

/// The reason against a load of 0.
pub const NO_LOAD: &str = "0 is neither a load (above 0) nor a tension (below 0)";

/// A number in the SI unit `si` (Pa, m, m^2, N, J/m^2, N/m, m/N, 1/m, 1/m^2, W/(m K), W/K, W/m2/K,
/// S, S/m2 or ohm m), plain or with another unit of the same dimension: `"5 MPa"`, `"0.2mm"`.
/// Rounded once.
///
/// ```
/// assert_eq!(asperity_inputs::quantity("2.5 kN", "N").unwrap(), 2500.0);
/// let error = asperity_inputs::quantity("2.5 mm", "N").unwrap_err();
/// assert_eq!(error, "\"2.5 mm\" is not a number in N: write 2kN, for example (units: N, kN, MN, mN, uN)");
/// ```
///
/// # Errors
/// A message with the text and the known units.
pub fn quantity(text: &str, si: &str) -> Result<f64, String> {
    number_in(text, si, "").map_err(|hint| format!("{text:?} {hint}"))
}

/// A number of a key of scene files in its SI unit, as [`quantity`] reads it; a plain number for
/// keys without a unit.
///
/// # Errors
/// Those of [`quantity`], with the yield strength or the contact hardness for `120 HV`.
pub fn quantity_of(key: &str, text: &str) -> Result<f64, String> {
    match unit_of(key) {
        Some(si) => number_in(text, si, key).map_err(|hint| format!("{text:?} {hint}")),
        None => text.trim().parse().map_err(|_| format!("{text:?} is not a number")),
    }
}

/// The number, or what follows its text in a message.
fn number_in(text: &str, si: &str, key: &str) -> Result<f64, String> {
    if let Ok(value) = text.trim().parse() {
        return Ok(value);
    }
    match UNITS.into_iter().find(|(known, ..)| *known == si) {
        Some(units) => in_si(text, key, units),
        None => {
            let number = text.trim().strip_suffix(si).unwrap_or(text).trim().parse();
            number.map_err(|_| format!("is not a number in {si}: write it in {si}"))
        }
    }
}

/// A number with one of the units of a key, or what follows its text in a message.
pub(crate) fn in_si(text: &str, key: &str, units: Units) -> Result<f64, String> {
    let (si, example, names) = units;
    if let Some(value) = read(text, units) {
        return Ok(value);
    }
    let is_not = format!("is not a number in {si}");
    if let Some(same) = converted(text, si) {
        return Err(format!("{is_not}: write {}, which is the same", same.replace(' ', "")));
    }
    let vickers = if si == "Pa" { hardness(text, key) } else { None };
    Err(vickers.or_else(|| notation_hint(text)).unwrap_or_else(|| {
        let (near, example) = (nearest_hint(in_other_case(text, units)), example.replace(' ', ""));
        let names = names.iter().map(|(unit, _)| *unit).collect::<Vec<_>>().join(", ");
        format!("{is_not}{near}: write {example}, for example (units: {names})")
    }))
}

/// A number in a unit that [`quantity`](crate::quantity) does not read, in one that it does.
///
/// ```
/// assert_eq!(asperity_inputs::converted("5 kN/cm2", "Pa").as_deref(), Some("50 MPa"));
/// assert_eq!(asperity_inputs::converted("5 kN/cm2", "N"), None);
/// ```
#[must_use]
pub fn converted(given: &str, si: &str) -> Option<String> {
    let (number, rest) = leading(given)?;
    let unit = plain(&rest);
    let other = |(of, name, ..): &&(&str, &str, f64, &str)| *of == si && *name == unit;
    let (.., factor, decimal) = OTHER_UNITS.iter().find(other)?;
    let value = scale(&number, 0)?;
    Some(format!("{} {decimal}", asperity::short(factor * value)))
}

/// The number with the only unit that differs in case: 20kN for 20KN; `None` if there are two (MN,
/// mN).
fn in_other_case(given: &str, units: Units) -> Option<String> {
    let (number, rest) = leading(given)?;
    let unit = plain(&rest);
    let mut alike = units.2.iter().filter(|(known, _)| known.eq_ignore_ascii_case(&unit));
    let (known, _) = alike.next().filter(|_| alike.next().is_none())?;
    Some(format!("{number}{known}"))
}

/// A number with one of the units.
fn read(given: &str, (si, _, units): Units) -> Option<f64> {
    let with_unit = || {
        let (number, rest) = leading(given)?;
        let unit = plain(&rest);
        // 1/mm2 may be written /mm2 or mm-2, 1/mm /mm or mm-1.
        let is = |known: &str| {
            let inverse = |of: &str| {
                let (length, power) = of.strip_suffix('2').map_or((of, 1), |length| (length, 2));
                unit.strip_prefix('/') == Some(of) || unit == format!("{length}-{power}")
            };
            unit == known || known.strip_prefix("1/").is_some_and(inverse)
        };
        let (_, of_unit) = units.iter().find(|(known, _)| is(known))?;
        scale(&number, *of_unit)
    };
    let by_sides = || {
        let lengths = UNITS.iter().find(|(known, ..)| *known == "m")?.2;
        sides::area(given, lengths, units)
    };
    with_unit().or_else(|| if si == "m^2" { by_sides() } else { None })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_units_are_converted() {
        for (text, si, same) in [
            ("36 ksi", "Pa", "write 248.2MPa,"),
            ("30 Msi", "Pa", "write 206.8GPa,"),
            ("0.5 in2", "m^2", "write 322.6mm2,"),
            ("8000 \u{c5}", "m", "write 800nm,"),
            ("0.8 micron", "m", "write 0.8um,"),
            ("100 lbf", "N", "write 444.8N,"),
            ("16 \u{b5}in", "m", "write 406.4nm,"),
            ("10 Mpsi", "Pa", "write 68.95GPa,"),
            ("200 kg/mm2", "Pa", "write 1961MPa,"),
            ("1 atm", "Pa", "write 101.3kPa,"),
            ("1 kgf/cm2", "Pa", "write 98.07kPa,"),
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
    fn powers_are_read_and_other_digits_after_a_number_refused() {
        for (text, si, meant) in [
            ("10^2 N", "N", 100.0),
            ("10\u{b2} N", "N", 100.0),
            ("10^-3 m", "m", 1e-3),
            ("5\u{b7}10^6 Pa", "Pa", 5e6),
            ("2.5 x 10^3 N", "N", 2500.0),
            ("2.5*10^3N", "N", 2500.0),
            ("2.5 \u{d7} 10\u{2076} Pa", "Pa", 2.5e6),
            ("5 x 10^2 mm2", "m^2", 5e-4),
            ("5\u{b7}10^1 mm2", "m^2", 5e-5),
            ("10^3 1/mm2", "1/m^2", 1e9),
            ("12 500 N", "N", 12500.0),
            ("1\u{202f}234\u{202f}567.5 Pa", "Pa", 1_234_567.5),
        ] {
            assert_eq!(quantity(text, si), Ok(meant), "{text}");
        }
        for (text, si, how) in [
            ("2^10 N", "N", "\"2^10 N\" is not a number in N"),
            ("2*10 N", "N", "\"2*10 N\" is not a number in N"),
            ("1 00 N", "N", "\"1 00 N\" is not a number in N"),
            ("1000 500 N", "N", "\"1000 500 N\" is not a number in N"),
        ] {
            let error = quantity(text, si).unwrap_err();
            assert!(error.starts_with(how), "{error}");
        }
    }

    #[test]
    fn a_hardness_is_converted_for_the_key_that_takes_it() {
        for text in ["120 HV", "120HV10", "HV 120", "120 hv"] {
            let error = quantity_of("hardness", text).unwrap_err();
            let wanted =
                format!("{text:?} is not in Pa: write 1.269GPa, the contact hardness (mean");
            assert!(error.starts_with(&wanted), "{error}");
        }
        assert!(quantity("120 HV", "N").unwrap_err().contains("units: N, kN"));
    }

    fn value(text: &str, key: &str) -> Option<f64> {
        let units = Key::find("", key).and_then(Key::units).unwrap();
        read(text, units)
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
