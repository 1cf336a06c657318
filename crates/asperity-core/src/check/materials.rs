//! Plausibility of moduli, hardnesses and other material numbers.

use super::units::{CONDUCTIVITIES, ENERGIES, PRESSURES, RESISTIVITIES, Unit, likely, likely_unit};
use crate::diagnostic::short;
use crate::{Body, Diagnostic, Diagnostics, Interface, Severity, hardness_of_vickers};

/// E from soft gels to diamond \[Pa\].
const MODULUS: [f64; 2] = [3e4, 1.3e12];
/// H from soft plastics to diamond \[Pa\].
const HARDNESS: [f64; 2] = [1e5, 1.5e11];
/// H/E: from indium and lead to ceramics and hard plastics.
const RATIO: [f64; 2] = [3e-4, 0.3];
/// Modulus \[Pa\] from which a metal is stiffer than tin, and
const STIFF: f64 = 6e10;
/// the least H/E of such a body: the softest annealed metals (copper, gold, aluminium) have 1/300
/// to 1/500, indium and tin 1/1000 below that modulus. \[recalled\]
const SOFTEST: f64 = 1.5e-3;
/// H/E of a stiff material above which the hardness is probably a modulus.
const NO_HARDNESS: f64 = 2.0 * RATIO[1];
/// Modulus \[Pa\] below which materials do not yield and the hardness may be any number near E.
const RUBBER: f64 = 1e8;
/// Modulus \[Pa\] below which a material is a polymer or softer.
const PLASTIC: f64 = 3e9;
/// Smallest H/E of polymers.
const PLASTIC_RATIO: f64 = 0.02;
/// G/E of two bodies; 0.17 to 0.25, (1-ν)/(2(2-ν)), for equal materials.
const SHEAR_RATIO: [f64; 2] = [0.08, 0.5];
/// H/S_y.
const YIELD_RATIO: [f64; 2] = [1.5, 6.0];
/// w_a \[J/m²\], from surfaces in a liquid to cold-welding metals.
const ADHESION: [f64; 2] = [1e-3, 5.0];
/// k \[W/(m K)\], from aerogels to diamond.
const CONDUCTIVITY: [f64; 2] = [0.01, 3000.0];
/// ρ \[Ω m\] of conductors, from cold copper to carbon and composites.
const RESISTIVITY: [f64; 2] = [1e-9, 1e-2];
/// Vickers hardnesses, from lead to sintered carbides.
const VICKERS: [f64; 2] = [4.0, 3000.0];
/// The greatest H/E of what is tested by Vickers: glass has 1/12. \[recalled\]
const HARDEST: f64 = 0.1;
/// S = 0.454 + 0.41 ν.
const PRESSURE_FACTOR: [f64; 2] = [0.2, 1.2];

/// Numbers of one material or of an interface, with the name of the modulus.
struct Material {
    modulus: (&'static str, f64),
    hardness: Option<f64>,
    yield_strength: Option<f64>,
}

impl Body {
    /// Findings of numbers outside the range of any material.
    #[must_use]
    pub fn findings(&self) -> Diagnostics {
        let modulus = ("youngs_modulus", self.youngs_modulus);
        let &Self { hardness, yield_strength, .. } = self;
        let mut found = Material { modulus, hardness, yield_strength }.findings();
        found.extend(conducting(self.thermal_conductivity, self.electrical_resistivity));
        found
    }
}

impl Interface {
    /// Findings of numbers outside the range of any two materials.
    #[must_use]
    pub fn findings(&self) -> Diagnostics {
        let modulus = ("equivalent_modulus", self.equivalent_modulus);
        let &Self { hardness, yield_strength, .. } = self;
        let mut found = Material { modulus, hardness, yield_strength }.findings();
        if let Some(shear) = self.equivalent_shear_modulus {
            let usual = SHEAR_RATIO.map(|ratio| ratio * self.equivalent_modulus);
            // A finding about the modulus already explains the ratio.
            if found.is_empty() && !within(shear, usual) {
                let share = short(shear / self.equivalent_modulus);
                let meaning = format!(
                    "{share} of the equivalent modulus, where (1 - nu)/(2 (2 - nu)), about 0.2, is usual"
                );
                let unit = likely_unit(shear, PRESSURES, "Pa", |g| within(g, usual));
                let found_here = unusual("equivalent_shear_modulus", shear, usual).unit("Pa");
                found.push(with_unit(found_here.advice(meaning), unit));
            }
        }
        if let Some(work) = self.work_of_adhesion
            && work > 0.0
            && !within(work, ADHESION)
        {
            let unit = likely_unit(work, ENERGIES, "J/m2", |w| within(w, ADHESION));
            let found_here = unusual("work_of_adhesion", work, ADHESION).unit("J/m2");
            let found_here = found_here.advice("clean surfaces in air have about 0.05");
            found.push(with_unit(found_here, unit));
        }
        if let Some(factor) = self.pressure_factor
            && !within(factor, PRESSURE_FACTOR)
        {
            let advice = "leave it out for 0.454 + 0.41 nu";
            found.push(unusual("pressure_factor", factor, PRESSURE_FACTOR).advice(advice));
        }
        found.extend(conducting(self.thermal_conductivity, self.electrical_resistivity));
        found
    }
}

/// Findings of conductivity and resistivity: warnings at most, as no force depends on them.
fn conducting(conductivity: Option<f64>, resistivity: Option<f64>) -> Vec<Diagnostic> {
    let check = |field, value: f64, usual, units: &[Unit], si| {
        let unit = likely_unit(value, units, si, |x| within(x, usual));
        let found = Diagnostic::warning("unusual-size", field, value).usual(usual).unit(si);
        (!within(value, usual)).then(|| with_unit(found.advice(CHECK_UNIT), unit))
    };
    let thermal = conductivity
        .and_then(|k| check("thermal_conductivity", k, CONDUCTIVITY, CONDUCTIVITIES, "W/(m K)"));
    let electrical = resistivity
        .and_then(|rho| check("electrical_resistivity", rho, RESISTIVITY, RESISTIVITIES, "ohm m"));
    thermal.into_iter().chain(electrical).collect()
}

impl Material {
    fn findings(&self) -> Diagnostics {
        let mut found: Diagnostics = self.sizes().into_iter().collect();
        // A finding about the hardness already explains the ratio.
        if let (Some(h), Some(y)) = (self.hardness, self.yield_strength)
            && found.is_empty()
            && !within(h / y, YIELD_RATIO)
        {
            let usual = [h / YIELD_RATIO[1], h / YIELD_RATIO[0]];
            let advice = format!("{} of the hardness, where 1/2.8 is usual", short(y / h));
            found.push(unusual("yield_strength", y, usual).unit("Pa").advice(advice));
        }
        found
    }

    /// A warning for a hardness in Pa below that of any metal as stiff.
    fn too_soft(&self) -> Option<Diagnostic> {
        let (_, modulus) = self.modulus;
        let hardness = self.hardness.filter(|h| modulus >= STIFF && *h < SOFTEST * modulus)?;
        let usual = [SOFTEST, RATIO[1]].map(|ratio| ratio * modulus);
        let advice = format!(
            "hardness over modulus is {}, where the softest metals have {}; {CHECK_UNIT}",
            short(hardness / modulus),
            short(1.0 / 500.0)
        );
        let found = Diagnostic::warning("unusual-size", "hardness", hardness);
        Some(found.usual(usual).unit("Pa").advice(advice))
    }

    /// The modulus \[Pa\], in the unit in which it is plausible.
    fn modulus_meant(&self) -> f64 {
        let (_, modulus) = self.modulus;
        let unit = meant(modulus, self.hardness.or(self.yield_strength)).and_then(|(e, _)| e);
        unit.map_or(modulus, |(_, factor)| factor * modulus)
    }

    /// Findings of modulus and hardness, each by itself and in proportion to the other.
    fn sizes(&self) -> Vec<Diagnostic> {
        let (modulus_field, modulus) = self.modulus;
        let (strength_field, strength) = match (self.hardness, self.yield_strength) {
            (Some(h), _) => ("hardness", Some(h)),
            (None, yields) => ("yield_strength", yields),
        };
        if plausible(modulus, strength) {
            return self.too_soft().into_iter().collect();
        }
        let ratio = strength.unwrap_or(0.0) / modulus;
        let found = |field, value: f64, usual: [f64; 2], unit: Option<Unit>| {
            let of_modulus = field == modulus_field;
            // The usual range is that of the material with the likely unit.
            let meant = unit.filter(|_| of_modulus).map_or(1.0, |(_, factor)| factor);
            let by_ratio = ratios(meant * modulus);
            let (usual, meaning) = match within(value, usual) {
                false => (usual, format!("no material has such a value; {CHECK_UNIT}")),
                true => {
                    let usual = match of_modulus {
                        true => [by_ratio[1], by_ratio[0]].map(|r| ratio * modulus / r),
                        false => by_ratio.map(|r| r * modulus),
                    };
                    let [least, most] = by_ratio.map(short);
                    let meaning = format!(
                        "{strength_field} over modulus is {}, where {least} to {most} is usual",
                        short(ratio)
                    );
                    (usual, meaning)
                }
            };
            let stiff = !of_modulus && modulus >= PLASTIC && ratio > NO_HARDNESS;
            match unit {
                Some(unit) => unusual(field, value, usual)
                    .advice(format!("{meaning}; {CHECK_UNIT}"))
                    .likely_unit(match field {
                        "hardness" => likely_hardness(value, unit, self.modulus_meant()),
                        _ => likely(value, unit, "Pa"),
                    }),
                None if stiff => {
                    let usual = by_ratio.map(|r| r * modulus);
                    let advice = format!("{} times the modulus looks like a modulus", short(ratio));
                    Diagnostic::error("unusual-size", field, value).usual(usual).advice(advice)
                }
                None => unusual(field, value, usual).advice(meaning),
            }
            .unit("Pa")
        };
        let of_modulus = |unit| found(modulus_field, modulus, MODULUS, unit);
        let of_strength = |unit| strength.map(|h| found(strength_field, h, HARDNESS, unit));
        match meant(modulus, strength) {
            Some((e, h)) => {
                let e = e.map(|unit| of_modulus(Some(unit)));
                e.into_iter().chain(h.and_then(|unit| of_strength(Some(unit)))).collect()
            }
            None => {
                let e = (!within(modulus, MODULUS)).then(|| of_modulus(None));
                let odd = e.is_none() || strength.is_some_and(|h| !within(h, HARDNESS));
                e.into_iter().chain(if odd { of_strength(None) } else { None }).collect()
            }
        }
    }
}

/// "200 looks like HV or MPa; 200 HV is 2.115e9 Pa, 200 MPa is 2e8 Pa", where a number of that
/// size is a Vickers hardness as well.
fn likely_hardness(value: f64, unit: Unit, modulus: f64) -> String {
    let vickers = hardness_of_vickers(value);
    let is_vickers = within(value, VICKERS)
        && modulus >= PLASTIC
        && within(vickers / modulus, [SOFTEST, HARDEST]);
    let (name, factor) = unit;
    let [given, meant, vickers] = [value, factor * value, vickers].map(short);
    match is_vickers {
        true => format!(
            "{given} looks like HV or {name}; {given} HV is {vickers} Pa, {given} {name} is {meant} Pa"
        ),
        false => likely(value, unit, "Pa"),
    }
}

/// Units in which modulus and strength are plausible, tried in order: one of them in another unit
/// than Pa, both in the same unit, each in its own unit.
fn meant(modulus: f64, strength: Option<f64>) -> Option<(Option<Unit>, Option<Unit>)> {
    let units = || PRESSURES.iter().map(|unit| Some(*unit));
    let alone = units().map(|u| (u, None)).chain(units().map(|u| (None, u)));
    let both = units().map(|u| (u, u));
    let any = units().flat_map(|u| units().map(move |v| (u, v)));
    let times = |value: f64, unit: Option<Unit>| unit.map_or(value, |(_, factor)| value * factor);
    alone
        .chain(both)
        .chain(any)
        .find(|(e, h)| plausible(times(modulus, *e), strength.map(|value| times(value, *h))))
}

/// Whether a material may have this modulus and hardness.
fn plausible(modulus: f64, strength: Option<f64>) -> bool {
    within(modulus, MODULUS)
        && strength.is_none_or(|h| within(h, HARDNESS) && within(h / modulus, ratios(modulus)))
}

/// H/E of materials with this modulus.
fn ratios(modulus: f64) -> [f64; 2] {
    match modulus {
        // The hardness of elastomers is a placeholder near E.
        e if e < RUBBER => [PLASTIC_RATIO, 10.0 * RATIO[1]],
        e if e < PLASTIC => [PLASTIC_RATIO, RATIO[1]],
        _ => RATIO,
    }
}

pub(crate) fn within(value: f64, [from, to]: [f64; 2]) -> bool {
    (from..=to).contains(&value)
}

/// An error ten times outside the usual range, otherwise a warning.
pub(crate) fn severity(value: f64, [from, to]: [f64; 2]) -> Severity {
    if value < 0.1 * from || value > 10.0 * to { Severity::Error } else { Severity::Warning }
}

/// What to do where no unit is likely.
const CHECK_UNIT: &str = "check the number and its unit";

/// A finding with the likely unit, if there is one.
fn with_unit(found: Diagnostic, unit: Option<String>) -> Diagnostic {
    match unit {
        Some(unit) => found.likely_unit(unit),
        None => found,
    }
}

/// A finding for a number outside the usual range of materials.
fn unusual(field: &'static str, value: f64, usual: [f64; 2]) -> Diagnostic {
    Diagnostic::warning("unusual-size", field, value).usual(usual).severity(severity(value, usual))
}
