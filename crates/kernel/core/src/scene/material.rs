//! The materials: the numbers of one body, and of the interface of two.

use std::cmp::Ordering;

use serde::{Deserialize, Serialize};

use crate::ContactError;
use crate::error::require;

/// Hardness over yield strength when only one of them is known (Tabor's ratio, as the JG and KE
/// papers use it). \[seen\]
pub const HARDNESS_OVER_YIELD: f64 = 2.8;

/// A number of a [`Body`] or an [`Interface`].
#[derive(Debug, Clone, Copy)]
pub struct MaterialNumber<T: 'static> {
    /// Its name.
    pub name: &'static str,
    /// The number in SI units, if it is set.
    pub get: fn(&T) -> Option<f64>,
    /// Whether it may have this value, and what is required.
    must: fn(&T, f64) -> (bool, &'static str),
}

/// A struct of numbers: those that are always set, then the others, each with its meaning and what
/// it must be.
macro_rules! material {
    ($(#[$about:meta])* $struct:ident
        { $($(#[$means:meta])* $always:ident: $must:expr,)+ }
        { $($(#[$says:meta])* $maybe:ident: $may:expr,)+ }) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
        #[serde(deny_unknown_fields)]
        #[non_exhaustive]
        pub struct $struct {
            $($(#[$means])* pub $always: f64,)+
            $($(#[$says])* pub $maybe: Option<f64>,)+
        }

        impl $struct {
            /// Its numbers.
            pub const NUMBERS: &'static [MaterialNumber<Self>] = &[
                $(MaterialNumber {
                    name: stringify!($always),
                    get: |of| Some(of.$always),
                    must: $must,
                },)+
                $(MaterialNumber { name: stringify!($maybe), get: |of| of.$maybe, must: $may },)+
            ];

            /// Without the other numbers: it never yields, such as rubber, and only GW, Persson,
            /// DMT and JKR apply.
            #[must_use]
            pub fn elastic($($always: f64),+) -> Self {
                Self { $($always,)+ $($maybe: None),+ }
            }

            fn check_numbers(&self) -> Result<(), ContactError> {
                Self::NUMBERS.iter().try_for_each(|number| {
                    let Some(value) = (number.get)(self) else { return Ok(()) };
                    let (holds, required) = (number.must)(self, value);
                    require(holds, number.name, value, required).map(drop)
                })
            }
        }
    };
}

fn above_0<T>(_: &T, value: f64) -> (bool, &'static str) {
    (value.is_finite() && value > 0.0, "a finite number above 0")
}

fn poissons_ratio<T>(_: &T, value: f64) -> (bool, &'static str) {
    (value > -1.0 && value <= 0.5, "a number above -1 and at most 0.5")
}

/// Of a tangent modulus beside Young's modulus.
fn below(modulus: f64, tangent: f64) -> (bool, &'static str) {
    ((0.0..modulus).contains(&tangent), "at least 0 and less than Young's modulus")
}

material! {
    /// One elastic-plastic body.
    Body {
        /// Young's modulus \[Pa\], > 0.
        youngs_modulus: above_0,
        /// Poisson's ratio, in (-1, 0.5].
        poissons_ratio: poissons_ratio,
    } {
        /// Hardness \[Pa\]; 2.8 times the yield strength if not given. Without either, the body
        /// never yields: only the elastic models (GW, Persson, DMT, JKR) apply.
        hardness: above_0,
        /// Yield strength \[Pa\]; the hardness over 2.8 if not given.
        yield_strength: above_0,
        /// E_t \[Pa\], the slope of stress over strain beyond yielding, at least 0 and below E;
        /// used by Ghaednia's law only.
        tangent_modulus: |body, tangent| below(body.youngs_modulus, tangent),
        /// Thermal conductivity k \[W/(m K)\]; used by the thermal conductance only.
        thermal_conductivity: above_0,
        /// Electrical resistivity ρ \[Ω m\]; used by the electrical conductance only.
        electrical_resistivity: above_0,
    }
}

material! {
    /// The equivalent properties of two bodies in contact, as the laws use them.
    Interface {
        /// E \[Pa\]: 1/E = (1-ν₁²)/E₁ + (1-ν₂²)/E₂.
        equivalent_modulus: above_0,
        /// ν of the softer body, in (-1, 0.5].
        poissons_ratio: poissons_ratio,
    } {
        /// G \[Pa\]: 1/G = (2-ν₁)/G₁ + (2-ν₂)/G₂ (Mindlin); the Gao and AT models need it.
        equivalent_shear_modulus: above_0,
        /// Hardness of the softer body \[Pa\]; 2.8 times the yield strength if not given. Only the
        /// elastic models (GW, Persson, DMT, JKR) work without either.
        hardness: above_0,
        /// Yield strength of the softer body \[Pa\]; the hardness over 2.8 if not given.
        yield_strength: above_0,
        /// Maximum contact pressure factor S; 0.454 + 0.41 ν if not given.
        pressure_factor: above_0,
        /// E_t \[Pa\] of two bodies with the same Young's modulus and Poisson's ratio, at least 0
        /// and below that modulus, 2 (1-ν²) E; used by Ghaednia's law only.
        tangent_modulus: |of, tangent| {
            below(2.0 * (1.0 - of.poissons_ratio.powi(2)) * of.equivalent_modulus, tangent)
        },
        /// k \[W/(m K)\]: 2/k = 1/k₁ + 1/k₂; used by the thermal conductance only.
        thermal_conductivity: above_0,
        /// ρ \[Ω m\]: 2ρ = ρ₁ + ρ₂; used by the electrical conductance only.
        electrical_resistivity: above_0,
        /// w_a = γ₁ + γ₂ - γ₁₂ \[J/m²\], at least 0: the work of adhesion of the two surfaces;
        /// used by DMT and JKR only.
        work_of_adhesion: |_, work| {
            (work >= 0.0 && work.is_finite(), "a finite number, at least 0,")
        },
    }
}

impl Body {
    /// A body with this hardness.
    #[must_use]
    pub fn new(youngs_modulus: f64, poissons_ratio: f64, hardness: f64) -> Self {
        Self { hardness: Some(hardness), ..Self::elastic(youngs_modulus, poissons_ratio) }
    }

    /// A body with this yield strength \[Pa\]; the hardness follows.
    #[must_use]
    pub fn yielding(youngs_modulus: f64, poissons_ratio: f64, yield_strength: f64) -> Self {
        let yield_strength = Some(yield_strength);
        Self { yield_strength, ..Self::elastic(youngs_modulus, poissons_ratio) }
    }

    /// Checks every number; returns hardness and yield strength \[Pa\], if there is either.
    fn check(&self) -> Result<[Option<f64>; 2], ContactError> {
        self.check_numbers()?;
        Ok(hardness_and_yield(self.hardness, self.yield_strength))
    }

    /// (1-ν²)/E and (2-ν)/G with G = E/(2(1+ν)).
    fn compliances(&self) -> (f64, f64) {
        let (e, nu) = (self.youngs_modulus, self.poissons_ratio);
        ((1.0 - nu * nu) / e, (2.0 - nu) * 2.0 * (1.0 + nu) / e)
    }
}

/// Each is derived from the other if only one is given.
fn hardness_and_yield(hardness: Option<f64>, yield_strength: Option<f64>) -> [Option<f64>; 2] {
    let by_yield = yield_strength.map(|y| y * HARDNESS_OVER_YIELD);
    let by_hardness = hardness.map(|h| h / HARDNESS_OVER_YIELD);
    [hardness.or(by_yield), yield_strength.or(by_hardness)]
}

impl Interface {
    /// An interface from its equivalent modulus \[Pa\], and Poisson's ratio and hardness \[Pa\] of
    /// the softer body; set the public fields for the rest.
    #[must_use]
    pub fn new(equivalent_modulus: f64, poissons_ratio: f64, hardness: f64) -> Self {
        Self { hardness: Some(hardness), ..Self::elastic(equivalent_modulus, poissons_ratio) }
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
        let both_yield = one[0].is_some() && other[0].is_some();
        let rank = |body: &Body, [hardness, yields]: [Option<f64>; 2]| {
            let softness = if both_yield { hardness } else { Some(body.youngs_modulus) };
            let unset = f64::INFINITY;
            [softness.unwrap_or(unset), yields.unwrap_or(unset), body.poissons_ratio]
        };
        let order = rank(first, one).partial_cmp(&rank(second, other));
        let softer = if order == Some(Ordering::Greater) { second } else { first };
        let (a, b) = (first.compliances(), second.compliances());
        let mean = |of: fn(&Body) -> Option<f64>, mean: fn(f64, f64) -> f64| {
            Some(mean(of(first)?, of(second)?))
        };
        let alike = first.youngs_modulus.total_cmp(&second.youngs_modulus).is_eq()
            && first.poissons_ratio.total_cmp(&second.poissons_ratio).is_eq();
        let hardens_alike = order != Some(Ordering::Equal)
            || first.tangent_modulus.partial_cmp(&second.tangent_modulus) == order;
        Ok(Self {
            tangent_modulus: softer.tangent_modulus.filter(|_| alike && hardens_alike),
            // Written so that no product overflows.
            thermal_conductivity: mean(
                |body| body.thermal_conductivity,
                |a, b| 2.0 * a / (1.0 + a / b),
            ),
            electrical_resistivity: mean(
                |body| body.electrical_resistivity,
                |a, b| 0.5 * a + 0.5 * b,
            ),
            ..Self::of_body(softer, (a.0 + b.0, a.1 + b.1))
        })
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

    /// Checks every field; returns hardness and yield strength \[Pa\], if there is either, and
    /// the pressure factor.
    ///
    /// # Errors
    /// [`ContactError`] naming the field that is out of range.
    pub fn check(&self) -> Result<(Option<f64>, Option<f64>, f64), ContactError> {
        self.check_numbers()?;
        let [hardness, yield_strength] = hardness_and_yield(self.hardness, self.yield_strength);
        // Chang, Etsion & Bogy; positive for every ν allowed. [seen]
        let factor = self.pressure_factor.unwrap_or(0.454 + 0.41 * self.poissons_ratio);
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
        assert!(message.starts_with("tangent_modulus is 1.92e11"), "{message}");
    }

    #[test]
    fn every_bad_field_is_named() {
        let good = Interface::new(116e9, 0.31, 1.12e9);
        let bad = [
            ("poissons_ratio", Interface { poissons_ratio: -1.0, ..good }),
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
