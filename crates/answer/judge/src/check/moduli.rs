//! Plausibility of a modulus beside a hardness or a yield strength.

use super::usual::{CHECK_UNIT, Input, PRESSURES, Unit, implausible, in_other_units, within};
use asperity_core::{
    Findings, HARDNESS_OVER_YIELD, hardness_of_vickers, short, vickers_of_rockwell_c,
};

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
/// Modulus \[Pa\] below which materials do not yield and the hardness may be any number near E.
const RUBBER: f64 = 1e8;
/// Modulus \[Pa\] below which a material is a polymer or softer.
const PLASTIC: f64 = 3e9;
/// Smallest H/E of polymers.
const PLASTIC_RATIO: f64 = 0.02;
/// H/S_y.
const YIELD_RATIO: [f64; 2] = [1.5, 6.0];
/// Units of hardnesses: 1 HV is 1 kgf/mm² over sin 68°.
const HARDNESSES: &[Unit] =
    &[(HV, 9.806_65e6 / 0.927_183_854_566_787_4), PRESSURES[0], PRESSURES[1]];
const HV: &str = "HV";
const HRC: &str = "HRC";
/// Moduli of steels \[Pa\], also against a rigid body, which are tested by Rockwell C: no steel is
/// as soft as 65 HV.
const STEEL: [f64; 2] = [1.8e11, 2.4e11];
/// The greatest H/E of what is tested by Vickers: glass has 1/12. \[recalled\]
const HARDEST: f64 = 0.1;

/// Findings of the numbers of one material or of an interface, alone and beside each other; the
/// modulus with its name.
pub(super) fn findings(
    (field, modulus): (&'static str, f64),
    hardness: Option<f64>,
    yield_strength: Option<f64>,
) -> Findings {
    // The size of 1 HRC depends on the number.
    let rockwell = hardness.and_then(|value| {
        let vickers = vickers_of_rockwell_c(value)?;
        Some((HRC, hardness_of_vickers(vickers) / value))
    });
    let units: Vec<Unit> = rockwell.into_iter().chain(HARDNESSES.iter().copied()).collect();
    let strength = match (hardness, yield_strength) {
        (Some(value), _) => Some((Input::new("hardness", HARDNESS, "Pa", &units), value)),
        (_, Some(value)) => Some((Input::new("yield_strength", HARDNESS, "Pa", PRESSURES), value)),
        _ => None,
    };
    let modulus = (Input::new(field, MODULUS, "Pa", PRESSURES), modulus);
    let found = match strength {
        Some(strength) => together(modulus, strength),
        None => modulus.0.finding(modulus.1).into_iter().collect(),
    };
    // A finding about the hardness already explains the ratio.
    let Some((h, y)) = hardness.zip(yield_strength).filter(|_| found.is_empty()) else {
        return found;
    };
    let [most, least] = YIELD_RATIO.map(|ratio| h / ratio);
    let advice = format!("{} of the hardness, where 1/2.8 is usual", short(y / h));
    let found = Input::new("yield_strength", [least, most], "Pa", &[]).finding(y);
    found.map(|found| found.advice(advice)).into_iter().collect()
}

/// Findings of a modulus and a strength.
fn together(modulus: (Input<'_>, f64), (input, strength): (Input<'_>, f64)) -> Findings {
    let ratios = |modulus| ratios(modulus, input.field == "hardness");
    let is_usual =
        |[e, h]: [f64; 2]| within(e, MODULUS) && within(h, HARDNESS) && within(h / e, ratios(e));
    let e = modulus.1;
    if is_usual([e, strength]) {
        return Findings::default();
    }
    // Another unit changes the ratio by more than ten.
    let is_far =
        implausible(strength / e, ratios(e)) || !within(e, MODULUS) || !within(strength, HARDNESS);
    let cost = |values: &[f64], units: &[Option<Unit>]| {
        let [modulus, strength] = [values[0], values[1]];
        let is_tested = match units[1] {
            Some((HRC, _)) => within(modulus, STEEL),
            Some((HV, _)) => strength <= HARDEST * modulus,
            _ => true,
        };
        (is_tested && is_usual([modulus, strength])).then_some(0.0)
    };
    let numbers = [modulus, (input, strength)];
    let ratio = ratios(e).map(short);
    let advice = format!(
        "{} over modulus is {}, where {} to {} is usual; {CHECK_UNIT}",
        input.field,
        short(strength / e),
        ratio[0],
        ratio[1]
    );
    let found = if is_far { in_other_units(&numbers, cost) } else { vec![] };
    if !found.is_empty() {
        return found.into_iter().map(|found| found.advice(advice.clone())).collect();
    }
    let of_modulus = modulus.0.finding(e);
    let [least, most] = ratios(e).map(|ratio| ratio * e);
    let usual = [least.max(HARDNESS[0]), most.min(HARDNESS[1])];
    let usual = if usual[0] < usual[1] { usual } else { HARDNESS };
    let of_strength = Input { usual, units: &[], ..input }.finding(strength).map(|found| {
        // A modulus in place of the hardness.
        let is_modulus = e >= RUBBER && strength > e;
        let is_implausible = found.is_implausible() || is_modulus;
        found.implausible(is_implausible).advice(advice)
    });
    let of_strength = of_strength.filter(|_| of_modulus.is_none() || !within(strength, HARDNESS));
    of_modulus.into_iter().chain(of_strength).collect()
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
    use crate::Plausible;
    use asperity_core::{Body, Finding};

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
                // What each unit is in Pa, behind "is".
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
            (210e9, 200.0, "200 HV is 2.115e9 Pa"),
            (210e9, 58.0, "58 HRC is 6.907e9 Pa"),
            (120e9, 60.0, "60 HV is 6.346e8 Pa"),
            (70e9, 200.0, "200 HV is 2.115e9 Pa"),
            (210e9, 2.0, "2 GPa is 2e9 Pa"),
            (72e9, 5.74, "5.74 GPa is 5.74e9 Pa"),
            // Tin, indium and lead.
            (50e9, 5.0, "5 HV is 5.288e7 Pa"),
            (12.7e9, 1.0, "1 HV is 1.058e7 Pa"),
            (16e9, 4.0, "4 HV is 4.231e7 Pa"),
        ] {
            let found = of_hardness(modulus, hardness).unwrap().to_string();
            assert!(found.ends_with(&format!("; {wanted}")), "{found}");
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
        assert!(!soft.is_implausible() && soft.message().ends_with(CHECK_UNIT), "{soft}");
    }
}
