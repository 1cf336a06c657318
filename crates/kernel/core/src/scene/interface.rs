//! The equivalent properties of two bodies in contact.

use std::cmp::Ordering;

use serde::{Deserialize, Serialize};

use super::body::{
    Body, check_conduction, check_tangent_modulus, hardness_and_yield, poissons_ratio,
};
use crate::ContactError;
use crate::error::{positive, require};

/// The equivalent properties of two bodies in contact, as the laws use them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct Interface {
    /// E \[Pa\]: 1/E = (1-ν₁²)/E₁ + (1-ν₂²)/E₂.
    pub equivalent_modulus: f64,
    /// G \[Pa\]: 1/G = (2-ν₁)/G₁ + (2-ν₂)/G₂ (Mindlin); the Gao and AT models need it.
    #[serde(default)]
    pub equivalent_shear_modulus: Option<f64>,
    /// ν of the softer body, in (-1, 0.5].
    pub poissons_ratio: f64,
    /// Hardness of the softer body \[Pa\]; 2.8 times the yield strength if not given. Only the
    /// elastic models (GW, Persson, DMT, JKR) work without either.
    #[serde(default)]
    pub hardness: Option<f64>,
    /// Yield strength of the softer body \[Pa\]; the hardness over 2.8 if not given.
    #[serde(default)]
    pub yield_strength: Option<f64>,
    /// Maximum contact pressure factor S; 0.454 + 0.41 ν if not given.
    #[serde(default)]
    pub pressure_factor: Option<f64>,
    /// E_t \[Pa\] of two bodies with the same Young's modulus and Poisson's ratio, at least 0 and
    /// below that modulus, 2 (1-ν²) E; used by Ghaednia's law only.
    #[serde(default)]
    pub tangent_modulus: Option<f64>,
    /// k \[W/(m K)\]: 2/k = 1/k₁ + 1/k₂; used by the thermal conductance only.
    #[serde(default)]
    pub thermal_conductivity: Option<f64>,
    /// ρ \[Ω m\]: 2ρ = ρ₁ + ρ₂; used by the electrical conductance only.
    #[serde(default)]
    pub electrical_resistivity: Option<f64>,
    /// w_a = γ₁ + γ₂ - γ₁₂ \[J/m²\], at least 0: the work of adhesion of the two surfaces; used by
    /// DMT and JKR only.
    #[serde(default)]
    pub work_of_adhesion: Option<f64>,
}

impl Interface {
    /// An interface from its equivalent modulus \[Pa\], and Poisson's ratio and hardness \[Pa\] of
    /// the softer body; set the public fields for the rest.
    #[must_use]
    pub fn new(equivalent_modulus: f64, poissons_ratio: f64, hardness: f64) -> Self {
        Self {
            equivalent_modulus,
            equivalent_shear_modulus: None,
            poissons_ratio,
            hardness: Some(hardness),
            yield_strength: None,
            pressure_factor: None,
            tangent_modulus: None,
            thermal_conductivity: None,
            electrical_resistivity: None,
            work_of_adhesion: None,
        }
    }

    /// Two deformable bodies, in either order. Hardness, yield strength and ν are of the body
    /// that yields: of the lower hardness; of two equally hard ones, of the lower yield strength,
    /// then of the smaller ν, whose w_c is smaller. If either body has no hardness they are those
    /// of the lower Young's modulus. The tangent modulus is of the body that yields, and of
    /// both if they are equally hard; it is set only if both have the same E and ν.
    ///
    /// # Errors
    /// [`ContactError`] naming the field, of either body, that is out of range.
    pub fn between(first: &Body, second: &Body) -> Result<Self, ContactError> {
        let (one, other) = (first.check()?, second.check()?);
        let both_yield = one.0.is_some() && other.0.is_some();
        let rank = |body: &Body, (hardness, yields): (Option<f64>, Option<f64>)| {
            let softness = if both_yield { hardness } else { Some(body.youngs_modulus) };
            let unset = f64::INFINITY;
            [softness.unwrap_or(unset), yields.unwrap_or(unset), body.poissons_ratio]
        };
        let order = rank(first, one).partial_cmp(&rank(second, other));
        let softer = if order == Some(Ordering::Greater) { second } else { first };
        let (a, b) = (first.compliances(), second.compliances());
        let both = |of: fn(&Body) -> Option<f64>| of(first).zip(of(second));
        // Written as ratios, so that no product overflows.
        let conductivities = both(|body| body.thermal_conductivity);
        let resistivities = both(|body| body.electrical_resistivity);
        let alike = first.youngs_modulus.total_cmp(&second.youngs_modulus).is_eq()
            && first.poissons_ratio.total_cmp(&second.poissons_ratio).is_eq();
        let hardens_alike = order != Some(Ordering::Equal)
            || first.tangent_modulus.partial_cmp(&second.tangent_modulus) == order;
        Ok(Self {
            tangent_modulus: softer.tangent_modulus.filter(|_| alike && hardens_alike),
            thermal_conductivity: conductivities.map(|(a, b)| Self::mean_conductivity(a, b)),
            electrical_resistivity: resistivities.map(|(a, b)| 0.5 * a + 0.5 * b),
            ..Self::of_body(softer, (a.0 + b.0, a.1 + b.1))
        })
    }

    /// The thermal conductivity of an interface, 2 k₁ k₂/(k₁ + k₂), from its bodies', both
    /// above 0; all in W/(m K).
    #[must_use]
    pub fn mean_conductivity(first: f64, second: f64) -> f64 {
        2.0 * first / (1.0 + first / second)
    }

    /// A deformable body on a rigid one. Conductivity and resistivity are not set: those of the
    /// rigid body are unknown.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn against_rigid(body: &Body) -> Result<Self, ContactError> {
        body.check()?;
        Ok(Self::of_body(body, body.compliances()))
    }

    /// Hardness and ν of one body, with these compliances \[1/Pa\].
    fn of_body(body: &Body, (normal, tangential): (f64, f64)) -> Self {
        Self {
            equivalent_shear_modulus: Some(1.0 / tangential),
            hardness: body.hardness,
            yield_strength: body.yield_strength,
            ..Self::elastic(1.0 / normal, body.poissons_ratio)
        }
    }

    /// An interface that never yields, such as rubber on glass: for GW, Persson, DMT and JKR only.
    #[must_use]
    pub fn elastic(equivalent_modulus: f64, poissons_ratio: f64) -> Self {
        Self { hardness: None, ..Self::new(equivalent_modulus, poissons_ratio, 0.0) }
    }

    /// Checks every field; returns hardness and yield strength \[Pa\], if there is either, and
    /// the pressure factor.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn check(&self) -> Result<(Option<f64>, Option<f64>, f64), ContactError> {
        positive("equivalent_modulus", self.equivalent_modulus)?;
        let shear = self.equivalent_shear_modulus;
        shear.map(|shear| positive("equivalent_shear_modulus", shear)).transpose()?;
        poissons_ratio(self.poissons_ratio)?;
        let alike = 2.0 * (1.0 - self.poissons_ratio.powi(2)) * self.equivalent_modulus;
        check_tangent_modulus(self.tangent_modulus, alike)?;
        check_conduction(self.thermal_conductivity, self.electrical_resistivity)?;
        let work = self.work_of_adhesion.unwrap_or(0.0);
        let holds = work >= 0.0 && work.is_finite();
        require(holds, "work_of_adhesion", work, "a finite number, at least 0,")?;
        let (hardness, yield_strength) = hardness_and_yield(self.hardness, self.yield_strength)?;
        let factor = match self.pressure_factor {
            Some(factor) => positive("pressure_factor", factor)?,
            // Chang, Etsion & Bogy; positive for every ν allowed. [seen]
            None => 0.454 + 0.41 * self.poissons_ratio,
        };
        Ok((hardness, yield_strength, factor))
    }

    /// The hardness of the softer body \[Pa\], or that of its yield strength; `None` for elastic
    /// bodies and for invalid fields.
    #[must_use]
    pub fn softer_hardness(&self) -> Option<f64> {
        self.check().ok().and_then(|(hardness, ..)| hardness)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steel_on_rigid_has_the_moduli_of_figure_10() {
        let steel = Body {
            youngs_modulus: 200e9,
            poissons_ratio: 0.3,
            yield_strength: Some(400e6),
            ..Body::elastic(200e9, 0.3)
        };
        let interface = Interface::against_rigid(&steel).unwrap();
        assert!((interface.equivalent_modulus / 219.78e9 - 1.0).abs() < 1e-4);
        let shear = interface.equivalent_shear_modulus.unwrap();
        assert!((shear / 45.249e9 - 1.0).abs() < 1e-4);
        let (hardness, yield_strength, factor) = interface.check().unwrap();
        let (hardness, yield_strength) = (hardness.unwrap(), yield_strength.unwrap());
        assert!((hardness - 1.12e9).abs() < 1.0 && (yield_strength - 400e6).abs() < 1.0);
        assert!((factor - 0.577).abs() < 1e-12);
    }

    #[test]
    fn the_softer_body_gives_hardness_and_poissons_ratio() {
        let (hard, soft) = (Body::new(210e9, 0.28, 7e9), Body::new(70e9, 0.33, 1e9));
        for interface in [Interface::between(&hard, &soft), Interface::between(&soft, &hard)] {
            let interface = interface.unwrap();
            assert_eq!(interface.hardness, Some(1e9));
            assert!((interface.poissons_ratio - 0.33).abs() < 1e-15);
        }
    }

    #[test]
    fn bodies_are_equal_in_either_order() {
        let either = |one: &Body, other: &Body| {
            let [found, turned] = [(one, other), (other, one)]
                .map(|(one, other)| Interface::between(one, other).unwrap());
            assert_eq!(found, turned);
            found
        };
        let nu = |interface: Interface| (100.0 * interface.poissons_ratio).round();
        let steel = Body::new(210e9, 0.3, 2e9);
        let equally_hard = Body::new(100e9, 0.45, 2e9);
        assert!((nu(either(&steel, &equally_hard)) - 30.0).abs() < 1e-9);
        let weaker = Body { yield_strength: Some(400e6), ..equally_hard };
        assert!((nu(either(&steel, &weaker)) - 45.0).abs() < 1e-9);
        // Without a hardness the modulus decides.
        let elastic = Body { hardness: None, ..equally_hard };
        assert_eq!(either(&steel, &elastic).hardness, None);
        let as_stiff = Body { youngs_modulus: 210e9, ..elastic };
        assert_eq!(either(&steel, &as_stiff).hardness, Some(2e9));
        // Equally hard bodies harden alike, or not by this law.
        let hardening = Body { tangent_modulus: Some(620e6), ..steel };
        assert_eq!(either(&steel, &hardening).tangent_modulus, None);
        let more = Body { tangent_modulus: Some(6.2e9), ..steel };
        assert_eq!(either(&more, &hardening).tangent_modulus, None);
        let harder = Body { hardness: Some(3e9), ..more };
        assert_eq!(either(&harder, &hardening).tangent_modulus, Some(620e6));
    }

    #[test]
    fn conductivity_and_resistivity_are_means_and_need_both_bodies() {
        let mut one = Body::new(210e9, 0.28, 7e9);
        let mut other = one;
        (one.thermal_conductivity, other.thermal_conductivity) = (Some(50.0), Some(100.0));
        (one.electrical_resistivity, other.electrical_resistivity) = (Some(1e-7), Some(3e-7));
        let interface = Interface::between(&one, &other).unwrap();
        assert!((interface.thermal_conductivity.unwrap() - 200.0 / 3.0).abs() < 1e-12);
        assert!((interface.electrical_resistivity.unwrap() - 2e-7).abs() < 1e-21);
        other.thermal_conductivity = None;
        assert_eq!(Interface::between(&one, &other).unwrap().thermal_conductivity, None);
        assert_eq!(Interface::against_rigid(&one).unwrap().electrical_resistivity, None);
    }

    #[test]
    fn a_tangent_modulus_needs_two_like_bodies() {
        let steel = Body { tangent_modulus: Some(620e6), ..Body::new(192e9, 0.3, 1e9) };
        let stiffer = Body { youngs_modulus: 193e9, ..steel };
        let of = |interface: Interface| interface.tangent_modulus;
        assert_eq!(of(Interface::between(&steel, &steel).unwrap()), Some(620e6));
        assert_eq!(of(Interface::between(&steel, &stiffer).unwrap()), None);
        assert_eq!(of(Interface::against_rigid(&steel).unwrap()), None);
        let rubber = Body { tangent_modulus: Some(192e9), ..steel };
        let message = Interface::against_rigid(&rubber).unwrap_err().to_string();
        assert!(message.starts_with("tangent_modulus is 192000000000"), "{message}");
    }

    #[test]
    fn every_bad_field_is_named() {
        let good = Interface::new(116e9, 0.31, 1.12e9);
        let bad = [
            ("equivalent_modulus", Interface { equivalent_modulus: -1.0, ..good }),
            ("equivalent_modulus", Interface { equivalent_modulus: f64::NAN, ..good }),
            ("equivalent_shear_modulus", Interface { equivalent_shear_modulus: Some(0.0), ..good }),
            ("poissons_ratio", Interface { poissons_ratio: 0.51, ..good }),
            ("poissons_ratio", Interface { poissons_ratio: -1.0, ..good }),
            ("hardness", Interface { hardness: Some(0.0), ..good }),
            ("yield_strength", Interface { yield_strength: Some(f64::INFINITY), ..good }),
            ("pressure_factor", Interface { pressure_factor: Some(0.0), ..good }),
            ("tangent_modulus", Interface { tangent_modulus: Some(-1.0), ..good }),
            ("tangent_modulus", Interface { tangent_modulus: Some(210e9), ..good }),
            ("thermal_conductivity", Interface { thermal_conductivity: Some(-1.0), ..good }),
            ("electrical_resistivity", Interface { electrical_resistivity: Some(0.0), ..good }),
            ("work_of_adhesion", Interface { work_of_adhesion: Some(-0.05), ..good }),
            ("work_of_adhesion", Interface { work_of_adhesion: Some(f64::NAN), ..good }),
        ];
        for (field, interface) in bad {
            let message = interface.check().unwrap_err().to_string();
            assert!(message.starts_with(field), "{field}: {message}");
        }
        assert!(Interface { poissons_ratio: 0.5, ..good }.check().is_ok());
        assert!(Interface { work_of_adhesion: Some(0.0), ..good }.check().is_ok());
    }

    #[test]
    fn rubber_needs_no_hardness_and_is_the_softer_one() {
        let (rubber, glass) = (Body::elastic(2e6, 0.5), Body::new(70e9, 0.22, 6e9));
        for interface in [Interface::between(&rubber, &glass), Interface::between(&glass, &rubber)]
        {
            let interface = interface.unwrap();
            assert!((interface.poissons_ratio - 0.5).abs() < 1e-15);
            assert_eq!(interface.check().unwrap().0, None);
        }
        assert_eq!(Interface::elastic(2e6, 0.5).check().unwrap().1, None);
    }
}
