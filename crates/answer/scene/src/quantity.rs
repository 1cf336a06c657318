//! Numbers with a unit, "210 GPa", in SI units.

use asperity::{
    OTHER_UNITS, UNITS, Units, hardness_of_vickers, nearest_hint, plain_unit as plain, short,
    vickers_of_brinell, vickers_of_rockwell_c,
};

use crate::keys::{Key, key_of_input};
use crate::likely::{hardness_test, notation_hint};
use crate::scaled::{leading, scale};
use crate::sides;

/// Units of kinematic viscosities, which data sheets of oils have, and what to do.
const KINEMATIC: [&str; 4] = ["cSt", "St", "mm2/s", "m2/s"];
const TIMES_DENSITY: &str = "is a kinematic viscosity: multiply it by the density (10 cSt in oil of 870 kg/m3 are 8.7 mPa s)";

/// The SI unit of a key of scene files, as [`quantity`] takes it; `None` for keys without a unit.
///
/// ```
/// assert_eq!(asperity_scene::unit_of("youngs_modulus"), Some("Pa"));
/// assert_eq!(asperity_scene::unit_of("poissons_ratio"), None);
/// ```
#[must_use]
pub fn unit_of(key: &str) -> Option<&'static str> {
    Key::find("", key).map(|key| key.unit).filter(|unit| !unit.is_empty())
}

/// The head of a column of an input, with its SI unit: `hardness_Pa`.
///
/// ```
/// assert_eq!(asperity_scene::column_of("body1_hardness"), "body1_hardness_Pa");
/// assert_eq!(asperity_scene::column_of("asperity_density"), "asperity_density_per_m2");
/// ```
#[must_use]
pub fn column_of(input: &str) -> String {
    match unit_of(key_of_input(input)) {
        Some(unit) => {
            let unit = unit.trim_start_matches('1').replace('/', "_per_").replace(' ', "_");
            format!("{input}_{}", unit.replace(['(', ')', '^'], "").trim_start_matches('_'))
        }
        None => input.into(),
    }
}

/// The reason against a load of 0.
pub const NO_LOAD: &str = "0 is neither a load (above 0) nor a tension (below 0)";

/// A number in the SI unit `si` (Pa, m, m^2, N, J/m^2, N/m, m/N, 1/m, 1/m^2, W/(m K), W/K, W/m2/K,
/// S, S/m2 or ohm m), plain or with another unit of the same dimension: `"5 MPa"`, `"0.2mm"`,
/// `"36 ksi"`. Rounded once with a decimal unit.
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
    number_in(text, si, "").map_err(|hint| format!("{text:?} {hint}"))
}

/// A number of a key of scene files in its SI unit, as [`quantity`] reads it; a plain number for
/// keys without a unit.
///
/// # Errors
/// Those of [`quantity`]; of the keys, only `hardness` takes `120 HV`, `58 HRC` and `200 HB`.
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
    let other = || {
        let (value, unit) = in_known_unit(text, key, si)?;
        read(&format!("{value:e}{unit}"), units)
    };
    if let Some(value) = read(text, units).or_else(other) {
        return Ok(value);
    }
    let is_hardness = key == "yield_strength" && hardness_test(text).is_some();
    let strength = "is a hardness, not a yield strength: give hardness instead";
    let is_kinematic =
        si == "Pa s" && leading(text).is_some_and(|(_, unit)| KINEMATIC.contains(&&*plain(&unit)));
    let other_scale = |scale: &str| key == "hardness" && text.to_uppercase().contains(scale);
    let is_other = ["HB", "HR", "SHORE"].into_iter().any(other_scale);
    let of_table = "is a hardness outside the tables for steel (20 to 65 HRC, up to 450 HB): convert it to HV or GPa";
    let hint = is_hardness.then_some(strength).or(is_kinematic.then_some(TIMES_DENSITY));
    let hint = hint.or(is_other.then_some(of_table));
    Err(hint.map(String::from).or_else(|| notation_hint(text)).unwrap_or_else(|| {
        let near = nearest_hint(in_other_case(text, units));
        let typed = Key::find("", key).map(|key| key.form[1]).filter(|typed| !typed.is_empty());
        // 200 1/mm2 joined would read as 2001 per mm2.
        let example = typed.unwrap_or(example);
        let example =
            if example.contains(" 1/") { example.into() } else { example.replace(' ', "") };
        let names = names.iter().map(|(unit, _)| *unit).collect::<Vec<_>>().join(", ");
        format!("is not a number in {si}{near}: write {example}, for example (units: {names})")
    }))
}

/// The Vickers number of a hardness test, and the table by which it was found from another scale.
fn vickers(text: &str) -> Option<(f64, Option<&'static str>)> {
    let (number, scale) = hardness_test(text)?;
    Some(match scale {
        "HV" => (number, None),
        "HRC" => (vickers_of_rockwell_c(number)?, Some("by a table for steel, 20 to 65 HRC")),
        _ => (vickers_of_brinell(number)?, Some("HB/0.95, for steel up to 450 HB")),
    })
}

/// A number of a key in one of [`OTHER_UNITS`], or a hardness such as `120 HV`, as a value in a
/// decimal unit.
fn in_known_unit(text: &str, key: &str, si: &str) -> Option<(f64, &'static str)> {
    if let Some((vickers, _)) = vickers(text).filter(|_| key == "hardness") {
        return Some((1e-9 * hardness_of_vickers(vickers), "GPa"));
    }
    let (number, rest) = leading(text)?;
    let unit = plain(&rest);
    let other = |(of, name, ..): &&(&str, &str, f64, &str)| *of == si && *name == unit;
    let (.., factor, decimal) = OTHER_UNITS.iter().find(other)?;
    Some((factor * scale(&number, 0)?, decimal))
}

/// A number of a key, or of any with an empty one, that has a unit outside of the decimal ones, in
/// one of these; of a hardness on another scale than Vickers, with its table.
///
/// ```
/// assert_eq!(asperity_scene::converted("5 kN/cm2", "", "Pa").as_deref(), Some("50 MPa"));
/// assert_eq!(asperity_scene::converted("5 kN/cm2", "", "N"), None);
/// assert_eq!(asperity_scene::converted("120 HV", "hardness", "Pa").as_deref(), Some("1.269 GPa"));
/// ```
#[must_use]
pub fn converted(text: &str, key: &str, si: &str) -> Option<String> {
    let (value, unit) = in_known_unit(text, key, si)?;
    let table = vickers(text).filter(|_| key == "hardness").and_then(|(vickers, table)| {
        Some(format!(" ({vickers:.0} HV {}; tables differ by some per cent)", table?))
    });
    Some(format!("{} {unit}{}", short(value), table.unwrap_or_default()))
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
    fn other_units_are_taken() {
        for (text, si, wanted, same) in [
            ("36 ksi", "Pa", 248.211e6, "248.2 MPa"),
            ("30 Msi", "Pa", 206.843e9, "206.8 GPa"),
            ("145 psi", "Pa", 999_740.0, "999.7 kPa"),
            ("210 kN/mm2", "Pa", 210e9, "210 GPa"),
            ("0.5 in2", "m^2", 322.58e-6, "322.6 mm2"),
            ("8000 \u{c5}", "m", 800e-9, "800 nm"),
            ("0.8 micron", "m", 0.8e-6, "0.8 um"),
            ("100 lbf", "N", 444.822, "444.8 N"),
            ("16 \u{b5}in", "m", 406.4e-9, "406.4 nm"),
            ("10 Mpsi", "Pa", 68.9476e9, "68.95 GPa"),
            ("200 kgf/mm^2", "Pa", 1961.33e6, "1961 MPa"),
            ("1 atm", "Pa", 101_325.0, "101.3 kPa"),
        ] {
            let found = quantity(text, si).unwrap();
            assert!((found / wanted - 1.0).abs() < 3e-6, "{text}: {found}");
            assert_eq!(converted(text, "", si).as_deref(), Some(same));
        }
        assert!(quantity("36 ksi", "N").unwrap_err().contains("write 2kN, for example"));
        assert_eq!(converted("210 GPa", "youngs_modulus", "Pa"), None);
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
        for text in ["2^10 N", "2*10 N", "1 00 N", "1000 500 N"] {
            assert!(quantity(text, "N").is_err(), "{text}");
        }
    }

    #[test]
    fn a_vickers_number_is_taken_by_the_hardness_alone() {
        for text in ["120 HV", "120HV10", "HV 120", "120 hv"] {
            let found = quantity_of("hardness", text).unwrap();
            assert!((found / 1.269217e9 - 1.0).abs() < 1e-5, "{text}: {found}");
        }
        for (text, pascals) in [
            ("58 HRC", 6.907e9),
            ("HRC 40", 4.146e9),
            ("190 HBW10/3000", 2.115e9),
            ("190 HB", 2.115e9),
        ] {
            let found = quantity_of("hardness", text).unwrap();
            assert!((found / pascals - 1.0).abs() < 5e-4, "{text}: {found}");
        }
        let note = converted("58 HRC", "hardness", "Pa").unwrap();
        assert!(note.starts_with("6.907 GPa (653 HV "), "{note}");
        for text in ["70 HRC", "500 HB", "90 HRB", "60 Shore A"] {
            assert!(
                quantity_of("hardness", text).unwrap_err().contains("tables for steel"),
                "{text}"
            );
        }
        assert!(quantity_of("yield_strength", "120 HV").is_err());
        assert!(quantity("120 HV", "N").unwrap_err().contains("units: N, kN"));
        assert!(quantity_of("youngs_modulus", "120 HV").is_err());
    }

    #[test]
    fn the_example_of_a_message_is_that_of_the_key() {
        for (key, text, wanted) in [
            ("hardness", "5 kg", "write 2GPa, for example"),
            ("youngs_modulus", "210 mm", "write 210GPa, for example"),
            ("sq", "Ra 0.8", "write 1.1um, for example"),
            ("asperity_density", "0.01 1/in2", "write 200 1/mm2, for example"),
        ] {
            let error = quantity_of(key, text).unwrap_err();
            assert!(error.contains(wanted), "{error}");
        }
        assert!(quantity("5 kg", "Pa").unwrap_err().contains("write 5MPa, for example"));
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
