//! Plausibility of moduli, hardnesses and other numbers of materials.

use super::Plausible;
use super::usual::{CHECK_UNIT, outside, unusual, within};
use asperity_core::{
    Body, Finding, Findings, HARDNESS_OVER_YIELD, Interface, MaterialNumber, short,
};

/// H/E: from indium and lead to ceramics and hard plastics.
const RATIO: [f64; 2] = [3e-4, 0.3];
/// Modulus \[Pa\] above which no metal is as soft as indium and tin.
const STIFF: f64 = 6e10;
/// Least H/E above that modulus: the softest annealed metals (copper, gold, aluminium) have 1/300
/// to 1/500. \[recalled\]
const SOFTEST: f64 = 1.5e-3;
/// Modulus \[Pa\] below which materials do not yield and the hardness may be any number near E.
const RUBBER: f64 = 1e8;
/// Modulus \[Pa\] below which a material is a polymer or softer.
const PLASTIC: f64 = 3e9;
/// Hardness \[Pa\] that no polymer has.
const METAL: f64 = 5e8;
/// Smallest H/E of polymers.
const PLASTIC_RATIO: f64 = 0.02;
/// H/S_y: of nine of ten metals 3.3 to 7.8, of soft aluminium, which hardens, 10.6.
const YIELD_RATIO: [f64; 2] = [1.5, 11.0];
/// G/E of two bodies; 0.17 to 0.25, (1-ν)/(2(2-ν)), for equal materials.
const SHEAR_RATIO: [f64; 2] = [0.08, 0.5];
/// Numbers on which no force depends.
const OF_NO_FORCE: [&str; 2] = ["thermal_conductivity", "electrical_resistivity"];

impl Plausible for Body {
    fn findings(&self) -> Findings {
        let modulus = ("youngs_modulus", self.youngs_modulus);
        let mut found = elastic_plastic(modulus, self.hardness, self.yield_strength);
        found.extend(of_no_force(self, Self::NUMBERS));
        found
    }
}

impl Plausible for Interface {
    fn findings(&self) -> Findings {
        let modulus = self.equivalent_modulus;
        let named = ("equivalent_modulus", modulus);
        let mut found = elastic_plastic(named, self.hardness, self.yield_strength);
        // A finding about the modulus already explains the ratio.
        if let Some(shear) = self.equivalent_shear_modulus.filter(|_| found.is_empty()) {
            let share = short(shear / modulus);
            let advice = format!(
                "{share} of the equivalent modulus, where (1 - nu)/(2 (2 - nu)), about 0.2, is usual"
            );
            let odd = outside("equivalent_shear_modulus", shear, SHEAR_RATIO.map(|r| r * modulus));
            found.extend(odd.map(|found| found.advice(advice)));
        }
        let work = self.work_of_adhesion.filter(|work| *work > 0.0);
        let work = work.and_then(|work| unusual("work_of_adhesion", work));
        found.extend(work.map(|found| found.advice("clean surfaces in air have about 0.05")));
        let factor = self.pressure_factor.and_then(|factor| unusual("pressure_factor", factor));
        found.extend(factor.map(|found| found.advice("leave it out for 0.454 + 0.41 nu")));
        found.extend(of_no_force(self, Self::NUMBERS));
        found
    }
}

/// Findings of the numbers of a body or an interface that are judged nowhere else: no force depends
/// on them.
fn of_no_force<T>(of: &T, numbers: &[MaterialNumber<T>]) -> Findings {
    let others = numbers.iter().filter(|number| OF_NO_FORCE.contains(&number.name));
    let found = others.filter_map(|number| unusual(number.name, (number.get)(of)?));
    found.map(|found| found.implausible(false)).collect()
}

/// Findings of a modulus, by its name, and of a hardness or a yield strength, alone and beside each
/// other.
fn elastic_plastic(
    (field, modulus): (&'static str, f64),
    hardness: Option<f64>,
    yield_strength: Option<f64>,
) -> Findings {
    let named = hardness.map(|h| ("hardness", h));
    let strength = named.or(yield_strength.map(|y| ("yield_strength", y)));
    // A modulus in place of the hardness.
    let is_modulus = |value: f64| modulus >= RUBBER && value > modulus;
    let of_strength = strength.and_then(|(key, value)| unusual(key, value));
    let of_strength =
        of_strength.map(|f| f.clone().implausible(f.is_implausible() || is_modulus(f.value)));
    let found: Findings = unusual(field, modulus).into_iter().chain(of_strength).collect();
    let Some((key, value)) = strength.filter(|_| found.is_empty()) else { return found };
    let is_hardness = key == "hardness";
    let least = if is_hardness { METAL } else { METAL / HARDNESS_OVER_YIELD };
    // A strength that no polymer has shows a modulus that no metal has.
    let is_metal = value >= least && modulus < PLASTIC;
    let usual = ratios(if is_metal { STIFF } else { modulus }, is_hardness);
    if !within(value / modulus, usual) {
        let advice = format!(
            "{key} over modulus is {}, where {} to {} is usual; {CHECK_UNIT}",
            short(value / modulus),
            short(usual[0]),
            short(usual[1])
        );
        // No unit is likely: the number alone is usual.
        let odd = match is_metal {
            true => outside(field, modulus, [value / usual[1], value / usual[0]]),
            false => outside(key, value, usual.map(|ratio| ratio * modulus)),
        };
        let odd = odd.and_then(Finding::with_stated_unit).map(|found| {
            let is_odd = found.excess() > 10.0 || is_modulus(value);
            found.advice(advice).implausible(is_odd)
        });
        return odd.into_iter().collect();
    }
    let Some((h, y)) = hardness.zip(yield_strength) else { return found };
    let [most, least] = YIELD_RATIO.map(|ratio| h / ratio);
    let advice = format!("{} of the hardness, where 1/7.8 to 1/2.8 is usual", short(y / h));
    let odd = outside("yield_strength", y, [least, most]);
    odd.map(|found| found.advice(advice)).into_iter().collect()
}

/// Strength over modulus of materials with this modulus.
fn ratios(modulus: f64, is_hardness: bool) -> [f64; 2] {
    let [least, most] = match modulus {
        // The hardness of elastomers is a placeholder near E.
        e if e < RUBBER => [PLASTIC_RATIO, 10.0 * RATIO[1]],
        e if e < PLASTIC => [PLASTIC_RATIO, RATIO[1]],
        e if e >= STIFF && is_hardness => [SOFTEST, RATIO[1]],
        _ => RATIO,
    };
    [if is_hardness { least } else { least / HARDNESS_OVER_YIELD }, most]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn soft_polymers_are_usual_and_odd_ratios_are_warnings() {
        // PTFE and polyethylene, on a rigid body and alone.
        for (modulus, poisson, strength) in [(500e6, 0.46, 12e6), (1e9, 0.45, 20e6)] {
            for modulus in [modulus, modulus / (1.0 - poisson * poisson)] {
                let found = Body::yielding(modulus, poisson, strength).findings();
                assert!(found.is_empty(), "{found:?}");
            }
        }
        for (modulus, hardness, is_implausible) in
            [(6e8, 8e6, false), (210e9, 2e8, false), (50e9, 1.2e7, false), (70e9, 1.2e6, true)]
        {
            let found = Body::new(modulus, 0.4, hardness).findings();
            let [one] = &found[..] else { panic!("{found:?}") };
            assert_eq!((&*one.field, one.is_implausible()), ("hardness", is_implausible), "{one}");
        }
        // No polymer is so hard, and no metal so soft.
        for (modulus, hardness) in [(210e6, 2e9), (70e6, 1e9), (2e9, 1e9)] {
            let found = Body::new(modulus, 0.3, hardness).findings();
            assert_eq!((found.len(), &*found[0].field), (1, "youngs_modulus"), "{found:?}");
        }
    }
}
