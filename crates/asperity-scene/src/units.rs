//! Units of numbers, and a number with one of them.

use crate::scaled::{leading, scale};
use crate::sides;
use crate::unit_name::plain;

pub(crate) type Units = (&'static str, &'static str, &'static [(&'static str, i32)]);

/// The SI unit as in the template, an example, and the units with their powers of ten. In units,
/// spaces, raised dots, * and ^ are ignored; µ is u, ² is 2, and Ω is ohm.
pub(crate) const UNITS: [Units; 15] = [
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
    (
        "N/m",
        "20 N/um",
        &[
            ("N/m", 0),
            ("N/mm", 3),
            ("N/um", 6),
            ("N/nm", 9),
            ("kN/mm", 6),
            ("kN/um", 9),
            ("MN/m", 6),
            ("GN/m", 9),
        ],
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
    ("W/K", "2 kW/K", &[("W/K", 0), ("mW/K", -3), ("kW/K", 3)]),
    (
        "W/m2/K",
        "5 kW/m2/K",
        &[
            ("W/m2/K", 0),
            ("W/(m2K)", 0),
            ("W/m2K", 0),
            ("kW/m2/K", 3),
            ("kW/(m2K)", 3),
            ("kW/m2K", 3),
            ("W/cm2/K", 4),
            ("W/(cm2K)", 4),
            ("W/cm2K", 4),
        ],
    ),
    ("S", "2 kS", &[("S", 0), ("uS", -6), ("mS", -3), ("kS", 3), ("1/ohm", 0)]),
    ("S/m2", "2 S/mm2", &[("S/m2", 0), ("S/cm2", 4), ("S/mm2", 6), ("kS/m2", 3)]),
    (
        "ohm m",
        "17 uohm cm",
        &[("uohmcm", -8), ("uohmm", -6), ("nohmm", -9), ("mohmm", -3), ("ohmcm", -2), ("ohmm", 0)],
    ),
];
/// A pound-force per square inch \[kPa\].
const PSI: f64 = 6.894_757_293_168_4;
/// Units that are not read, with their size in one that is.
const OTHERS: [(&str, &str, f64, &str); 22] = [
    ("Pa", "kN/mm2", 1.0, "GPa"),
    ("Pa", "kN/cm2", 10.0, "MPa"),
    ("Pa", "kN/m2", 1.0, "kPa"),
    ("Pa", "N/cm2", 10.0, "kPa"),
    ("Pa", "kgf/mm2", 9.80665, "MPa"),
    ("Pa", "kg/mm2", 9.80665, "MPa"),
    ("Pa", "kgf/cm2", 98.0665, "kPa"),
    ("Pa", "kg/cm2", 98.0665, "kPa"),
    ("Pa", "atm", 101.325, "kPa"),
    ("Pa", "Msi", PSI, "GPa"),
    ("Pa", "Mpsi", PSI, "GPa"),
    ("Pa", "ksi", PSI, "MPa"),
    ("Pa", "psi", PSI, "kPa"),
    ("N", "kgf", 9.80665, "N"),
    ("N", "lbf", 4.448_221_615_260_5, "N"),
    ("m", "uin", 25.4, "nm"),
    ("m", "in", 25.4, "mm"),
    ("m", "micron", 1.0, "um"),
    ("m", "microns", 1.0, "um"),
    ("m", "\u{c5}", 0.1, "nm"),
    ("m", "\u{212b}", 0.1, "nm"),
    ("m^2", "in2", 645.16, "mm2"),
];

/// Whether a text is a unit of one of the quantities, or the name of a scale: kN, W/(m K), psi, HV.
#[must_use]
pub fn is_unit(text: &str) -> bool {
    let unit = plain(text);
    let decimal = UNITS.iter().flat_map(|(.., units)| units.iter().map(|(name, _)| *name));
    let others = OTHERS.iter().map(|(_, name, ..)| *name).chain(["%", "HV"]);
    decimal.chain(others).any(|known| known == unit)
}

/// A number in a unit that [`quantity`](crate::quantity) does not read, in one that it does.
///
/// ```
/// assert_eq!(asperity_scene::converted("5 kN/cm2", "Pa").as_deref(), Some("50 MPa"));
/// assert_eq!(asperity_scene::converted("5 kN/cm2", "N"), None);
/// ```
#[must_use]
pub fn converted(given: &str, si: &str) -> Option<String> {
    let (number, power, rest) = leading(given)?;
    let unit = plain(rest);
    let other = |(of, name, ..): &&(&str, &str, f64, &str)| *of == si && *name == unit;
    let (.., factor, decimal) = OTHERS.iter().find(other)?;
    let value = scale(&number, power)?;
    Some(format!("{} {decimal}", asperity::short(factor * value)))
}

pub(crate) fn list(units: &[(&str, i32)]) -> String {
    units.iter().map(|(unit, _)| *unit).collect::<Vec<_>>().join(", ")
}

/// The number with the only unit that differs in case: 20kN for 20KN; `None` if there are two (MN,
/// mN).
pub(crate) fn in_other_case(given: &str, units: Units) -> Option<String> {
    let (number, 0, rest) = leading(given)? else { return None };
    let unit = plain(rest);
    let mut alike = units.2.iter().filter(|(known, _)| known.eq_ignore_ascii_case(&unit));
    let (known, _) = alike.next().filter(|_| alike.next().is_none())?;
    Some(format!("{number}{known}"))
}

/// A number with one of the units.
pub(crate) fn read(given: &str, (si, _, units): Units) -> Option<f64> {
    let with_unit = || {
        let (number, power, rest) = leading(given)?;
        let unit = plain(rest);
        // 1/mm2 may be written /mm2 or mm-2, 1/mm /mm or mm-1.
        let is = |known: &str| {
            let inverse = |of: &str| {
                let (length, power) = of.strip_suffix('2').map_or((of, 1), |length| (length, 2));
                unit.strip_prefix('/') == Some(of) || unit == format!("{length}-{power}")
            };
            unit == known || known.strip_prefix("1/").is_some_and(inverse)
        };
        let (_, of_unit) = units.iter().find(|(known, _)| is(known))?;
        scale(&number, power.checked_add(*of_unit)?)
    };
    let by_sides = || {
        let lengths = UNITS.iter().find(|(known, ..)| *known == "m")?.2;
        sides::area(given, lengths, units)
    };
    with_unit().or_else(|| if si == "m^2" { by_sides() } else { None })
}
