//! Likely units of numbers outside their usual range.

use crate::finding::short;

/// A unit that users may give in place of SI: name, and value in SI units. Lists start with the
/// likeliest.
pub(crate) type Unit = (&'static str, f64);

/// Units of moduli and strengths \[Pa\].
pub(crate) const PRESSURES: &[Unit] = &[("GPa", 1e9), ("MPa", 1e6), ("kPa", 1e3)];
/// Units of works of adhesion \[J/m²\].
pub(crate) const ENERGIES: &[Unit] = &[("mJ/m2", 1e-3)];
/// Units of thermal conductivities \[W/(m K)\].
pub(crate) const CONDUCTIVITIES: &[Unit] = &[("mW/(m K)", 1e-3), ("W/(mm K)", 1e3)];
/// Units of electrical resistivities \[Ω m\].
pub(crate) const RESISTIVITIES: &[Unit] =
    &[("uohm cm", 1e-8), ("nohm m", 1e-9), ("ohm mm2/m", 1e-6)];
/// Units of lengths \[m\].
pub(crate) const LENGTHS: &[Unit] = &[("um", 1e-6), ("mm", 1e-3), ("nm", 1e-9)];
/// Units of asperity densities \[1/m²\].
pub(crate) const DENSITIES: &[Unit] =
    &[("1/mm2", 1e6), ("1/um2", 1e12), ("1/cm2", 1e4), ("1/nm2", 1e18)];
/// Units of areas \[m²\].
pub(crate) const AREAS: &[Unit] = &[("mm2", 1e-6), ("cm2", 1e-4), ("um2", 1e-12)];

/// Advice with the first unit in which a value is plausible.
pub(crate) fn likely_unit(
    value: f64,
    units: &[Unit],
    si: &str,
    makes_sense: impl Fn(f64) -> bool,
) -> Option<String> {
    units
        .iter()
        .find(|(_, factor)| makes_sense(value * factor))
        .map(|unit| likely(value, &[*unit], si))
}

/// "116 looks like GPa; 116 GPa is 1.16e11 Pa", or "200 looks like HV or MPa; 200 HV is 2.115e9 Pa,
/// 200 MPa is 2e8 Pa".
pub(crate) fn likely(value: f64, units: &[Unit], si: &str) -> String {
    let given = short(value);
    let names: Vec<&str> = units.iter().map(|(name, _)| *name).collect();
    let is = |(name, factor): &Unit| format!("{given} {name} is {} {si}", short(value * factor));
    let each: Vec<String> = units.iter().map(is).collect();
    format!("{given} looks like {}; {}", names.join(" or "), each.join(", "))
}
