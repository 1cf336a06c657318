//! Numbers with a unit, "210 GPa", in SI units.

use asperity::{
    BRINELL_LIMITS, ROCKWELL_C_LIMITS, Units, hardness_of_vickers, plain_unit as plain, short,
    units, vickers_of_brinell, vickers_of_rockwell_c,
};

use crate::keys::{Key, key_of_input};

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
/// assert_eq!(error, "\"2.5 mm\" is not a number in N: write \"2 kN\", for example (units: N, kN, MN, mN, uN)");
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
/// The errors of [`quantity`]; of the keys, only `hardness` takes `120 HV`, `58 HRC` and `200 HB`.
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
    match units().iter().find(|units| units.si == si) {
        Some(units) => in_si(text, key, units),
        None => {
            let number = text.trim().strip_suffix(si).unwrap_or(text).trim().parse();
            number.map_err(|_| format!("is not a number in {si}: write it in {si}"))
        }
    }
}

/// A number with one of the units of a key, or what follows its text in a message. Of the keys,
/// the hardness takes results of hardness tests.
pub(crate) fn in_si(text: &str, key: &str, units: &Units) -> Result<f64, String> {
    if let Some(number) = read(text, units) {
        return Ok(number);
    }
    if let Some((number, scale_of_test)) = tested(text).filter(|_| key == "hardness") {
        let gigapascals = 1e-9 * hardness_of_vickers(vickers(number, &scale_of_test)?);
        return scale(&format!("{gigapascals:e}"), 9).ok_or_else(|| "is not finite".into());
    }
    if let Some(hint) = notation_hint(text) {
        return Err(hint.into());
    }
    let typed = Key::find("", key).map(|key| key.form[1]).filter(|typed| !typed.is_empty());
    let (si, example) = (units.si, typed.unwrap_or(units.example));
    let names = units.decimal.iter().map(|(unit, _)| *unit).collect::<Vec<_>>().join(", ");
    Err(format!("is not a number in {si}: write \"{example}\", for example (units: {names})"))
}

/// Which of two ends has no unit where the other has one; 0 needs none.
pub(crate) fn without_unit(ends: [f64; 2], has_unit: [bool; 2]) -> Option<usize> {
    let bare = usize::from(has_unit[0]);
    (has_unit[0] != has_unit[1] && ends[bare] != 0.0).then_some(bare)
}

/// What is wrong with a number that is refused for its commas or points; `None` for other texts.
///
/// ```
/// assert!(asperity_scene::notation_hint("1,5 kN").is_some());
/// assert_eq!(asperity_scene::notation_hint("1.5 kN"), None);
/// ```
#[must_use]
pub fn notation_hint(text: &str) -> Option<&'static str> {
    let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let separates = |(k, c): (usize, char)| {
        is_digit(text[..k].chars().next_back()) && is_digit(text[k + c.len_utf8()..].chars().next())
    };
    let separators = text.char_indices().filter(|(_, c)| ",'\u{2019}\u{a0}\u{202f}".contains(*c));
    let is_odd = { separators }.any(separates) || text.matches('.').count() > 1;
    is_odd.then_some("has a decimal comma or separators of thousands; write it as 1234.5")
}

/// The decimal number at the start of a text, and the unit behind it.
fn leading(text: &str) -> Option<(String, String)> {
    let text = text.trim();
    let is_part = |c: char| c.is_ascii_digit() || ".+-eE_".contains(c);
    let (number, unit) = text.split_at(text.find(|c| !is_part(c)).unwrap_or(text.len()));
    let number = number.replace('_', "").to_lowercase();
    number.parse::<f64>().ok().map(|_| (number, plain(unit)))
}

/// A decimal number times a power of ten, rounded once.
fn scale(number: &str, power: i32) -> Option<f64> {
    let (digits, own) = number.split_once('e').unwrap_or((number, "0"));
    let exponent = own.parse::<i32>().ok()?.checked_add(power)?;
    format!("{digits}e{exponent}").parse().ok()
}

/// The number and the scale of the result of a hardness test, `120 HV10` or `HRC 58`.
fn tested(text: &str) -> Option<(f64, String)> {
    let text = text.trim().to_uppercase();
    let (before, rest) = text.split_at(text.find('H')?);
    let end = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
    let (scale, after) = rest.split_at(end);
    // Before the scale, with the load of the test behind it, or behind it.
    let is_load = |text: &str| text.split('/').all(|of| of.trim().parse::<f64>().is_ok());
    let number = match (before.trim(), after.trim()) {
        ("", number) => number,
        (number, load) if load.is_empty() || is_load(load) => number,
        _ => return None,
    };
    let number = number.parse::<f64>().ok().filter(|value| value.is_finite())?;
    Some((number, scale.into()))
}

/// The Vickers number of the result of a hardness test, or what follows its text in a message.
fn vickers(number: f64, scale: &str) -> Result<f64, String> {
    let instead = "write the Vickers number, \"200 HV\", or a pressure, \"2 GPa\"";
    let (found, [least, most]) = match scale {
        "HV" => return Ok(number),
        "HRC" => (vickers_of_rockwell_c(number), ROCKWELL_C_LIMITS),
        "HB" | "HBW" => (vickers_of_brinell(number), BRINELL_LIMITS),
        _ => return Err(format!("is not converted, as HV, HRC and HBW are: {instead}")),
    };
    found.ok_or_else(|| {
        format!("is beyond {least} to {most} {scale}, which are converted: {instead}")
    })
}

/// What to write instead of a number with a tolerance, `2 GPa +- 10 %`, or of a range in one text,
/// `1.8-2.2 GPa`: both ends, in brackets.
///
/// ```text
/// has a tolerance: write both ends, ["1.8 GPa", "2.2 GPa"]
/// ```
pub(crate) fn both_ends(text: &str) -> Option<String> {
    let (what, ends, unit) = tolerance(text).or_else(|| range(text))?;
    let end = |value: f64| match &*unit {
        "" => short(value),
        unit => format!("\"{} {unit}\"", short(value)),
    };
    let [lower, upper] = ends.map(end);
    Some(format!("{what}: write both ends, [{lower}, {upper}]"))
}

/// What a text is, its ends and their unit.
type Ends = (&'static str, [f64; 2], String);

fn tolerance(text: &str) -> Option<Ends> {
    let signs = ["+/-", "+-", "\u{b1}"];
    let (number, tolerance) = signs.into_iter().find_map(|sign| text.split_once(sign))?;
    let ((number, unit), (by, of)) = (leading(number)?, leading(tolerance)?);
    let (number, by) = (number.parse::<f64>().ok()?, by.parse::<f64>().ok()?);
    let (by, unit) = match (&*unit, &*of) {
        (_, "%") => (0.01 * by * number, unit),
        ("", _) => (by, of),
        (_, "") => (by, unit),
        (one, other) if one == other => (by, unit),
        _ => return None,
    };
    Some(("has a tolerance", [number - by, number + by], unit))
}

fn range(text: &str) -> Option<Ends> {
    let between = |sign: &str| {
        let ends = |(k, _)| leading(&text[..k]).zip(leading(&text[k + sign.len()..]));
        let mut found = text.match_indices(sign).filter_map(ends);
        found.find(|((_, of), (_, unit))| of.is_empty() || of == unit)
    };
    let ((lower, _), (upper, unit)) =
        ["...", "..", " to ", "\u{2013}", "-"].into_iter().find_map(between)?;
    let mut ends: [f64; 2] = [lower.parse().ok()?, upper.parse().ok()?];
    ends.sort_by(f64::total_cmp);
    Some(("is a range", ends, unit))
}

/// A number with one of the units.
fn read(given: &str, units: &Units) -> Option<f64> {
    let (number, unit) = leading(given)?;
    // 1/mm2 may be written /mm2 or mm-2, 1/mm /mm or mm-1.
    let is = |known: &str| {
        let inverse = |of: &str| {
            let (length, power) = of.strip_suffix('2').map_or((of, 1), |length| (length, 2));
            unit.strip_prefix('/') == Some(of) || unit == format!("{length}-{power}")
        };
        unit == known || known.strip_prefix("1/").is_some_and(inverse)
    };
    if let Some((_, power)) = units.decimal.iter().find(|(known, _)| is(known)) {
        return scale(&number, *power);
    }
    let (_, size, power) = units.others.iter().find(|(known, ..)| *known == unit)?;
    scale(&format!("{:e}", size * scale(&number, 0)?), *power)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Texts, the key or the unit of a number, its number and within what: 0 for bit by bit.
    #[test]
    fn numbers_with_units_are_taken() {
        for line in include_str!("../tests/suite/quantities.csv").lines().skip(1) {
            let [text, of, wanted, within] =
                line.split("; ").map(str::trim).collect::<Vec<_>>()[..]
            else {
                panic!("{line}")
            };
            let key = Key::find("", of).and_then(Key::units);
            let found = match (within, key) {
                ("0", Some(units)) => read(text, units),
                (_, Some(_)) => quantity_of(of, text).ok(),
                _ => quantity(text, of).ok(),
            };
            let (Some(found), Ok(wanted)) = (found, wanted.parse::<f64>()) else {
                assert!(found.is_none() && wanted == "refused", "{line}: {found:?}");
                continue;
            };
            let within: f64 = within.parse().unwrap();
            let is_same = found.total_cmp(&wanted).is_eq();
            assert!(is_same || (found / wanted - 1.0).abs() < within, "{line}: {found}");
        }
    }

    #[test]
    fn other_digits_beside_a_number_are_refused() {
        for text in ["2^10 N", "10^2 N", "10\u{b2} N", "2*10 N", "5 x 10^2 N", "1 00 N", "12 500 N"]
        {
            assert!(quantity(text, "N").is_err(), "{text}");
        }
        for text in ["1,5 N", "1.234.567 N", "1'500 N", "12\u{202f}500 N"] {
            assert_eq!(notation_hint(text).is_some(), quantity(text, "N").is_err(), "{text}");
        }
        assert_eq!(
            [notation_hint("5 1/mm2"), notation_hint("1.500"), notation_hint("1, 5")],
            [None; 3]
        );
    }
}
