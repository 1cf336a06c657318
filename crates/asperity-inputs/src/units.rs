//! Units of numbers, and a number with one of them.

use asperity::plain_unit as plain;
pub(crate) use asperity::{OTHER_UNITS, UNITS, Units};

use crate::scaled::{leading, scale};
use crate::sides;

/// Whether a text is a unit of one of the quantities, or the name of a scale: kN, W/(m K), psi, HV.
#[must_use]
pub fn is_unit(text: &str) -> bool {
    let unit = plain(text);
    let decimal = UNITS.iter().flat_map(|(.., units)| units.iter().map(|(name, _)| *name));
    let others = OTHER_UNITS.iter().map(|(_, name, ..)| *name).chain(["%", "HV"]);
    decimal.chain(others).any(|known| known == unit)
}

/// A number in a unit that [`quantity`](crate::quantity) does not read, in one that it does.
///
/// ```
/// assert_eq!(asperity_inputs::converted("5 kN/cm2", "Pa").as_deref(), Some("50 MPa"));
/// assert_eq!(asperity_inputs::converted("5 kN/cm2", "N"), None);
/// ```
#[must_use]
pub fn converted(given: &str, si: &str) -> Option<String> {
    let (number, power, rest) = leading(given)?;
    let unit = plain(rest);
    let other = |(of, name, ..): &&(&str, &str, f64, &str)| *of == si && *name == unit;
    let (.., factor, decimal) = OTHER_UNITS.iter().find(other)?;
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
