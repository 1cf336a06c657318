//! Units in which measurements are usually recorded.

/// A pound-force \[N\], exact: 0.45359237 kg times 9.80665 m/s².
const LBF: f64 = 4.448_221_615_260_5;
/// A pound-force on a square inch \[Pa\].
const PSI: f64 = LBF / (0.0254 * 0.0254);

/// Units with their size in the SI unit of a column.
pub(crate) const UNITS: [(&str, &[(&str, f64)]); 10] = [
    ("N", &[("kN", 1e3), ("MN", 1e6), ("mN", 1e-3), ("uN", 1e-6), ("lbf", LBF)]),
    (
        "Pa",
        &[("MPa", 1e6), ("kPa", 1e3), ("bar", 1e5), ("GPa", 1e9), ("psi", PSI), ("ksi", 1e3 * PSI)],
    ),
    ("m", &[("um", 1e-6), ("nm", 1e-9), ("mm", 1e-3)]),
    ("m2", &[("mm2", 1e-6), ("um2", 1e-12), ("cm2", 1e-4)]),
    (
        "N/m",
        &[
            ("N/um", 1e6),
            ("N/mm", 1e3),
            ("N/nm", 1e9),
            ("kN/mm", 1e6),
            ("MN/m", 1e6),
            ("GN/m", 1e9),
        ],
    ),
    ("W/K", &[("mW/K", 1e-3), ("kW/K", 1e3)]),
    ("W/m2/K", &[("kW/m2/K", 1e3), ("W/cm2/K", 1e4)]),
    ("S", &[("kS", 1e3), ("mS", 1e-3)]),
    ("S/m2", &[("S/mm2", 1e6), ("S/cm2", 1e4)]),
    ("", &[("%", 0.01)]),
];

/// A column in another unit than its own.
pub(crate) struct OtherUnit<'k> {
    /// The column in its SI unit.
    pub(crate) column: &'k str,
    pub(crate) unit: &'static str,
    pub(crate) si: &'static str,
    /// The unit in SI units.
    pub(crate) factor: f64,
}

/// The known column that `name` is in another unit: `load_N` for `load_kN`.
pub(crate) fn in_other_unit<'k>(name: &str, known: &[&'k str]) -> Option<OtherUnit<'k>> {
    let written = |unit: &str| unit.replace('/', "_per_");
    // Pressure [MPa] is pressure_MPa.
    let name = match name.split_once(['[', '(']) {
        Some((name, unit)) => {
            let unit = written(unit.trim_end_matches([']', ')']));
            format!("{}_{unit}", name.trim().to_lowercase().replace(' ', "_"))
        }
        None => written(name),
    };
    known.iter().find_map(|column| {
        // Of m and N_per_m, the longer one is the unit.
        let ends = UNITS
            .iter()
            .filter(|(si, _)| !si.is_empty() && column.ends_with(&format!("_{}", written(si))));
        let (si, units) = ends.max_by_key(|(si, _)| si.len())?;
        let given = name.strip_prefix(column.strip_suffix(&*written(si))?)?;
        let (unit, factor) = *units.iter().find(|(unit, _)| written(unit) == given)?;
        Some(OtherUnit { column, unit, si, factor })
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
            assert!(UNITS.iter().any(|(si, _)| *si == unit), "{quantity} {unit}");
        }
    }

    #[test]
    fn columns_in_other_units_are_recognised() {
        let [thermal, electrical, per_area] = [
            Quantity::ThermalConductancePerArea,
            Quantity::ElectricalConductance,
            Quantity::ElectricalConductancePerArea,
        ]
        .map(Quantity::column);
        let known = ["load_N", "area_m2", "tangent_N_per_m", "separation_m"];
        let known = [&known[..], &[&*thermal, &*electrical, &*per_area]].concat();
        for (name, wanted) in [
            ("load_kN", Some(("load_N", "kN", 1e3))),
            ("area_mm2", Some(("area_m2", "mm2", 1e-6))),
            ("tangent_N_per_um", Some(("tangent_N_per_m", "N/um", 1e6))),
            ("separation_um", Some(("separation_m", "um", 1e-6))),
            ("Load [kN]", Some(("load_N", "kN", 1e3))),
            ("tangent (N/um)", Some(("tangent_N_per_m", "N/um", 1e6))),
            ("load [N]", None),
            ("load_N", None),
            ("load", None),
            ("load_lbf", Some(("load_N", "lbf", LBF))),
            ("load_stone", None),
            ("tangent_MN_per_m", Some(("tangent_N_per_m", "MN/m", 1e6))),
            ("thermal_conductance_per_area_kW_per_m2_per_K", Some((&*thermal, "kW/m2/K", 1e3))),
            ("electrical_conductance_kS", Some((&*electrical, "kS", 1e3))),
            ("electrical_conductance_per_area_S_per_mm2", Some((&*per_area, "S/mm2", 1e6))),
        ] {
            let found = in_other_unit(name, &known);
            let found = found.map(|other| (other.column, other.unit, other.factor));
            assert_eq!(found, wanted, "{name}");
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
