//! Names of columns with the units in which measurements are usually recorded.

use asperity_core::{plain_unit, units_of};

use crate::names::usual_name;

/// A column as its name is written, with its unit.
#[derive(Debug)]
pub(crate) struct Named<'k> {
    /// The column in its SI unit.
    pub(crate) column: &'k str,
    pub(crate) unit: &'static str,
    /// The unit in SI units.
    pub(crate) factor: f64,
}

/// A unit in a name as it is compared: N/um for `N_per_um`.
fn unit_in_name(unit: &str) -> String {
    let unit = unit.trim().trim_matches(['[', ']', '(', ')']).replace("percent", "%");
    let unit = unit.replace("per_cent", "%").replace("_per_", "/").replace(" per ", "/");
    plain_unit(&unit).replace(['(', ')'], "")
}

/// The unit of a column's name as it is compared, and what stands before it.
fn parts(column: &str) -> (&str, String) {
    // Of m and N_per_m, the longer one is the unit.
    let units = ["N", "Pa", "m", "m2", "N_per_m", "W_per_K", "W_per_m2_per_K", "S", "S_per_m2"];
    let ends = units.iter().filter_map(|si| {
        let quantity = column.strip_suffix(si)?.strip_suffix('_')?;
        Some((quantity, unit_in_name(si)))
    });
    ends.max_by_key(|(_, si)| si.len()).unwrap_or((column, String::new()))
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

/// The known column that `name` is with a unit: `load_N` for `load_kN`, `F [kN]` and `F/kN`.
pub(crate) fn with_unit<'k>(name: &str, known: &[&'k str]) -> Option<Named<'k>> {
    readings(name).into_iter().find_map(|(before, unit)| {
        let quantity = usual_name(before, true)?;
        known.iter().find_map(|column| {
            let (of, si) = parts(column);
            let is_share = unit == "%" && of.strip_suffix("_fraction") == Some(&*quantity);
            let units = units_of(&si).into_iter().filter(|_| of == quantity || is_share);
            let (unit, factor) = units.into_iter().find(|(known, _)| {
                // W/(m2 K) is W/m2/K; scenes have both.
                unit_in_name(known) == unit
            })?;
            Some(Named { column, unit, factor })
        })
    })
}

/// The known stiffness that `name` is over the nominal area: `unloading_stiffness_N_per_m` for
/// `unloading_stiffness_per_area_N_per_m3` and `unloading_stiffness_Pa_per_m`.
pub(crate) fn per_area<'k>(name: &str, known: &[&'k str]) -> Option<&'k str> {
    let quantity = |column: &'k str| Some((column, column.strip_suffix("_N_per_m")?));
    let begins = |(_, quantity): &(&str, &str)| name.starts_with(quantity);
    let stiffnesses = known.iter().filter_map(|column| quantity(column)).filter(begins);
    let (column, quantity) = stiffnesses.max_by_key(|(_, quantity)| quantity.len())?;
    let unit = name.strip_prefix(quantity)?;
    let is_pressure_per_length = unit.contains("Pa_per_") || unit.contains("Pa/");
    let areas = ["per_area", "per_m2", "per_mm2", "per_um2", "per_m3", "per_mm3", "/m2", "/m3"];
    (is_pressure_per_length || areas.iter().any(|area| unit.contains(area))).then_some(column)
}

#[cfg(test)]
mod tests {
    use asperity_core::Quantity;

    use super::*;

    #[test]
    fn every_unit_of_a_quantity_has_others() {
        // Logarithms have one unit.
        for quantity in Quantity::ALL.into_iter().filter(|q| !q.unit().starts_with("ln ")) {
            let unit = quantity.unit();
            assert!(!units_of(unit).is_empty(), "{quantity} {unit}");
            let column = quantity.column();
            let name = quantity.to_string().replace('-', "_");
            assert_eq!(parts(&column), (&*name, unit_in_name(unit)), "{quantity}");
        }
    }

    #[test]
    fn columns_with_units_are_recognised() {
        let columns = Quantity::ALL.map(Quantity::column);
        let known = ["load_N", "pressure_Pa", "separation_m"].into_iter();
        let known: Vec<&str> = known.chain(columns.iter().map(String::as_str)).collect();
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
            let found = with_unit(name, &known).map(|other| (other.column, other.factor));
            let near = found.filter(|found| (found.1 / wanted.1 - 1.0).abs() < 1e-12);
            assert!(near.is_some_and(|found| found.0 == wanted.0), "{name}: {found:?}");
        }
        for name in ["load", "load_stone", "a_b", "f", "[N]", "_", "comment"] {
            let found = with_unit(name, &known).map(|other| (other.column, other.factor));
            assert_eq!(found, None, "{name}");
        }
    }

    #[test]
    fn stiffnesses_per_area_are_recognised() {
        let known = ["stiffness_N_per_m", "unloading_stiffness_N_per_m", "area_m2"];
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
