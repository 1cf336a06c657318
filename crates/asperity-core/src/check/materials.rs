//! Plausibility of moduli, hardnesses and other material numbers.

use super::moduli::Material;
use super::units::{CONDUCTIVITIES, ENERGIES, PRESSURES, RESISTIVITIES, Unit, likely_unit};
use super::usual::{CHECK_UNIT, unusual, with_unit, within};
use crate::finding::short;
use crate::{Body, Finding, Findings, Interface};

/// G/E of two bodies; 0.17 to 0.25, (1-ν)/(2(2-ν)), for equal materials.
const SHEAR_RATIO: [f64; 2] = [0.08, 0.5];
/// w_a \[J/m²\], from surfaces in a liquid to cold-welding metals.
const ADHESION: [f64; 2] = [1e-3, 5.0];
/// k \[W/(m K)\], from aerogels to diamond.
const CONDUCTIVITY: [f64; 2] = [0.01, 3000.0];
/// ρ \[Ω m\] of conductors, from cold copper to carbon and composites.
const RESISTIVITY: [f64; 2] = [1e-9, 1e-2];
/// S = 0.454 + 0.41 ν.
const PRESSURE_FACTOR: [f64; 2] = [0.2, 1.2];

impl Body {
    /// Findings of numbers outside the range of any material.
    #[must_use]
    pub fn findings(&self) -> Findings {
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
    pub fn findings(&self) -> Findings {
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
fn conducting(conductivity: Option<f64>, resistivity: Option<f64>) -> Vec<Finding> {
    let check = |field, value: f64, usual, units: &[Unit], si| {
        let unit = likely_unit(value, units, si, |x| within(x, usual));
        let found = Finding::warning("unusual-size", field, value).usual(usual).unit(si);
        (!within(value, usual)).then(|| with_unit(found.advice(CHECK_UNIT), unit))
    };
    let thermal = conductivity
        .and_then(|k| check("thermal_conductivity", k, CONDUCTIVITY, CONDUCTIVITIES, "W/(m K)"));
    let electrical = resistivity
        .and_then(|rho| check("electrical_resistivity", rho, RESISTIVITY, RESISTIVITIES, "ohm m"));
    thermal.into_iter().chain(electrical).collect()
}
