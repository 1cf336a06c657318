//! The normal law of one contact in each regime: N, A*, K_n and r as functions of
//! y = (contact-normal interference)/w_c.

use std::ops::Range;

use asperity_core::{Power, Regime};

/// End of the elastic range, in y (seen in text that quotes the paper).
pub const ELASTIC_END: f64 = 1.0;
/// End of the elastic-plastic range, in y.
pub const PLASTIC_FROM: f64 = 110.0;
/// End of JG's elastic range, from which its plastic area y (y/1.9)^B is counted.
const JG_ORIGIN: f64 = 1.9;

/// The normal law of one regime.
///
/// ```text
///                   N                       A*                      K_n
/// elastic           y^1.5                   y                       1.5 √y
/// elastic-plastic   1.32 (y-1)^1.27 + 1     1 + 1.19 (y-1)^1.1      1.6764 (y-1)^0.27
/// plastic           3y/S                    y (y/1.9)^B             3/S
/// ```
/// r = √A* - s₀, where s₀ = 0 for Gao and for every elastic contact. r and the "1 +" differ from
/// the printed equations: the AT paper's table of misprints gives the reasons.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalLaw {
    /// The row of the table.
    pub regime: Regime,
    /// S, the maximum contact pressure factor.
    pub pressure_factor: f64,
    /// B, the exponent of the plastic area.
    pub area_exponent: f64,
    /// s₀, the reduction of the contact radius over √(R w_c).
    pub radius_loss: f64,
}

impl NormalLaw {
    /// N.
    #[must_use]
    pub fn load(&self, y: f64) -> f64 {
        match self.regime {
            Regime::Elastic => y * y.sqrt(),
            Regime::ElasticPlastic => 1.32 * (y - 1.0).powf(1.27) + 1.0,
            Regime::Plastic => 3.0 * y / self.pressure_factor,
        }
    }

    /// A*.
    #[must_use]
    pub fn area(&self, y: f64) -> f64 {
        match self.regime {
            Regime::Elastic => y,
            Regime::ElasticPlastic => 1.19 * (y - 1.0).powf(1.1) + 1.0,
            Regime::Plastic => y * (y / JG_ORIGIN).powf(self.area_exponent),
        }
    }

    /// K_n = dN/dy.
    #[must_use]
    pub fn stiffness(&self, y: f64) -> f64 {
        match self.regime {
            Regime::Elastic => 1.5 * y.sqrt(),
            Regime::ElasticPlastic => 1.6764 * (y - 1.0).powf(0.27),
            Regime::Plastic => 3.0 / self.pressure_factor,
        }
    }

    /// r, the contact radius over √(R w_c).
    #[must_use]
    pub fn radius(&self, y: f64) -> f64 {
        self.area(y).sqrt() - self.radius_loss
    }

    /// N as powers, for averages in closed form.
    #[must_use]
    pub fn load_powers(&self) -> Vec<Power> {
        match self.regime {
            Regime::Elastic => vec![Power::new(1.0, 1.5)],
            Regime::ElasticPlastic => {
                vec![Power::new(1.0, 0.0), Power::from_origin(1.32, 1.0, 1.27)]
            }
            Regime::Plastic => vec![Power::new(3.0 / self.pressure_factor, 1.0)],
        }
    }

    /// A* as powers, for averages in closed form.
    #[must_use]
    pub fn area_powers(&self) -> Vec<Power> {
        let b = self.area_exponent;
        match self.regime {
            Regime::Elastic => vec![Power::new(1.0, 1.0)],
            Regime::ElasticPlastic => {
                vec![Power::new(1.0, 0.0), Power::from_origin(1.19, 1.0, 1.1)]
            }
            Regime::Plastic => vec![Power::new(JG_ORIGIN.powf(-b), 1.0 + b)],
        }
    }
}

/// The range of y of a regime.
#[must_use]
pub fn regime_range(regime: Regime) -> Range<f64> {
    match regime {
        Regime::Elastic => 0.0..ELASTIC_END,
        Regime::ElasticPlastic => ELASTIC_END..PLASTIC_FROM,
        Regime::Plastic => PLASTIC_FROM..f64::INFINITY,
    }
}

/// The static friction coefficient of one contact, μ = 0.27 coth(0.27 N^0.35): Brizmer, Kligerman &
/// Etsion 2007, from general knowledge of the literature.
#[must_use]
pub fn friction(load: f64) -> f64 {
    0.27 / (0.27 * load.powf(0.35)).tanh()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_equal_the_functions_of_the_table() {
        for (regime, y) in [
            (Regime::Elastic, 0.3),
            (Regime::ElasticPlastic, 1.0),
            (Regime::ElasticPlastic, 40.0),
            (Regime::Plastic, 300.0),
        ] {
            let law =
                NormalLaw { regime, pressure_factor: 0.58, area_exponent: 0.15, radius_loss: 0.0 };
            let sum = |powers: Vec<Power>| powers.iter().map(|p| p.value(y)).sum::<f64>();
            assert!((sum(law.load_powers()) / law.load(y) - 1.0).abs() < 1e-14);
            assert!((sum(law.area_powers()) / law.area(y) - 1.0).abs() < 1e-14);
            assert!(regime_range(regime).contains(&y));
        }
    }

    #[test]
    fn friction_is_high_at_light_loads_and_tends_to_0_27() {
        assert!((friction(1e30) - 0.27).abs() < 1e-12);
        assert!((friction(1e-12) * 1e-12f64.powf(0.35) - 1.0).abs() < 1e-8);
    }
}
