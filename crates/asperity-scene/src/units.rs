//! Units of numbers, and a number with one of them.

use crate::scaled::scale;
use crate::sides;

pub(crate) type Units = (&'static str, &'static str, &'static [(&'static str, i32)]);

/// The SI unit as in the template, an example, and the units with their powers of ten. Spaces, dots
/// between units, * and ^ are ignored; µ is u, ² is 2, and Ω is ohm.
pub(crate) const UNITS: [Units; 10] = [
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
pub(crate) fn converted(given: &str, si: &str) -> Option<String> {
    let text = plain(given);
    let other = OTHERS.iter().filter(|(of, ..)| *of == si);
    other.into_iter().find_map(|(_, unit, factor, decimal)| {
        let value = scale(text.strip_suffix(unit)?, 0)?;
        Some(format!("{} {decimal}", asperity::short(factor * value)))
    })
}

pub(crate) fn list(units: &[(&str, i32)]) -> String {
    units.iter().map(|(unit, _)| *unit).collect::<Vec<_>>().join(", ")
}

/// The number with the only unit that differs in case: 20kN for 20KN; `None` if there are two (MN,
/// mN).
pub(crate) fn in_other_case(given: &str, units: Units) -> Option<String> {
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
pub(crate) fn read(given: &str, (si, _, units): Units) -> Option<f64> {
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
