//! Headers of measurements: names of columns with units, and what is meant by other names.

use asperity_core::{Quantity, nearest_name, plain_unit, short, units_of};

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
    let of_area = |(before, unit): &(&str, String)| {
        usual_name(before, true).as_deref() == Some(STIFFNESS) && unit.contains("Pa/")
    };
    if readings(&name).iter().any(of_area) {
        return column(which_stiffness(
            ", and multiply its values, in N/m per m2, by the nominal area",
        ));
    }
    match named(&name, &known) {
        Some((_, factor)) if is_other(factor) => {
            let multiply = format!(", and multiply its values by {}", short(factor));
            return column(which_stiffness(&multiply));
        }
        None if usual != STIFFNESS => {}
        _ => return column(which_stiffness("")),
    }
    if let Some(column) = per_area(&name, &known) {
        return FitError::Data(format!(
            "column {name:?} is per nominal area: name it {column} and multiply its values, in N/m per m2, by the nominal area"
        ));
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

fn is_other(factor: f64) -> bool {
    (factor - 1.0).abs() > f64::EPSILON
}

/// The names of a stiffness of which a header does not say the kind, and how to `multiply` it.
fn which_stiffness(multiply: &str) -> String {
    let [unloading, tangent, tangential] =
        [Quantity::UnloadingStiffness, Quantity::Tangent, Quantity::TangentialStiffness]
            .map(Quantity::column);
    format!(
        "the name does not say which stiffness was measured: name the column {unloading} (small vibrations, ultrasound, start of unloading), {tangent} (first loading) or {tangential} (shear){multiply}"
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

/// The column that a name is with another unit, and the size of that unit: `load_N` and 1000 for
/// `load_kN`, `F [kN]` and `F/kN`; none for a stiffness of unstated kind.
pub(crate) fn with_unit(name: &str) -> Option<(String, f64)> {
    let known = known_columns();
    let (column, factor) = named(name, &known)?;
    (column != Quantity::Stiffness.column()).then(|| (column.to_string(), factor))
}

/// Whether a text is a unit of a column, as `[kN]`.
#[must_use]
pub fn is_unit(text: &str) -> bool {
    let is =
        |si: &str| units_of(si).iter().any(|(unit, _)| unit_in_name(unit) == unit_in_name(text));
    known_columns().iter().any(|known| is(&known.si))
}

/// The known column that `name` is with a unit, and the unit in SI units.
fn named<'k>(name: &str, known: &'k [Known]) -> Option<(&'k str, f64)> {
    readings(name).into_iter().find_map(|(before, unit)| {
        let usual = usual_name(before, true)?;
        known.iter().find_map(|Known { column, quantity, si }| {
            let is_share = unit == "%" && quantity.strip_suffix("_fraction") == Some(&*usual);
            let units = units_of(si).into_iter().filter(|_| *quantity == usual || is_share);
            // W/(m2 K) is W/m2/K; scenes have both.
            let (_, factor) = units.into_iter().find(|(known, _)| unit_in_name(known) == unit)?;
            Some((column.as_str(), factor))
        })
    })
}

/// The known stiffness that `name` is over the nominal area: `unloading_stiffness_N_per_m` for
/// `unloading_stiffness_per_area_N_per_m3` and `unloading_stiffness_Pa_per_m`.
fn per_area<'k>(name: &str, known: &'k [Known]) -> Option<&'k str> {
    let begins = |known: &&Known| known.si == "N/m" && name.starts_with(&known.quantity);
    let begun = known.iter().filter(begins).max_by_key(|known| known.quantity.len())?;
    let unit = name.strip_prefix(&begun.quantity)?;
    let areas = [
        "per_area", "per_m2", "per_mm2", "per_um2", "per_m3", "per_mm3", "/m2", "/m3", "Pa_per_",
        "Pa/",
    ];
    areas.iter().any(|area| unit.contains(area)).then_some(&begun.column)
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
        let per_area = "thermal_conductance_per_area_W_per_m2_per_K";
        for (name, wanted) in [
            ("load_kN", ("load_N", 1e3)),
            ("area_mm2", ("area_m2", 1e-6)),
            ("A [mm^2]", ("area_m2", 1e-6)),
            ("tangent_N_per_um", ("tangent_N_per_m", 1e6)),
            ("tangent_N/um", ("tangent_N_per_m", 1e6)),
            ("separation_um", ("separation_m", 1e-6)),
            ("gap [\u{b5}m]", ("separation_m", 1e-6)),
            ("d [\u{b5}m]", ("separation_m", 1e-6)),
            ("Load [kN]", ("load_N", 1e3)),
            ("load_N", ("load_N", 1.0)),
            ("load [N]", ("load_N", 1.0)),
            ("F/N", ("load_N", 1.0)),
            ("p/MPa", ("pressure_Pa", 1e6)),
            ("p / MPa", ("pressure_Pa", 1e6)),
            ("pressure [N/mm2]", ("pressure_Pa", 1e6)),
            ("pressure_N_per_mm2", ("pressure_Pa", 1e6)),
            ("pressure_kN/m2", ("pressure_Pa", 1e3)),
            ("load_lbf", ("load_N", 4.448_221_615_260_5)),
            ("load_kgf", ("load_N", 9.80665)),
            ("tangent (N/um)", ("tangent_N_per_m", 1e6)),
            ("tangent_MN_per_m", ("tangent_N_per_m", 1e6)),
            ("unloading_stiffness_kN_per_um", ("unloading_stiffness_N_per_m", 1e9)),
            ("thermal_conductance_per_area_kW_per_m2_per_K", (per_area, 1e3)),
            ("h [W/m2K]", (per_area, 1.0)),
            ("h [kW/(m2 K)]", (per_area, 1e3)),
            ("area_percent", ("area_fraction", 0.01)),
            ("area_fraction_%", ("area_fraction", 0.01)),
            ("area_fraction_percent", ("area_fraction", 0.01)),
            ("electrical_conductance_kS", ("electrical_conductance_S", 1e3)),
        ] {
            let found = named(name, &known);
            let near = found.filter(|found| (found.1 / wanted.1 - 1.0).abs() < 1e-12);
            assert!(near.is_some_and(|found| found.0 == wanted.0), "{name}: {found:?}");
        }
        for name in ["load", "load_stone", "a_b", "f", "[N]", "_", "comment"] {
            let found = named(name, &known);
            assert_eq!(found, None, "{name}");
        }
    }

    #[test]
    fn stiffnesses_per_area_are_recognised() {
        let known = known_columns();
        for (name, wanted) in [
            ("stiffness_per_area_N_per_m3", Some("stiffness_N_per_m")),
            ("unloading_stiffness_GPa_per_m", Some("unloading_stiffness_N_per_m")),
            ("unloading_stiffness_N_per_um_per_mm2", Some("unloading_stiffness_N_per_m")),
            ("unloading_stiffness_N_per_mm", None),
            ("area_per_area", None),
        ] {
            assert_eq!(per_area(name, &known), wanted, "{name}");
        }
    }
}
