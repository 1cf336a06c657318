//! The usual range of each number of a scene, and the unit that explains a number outside of it.

use asperity_core::{
    Code, Finding, Surface, hardness_of_vickers, plain_unit, short, units as known_units,
    vickers_of_rockwell_c,
};

/// The advice about an unusual number.
pub(super) const CHECK_UNIT: &str = "check the number and its unit";

/// Units that explain no number: instruments report none in them.
const RARE: [&str; 6] = ["bar", "cm", "kPa", "pm", "1/cm", "1/cm2"];

/// Numbers of a scene by their keys: the usual range, a typical value, and the SI unit.
type Usual = (&'static [&'static str], [f64; 2], f64, &'static str);

/// From elastomers to diamond; asperities from atomic corrugation to the stones of asphalt.
const USUAL: [Usual; 33] = [
    (&["youngs_modulus", "equivalent_modulus"], [1e6, 2e12], 1e11, "Pa"),
    (&["equivalent_shear_modulus"], [3e5, 1e12], 3e10, "Pa"),
    (&["hardness"], [1e5, 1.5e11], 3e9, "Pa"),
    (&["yield_strength"], [1e5, 5e10], 5e8, "Pa"),
    // S = 0.454 + 0.41 nu.
    (&["pressure_factor"], [0.2, 1.2], 0.6, ""),
    // From surfaces in a liquid to cold-welding metals.
    (&["work_of_adhesion"], [1e-3, 5.0], 0.05, "J/m2"),
    // From aerogels to diamond.
    (&["thermal_conductivity"], [0.01, 3000.0], 50.0, "W/(m K)"),
    // Of conductors, from cold copper to carbon and composites.
    (&["electrical_resistivity"], [1e-9, 1e-2], 1e-7, "ohm m"),
    // From the tip of an instrument to a large flange.
    (&["nominal_area"], [1e-16, 0.03], 1e-4, "m2"),
    // From cleaved mica to the texture of asphalt.
    (
        &["asperity_height_std", "surface_height_std", "sq", "ra", "rq", "rz"],
        [3e-11, 2e-3],
        1e-6,
        "m",
    ),
    (&["asperity_radius"], [2e-9, 0.015], 1e-4, "m"),
    (&["asperity_density"], [5e3, 1e16], 1e9, "1/m2"),
    (&["spd"], [1e6, 1e16], 1e9, "1/m2"),
    (&["spc"], [100.0, 5e8], 5e3, "1/m"),
    (&["m0"], [1e-21, 4e-6], 1e-12, "m2"),
    (&["m4"], [100.0, 1e17], 5e4, "1/m2"),
    (&["mean_slope", "rdq", "rms_gradient", "height_std_over_radius"], [0.0, 1.0], 0.1, ""),
    // Of profiles and of random surfaces, from atoms to waviness.
    (&["rsm"], [1e-10, 0.05], 1e-4, "m"),
    (&["wavelength"], [1e-10, 0.05], 5e-6, "m"),
    // From scans by atomic force to profiles of waviness.
    (&["lambda_c", "filter"], [1e-9, 0.08], 8e-4, "m"),
    (&["lambda_s", "smooth"], [1e-10, 0.01], 2.5e-6, "m"),
    (&["mean_plane_offset"], [-2e-3, 2e-3], 1e-6, "m"),
    // Of gases and liquids; the jump distance is at most as of air at 1e-4 bar.
    (&["gas_conductivity"], [1e-3, 100.0], 0.03, "W/(m K)"),
    (&["gas_parameter"], [0.0, 5e-3], 4e-7, "m"),
    // From tips of probes to nearly conforming bodies.
    // Of curved bodies, also as radius_x or body1_radius_x.
    (&["radius"], [1e-8, 5.0], 0.1, "m"),
    // Of seals, from instruments to long flanges.
    (&["width"], [1e-6, 1.0], 0.01, "m"),
    (&["length", "perimeter", "reference_length"], [1e-5, 10.0], 0.1, "m"),
    (&["upstream_pressure"], [100.0, 1e9], 1e6, "Pa"),
    // From hydrogen to thick oils and greases.
    (&["viscosity"], [5e-6, 10.0], 0.01, "Pa s"),
    (&["density"], [50.0, 2.5e4], 1e3, "kg/m^3"),
    (&["temperature"], [100.0, 1500.0], 293.0, "K"),
    (&["molar_mass"], [1e-3, 0.5], 0.03, "kg/mol"),
    (&["roughness_parameter"], Surface::USUAL_ASPERITY_ROUGHNESS, 0.04, ""),
];

/// The finding of a number outside its usual range, by its key in scene files; with the unit in
/// which it is nearest to a typical number, if one makes it usual. Such a number, and one ten times
/// outside the range, is implausible.
///
/// ```
/// let found = asperity_judge::unusual("sq", 1.1).unwrap().to_string();
/// assert_eq!(found, "sq is 1.1 m (usual: 3e-11 to 0.002): 1.1 looks like um; 1.1 um is 1.1e-6 m");
/// assert_eq!(asperity_judge::unusual("sq", 1.1e-6), None);
/// ```
#[must_use]
pub fn unusual(key: &'static str, value: f64) -> Option<Finding> {
    outside(key, value, entry(key)?.1)
}

fn entry(key: &str) -> Option<&'static Usual> {
    let key = if key.contains("radius_") { "radius" } else { key };
    USUAL.iter().find(|(keys, ..)| keys.contains(&key))
}

/// The same with another usual range.
#[must_use]
pub fn outside(key: &'static str, value: f64, usual: [f64; 2]) -> Option<Finding> {
    let (.., typical, si) = *entry(key)?;
    if within(value, usual) {
        return None;
    }
    let found = Finding::warning(Code::UnusualSize, key, value).usual(usual).unit(si);
    let off = |size: f64| (value * size / typical).ln().abs();
    let known = units(key, si, value).into_iter().filter(|(_, size)| within(value * size, usual));
    let found = match known.min_by(|one, other| off(one.1).total_cmp(&off(other.1))) {
        Some((unit, size)) => {
            let [given, meant] = [value, value * size].map(short);
            let hint = match unit {
                // Pure numbers are written without it.
                "%" => format!("{given} looks like %: write {meant}"),
                _ => format!("{given} looks like {unit}; {given} {unit} is {meant} {si}"),
            };
            found.likely_unit(hint).implausible(true)
        }
        None => found.implausible(value < 0.1 * usual[0] || value > 10.0 * usual[1]),
    };
    Some(found.advice(CHECK_UNIT))
}

/// The units of a number with their sizes in SI; those of hardnesses have scales of tests, of which
/// the size of 1 HRC depends on the number, and slopes have per cent.
fn units(key: &str, si: &str, value: f64) -> Vec<(&'static str, f64)> {
    let listed = known_units().iter().filter(|of| plain_unit(of.si) == plain_unit(si));
    // Inputs in these units are rare, but for pressures of fluids.
    let usual = |unit: &str| si == "Pa" && key.contains("pressure") || !RARE.contains(&unit);
    let units = listed.flat_map(|of| &of.decimal).filter(|(unit, _)| usual(unit));
    let mut units: Vec<_> = units.map(|(unit, power)| (*unit, 10f64.powi(*power))).collect();
    match key {
        "hardness" => {
            units.push(("HV", hardness_of_vickers(1.0)));
            let rockwell = vickers_of_rockwell_c(value).map(hardness_of_vickers);
            units.extend(rockwell.map(|pascals| ("HRC", pascals / value)));
        }
        "mean_slope" | "rdq" => units.push(("%", 0.01)),
        _ => {}
    }
    units
}

/// Whether a value is in a range, ends included.
pub(super) fn within(value: f64, [from, to]: [f64; 2]) -> bool {
    (from..=to).contains(&value)
}
