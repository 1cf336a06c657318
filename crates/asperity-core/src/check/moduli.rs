//! Plausibility of a modulus beside a hardness or a yield strength.

use super::likely_unit::{CHECK_UNIT, Input, PRESSURES, Unit, within};
use crate::finding::short;
use crate::{Finding, Findings, HARDNESS_OVER_YIELD, hardness_of_vickers};

/// E from soft gels to diamond \[Pa\].
const MODULUS: [f64; 2] = [3e4, 1.3e12];
/// H from soft plastics to diamond \[Pa\].
const HARDNESS: [f64; 2] = [1e5, 1.5e11];
/// H/E: from indium and lead to ceramics and hard plastics.
const RATIO: [f64; 2] = [3e-4, 0.3];
/// Modulus \[Pa\] above which no metal is as soft as indium and tin.
const STIFF: f64 = 6e10;
/// Least H/E above that modulus: the softest annealed metals (copper, gold, aluminium) have 1/300
/// to 1/500. \[recalled\]
const SOFTEST: f64 = 1.5e-3;
/// H/E of a stiff material above which the hardness is probably a modulus.
const NO_HARDNESS: f64 = 2.0 * RATIO[1];
/// Modulus \[Pa\] below which materials do not yield and the hardness may be any number near E.
const RUBBER: f64 = 1e8;
/// Modulus \[Pa\] below which a material is a polymer or softer.
const PLASTIC: f64 = 3e9;
/// Smallest H/E of polymers.
const PLASTIC_RATIO: f64 = 0.02;
/// H/S_y.
const YIELD_RATIO: [f64; 2] = [1.5, 6.0];
/// Vickers hardnesses, from indium to sintered carbides.
const VICKERS: [f64; 2] = [1.0, 3000.0];
/// The greatest H/E of what is tested by Vickers: glass has 1/12. \[recalled\]
const HARDEST: f64 = 0.1;
/// The greatest H/E of metals: hardened steels and sintered carbides have 1/27. \[recalled\]
const HARDEST_METAL: f64 = 0.05;
/// Meaning of a number that no material has.
const NO_MATERIAL: &str = "no material has such a value";

/// Numbers of one material or of an interface, with the name of the modulus.
pub(super) struct Material {
    pub(super) modulus: (&'static str, f64),
    pub(super) hardness: Option<f64>,
    pub(super) yield_strength: Option<f64>,
}

impl Material {
    /// Findings of the numbers, alone and beside each other.
    pub(super) fn findings(&self) -> Findings {
        let mut found: Findings = self.sizes().into_iter().collect();
        // A finding about the hardness already explains the ratio.
        if let (Some(h), Some(y)) = (self.hardness, self.yield_strength)
            && found.is_empty()
        {
            let usual = [h / YIELD_RATIO[1], h / YIELD_RATIO[0]];
            let advice = format!("{} of the hardness, where 1/2.8 is usual", short(y / h));
            let input = Input::new("yield_strength", usual, "Pa", &[]);
            found.extend(input.finding(y).map(|found| found.advice(advice)));
        }
        found
    }

    fn strength(&self) -> Option<Strength> {
        let hardness = self.hardness.map(|value| Strength { field: "hardness", value });
        let yields = self.yield_strength.map(|value| Strength { field: "yield_strength", value });
        hardness.or(yields)
    }

    /// Findings of modulus and hardness, each by itself and in proportion to the other.
    fn sizes(&self) -> Vec<Finding> {
        let ((field, modulus), strength) = (self.modulus, self.strength());
        if plausible(modulus, strength) {
            return vec![];
        }
        // Another unit changes the ratio by more than ten.
        if let Some(strength) = strength.filter(|s| s.is_nearly_usual(modulus)) {
            return vec![strength.finding(modulus, &[])];
        }
        let (unit, units) = meant(modulus, strength).unwrap_or_default();
        let unexplained = unit.is_none() && units.is_empty();
        let times = |value: f64, unit: Option<&Unit>| unit.map_or(value, |unit| unit.1 * value);
        let meant = times(modulus, unit.as_ref());
        let is_odd = !within(modulus, MODULUS);
        let of_modulus = (unit.is_some() || unexplained && is_odd).then(|| {
            let (usual, meaning) = match strength.filter(|_| !is_odd) {
                Some(given) => {
                    let strong = Strength { value: times(given.value, units.first()), ..given };
                    let [least, most] = strong.ratios(meant);
                    let usual = [strong.value / most, strong.value / least];
                    (usual, given.over(modulus, [least, most]))
                }
                None => (MODULUS, NO_MATERIAL.into()),
            };
            let found = Input::new(field, usual, "Pa", &[]).in_unit(modulus, unit.as_slice());
            found.advice(format!("{meaning}; {CHECK_UNIT}"))
        });
        let is_odd = |strength: &Strength| !is_odd || !within(strength.value, HARDNESS);
        let explained = |strength: &Strength| !units.is_empty() || unexplained && is_odd(strength);
        let of_strength = strength.filter(explained).map(|s| s.finding(meant, &units));
        of_modulus.into_iter().chain(of_strength).collect()
    }
}

/// A hardness or a yield strength.
#[derive(Clone, Copy)]
struct Strength {
    field: &'static str,
    value: f64,
}

impl Strength {
    /// Strength over modulus of materials with this modulus.
    fn ratios(self, modulus: f64) -> [f64; 2] {
        match ratios(modulus) {
            [least, most] if self.field != "hardness" => [least / HARDNESS_OVER_YIELD, most],
            [_, most] if modulus >= STIFF => [SOFTEST, most],
            usual => usual,
        }
    }

    /// Whether strength and modulus are usual, and their ratio is within ten times its usual range.
    fn is_nearly_usual(self, modulus: f64) -> bool {
        let [least, most] = self.ratios(modulus);
        within(modulus, MODULUS)
            && within(self.value, HARDNESS)
            && within(self.value / modulus, [0.1 * least, 10.0 * most])
    }

    /// Units, the likeliest first, in which this is the strength of a body with this modulus.
    fn units(self, modulus: f64, pressures: &[Unit]) -> Vec<Unit> {
        let vickers = ("HV", hardness_of_vickers(1.0));
        let over = |(_, factor): Unit| factor * self.value / modulus;
        let is_vickers = self.field == "hardness"
            && within(self.value, VICKERS)
            && modulus >= PLASTIC
            && within(over(vickers), [self.ratios(modulus)[0], HARDEST]);
        // What has a Vickers hardness is probably a metal.
        let most = if is_vickers { HARDEST_METAL } else { f64::INFINITY };
        let is_pressure = |unit: &Unit| {
            let value = unit.1 * self.value;
            over(*unit) <= most && plausible(modulus, Some(Self { value, ..self }))
        };
        let pressures = pressures.iter().copied().filter(is_pressure);
        is_vickers.then_some(vickers).into_iter().chain(pressures).collect()
    }

    /// "`hardness` over modulus is 9.524e-4, where 0.0015 to 0.3 is usual"
    fn over(self, modulus: f64, usual: [f64; 2]) -> String {
        let ([least, most], ratio) = (usual.map(short), short(self.value / modulus));
        format!("`{}` over modulus is {ratio}, where {least} to {most} is usual", self.field)
    }

    /// The finding of a strength beside a modulus, in these likely units, if there are any.
    fn finding(self, modulus: f64, units: &[Unit]) -> Finding {
        let Self { field, value } = self;
        let (ratio, by_ratio) = (value / modulus, self.ratios(modulus));
        let [least, most] = by_ratio.map(|ratio| ratio * modulus);
        let usual = [least.max(HARDNESS[0]), most.min(HARDNESS[1])];
        let usual = if usual[0] < usual[1] { usual } else { HARDNESS };
        let found = Input::new(field, usual, "Pa", &[]).in_unit(value, units);
        if modulus >= PLASTIC && ratio > NO_HARDNESS {
            let advice = format!("{} times the modulus looks like a modulus", short(ratio));
            return found.implausible(true).advice(advice);
        }
        let meaning = match within(value, HARDNESS) {
            true => self.over(modulus, by_ratio),
            false => NO_MATERIAL.into(),
        };
        found.advice(format!("{meaning}; {CHECK_UNIT}"))
    }
}

/// Units in which modulus and strength are plausible, of the strength all that are; no unit where
/// a number is plausible in Pa. Another unit of the strength comes first, kPa last.
fn meant(modulus: f64, strength: Option<Strength>) -> Option<(Option<Unit>, Vec<Unit>)> {
    let without_kilo = PRESSURES.split_last().map_or(PRESSURES, |(_, others)| others);
    [without_kilo, PRESSURES].into_iter().find_map(|pressures| {
        let of_modulus = pressures.iter().copied().map(Some);
        std::iter::once(None).chain(of_modulus).find_map(|unit: Option<Unit>| {
            let modulus = unit.map_or(modulus, |(_, factor)| factor * modulus);
            if plausible(modulus, strength) {
                return Some((unit, vec![]));
            }
            let units = strength.filter(|_| within(modulus, MODULUS))?.units(modulus, pressures);
            (!units.is_empty()).then_some((unit, units))
        })
    })
}

/// Whether a material may have this modulus and hardness.
fn plausible(modulus: f64, strength: Option<Strength>) -> bool {
    let fits = |s: Strength| within(s.value / modulus, s.ratios(modulus));
    within(modulus, MODULUS) && strength.is_none_or(|s| within(s.value, HARDNESS) && fits(s))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Body;

    /// The finding for a hardness beside a modulus.
    fn of_hardness(modulus: f64, hardness: f64) -> Option<Finding> {
        Body::new(modulus, 0.3, hardness).findings().into_iter().next()
    }

    #[test]
    fn advice_on_units_leaves_no_finding_when_it_is_followed() {
        // Steel, aluminium, copper, magnesium, lead, indium, tungsten carbide.
        let metals = [210e9, 70e9, 120e9, 43e9, 16e9, 12.7e9, 600e9];
        let mut followed = 0;
        for (modulus, vickers) in metals.iter().flat_map(|e| (2..=900).map(move |hv| (*e, hv))) {
            let vickers = f64::from(vickers);
            let pascals = hardness_of_vickers(vickers);
            let given = [vickers, pascals * 1e-9, pascals * 1e-6, pascals * 1e-3];
            for (value, scale) in given.into_iter().flat_map(|h| [1.0, 1e-9, 1e-6].map(|s| (h, s)))
            {
                let found = Body::new(modulus * scale, 0.3, value).findings();
                // "210 looks like GPa; 210 GPa is 2.1e11 Pa, ..": what each is in Pa.
                let advised = |field: &str| -> Vec<f64> {
                    let of_field = found.iter().find(|found| found.field == field);
                    let advice = of_field.and_then(|found| found.likely_unit.clone());
                    let words = advice.unwrap_or_default();
                    let numbers = words.split(" is ").skip(1);
                    let number = |text: &str| text.split(' ').next()?.parse().ok();
                    numbers.filter_map(number).collect()
                };
                let (moduli, hardnesses) = (advised("youngs_modulus"), advised("hardness"));
                let modulus = moduli.first().copied().unwrap_or(modulus * scale);
                for hardness in hardnesses {
                    followed += 1;
                    let next = of_hardness(modulus, hardness);
                    assert_eq!(next, None, "E {modulus:e}, H {value} {hardness:e}");
                }
            }
        }
        assert!(followed > 10_000, "{followed}");
    }

    #[test]
    fn units_are_those_that_are_plausible_beside_the_modulus() {
        for (modulus, hardness, wanted) in [
            (210e9, 200.0, "200 looks like HV; 200 HV is 2.115e9 Pa"),
            (210e9, 60.0, "60 looks like HV; 60 HV is 6.346e8 Pa"),
            (70e9, 200.0, "200 looks like HV or MPa; 200 HV is 2.115e9 Pa, 200 MPa is 2e8 Pa"),
            (210e9, 2.0, "2 looks like GPa; 2 GPa is 2e9 Pa"),
            (72e9, 5.74, "5.74 looks like GPa; 5.74 GPa is 5.74e9 Pa"),
            // Tin, indium and lead.
            (50e9, 5.0, "5 looks like HV; 5 HV is 5.288e7 Pa"),
            (12.7e9, 1.0, "1 looks like HV; 1 HV is 1.058e7 Pa"),
            (16e9, 4.0, "4 looks like HV; 4 HV is 4.231e7 Pa"),
        ] {
            let found = of_hardness(modulus, hardness).unwrap().to_string();
            assert!(found.ends_with(&format!(": {wanted}")), "{found}");
        }
        for (modulus, wanted) in [(210.0, "210 GPa is 2.1e11"), (2.1e5, "2.1e5 MPa is 2.1e11")] {
            let found = Body::new(modulus, 0.3, 200.0).findings();
            let texts: Vec<String> = found.iter().map(ToString::to_string).collect();
            assert!(texts.len() == 2 && texts[0].contains(wanted), "{texts:?}");
            assert!(texts[1].ends_with("200 HV is 2.115e9 Pa"), "{texts:?}");
        }
        // A gel in kPa, which nothing else explains.
        let gel = Body::elastic(40.0, 0.5).findings();
        assert!(gel[0].message().contains("40 looks like GPa"), "{gel:?}");
        let gel = Body::new(50.0, 0.5, 50.0).findings();
        assert!(gel[0].message().contains("50 looks like"), "{gel:?}");
    }

    #[test]
    fn soft_polymers_are_usual_and_slightly_odd_ratios_are_warnings_in_their_own_units() {
        // PTFE and polyethylene, on a rigid body and alone.
        for (modulus, poisson, strength) in [(500e6, 0.46, 12e6), (1e9, 0.45, 20e6)] {
            for modulus in [modulus, modulus / (1.0 - poisson * poisson)] {
                let found = Body::yielding(modulus, poisson, strength).findings();
                assert!(found.is_empty(), "{found:?}");
            }
        }
        for (modulus, hardness) in [(6e8, 8e6), (3e7, 3e5), (210e9, 2e8), (50e9, 1.2e7)] {
            let found = Body::new(modulus, 0.4, hardness).findings();
            let [one] = &found[..] else { panic!("{found:?}") };
            assert!(one.field == "hardness" && !one.is_implausible(), "{one}");
            assert_eq!(one.likely_unit, None, "{one}");
        }
    }

    #[test]
    fn a_hardness_far_below_that_of_any_metal_is_implausible_and_says_so_once() {
        for hardness in [1.2e6, 9e5, 6e4, 200.0] {
            let mut found = of_hardness(70e9, hardness).unwrap();
            assert!(found.is_implausible(), "{hardness}");
            found.likely_unit = None;
            assert_eq!(found.message().matches(CHECK_UNIT).count(), 1, "{found}");
        }
        let soft = of_hardness(210e9, 2e8).unwrap();
        let wanted = "hardness over modulus is 9.524e-4, where 0.0015 to 0.3 is usual; check the number and its unit";
        assert!(!soft.is_implausible() && soft.message().ends_with(wanted), "{soft}");
    }
}
