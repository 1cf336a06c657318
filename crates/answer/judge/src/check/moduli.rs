//! Plausibility of moduli, hardnesses and other numbers of materials.

use super::Plausible;
use super::usual::unusual;
use asperity_core::{Body, Findings, Interface, MaterialNumber};

/// Numbers on which force and area depend; others change answers of their own only.
const OF_FORCE: [&str; 7] = [
    "youngs_modulus",
    "equivalent_modulus",
    "equivalent_shear_modulus",
    "hardness",
    "yield_strength",
    "pressure_factor",
    "work_of_adhesion",
];

impl Plausible for Body {
    fn findings(&self) -> Findings {
        of_numbers(self, Self::NUMBERS)
    }
}

impl Plausible for Interface {
    fn findings(&self) -> Findings {
        of_numbers(self, Self::NUMBERS)
    }
}

/// The unusual ones among the numbers of a material; a work of adhesion of 0 is none.
fn of_numbers<T>(of: &T, numbers: &[MaterialNumber<T>]) -> Findings {
    let found = numbers.iter().filter_map(|number| {
        let value = (number.get)(of).filter(|value| *value > 0.0)?;
        let found = unusual(number.name, value)?;
        let is_implausible = found.is_implausible() && OF_FORCE.contains(&number.name);
        Some(found.implausible(is_implausible))
    });
    found.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn materials_are_usual_and_other_units_are_implausible() {
        // PTFE and polyethylene, on a rigid body and alone.
        for (modulus, poisson, strength) in [(500e6, 0.46, 12e6), (1e9, 0.45, 20e6)] {
            for modulus in [modulus, modulus / (1.0 - poisson * poisson)] {
                let found = Body::yielding(modulus, poisson, strength).findings();
                assert!(found.is_empty(), "{found:?}");
            }
        }
        for (modulus, hardness, field) in [(210e9, 2.0, "hardness"), (210.0, 2e9, "youngs_modulus")]
        {
            let found = Body::new(modulus, 0.3, hardness).findings();
            let [one] = &found[..] else { panic!("{found:?}") };
            assert!(one.field == field && one.is_implausible(), "{one}");
        }
    }
}
