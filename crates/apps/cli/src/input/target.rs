//! A wanted value of a quantity.

use asperity::Quantity;

use crate::input::numbers::of_unit;

/// A wanted value: the column of the quantity, and the value in its unit.
pub fn target(text: &str) -> Result<(String, f64), String> {
    let example = "write <quantity>=<value> with a decimal point, for example area_fraction=0.4%";
    let (name, value) = text.split_once('=').ok_or(example)?;
    let names = Quantity::ALL.into_iter().find(|quantity| quantity.column() == name.trim());
    let quantity = names.map_or_else(|| name.parse::<Quantity>(), Ok);
    let quantity = quantity.map_err(|error| error.to_string())?;
    let number = match (value.trim().strip_suffix('%'), quantity.unit()) {
        (Some(percent), "") => of_unit(percent, "").map(|percent| percent / 100.0),
        (_, "m2") => of_unit(value, "m^2"),
        (_, unit) => of_unit(value, unit),
    };
    Ok((quantity.column(), number?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn targets_have_names_and_units_of_quantities() {
        let found = [
            ("area_fraction=2%", "area_fraction", 0.02),
            ("area=1 mm2", "area_m2", 1e-6),
            ("unloading-stiffness=2e9", "unloading_stiffness_N_per_m", 2e9),
            ("mean_pressure_Pa=1GPa", "mean_pressure_Pa", 1e9),
            ("tangent=1 N/nm", "tangent_N_per_m", 1e9),
            ("electrical-conductance=1kS", "electrical_conductance_S", 1e3),
            ("thermal-conductance=2 kW/K", "thermal_conductance_W_per_K", 2e3),
            (
                "thermal-conductance-per-area=5 kW/(m2 K)",
                "thermal_conductance_per_area_W_per_m2_per_K",
                5e3,
            ),
        ];
        for (text, name, value) in found {
            assert_eq!(target(text), Ok((name.to_string(), value)), "{text}");
        }
        assert_eq!(target("ln-force=-2").map(|(_, value)| value), Ok(-2.0));
        for bad in ["area", "aera=1e-6", "area=big", "area=1 N", "area_fraction=%", "area=nan"] {
            assert!(target(bad).is_err(), "{bad}");
        }
    }
}
