//! Units of scene files and of measurements.

/// An SI unit, an example, and the units with their powers of ten.
pub type Units = (&'static str, &'static str, &'static [(&'static str, i32)]);

/// The SI unit as in the template, an example, and the units with their powers of ten. In units,
/// spaces, raised dots, * and ^ are ignored; µ is u, ² is 2, and Ω is ohm.
pub const UNITS: [Units; 19] = [
    (
        "Pa",
        "5 MPa",
        &[("GPa", 9), ("MPa", 6), ("kPa", 3), ("Pa", 0), ("bar", 5), ("N/mm2", 6), ("N/m2", 0)],
    ),
    ("Pa s", "1 mPa s", &[("Pas", 0), ("mPas", -3), ("uPas", -6), ("cP", -3)]),
    ("kg/m^3", "1000 kg/m3", &[("kg/m3", 0), ("g/cm3", 3), ("kg/l", 3)]),
    ("kg/mol", "4 g/mol", &[("kg/mol", 0), ("g/mol", -3)]),
    ("K", "293 K", &[("K", 0)]),
    ("m", "0.2 mm", &[("m", 0), ("cm", -2), ("mm", -3), ("um", -6), ("nm", -9), ("pm", -12)]),
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
/// A pound-force \[N\], exact: 0.45359237 kg times 9.80665 m/s².
const LBF: f64 = 4.448_221_615_260_5;
/// A thousand pounds-force on a square inch \[MPa\].
const KSI: f64 = 1e-3 * LBF / (0.0254 * 0.0254);

/// Units that are not decimal, or rare: their SI unit, their name, and their size in one of
/// [`UNITS`].
pub const OTHER_UNITS: [(&str, &str, f64, &str); 23] = [
    ("Pa", "kN/mm2", 1.0, "GPa"),
    ("Pa", "kN/cm2", 10.0, "MPa"),
    ("Pa", "kN/m2", 1.0, "kPa"),
    ("Pa", "N/cm2", 10.0, "kPa"),
    ("Pa", "kgf/mm2", 9.80665, "MPa"),
    ("Pa", "kg/mm2", 9.80665, "MPa"),
    ("Pa", "kgf/cm2", 98.0665, "kPa"),
    ("Pa", "kg/cm2", 98.0665, "kPa"),
    ("Pa", "atm", 101.325, "kPa"),
    ("Pa", "Msi", KSI, "GPa"),
    ("Pa", "Mpsi", KSI, "GPa"),
    ("Pa", "ksi", KSI, "MPa"),
    ("Pa", "psi", KSI, "kPa"),
    ("N", "kgf", 9.80665, "N"),
    ("N", "lbf", LBF, "N"),
    ("m", "uin", 25.4, "nm"),
    ("m", "in", 25.4, "mm"),
    ("m", "micron", 1.0, "um"),
    ("m", "microns", 1.0, "um"),
    ("m", "angstrom", 100.0, "pm"),
    ("m", "\u{c5}", 0.1, "nm"),
    ("m", "\u{212b}", 0.1, "nm"),
    ("m^2", "in2", 645.16, "mm2"),
];

/// A unit without ignored characters, in ASCII: `um` for `µm`, `mm2` for `mm^2` and `mm²`.
#[must_use]
pub fn plain_unit(unit: &str) -> String {
    let left_out = |c: char| c.is_whitespace() || "^*\u{b7}".contains(c);
    let text: String = unit.chars().filter(|c| !left_out(*c)).collect();
    let text = text.replace(['\u{b5}', '\u{3bc}'], "u");
    let text = text.replace('\u{b2}', "2").replace('\u{b3}', "3");
    text.replace('\u{207b}', "-").replace(['\u{3a9}', '\u{2126}'], "ohm")
}

/// The units of a quantity with this SI unit and their sizes in it, those of scene files first;
/// shares have per cent.
#[must_use]
pub fn units_of(si: &str) -> Vec<(&'static str, f64)> {
    if si.is_empty() {
        return vec![("%", 0.01)];
    }
    let si = plain_unit(si);
    let Some((known, _, units)) = UNITS.iter().find(|(known, ..)| plain_unit(known) == si) else {
        return vec![];
    };
    let power = |unit: &str| units.iter().find(|(name, _)| *name == unit).map(|(_, power)| *power);
    let decimal = units.iter().map(|(name, power)| (*name, 10f64.powi(*power)));
    let others = OTHER_UNITS.iter().filter(|(of, ..)| of == known);
    let other = |(_, name, size, unit): &(&str, &'static str, f64, &str)| {
        Some((*name, size * 10f64.powi(power(unit)?)))
    };
    decimal.chain(others.filter_map(other)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_other_unit_has_a_size() {
        for (si, name, ..) in OTHER_UNITS {
            assert!(units_of(si).iter().any(|(unit, _)| *unit == name), "{name}");
        }
        let psi = units_of("Pa").into_iter().find(|(unit, _)| *unit == "psi");
        // The usual rounded value.
        assert!(psi.is_some_and(|(_, size)| (size / 6_894.757 - 1.0).abs() < 1e-7), "{psi:?}");
    }
}
