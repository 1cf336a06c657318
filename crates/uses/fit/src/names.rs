//! Headers of measurements: names of columns with units, and what is meant by other names.

use asperity_core::{Quantity, nearest_name, plain_unit, units_of};

use crate::FitError;
use crate::observation::{CLOSURE, LOAD, PRESSURE, SEPARATION};

/// Quantities and their other names, in lower case.
const OTHER_NAMES: [(&str, &[&str]); 6] = [
    ("load", &["normal_force", "preload", "f", "fn"]),
    ("pressure", &["nominal_pressure", "p"]),
    ("area", &["contact_area", "real_area", "a"]),
    ("separation", &["gap", "distance", "d"]),
    ("thermal_conductance_per_area", &["h"]),
    (STIFFNESS, &["contact_stiffness", "normal_stiffness", "k", "kn"]),
];
/// A stiffness of which kind its name does not say.
const STIFFNESS: &str = "stiffness";

/// The usual word for a quantity, in lower case: separation for gap. Names of one or two letters
/// have many meanings without a unit, and are none.
fn usual_name(name: &str, has_unit: bool) -> Option<String> {
    let lower = name.trim().to_lowercase().replace([' ', '-'], "_");
    let known = OTHER_NAMES.into_iter().find(|(_, others)| others.contains(&&*lower));
    match known {
        Some((usual, _)) => (has_unit || lower.len() > 2).then(|| usual.into()),
        None => Some(lower),
    }
}

/// Names of displacements, which no model has.
const DISPLACEMENTS: [&str; 5] =
    ["displacement", "approach", "indentation", "compression", "closure"];

/// A column that data may have.
struct Known {
    /// Its name: `area_m2`.
    column: String,
    /// The quantity: `area`.
    quantity: String,
    /// The unit as it is compared.
    si: String,
}

/// All columns of places and quantities.
fn known_columns() -> Vec<Known> {
    let places = [
        (LOAD, "load", "N"),
        (PRESSURE, "pressure", "Pa"),
        (SEPARATION, "separation", "m"),
        (CLOSURE, "closure", "m"),
    ]
    .map(|(column, quantity, si)| (column.to_string(), quantity.to_string(), si));
    // Pressure is a place and a quantity; no model of a fit has quantities of one model.
    let is_own = |quantity: &Quantity| *quantity != Quantity::Pressure && quantity.is_of_models();
    let quantities = Quantity::ALL.into_iter().filter(is_own);
    let quantities = quantities.map(|q| (q.column(), q.to_string().replace('-', "_"), q.unit()));
    let known = |(column, quantity, si)| Known { column, quantity, si: unit_in_name(si) };
    places.into_iter().chain(quantities).map(known).collect()
}

/// Why a name is no column of a fit, with the column that is meant where that is clear.
pub(crate) fn unknown_column(name: &str) -> FitError {
    let known = known_columns();
    let (name, usual) = (name.trim().to_string(), usual_name(name, false).unwrap_or_default());
    let column = |reason: String| FitError::Column { column: name.clone(), reason };
    if DISPLACEMENTS.iter().any(|other| usual.starts_with(other)) {
        return column(format!(
            "a displacement grows where the separation falls: name the column {CLOSURE}, with values in m"
        ));
    }
    if let Some((first, second)) = two_units(&name, &known) {
        let reason = format!("the units {first} and {second} contradict each other; leave one out");
        return column(reason);
    }
    match named(&name, &known) {
        None if usual != STIFFNESS => {}
        _ => {
            let unit = readings(&name).into_iter().find(|(_, unit)| is_unit(unit));
            return column(which_stiffness(unit.map(|(_, unit)| unit).as_deref()));
        }
    }
    let columns = || known.iter().map(|known| known.column.as_str());
    let begun = |behind: &str| {
        let begin = format!("{usual}{behind}");
        columns().find(|column| usual.len() > 2 && column.starts_with(&begin))
    };
    // A name without its unit is nearest to the column that it begins.
    let near = begun("_").or_else(|| nearest_name(&name, columns())).or_else(|| begun(""));
    let (near, known) = (near.map(Into::into), columns().collect::<Vec<_>>().join(", "));
    FitError::UnknownColumn { near, known, name }
}

/// The names of a stiffness of which a header does not say the kind, with its unit.
fn which_stiffness(unit: Option<&str>) -> String {
    let [unloading, tangent, tangential] =
        [Quantity::UnloadingStiffness, Quantity::Tangent, Quantity::TangentialStiffness].map(
            |quantity| match unit {
                Some(unit) => format!("{} [{unit}]", quantity.to_string().replace('-', "_")),
                None => quantity.column(),
            },
        );
    format!(
        "the name does not say which stiffness was measured: name the column {unloading} (small vibrations, ultrasound, start of unloading), {tangent} (first loading) or {tangential} (shear)"
    )
}

/// A unit in a name as it is compared: N/um for `N_per_um`.
fn unit_in_name(unit: &str) -> String {
    let unit = unit.trim().trim_matches(['[', ']', '(', ')']).replace("percent", "%");
    let unit = unit.replace("per_cent", "%").replace("_per_", "/").replace(" per ", "/");
    plain_unit(&unit).replace(['(', ')'], "")
}

/// The ways to read a name as a quantity with a unit behind it: `pressure [MPa]`, `p/MPa`,
/// `pressure_N_per_mm2`.
fn readings(name: &str) -> Vec<(&str, String)> {
    let separators = ['[', '(', '_', '/', ' ', ','];
    let at = name.match_indices(separators).filter(|(at, _)| *at > 0);
    at.map(|(at, separator)| {
        let (before, after) = name.split_at(at);
        let behind = after.get(separator.len()..).unwrap_or_default();
        (before.trim().trim_end_matches(['_', ',']), unit_in_name(behind))
    })
    .collect()
}

/// A known column and the size of the unit of its values.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Named {
    pub(crate) column: String,
    pub(crate) factor: f64,
    /// Whether the values are over the nominal area.
    pub(crate) over_area: bool,
}

/// The column that a name is with another unit: `load_N` and 1000 for `load_kN`, `F [kN]` and
/// `F/kN`; none for a stiffness of unstated kind.
pub(crate) fn with_unit(name: &str) -> Option<Named> {
    named(name, &known_columns()).filter(|found| found.column != Quantity::Stiffness.column())
}

/// Whether a text is a unit of a column, as `[kN]`.
fn is_unit(text: &str) -> bool {
    let unit = unit_in_name(text);
    let is = |known: &Known| size(&unit, &known.si).is_some();
    over_area(&unit).is_some() || known_columns().iter().any(is)
}

/// The size of a unit, as it is compared, of a quantity with this SI unit.
fn size(unit: &str, si: &str) -> Option<f64> {
    // W/(m2 K) is W/m2/K; scenes have both.
    units_of(si).into_iter().find(|(known, _)| unit_in_name(known) == unit).map(|(_, size)| size)
}

/// The size in N/m per m2 of a unit of a stiffness over the nominal area: `GPa/um`, `N/um/mm2` or
/// `N/mm3`.
fn over_area(unit: &str) -> Option<f64> {
    let (over, under) = unit.rsplit_once('/')?;
    let of = |above: &str, below: &str| Some(size(over, above)? / size(under, below)?);
    let cubed = || Some(size(over, "N")? / size(under.strip_suffix('3')?, "m")?.powi(3));
    of("Pa", "m").or_else(|| of("N/m", "m2")).or_else(cubed)
}

/// The known column that `name` is with a unit, and the unit in SI units.
fn named(name: &str, known: &[Known]) -> Option<Named> {
    readings(name).into_iter().find_map(|(before, unit)| {
        let usual = usual_name(before, true)?;
        let alone = usual.strip_suffix("_per_area");
        known.iter().find_map(|Known { column, quantity, si }| {
            let is_share = unit == "%" && quantity.strip_suffix("_fraction") == Some(&*usual);
            let is_it = *quantity == usual || is_share;
            // The name of the column with its unit once more, as `load_N [N]`.
            let plain = (column == before && unit == *si).then_some(1.0);
            let own = plain.or_else(|| size(&unit, si).filter(|_| is_it));
            let is_of_area = si == "N/m" && (is_it || alone == Some(quantity.as_str()));
            let of_area = || over_area(&unit).filter(|_| is_of_area);
            let factor = own.or_else(of_area)?;
            Some(Named { column: column.clone(), factor, over_area: own.is_none() })
        })
    })
}

/// The two units of a name such as `load_N [kN]`.
fn two_units(name: &str, known: &[Known]) -> Option<(String, String)> {
    readings(name).into_iter().find_map(|(before, unit)| {
        let (_, first) = readings(before).into_iter().find(|(_, first)| is_unit(first))?;
        let column = named(before, known).map_or(before.to_string(), |found| found.column);
        let of = known.iter().find(|of| of.column == column)?;
        size(&unit, &of.si).map(|_| (first, unit))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_unit_of_a_quantity_has_others() {
        // Logarithms have one unit.
        for known in known_columns().iter().filter(|known| !known.si.starts_with("ln")) {
            assert!(!units_of(&known.si).is_empty(), "{}", known.column);
        }
    }

    #[test]
    fn columns_with_units_are_recognised() {
        let known = known_columns();
        for line in include_str!("../tests/suite/headings.csv").lines().skip(1) {
            let [name, column, factor, over] =
                line.split(';').map(str::trim).collect::<Vec<_>>()[..]
            else {
                panic!("{line}")
            };
            let found = if over.is_empty() { named(name, &known) } else { with_unit(name) };
            let found = found.unwrap_or_else(|| panic!("{line}"));
            assert_eq!((&*found.column, found.over_area), (column, !over.is_empty()), "{line}");
            let factor: f64 = factor.parse().unwrap();
            assert!((found.factor / factor - 1.0).abs() < 1e-12, "{line}: {found:?}");
        }
        for name in ["load", "load_stone", "a_b", "f", "[N]", "_", "comment"] {
            assert_eq!(named(name, &known), None, "{name}");
        }
        assert!(!with_unit("unloading_stiffness_N_per_mm").unwrap().over_area);
        for name in ["k (GPa/um)", "area_per_area", "load (GPa/um)", "stiffness_per_area_N_per_m3"]
        {
            assert_eq!(with_unit(name), None, "{name}");
        }
    }

    #[test]
    fn two_units_of_a_name_agree_or_are_refused() {
        assert_eq!(with_unit("load_N [N]").map(|found| found.factor), Some(1.0));
        for (name, units) in [
            ("load_N [kN]", "N and kN"),
            ("load_kN [N]", "kN and N"),
            ("area_mm2 (cm2)", "mm2 and cm2"),
            ("unloading_stiffness_N_per_m [N/um]", "N/m and N/um"),
        ] {
            let refused = unknown_column(name).to_string();
            assert!(with_unit(name).is_none() && refused.contains(units), "{name}: {refused}");
        }
    }
}
