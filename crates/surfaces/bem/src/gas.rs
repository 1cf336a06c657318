//! Flow of a gas through the gap of a contact: isothermal, from a continuum to free molecules.
//!
//! A gas flows with the mass ṁ' = -(h²/v) Q(D) dp/dx per width, with v = √(2 R T) and the inverse
//! Knudsen number D = p h/(μ v), which differs from pixel to pixel and along the pressure. The map
//! is small against the seal, so that one pressure holds on it: its conductance k(p) follows from a
//! linear flow with the conductivities h² Q(D)/v, and the flow is W/L ∫ k dp between the pressures.

use std::f64::consts::PI;

use crate::BemError;
use crate::height_map::positive;

/// How a gas meets the walls.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rarefaction {
    /// No slip: D/6. The hydraulic gap of a liquid holds.
    Continuum,
    /// Slip of first order, 1 + 6 Kn: D/6 + √π/2.
    Slip,
    /// Diffuse walls at any D: the fit of Fukui and Kaneko (1990) \[recalled\], within 0.9 % of a
    /// solution of the BGK equation for D from 0.01 to 30.
    #[default]
    Transition,
}

impl Rarefaction {
    /// Q(D): the mass flow per width over h² (-dp/dx)/v.
    #[must_use]
    pub fn flow(self, d: f64) -> f64 {
        let least = d.max(Gas::LEAST);
        match self {
            Self::Continuum => d / 6.0,
            Self::Slip => d / 6.0 + 0.5 * PI.sqrt(),
            Self::Transition if d >= 5.0 => d / 6.0 + 1.0162 + 1.0653 / d - 2.1354 / (d * d),
            Self::Transition if d >= 0.15 => {
                0.138_52 * d + 1.250_87 + 0.156_53 / d - 0.009_69 / (d * d)
            }
            Self::Transition => {
                -2.229_19 * least + 2.106_73 + 0.016_53 / least - 0.000_069_4 / (least * least)
            }
        }
    }
}

/// A gas at a temperature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gas {
    viscosity: f64,
    /// √(2 R T) \[m/s\].
    speed: f64,
    rarefaction: Rarefaction,
}

impl Gas {
    /// Viscosity \[Pa s\], molar mass \[kg/mol\] and temperature \[K\].
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] for one that is not a positive number.
    pub fn new(
        viscosity: f64,
        molar_mass: f64,
        temperature: f64,
        rarefaction: Rarefaction,
    ) -> Result<Self, BemError> {
        const MOLAR: f64 = 8.314_462_618_153_24;
        let gas_constant = MOLAR / positive("molar mass", molar_mass)?;
        let speed = (2.0 * gas_constant * positive("temperature", temperature)?).sqrt();
        Ok(Self { viscosity: positive("viscosity", viscosity)?, speed, rarefaction })
    }

    /// Conductance h² Q(D)/v of an even gap \[m\] at a pressure \[Pa\]: mass flow per width over
    /// the gradient of the pressure \[s\].
    #[must_use]
    pub fn conductance(&self, gap: f64, pressure: f64) -> f64 {
        let d = self.inverse_knudsen(gap, pressure);
        if d > 0.0 { gap * gap / self.speed * self.rarefaction.flow(d) } else { 0.0 }
    }

    /// D = p h/(μ v), the gap \[m\] over the free path up to a factor; free molecules below
    /// [`LEAST`](Self::LEAST).
    #[must_use]
    pub fn inverse_knudsen(&self, gap: f64, pressure: f64) -> f64 {
        pressure * gap / (self.viscosity * self.speed)
    }

    /// R T \[J/kg\]: the pressure over the density.
    #[must_use]
    pub fn pressure_over_density(&self) -> f64 {
        0.5 * self.speed * self.speed
    }

    /// The least D of the fit. Below, Q grows as ln(1/D) until molecules fly along the whole gap,
    /// which no local law knows: it stays what it is here, as in a gap some 100 times as long as
    /// high.
    pub const LEAST: f64 = 0.01;
}
