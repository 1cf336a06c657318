//! Plausibility of moduli, hardnesses and other material numbers.

use super::usual::{Input, PRESSURES, within};
use super::{Plausible, moduli};
use asperity_core::{Body, Finding, Findings, Interface, short};

/// G/E of two bodies; 0.17 to 0.25, (1-ν)/(2(2-ν)), for equal materials.
const SHEAR_RATIO: [f64; 2] = [0.08, 0.5];
/// From surfaces in a liquid to cold-welding metals.
const ADHESION: Input<'static> =
    Input::new("work_of_adhesion", [1e-3, 5.0], "J/m2", &[("mJ/m2", 1e-3)]);
/// From aerogels to diamond.
const CONDUCTIVITY: Input<'static> = Input::new(
    "thermal_conductivity",
    [0.01, 3000.0],
    "W/(m K)",
    &[("mW/(m K)", 1e-3), ("W/(mm K)", 1e3)],
);
/// Of conductors, from cold copper to carbon and composites.
const RESISTIVITY: Input<'static> = Input::new(
    "electrical_resistivity",
    [1e-9, 1e-2],
    "ohm m",
    &[("uohm cm", 1e-8), ("nohm m", 1e-9), ("ohm mm2/m", 1e-6)],
);
/// From carbon to cold copper \[S/m\]: a resistivity of these is a conductivity.
const OF_CONDUCTORS: [f64; 2] = [1e4, 1e9];
/// S = 0.454 + 0.41 ν.
const PRESSURE_FACTOR: Input<'static> = Input::new("pressure_factor", [0.2, 1.2], "", &[]);

impl Plausible for Body {
    fn findings(&self) -> Findings {
        let modulus = ("youngs_modulus", self.youngs_modulus);
        let mut found = moduli::findings(modulus, self.hardness, self.yield_strength);
        found.extend(conducting(self.thermal_conductivity, self.electrical_resistivity));
        found
    }
}

impl Plausible for Interface {
    fn findings(&self) -> Findings {
        let modulus = ("equivalent_modulus", self.equivalent_modulus);
        let mut found = moduli::findings(modulus, self.hardness, self.yield_strength);
        // A finding about the modulus already explains the ratio.
        if let Some(shear) = self.equivalent_shear_modulus.filter(|_| found.is_empty()) {
            let usual = SHEAR_RATIO.map(|ratio| ratio * self.equivalent_modulus);
            let share = short(shear / self.equivalent_modulus);
            let advice = format!(
                "{share} of the equivalent modulus, where (1 - nu)/(2 (2 - nu)), about 0.2, is usual"
            );
            let input = Input::new("equivalent_shear_modulus", usual, "Pa", PRESSURES);
            found.extend(input.finding(shear).map(|found| found.advice(advice)));
        }
        let work = self.work_of_adhesion.filter(|work| *work > 0.0);
        let found_of = |input: Input<'_>, value: Option<f64>, advice| {
            value.and_then(|value| input.finding(value)).map(|found| found.advice(advice))
        };
        found.extend(found_of(ADHESION, work, "clean surfaces in air have about 0.05"));
        let advice = "leave it out for 0.454 + 0.41 nu";
        found.extend(found_of(PRESSURE_FACTOR, self.pressure_factor, advice));
        found.extend(conducting(self.thermal_conductivity, self.electrical_resistivity));
        found
    }
}

/// Findings of conductivity and resistivity, which no force depends on.
fn conducting(
    conductivity: Option<f64>,
    resistivity: Option<f64>,
) -> impl Iterator<Item = Finding> {
    let thermal = conductivity.and_then(|k| CONDUCTIVITY.finding(k));
    let electrical = resistivity.and_then(|rho| {
        let found = RESISTIVITY.finding(rho)?;
        let [given, inverse] = [rho, rho.recip()].map(short);
        let conductivity = format!(
            "{given} looks like a conductivity in S/m, of which the resistivity is {inverse} ohm m"
        );
        Some(if within(rho, OF_CONDUCTORS) { found.likely_unit(conductivity) } else { found })
    });
    let found = thermal.into_iter().chain(electrical);
    found.map(|found| found.implausible(false))
}
